"""Scenes judged by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from random import Random
from struct import pack
from typing import TypeVar

from catalogs import load_catalogs
from solver import generate
from solver.core import ask
from solver.request import Request
from solver.scene import Decoration, Furniture, Scene
from solver.validator.kinds import kinds_of
from solver.validator.sent_rooms import NumberedKinds, room_bytes
from solver.validator.walk import judged_storey, storeys
from solver.validator.world import world_of
from tests.core.native import Native

Thing = TypeVar("Thing", Furniture, Decoration)

KNOWN = load_catalogs()
ANSWERS = ("judge_storey", "free_floors", "measure_storey")


def thrown_about(scene: Scene, chance: Random) -> Scene:
    """A scene with a third of its things pushed, turned and stretched, and of its openings and rooms pushed."""

    def thrown(body: Thing) -> Thing:
        if chance.random() < 0.7:
            return body
        x, z = body.x + chance.uniform(-1.5, 1.5), body.z + chance.uniform(-1.5, 1.5)
        return replace(body, x=x, z=z, rotation=chance.choice((0, 45, 90, -30, 270, 400)), height=body.height * chance.uniform(0.3, 2.0))

    def pushed(at: float) -> float:
        return at if chance.random() < 0.7 else at + chance.uniform(-1.0, 1.0)

    rooms = [
        replace(
            room,
            x=pushed(room.x),
            furniture=tuple(map(thrown, room.furniture)),
            decorations=tuple(map(thrown, room.decorations)),
            openings=tuple(replace(one, position=pushed(one.position)) for one in room.openings),
        )
        for room in scene.rooms
    ]
    return replace(scene, rooms=tuple(rooms))


def requests() -> list[tuple[str, Sequence[bytes]]]:
    """Homes as they are made and thrown about: every storey, and all of its rooms to be judged."""
    found, chance = list[tuple[str, Sequence[bytes]]](), Random("native")
    for seed, preset in enumerate(("studio", "one_bed", "family")):
        made = generate(Request(seed=seed, program=preset, decorate=True)).scene
        for scene in (made, thrown_about(made, chance), thrown_about(made, chance)):
            world, kinds = world_of(scene), NumberedKinds(kinds_of(KNOWN))
            for places in storeys(world):
                walk, _ = judged_storey(world, [(place, room_bytes(world, place, kinds)) for place in places], kinds)
                asked = pack(f"<{len(places)}q", *range(len(places)))
                found += [("judge_storey", (walk.rows, asked)), *((answer, (walk.rows,)) for answer in ANSWERS[1:])]
    return found


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    asked = requests()
    for call in ANSWERS:
        rows = [rows for name, rows in asked if name == call]
        assert rows
        numbers = [1 << 60, 1 << 60] if call == "judge_storey" else []
        assert native.answers(call, rows) == b"".join(ask(call, *one, numbers=numbers) for one in rows)
