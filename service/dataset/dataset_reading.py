"""A dataset read back: one row, or the rows of all houses in the order of their seeds."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import pyarrow.parquet as pq

from service.dataset.dataset_plan import Shard, split_of
from service.dataset.manifest import manifest_of
from service.dataset.shards import table_path
from solver.errors import FieldError
from solver.plain import Document


def row_of(folder: Path, seed: int) -> Document:
    """Returns the row of a seed's home.

    Raises:
        FieldError: there is no dataset in the folder, or no such home in it.
    """
    size = manifest_of(folder)["shard_size"]
    path = folder / table_path("houses", split_of(seed), Shard(seed // size, seed, seed))
    rows = pq.read_table(path, filters=[("seed", "=", seed)]).to_pylist() if path.is_file() else []
    if not rows:
        raise FieldError("--seed", f"{folder} holds no home of seed {seed}", "a seed of its manifest")
    return cast(Document, rows[0])


def rows_of_houses(folder: Path, columns: list[str]) -> Iterator[dict[str, Any]]:
    """Yields some columns of every house, split by split, a batch of rows at a time in memory."""
    for path in sorted((folder / "tables" / "houses").glob("*.parquet")):
        for batch in pq.ParquetFile(path).iter_batches(batch_size=500, columns=columns):
            yield from batch.to_pylist()
