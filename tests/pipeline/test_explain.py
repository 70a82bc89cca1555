"""explain(): what holds a piece is there and at it; of what was changed nothing is claimed."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from catalogs import load_catalogs
from compose_homes import Explained, PieceRequest, RelationSpec, Request, Scene, SceneError, explain, generate, place, validate
from solver.answers import HOLDERS
from solver.core import ask
from solver.furnish import room_types
from solver.geometry import Rect
from solver.pieces import Attach, Candidate, Piece, Space
from solver.pipeline.explain import AT_PLACE, BALANCED, CHANGED, AsFurnished, _floor_holder, other_ways
from solver.placement import opened
from solver.scene import Furniture, Room
from tests.told_forms import has_form

POSE = ("kind", "x", "y", "z", "rotation", "width", "depth", "height", "on")
EXAMPLE = Path(__file__).parents[2] / "catalogs" / "example"
GAP = 0.045
"""Pieces that touch are at most this far apart, m: 3 cm are kept at walls."""
WALKED = 1.2
"""Floor that a person needs, or that is better kept free, is at most this deep, m."""
TOUCHING = 0.015
"""A piece at its wish is this close to it, m: the solve is rounded to millimetres, and slivers are tidied away since."""


@pytest.fixture(scope="module")
def home() -> Scene:
    return generate(Request(seed=9, program="family", decorate=True)).scene


@pytest.fixture(scope="module")
def answers(home: Scene) -> list[tuple[Room, Furniture, Explained]]:
    return [(room, piece, explain(home, piece.id)) for room in home.rooms[:9] for piece in room.furniture]


def test_every_piece_of_a_fresh_home_is_explained(home: Scene, answers: list[tuple[Room, Furniture, Explained]]) -> None:
    known = {piece.id for room in home.rooms for piece in room.furniture} | {o.id for room in home.rooms for o in room.openings}
    assert len(answers) > 30
    for room, piece, answer in answers:
        assert (answer.id, answer.room, answer.stands) == (piece.id, room.id, (piece.x, piece.z))
        assert CHANGED not in answer.notes
        assert not (answer.holds and {AT_PLACE, BALANCED} & set(answer.notes))
        assert {hold.by for hold in answer.holds} - {None} <= known - {piece.id}
        assert {hold.what for hold in answer.holds} <= set(HOLDERS)
        assert all(hold.message.endswith(f": {hold.cost_per_m:.2f} a metre") for hold in answer.holds)
        assert [hold.cost_per_m for hold in answer.holds] == sorted((hold.cost_per_m for hold in answer.holds), reverse=True)
    assert sum(len(answer.holds) for *_, answer in answers) > 20


def test_a_piece_at_its_wish_is_held_by_nothing(answers: list[tuple[Room, Furniture, Explained]]) -> None:
    there = [answer for *_, answer in answers if AT_PLACE in answer.notes]
    assert len(there) > 3
    for answer in there:
        assert answer.wished is not None and not answer.holds
        assert answer.stands == pytest.approx(answer.wished, abs=TOUCHING)


def test_a_wall_that_holds_is_there(answers: list[tuple[Room, Furniture, Explained]]) -> None:
    walls = [(room, piece, hold) for room, piece, answer in answers for hold in answer.holds if hold.what == "wall"]
    assert walls
    for room, piece, hold in walls:
        wide, deep = (piece.width, piece.depth) if piece.rotation % 180 == 0 else (piece.depth, piece.width)
        gaps = {
            "west": piece.x - wide / 2, "east": room.width - piece.x - wide / 2,
            "north": piece.z - deep / 2, "south": room.depth - piece.z - deep / 2,
        }  # fmt: skip
        # It, or what it moves with: a group's members stand within a few metres of one another.
        assert gaps[hold.towards] < 3.0


def test_what_holds_a_piece_is_of_its_kind_and_lies_on_the_side_that_is_said(answers: list[tuple[Room, Furniture, Explained]]) -> None:
    seen = Counter[str]()
    for room, piece, answer in answers:
        others, openings = {one.id: one for one in room.furniture}, {one.id: one.kind for one in room.openings}
        for hold in answer.holds:
            seen[hold.what] += 1
            if hold.what in ("piece", "use_side"):
                other = others[str(hold.by)]
                further = {"east": other.x - piece.x, "south": other.z - piece.z}
                further |= {"west": -further["east"], "north": -further["south"]}
                assert further[hold.towards] > 0
            elif hold.what in ("door", "window"):
                assert openings[str(hold.by)] in (("window",) if hold.what == "window" else ("door", "passage", "garage_door"))
    assert {"piece", "use_side", "door", "floor"} <= seen.keys()


HELD = re.compile(
    r"kept(?: with (\S+))? from going further \w+ by .*?"
    r"(?:, as (?:a person needs )?floor at (\S+?)( is better kept free)?)?: [\d.]+ a metre"
)


def test_what_holds_a_piece_touches_the_one_that_is_named_or_floor_at_it(answers: list[tuple[Room, Furniture, Explained]]) -> None:
    seen = Counter[tuple[bool, bool]]()
    for room, piece, answer in answers:
        there = {one.id: _box(one) for one in room.furniture}
        for hold in (hold for hold in answer.holds if hold.what in ("piece", "wall")):
            told = HELD.fullmatch(hold.message)
            assert told
            along, floor_at = told[1], told[2]
            assert floor_at in (None, along or piece.id) and along != piece.id
            seen[along is not None, floor_at is not None] += 1
            inner = room.width - 0.05, room.depth - 0.05
            walls = {
                "west": (-1, 0, 0.05, inner[1]),
                "north": (0, -1, inner[0], 0.05),
                "east": (inner[0], 0, 99, 99),
                "south": (0, inner[1], 99, 99),
            }
            mine, other = there[along or piece.id], there[hold.by] if hold.by else walls[hold.towards]
            axis, sign = int(hold.towards in ("north", "south")), 1 if hold.towards in ("east", "south") else -1
            between = other[axis] - mine[axis + 2] if sign > 0 else mine[axis] - other[axis + 2]
            aside = max(other[1 - axis] - mine[3 - axis], mine[1 - axis] - other[3 - axis])
            assert aside <= (WALKED if floor_at else GAP)
            assert between <= (WALKED if floor_at else GAP)
            assert floor_at or between >= -TOUCHING
    assert set(seen) == {(along, floor) for along in (False, True) for floor in (False, True)}


def _box(piece: Furniture) -> tuple[float, float, float, float]:
    wide, deep = (piece.width, piece.depth) if piece.rotation % 180 == 0 else (piece.depth, piece.width)
    return piece.x - wide / 2, piece.z - deep / 2, piece.x + wide / 2, piece.z + deep / 2


def test_of_a_changed_room_nothing_is_claimed(home: Scene) -> None:
    room = home.rooms[1]
    moved = replace(room.furniture[0], x=room.furniture[0].x + 0.01)
    changed = replace(home, rooms=(home.rooms[0], replace(room, furniture=(moved, *room.furniture[1:])), *home.rooms[2:]))
    answer = explain(changed, moved.id)
    assert (answer.wished, answer.holds, answer.notes) == (None, (), (CHANGED,))
    untouched = home.rooms[2].furniture[0].id
    assert explain(changed, untouched) == explain(home, untouched)


def test_of_a_list_that_was_placed_nothing_is_claimed() -> None:
    """What `/place` answers is certified, but no seed and no room type say how it was wished."""
    scene = place(Room("study", width=3.6, depth=3.0), [PieceRequest("desk", relations=(RelationSpec(type="against_wall"),))]).best.scene
    answer = explain(scene, "desk")
    assert (answer.wished, answer.holds, answer.notes, answer.ways) == (None, (), (CHANGED,), ())


def test_another_version_made_it(home: Scene) -> None:
    older = replace(home, generator={"version": "0.0.1", "catalog": (home.generator or {})["catalog"]})
    (note,) = explain(older, home.rooms[1].furniture[0].id).notes
    assert note.startswith("made with another version of Compose: 0.0.1, this is ")
    assert has_form(note)


def test_another_catalog_made_it(home: Scene) -> None:
    """A room as it was made, asked about with a folder laid over the catalogs: the catalog is another, not the room."""
    other = load_catalogs(EXAMPLE)
    id = home.rooms[1].furniture[0].id
    (note,) = explain(home, id, catalogs=other).notes
    assert note.startswith("made with another catalog: ")
    assert str((home.generator or {})["catalog"]) in note and other.fingerprint in note
    assert has_form(note)


def test_a_home_made_for_access_is_explained_too() -> None:
    made = generate(Request(seed=5, program="studio", access="din_18040_2")).scene
    room = next(room for room in made.rooms if room.type == "living_room")
    answers = [explain(made, piece.id) for piece in room.furniture]
    assert any(answer.wished for answer in answers)
    assert not any("made with" in note or note == CHANGED for answer in answers for note in answer.notes)


def test_the_whole_message_names_bodies_by_the_ids_of_the_scene() -> None:
    """Kitchens have counters by several labels of the search; in the scene they are counted together."""
    floors = 0
    for seed in range(42, 52):
        house = generate(Request(seed=seed, program="studio")).scene
        kitchen = next(room for room in house.rooms if room.type == "kitchen")
        for hold in (hold for piece in kitchen.furniture for hold in explain(house, piece.id).holds if hold.what == "floor"):
            assert hold.by in {piece.id for piece in kitchen.furniture}
            assert f"of {hold.by}, which is better kept free" in hold.message
            floors += 1
    assert floors


def test_floor_to_turn_in_is_nobodys() -> None:
    turning = Candidate("(floor)", (1500, 1500, 1800), 0, None, (2000, 1500), cost=0.0)
    holder = _floor_holder(Piece("floor to turn in", False, (turning,), is_floor=True), {})
    assert (holder.what, holder.by, holder.words) == ("floor", None, "floor to turn in, which is better kept free")


def test_an_unknown_id_is_named(home: Scene) -> None:
    with pytest.raises(SceneError, match="no_such"):
        explain(home, "no_such")


def named(message: str) -> set[str]:
    """The ids that a way's message names."""
    return {word.rstrip(",;") for word in message.split() if "/" in word}


