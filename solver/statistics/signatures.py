"""Signatures: short words that are equal where two rooms are furnished alike, or two plans have the same graph."""

from collections.abc import Iterable, Mapping, Sequence
from hashlib import blake2b

from solver.scene import Furniture


def room_signature(furniture: Iterable[Furniture]) -> str:
    """Returns a room's pieces and the walls they stand at, whatever their order and exact places."""
    return _digest(sorted(f"{piece.name} {piece.wall or 'free'}" for piece in furniture))


def graph_signature(labels: Mapping[str, str], edges: Sequence[tuple[str, str]]) -> str:
    """Returns a word that is the same for graphs that differ in the names and order of their nodes only.

    By colour refinement (Weisfeiler and Lehman 1968): a node's colour is its label, then again and again its own colour with those of its
    neighbours. Few graphs that differ get one word; so it never counts too many.
    """
    beside: dict[str, list[str]] = {name: [] for name in labels}
    for one, other in edges:
        beside[one].append(other)
        beside[other].append(one)
    colours = dict(labels)
    for _ in labels:
        colours = {name: _digest([colours[name], *sorted(colours[other] for other in beside[name])]) for name in labels}
    return _digest(sorted(colours.values()))


def _digest(words: Iterable[str]) -> str:
    return blake2b("\n".join(words).encode(), digest_size=8).hexdigest()
