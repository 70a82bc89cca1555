"""Distances and stretches over cells, against SciPy's."""

from __future__ import annotations

import numpy as np
from scipy import ndimage

from solver.exports.floor_grid import largest_stretch, squared_distances
from tests.every import every


@every("seed", range(40))
def test_the_largest_stretch_is_the_largest_label(seed: int) -> None:
    stream = np.random.default_rng(seed)
    cells = stream.random((stream.integers(1, 14), stream.integers(1, 14))) < stream.choice([0.3, 0.55, 0.7, 1.0])
    labels, count = ndimage.label(cells)
    sizes = np.bincount(labels.ravel(), minlength=2)[1:]
    expected = labels == 1 + int(sizes.argmax()) if count else cells
    assert np.array_equal(largest_stretch(cells), expected)


@every("seed", range(40))
def test_distances_are_exact(seed: int) -> None:
    stream = np.random.default_rng(seed)
    cells = stream.random((stream.integers(1, 30), stream.integers(1, 30))) < stream.choice([0.01, 0.1, 0.5])
    cells[stream.integers(cells.shape[0]), stream.integers(cells.shape[1])] = True
    assert np.array_equal(squared_distances(cells), np.rint(ndimage.distance_transform_edt(~cells) ** 2))
