"""Bodies that are told as rows, written by the core: the same text as that of the bodies themselves, whatever the rows hold."""

from __future__ import annotations

from dataclasses import replace
from random import Random
from unittest import mock

import pytest

from solver import core
from solver.body_rows import BODY, SIZE, DecorationRows, FurnitureRows, Look, LooksBySize, looks_in, told
from solver.exchange import dump_scene, dump_text, scene_text, write_scene
from solver.scene import Room, Scene

NAMES = ("bed", 'a "quoted" \\ chair', "Stuhl für Gäste", "\u2028 %s", "tab\tand\x7f", "n" * 300, "")
COLOURS = ("#123456", "", "\u00e9", '"')
FAR = 10**8


def random_rows(rng: Random, sort: str, count: int, carriers: int) -> tuple[bytes, LooksBySize]:
    """Returns rows of bodies that lie and hang anywhere, at the ends of millimetres and far off."""
    content, looks = b"", {}
    for _ in range(count):
        kind, size = rng.randrange(len(NAMES)), (rng.choice((1, 5, 10, 999, 1000, 123456)), rng.randrange(1, 9999), rng.randrange(FAR))
        category = rng.choice(NAMES) if sort == "furniture" else None
        metres = size[0] / 1000, size[1] / 1000, size[2] / 1000
        looks[kind, SIZE.pack(*size)] = Look(sort, NAMES[kind], rng.choice((None, "kind", NAMES[1])), metres, category)
        on, under = (rng.randrange(-1, carriers + count) for _ in range(2))
        turn = rng.randrange(-1, 4), rng.randrange(360), rng.randrange(-1, len(COLOURS)), rng.randrange(10**9), 0
        rect = [rng.choice((0, 1, -1, rng.randrange(-FAR, FAR), rng.randrange(-9999, 9999))) for _ in range(4)]
        content += BODY.pack(kind, on, under, *turn, *rect, rng.randrange(-5, 3000), *size)
    return content, looks


def random_room(seed: int) -> Room:
    """Returns a room whose furniture, and mostly whose things, are told as rows."""
    rng = Random(seed)
    bare = Room(f"{rng.choice(NAMES)} {seed}", index=seed, width=4, depth=3, accent=rng.choice((None, *NAMES)))
    count = rng.randrange(9)
    colours = {kind: rng.choice(NAMES) for kind in range(len(NAMES))}
    room = told(bare, FurnitureRows(*_of(random_rows(rng, "furniture", count, 0), bare), colours))
    if seed % 5 == 0:
        room = replace(bare, furniture=room.furniture)
    things = random_rows(rng, "decoration", rng.randrange(9), count)
    return told(room, DecorationRows(*_of(things, room), [COLOURS] * len(NAMES), [True] * len(NAMES))) if seed % 7 else room


def _of(rows: tuple[bytes, LooksBySize], room: Room) -> tuple[bytes, Room, list[Look]]:
    return rows[0], room, looks_in(*rows)


def random_scene(first: int) -> Scene:
    """Returns twenty such rooms."""
    return Scene(rooms=tuple(random_room(seed) for seed in range(first, first + 20)))


@pytest.mark.parametrize("first", range(0, 200, 20))
def test_told_bodies_are_written_as_the_bodies_are(first: int) -> None:
    scene = random_scene(first)
    with mock.patch.object(scene_text, "write_scene", side_effect=AssertionError("the rows were not written")):
        text = dump_scene(scene, "json")
    made = [replace(room, furniture=tuple(room.furniture), decorations=tuple(room.decorations)) for room in scene.rooms]
    bodies = replace(scene, rooms=tuple(made))
    assert text == dump_text(write_scene(bodies), "json") == dump_scene(bodies, "json")


def test_bodies_beside_unknown_keys_are_written() -> None:
    scene = random_scene(0)
    first, *others = scene.rooms
    for odd in (replace(scene, rooms=(replace(first, extra={"a": 1}), *others)), replace(scene, extra={"b": [2]})):
        assert dump_scene(odd, "json") == dump_text(write_scene(odd), "json")


def test_requests_that_are_cut_off_or_speak_of_what_is_not_there_are_refused() -> None:
    with mock.patch.object(core, "ask", wraps=core.ask) as asked:
        dump_scene(random_scene(0), "json")
    ((name, request),) = (call.args for call in asked.call_args_list)
    for cut in (0, 8, 16, len(request) // 2, len(request) - 8):
        with pytest.raises(core.CoreFailed, match="the request is none"):
            core.ask(name, request[:cut])
    for at in range(0, 12, 4):
        with pytest.raises(core.CoreFailed):
            core.ask(name, request[:at] + (10**6).to_bytes(4, "little") + request[at + 4 :])
