"""Plans of datasets that tests make."""

from __future__ import annotations

from pathlib import Path

from service.dataset.dataset_plan import DatasetPlan, varied


def plan(shard_size: int) -> DatasetPlan:
    """A plan that nothing is made of."""
    return DatasetPlan(Path("unused"), varied({}, {}), ("json",), shard_size, {}, {}, None)