def test_other_ways_are_at_other_walls_or_turned_otherwise(
    answers: list[tuple[Room, Furniture, Explained]],
) -> None:
    ways = [(piece, way) for _, piece, answer in answers for way in answer.ways]
    assert len(ways) > 40
    for _, piece, answer in answers:
        costs = [way.cost for way in answer.ways if way.cost is not None]
        assert costs == sorted(costs)
        assert len({(way.wall, way.rotation) for way in answer.ways}) == len(answer.ways)
        assert all((way.wall, way.rotation) != (piece.wall, piece.rotation) for way in answer.ways)
    cheaper = [way for _, way in ways if (way.cost or 0.0) < 0]
    assert cheaper
    assert all(("not for what is decided first" in way.message) == (not way.left_out) for way in cheaper)
    for piece, way in ways:
        own = [move for move in way.moves if move.id == piece.id]
        assert [move.rotation for move in own] == ([] if way.cost is None else [way.rotation])
        assert (way.cost is None) == way.message.endswith("no place was found for it so")
        assert all(name in way.message for name in way.left_out)
        assert all(name in {move.id for move in way.moves} | set(way.left_out) for name in named(way.message))


def test_what_would_stand_elsewhere_can(home: Scene, answers: list[tuple[Room, Furniture, Explained]]) -> None:
    """The validator, which knows nothing of placement, finds no fault in the rooms that the ways make."""
    tried = 0
    for room, _, answer in answers:
        for way in [way for way in answer.ways if way.cost is not None][:2]:
            at = {move.id: move for move in way.moves}
            furniture = tuple(
                replace(one, wall=None, **{key: getattr(at[one.id], key) for key in POSE}) if one.id in at else one
                for one in room.furniture
                if one.id not in way.left_out
            )
            bare = replace(room, furniture=furniture, decorations=())
            house = replace(home, rooms=tuple(bare if one.id == room.id else one for one in home.rooms), dynamic=())
            found = [issue for issue in validate(house) if issue.severity == "error" and issue.room == room.id]
            assert [issue for issue in found if issue.rule != "missing_required"] == []
            tried += 1
    assert tried > 20


