"""What relations that are asked for say: one list of words, and where they are sought they hold, whoever stands there."""

from __future__ import annotations

from random import Random
from typing import get_args

import pytest

from catalogs import load_catalogs
from catalogs.checks import BETWEEN, BY_DEGREE, TO_SOMETHING
from catalogs.relation_keys import EVERY, KEYS
from catalogs.schema import RelationSpec, RelationWord
from solver.geometry import ROTATION_AT_WALL, Rect, turned
from solver.pieces import Opened
from solver.relations.asking import HeldBox, Standing, boxes, holds_in_room, holds_with, regions, traits
from solver.relations.rows import RELATION_WORDS
from solver.relations.subject import Footing, Kind, Scope
from tests.furnish.reference.slots import SIDES

CLEAR = Rect(0, 0, 5000, 4000)
SCOPE = Scope(CLEAR, (Opened("door", "south", (1000, 1900), 4000), Opened("window", "north", (2000, 3400), 0)))
KINDS = [Kind.of(name, load_catalogs()) for name in ("dining_table", "dining_chair", "sofa", "desk", "bookshelf", "ottoman")]


def spec_of(word: str, **more: object) -> RelationSpec:
    return RelationSpec.model_validate({"type": word, **more})


def test_the_vocabulary_is_whole() -> None:
    assert get_args(RelationWord) == RELATION_WORDS
    assert KEYS.keys() == {*RELATION_WORDS}
    assert {key for keys in (EVERY, *KEYS.values()) for key in keys} == RelationSpec.model_fields.keys()


def test_what_each_is_like_is_what_the_catalogs_take_it_for() -> None:
    assert {word for word in RELATION_WORDS if traits(word).gives_place} == {*SIDES, "on"}
    assert {word for word in RELATION_WORDS if traits(word).with_all} == {"far_from", "far_from_door"}
    assert {*BY_DEGREE} <= {word for word in RELATION_WORDS if traits(word).by_degree or traits(word).turns}
    assert {word: traits(word).usual_mm for word in ("near", "far_from")} == {"near": 1500, "far_from": 2000}
    assert {word for word in RELATION_WORDS if traits(word).at_walls} == {"against_wall", "in_row", "opposite"}


@pytest.mark.parametrize("word", RELATION_WORDS)
def test_each_relation_says_where_it_holds_as_the_catalogs_let_it_be_used(word: str) -> None:
    """What takes an `of` has boxes; what does not, or may name an opening, has regions."""
    spec = spec_of(word, of=["door"])
    table, chair = KINDS[:2]
    lamp = Kind("lamp", (300, 300, 400))
    found = [box for own in (chair, lamp) for turn in (0, 90, 180, 270) for box in boxes(spec, own, table, turn)]
    assert bool(found) == (word in BETWEEN + TO_SOMETHING) or word in ("near_door", "far_from_door")
    rects = regions(SCOPE, spec, Footing(180, "south", (600, 400), Rect(0, 3570, 5000, 3970)))
    assert bool(rects) == (word not in BETWEEN and word != "facing")
    assert all(rect.x0 <= rect.x1 and rect.z0 <= rect.z1 for rect in rects)


@pytest.mark.parametrize("word", BETWEEN + TO_SOMETHING)
def test_a_piece_sent_to_a_box_holds_the_relation_at_its_corners(word: str) -> None:
    random, tried = Random(7), 0
    for _ in range(200):
        own, other = random.sample(KINDS, 2)
        turn, rotation = random.choice([0, 90, 180, 270]), random.choice([0, 90, 180, 270])
        more = {"align": random.choice(["back", "centre", "front"])} if word in {"beside", "in_front_of"} and random.random() < 0.5 else {}
        spec = spec_of(word, of=["it"], **more)
        for place in boxes(spec, own, other, turn) if word != "on" else []:
            for own_body, its in corners(place, own, other, (turn, rotation)):
                tried += 1
                assert holds_with(spec, own_body, its), (spec, own.name, other.name, turn, rotation, place)
    assert tried > 50 or word == "on"


def corners(place: HeldBox, own: Kind, other: Kind, turns: tuple[int, int]) -> list[tuple[Standing, Standing]]:
    """Returns the piece at the corners of a box, and the other one, so turned: about the origin of the room."""
    turn, rotation = turns
    (width, depth), (wide, deep) = turned(*own.size[:2], turn + rotation), turned(*other.size[:2], rotation)
    its = Standing("it", Rect(-(wide // 2), -(deep // 2), wide - wide // 2, deep - deep // 2), rotation)
    right, front = {0: ((1, 0), (0, 1)), 90: ((0, -1), (1, 0)), 180: ((-1, 0), (0, -1)), 270: ((0, 1), (-1, 0))}[rotation]
    found = []
    for across, along in ((x, z) for x in (place.box.x0, place.box.x1) for z in (place.box.z0, place.box.z1)):
        x, z = across * right[0] + along * front[0] - width // 2, across * right[1] + along * front[1] - depth // 2
        found.append((Standing("own", Rect(x, z, x + width, z + depth), (turn + rotation) % 360), its))
    return found


@pytest.mark.parametrize("word", [word for word in RELATION_WORDS if word not in BETWEEN])
def test_a_piece_sent_to_a_region_holds_the_relation_in_its_corners(word: str) -> None:
    tried = 0
    for wall, rotation in [*ROTATION_AT_WALL.items(), (None, 0), (None, 180)]:
        for name in ("door", "window") if word in TO_SOMETHING else (None,):
            spec = spec_of(word, of=[name] if name else [])
            width, depth = turned(700, 400, rotation)
            reach = {
                "north": Rect(0, 30, 5000, 30 + depth), "south": Rect(0, 3970 - depth, 5000, 3970), "west": Rect(30, 0, 30 + width, 4000),
                "east": Rect(4970 - width, 0, 4970, 4000), None: CLEAR,
            }[wall]  # fmt: skip
            for rect in regions(SCOPE, spec, Footing(rotation, wall, (width, depth), reach)):
                x0, x1 = max(rect.x0, reach.x0), min(rect.x1, reach.x1) - width
                z0, z1 = max(rect.z0, reach.z0), min(rect.z1, reach.z1) - depth
                for x, z in ((x, z) for x in (x0, x1) for z in (z0, z1) if x0 <= x1 and z0 <= z1):
                    tried += 1
                    own = Standing("own", Rect(x, z, x + width, z + depth), rotation, wall=wall)
                    assert holds_in_room(SCOPE, spec, own, (name,) if name else ()), (spec, wall, rect, x, z)
    assert tried > 3
