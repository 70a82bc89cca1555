"""Drags as the page does them: a piece goes through its room from point to point, frame by frame, each from the answer of the last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache

from catalogs import load_catalogs
from solver import Request, Scene, generate
from solver.pipeline.drag import NO_ANSWER, Dragging, FrameAnswer, alone, opening_of
from solver.scene import Decoration, Dynamic, Furniture
from solver.scene_bodies import bodies_of
from solver.streams import Stream

Body = Furniture | Decoration | Dynamic
STEP_M = 0.08
"""How far the pointer goes between two frames."""


@dataclass(frozen=True)
class Step:
    """A frame that was asked, and its answer."""

    wish: tuple[float, float]
    before: tuple[float, ...]
    answer: FrameAnswer


@cache
def home(seed: int, program: str = "family") -> Scene:
    return generate(Request(seed=seed, program=program, decorate=True)).scene


def dense_rooms(seed: int, program: str = "family", least: int = 7) -> list[Scene]:
    """The rooms of a home with so many pieces, each alone."""
    scene = home(seed, program)
    return [alone(scene, room) for room in scene.rooms if len(room.furniture) >= least]


def way(scene: Scene, label: str, frames: int, seed: int = 0) -> Iterator[tuple[float, float]]:
    """Where the pointer goes: from the piece's place to points all over the room."""
    stream, room = Stream(seed, f"drag of {label}"), scene.rooms[0]
    body = next(one for one in bodies_of(scene) if one.id == label)
    x, z = body.x, body.z
    to = x, z
    for _ in range(frames):
        while abs(to[0] - x) + abs(to[1] - z) < STEP_M:
            to = round(stream.unit() * room.width, 3), round(stream.unit() * room.depth, 3)
        far = ((to[0] - x) ** 2 + (to[1] - z) ** 2) ** 0.5
        share = min(1.0, STEP_M / far)
        x, z = round(x + (to[0] - x) * share, 3), round(z + (to[1] - z) * share, 3)
        yield x, z


def spots_of(scene: Scene) -> tuple[float, ...]:
    return tuple(value for body in bodies_of(scene) for value in (body.x, body.z))


def dragged(scene: Scene, label: str, frames: int, seed: int = 0) -> list[Step]:
    """The frames of one drag; none where the piece cannot be dragged by itself."""
    opening = opening_of(scene, label, (), load_catalogs())
    if opening is None:
        return []
    drag, spots, steps = Dragging(opening), spots_of(scene), list[Step]()
    for wish in way(scene, label, frames, seed):
        answer = drag.frame(*wish, spots)
        steps.append(Step(wish, spots, answer))
        spots = spots if answer.outcome == NO_ANSWER else answer.spots
    return steps


def scene_at(scene: Scene, spots: Sequence[float], label: str) -> Scene:
    """The scene with all its bodies at those spots; the piece in hand stands at no wall."""
    at = iter(zip(spots[::2], spots[1::2], strict=True))

    def moved(body: Body) -> Body:
        x, z = next(at)
        at_spot = replace(body, x=x, z=z)
        return replace(at_spot, wall=None) if isinstance(at_spot, Furniture) and body.id == label else at_spot

    bodies = [moved(body) for body in bodies_of(scene)]
    furniture = tuple(body for body in bodies if isinstance(body, Furniture))
    things = tuple(body for body in bodies if isinstance(body, Decoration))
    people = tuple(body for body in bodies if isinstance(body, Dynamic))
    return replace(scene, rooms=(replace(scene.rooms[0], furniture=furniture, decorations=things),), dynamic=people)


def neighbours(scene: Scene, label: str) -> list[int]:
    """The numbers of the pieces that are not in hand, nor go along as the chairs of a table do, nor stand on another."""
    found = []
    for number, piece in enumerate(scene.rooms[0].furniture):
        if piece.id != label and label not in (piece.under, piece.on):
            found.append(number)
    return found


def jump(step: Step, among: Sequence[int]) -> float:
    """How far the farthest of some bodies went in a frame, m."""
    if step.answer.outcome == NO_ANSWER:
        return 0.0
    after, before = step.answer.spots, step.before
    return max((((after[2 * k] - before[2 * k]) ** 2 + (after[2 * k + 1] - before[2 * k + 1]) ** 2) ** 0.5 for k in among), default=0.0)