def at_wall(label: str, *ways: tuple[str, int, float], width: int = 1000) -> Piece:
    """A required piece of that width, 0.5 m deep: walls with the x or z that is wished there and what it costs."""
    turn = {"north": 0, "south": 180, "west": 90}
    spot = {"north": (0, 280), "south": (0, 2720), "west": (280, 0)}
    candidates = [
        Candidate(label, (width, 500, 800), turn[wall], wall, (spot[wall][0] or wish, spot[wall][1] or wish), cost=cost)
        for wall, wish, cost in ways
    ]
    return Piece(label, True, tuple(candidates))


def test_what_a_way_costs_is_what_one_reckons_by_hand() -> None:
    """At the south wall two pieces wished at one place stand 1 m apart: 0.5 squared twice. At the west wall nothing is in the way."""
    space = Space("den", Rect(0, 0, 4000, 3000), (), ())
    pieces = (at_wall("bed", ("south", 2000, 0.0)), at_wall("desk", ("north", 2000, 0.0), ("south", 2000, 1.25), ("west", 1200, 3.0)))
    room = AsFurnished(space, pieces, opened(space, pieces, tidy=True), {"bed": "den/bed", "desk": "den/desk"})
    assert [(way.wall, way.cost) for way in other_ways(room, "desk")] == [("south", 1.75), ("west", 3.0)]
    south, west = other_ways(room, "desk")
    assert {move.id: abs(move.x - 2) for move in south.moves} == {"den/bed": pytest.approx(0.5), "den/desk": pytest.approx(0.5)}
    assert [move.id for move in west.moves] == ["den/desk"]
    assert "den/bed would stand elsewhere" in south.message
    assert other_ways(room, "bed") == ()


