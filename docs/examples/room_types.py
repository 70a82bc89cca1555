"""Learns from a dataset what type a room is by what stands in it: softmax regression in NumPy, on parquet.

compose dataset --seeds 0-199 --program family --out homes
python docs/examples/room_types.py homes
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pyarrow.parquet as pq


def read(folder: Path, split: str, words: list[str], types: list[str]) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Returns a split's rooms: pieces of each kind, and the numbers of their types; the first split names both."""
    rooms = pq.read_table(f"{folder}/tables/rooms", columns=["seed", "id", "type"]).to_pylist()
    chosen = seeds(folder, split)
    rooms = [row for row in rooms if row["seed"] in chosen]
    pieces = pq.read_table(f"{folder}/tables/pieces", columns=["seed", "room", "kind", "sort"]).to_pylist()
    if not types:
        words += sorted({row["kind"] for row in pieces if row["sort"] == "furniture" and row["kind"]})
        types += sorted({row["type"] for row in rooms})
    at = {(row["seed"], row["id"]): k for k, row in enumerate(rooms)}
    counts = np.zeros((len(rooms), len(words) + 1))
    counts[:, -1] = 1.0
    for row in pieces:
        if (row["seed"], row["room"]) in at and row["kind"] in words:
            counts[at[row["seed"], row["room"]], words.index(row["kind"])] += 1
    return counts, np.array([types.index(row["type"]) if row["type"] in types else -1 for row in rooms])


def seeds(folder: Path, split: str) -> set[int]:
    """Returns the seeds of a split."""
    files = sorted(folder.glob(f"tables/houses/{split}-*.parquet"))
    return {seed for file in files for seed in pq.read_table(file, columns=["seed"])["seed"].to_pylist()}


def train(counts: npt.NDArray[np.float64], types: npt.NDArray[np.int64], number: int, steps: int = 300) -> npt.NDArray[np.float64]:
    """Returns the weights of softmax regression, by gradient descent."""
    weights, wanted = np.zeros((counts.shape[1], number)), np.eye(number)[types]
    for _ in range(steps):
        scores = counts @ weights
        shares = np.exp(scores - scores.max(axis=1, keepdims=True))
        shares /= shares.sum(axis=1, keepdims=True)
        weights -= 0.5 * counts.T @ (shares - wanted) / len(counts)
    return weights


def main(folder: Path) -> None:
    """Trains on the split train, and says how many rooms of the other splits it knows."""
    words: list[str] = []
    types: list[str] = []
    weights = train(*read(folder, "train", words, types), len(types))
    for split in ("train", "validation", "test"):
        counts, known = read(folder, split, words, types)
        if len(counts):
            right = 100 * float(np.mean((counts @ weights).argmax(axis=1) == known))
            commonest = 100 * np.bincount(known[known >= 0]).max() / len(known)
            print(f"{split}: {len(counts)} rooms, {right:.1f} % known; {commonest:.1f} % are of the commonest type")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
