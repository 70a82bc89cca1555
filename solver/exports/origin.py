"""Where a file's house is from, and what is wrong with it, in words for comments."""

from __future__ import annotations

from collections.abc import Iterator

from solver.exports.model import HouseModel


def words_of(model: HouseModel) -> Iterator[str]:
    """Yields which seed and catalog made a house, and its warnings."""
    made = model.scene.generator or {}
    yield f"seed {model.scene.seed}, Compose {made.get('version')}, catalog {made.get('catalog')}"
    yield from (f"warning: {warning}" for warning in model.warnings)