def test_a_way_says_what_all_would_stand_on() -> None:
    """A set stands on one of two shelves, 0.8 and 1.2 m high; the desk at the west wall takes the lower one's place."""

    def upon(shelf: str, bottom: int, cost: float) -> Candidate:
        attach = Attach(shelf, shelf, (0, 0), (0, 0), "on top 0")
        return Candidate("set", (300, 300, 300), 0, None, (0, 0), cost=cost, bottom_mm=bottom, attach=attach, on=shelf)

    low = Piece("low", False, (Candidate("low", (800, 400, 800), 90, "west", (230, 800)),), skip_cost=2.0)
    high = at_wall("high", ("south", 3500, 0.0))
    set_ = Piece("set", True, (upon("low", 800, 0.0), upon("high", 1200, 1.0)))
    desk = at_wall("desk", ("north", 2000, 0.0), ("west", 800, 0.0), width=1600)
    space = Space("den", Rect(0, 0, 4000, 2200), (), ())
    ids = {label: f"den/{label}" for label in ("low", "high", "set", "desk")}
    pieces = (high, desk, low, set_)
    west = next(way for way in other_ways(AsFurnished(space, pieces, opened(space, pieces, tidy=True), ids), "desk") if way.wall == "west")
    assert west.left_out == ("den/low",)
    assert [(move.on, move.y) for move in west.moves if move.id == "den/set"] == [("den/high", 1.2)]
    assert [(move.on, move.y) for move in west.moves if move.id == "den/desk"] == [(None, 0.0)]
    before = {label: id for label, id in ids.items() if label != "high"}  # as of a room in which that one has no place
    west = next(
        way for way in other_ways(AsFurnished(space, pieces, opened(space, pieces[1:], tidy=True), before), "desk") if way.wall == "west"
    )
    assert [(move.on, move.y) for move in west.moves if move.id == "den/set"] == [(None, 1.2)]


def test_a_way_for_which_there_is_no_room_has_no_cost() -> None:
    space = Space("den", Rect(0, 0, 4000, 1500), (), ())
    pieces = (at_wall("bed", ("south", 2000, 0.0), width=2500), at_wall("desk", ("north", 2000, 0.0), ("south", 2000, 0.0), width=2000))
    room = AsFurnished(space, pieces, opened(space, pieces, tidy=True), {"bed": "den/bed", "desk": "den/desk"})
    (way,) = other_ways(room, "desk")
    assert (way.wall, way.cost, way.moves) == ("south", None, ())


def test_what_a_room_wants_is_asked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    scene, asked = generate(Request(seed=1, width=7, depth=5)).scene, list[str]()

    def noted(entry: str, *rows: bytes) -> bytes:
        asked.append(entry)
        return ask(entry, *rows)

    monkeypatch.setattr(room_types, "ask", noted)
    piece = next(piece for room in scene.rooms for piece in room.furniture)
    assert explain(scene, piece.id).notes != (CHANGED,)
    assert asked == ["furnish"]
