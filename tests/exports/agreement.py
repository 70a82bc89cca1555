"""Whether a format's files say of a house what its description says."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Final

from solver.exports import Files, HouseModel
from solver.exports.model import ModelBody
from tests.exports.readers import Seen

MM: Final = 0.001
DEGREE: Final = 0.1
NOT_READ: Final[Mapping[str, str]] = {
    "nav2": "a map of cells: its own tests walk it",
    "tasks": "poses and paths: their own tests walk them",
    "png": "pictures: their own tests look at them",
}
"""Formats that hold no bodies."""
READ_AS: Final = {"usdc": "usd", "usdz": "usd", "arena": "usd"}
"""Formats that the reader of another one reads."""
NOT_HELD: Final[Mapping[str, Callable[[ModelBody], bool]]] = {"boxes": lambda body: body.sort != "furniture"}
"""Which bodies a format leaves out, and says so in docs/exports.md."""


def reader_of(format: str) -> Callable[[Files], Mapping[str, Seen]]:
    """Returns what reads a format's files."""
    read: Callable[[Files], Mapping[str, Seen]] = import_module(f"tests.exports.readers.{READ_AS.get(format, format)}").read
    return read


def differences(model: HouseModel, seen: Mapping[str, Seen], format: str = "file") -> list[str]:
    """Returns in words what files say otherwise than the description."""
    left_out = NOT_HELD.get(format, lambda _: False)
    bodies = {body.id: body for body in model.bodies if not left_out(body)}
    found = [f"{format}: {name!r} is missing" for name in bodies if name not in seen]
    found += [f"{format}: {name!r} is nobody's" for name in seen if name not in bodies]
    return found + [f"{format}: {name!r}: {word}" for name, body in bodies.items() if name in seen for word in _wrong(body, seen[name])]


def _box(body: ModelBody) -> tuple[float, float, float]:
    return body.width, body.depth, body.height


def _filled(body: ModelBody) -> tuple[float, float, float]:
    """How much of its box a body's parts fill, m: what formats of bare geometry can be measured for."""
    ends = [[(part.at[k] - part.size[k] / 2, part.at[k] + part.size[k] / 2) for part in body.parts] for k in (0, 2, 1)]
    width, depth, height = (max(high for _, high in axis) - min(low for low, _ in axis) for axis in ends)
    return width, depth, height


def _wrong(body: ModelBody, seen: Seen) -> list[str]:
    pairs = {"x": (body.x, seen.x), "y": (body.y, seen.y), "z": (body.z, seen.z)}
    wrong = [f"{name} is {theirs}, not {ours}" for name, (ours, theirs) in pairs.items() if abs(ours - theirs) > MM]
    for word, box, parts, theirs in zip(("width", "depth", "height"), _box(body), _filled(body), seen[4:7], strict=True):
        if min(abs(box - theirs), abs(parts - theirs)) > MM:
            wrong.append(f"{word} is {theirs}, not {box} (its parts fill {parts:.4f})")
    turn = (body.turn - seen.turn + 180) % 360 - 180
    if abs(turn) > DEGREE:
        wrong.append(f"turn is {seen.turn}, not {body.turn}")
    if seen.mass is not None and not math.isclose(seen.mass, body.mass, rel_tol=0.001, abs_tol=1e-4):
        wrong.append(f"mass is {seen.mass}, not {body.mass}")
    return wrong
