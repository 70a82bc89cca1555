"""What relations that are asked for say: one list of words, and where they are sought they hold, whoever stands there."""

from __future__ import annotations

from itertools import product
from random import Random
from typing import get_args

import pytest

from catalogs import load_catalogs
from catalogs.checks import BETWEEN, BY_DEGREE, EVERY, KEYS, TO_SOMETHING
from catalogs.schema import RelationSpec, RelationWord
from solver.geometry import Rect, turned
from solver.pieces import Candidate
from solver.relations.held import Standing, holds_in_room, holds_with, traits
from solver.relations.subject import RELATION_WORDS, Kind
from tests.furnish.reference.slots import SIDES
from tests.relations.ways import SCOPE, beside, holding

KINDS = [Kind.of(name, load_catalogs()) for name in ("dining_table", "dining_chair", "sofa", "desk", "bookshelf", "ottoman")]


def spec_of(word: str, **more: object) -> RelationSpec:
    return RelationSpec.model_validate({"type": word, "cost": 6.0, **more})


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
    """What takes an `of` gives places at another piece; what does not, or may name an opening, places in the room."""
    table, chair = KINDS[:2]
    lamp = Kind("lamp", (300, 300, 400))
    found = any(beside(spec_of(word, of=["it"]), own, table) for own in (chair, lamp))
    assert found == (word in BETWEEN + TO_SOMETHING) or word in ("near_door", "far_from_door")
    spec = spec_of(word, of=["door"] if word in TO_SOMETHING else [])
    assert bool(holding(spec, chair, table)) == (word not in BETWEEN)


@pytest.mark.parametrize("word", BETWEEN + TO_SOMETHING)
def test_a_piece_sent_to_a_box_holds_the_relation_at_its_corners(word: str) -> None:
    random, tried = Random(7), 0
    for _ in range(50):
        own, other = random.sample(KINDS, 2)
        rotation = random.choice([0, 90, 180, 270])
        more = {"align": random.choice(["back", "centre", "front"])} if word in {"beside", "in_front_of"} and random.random() < 0.5 else {}
        spec = spec_of(word, of=["it"], **more)
        for way in beside(spec, own, other) if word != "on" else []:
            for own_body, its in corners(way, own, other, rotation):
                tried += 1
                assert holds_with(spec, own_body, its), (spec, own.name, other.name, rotation, way)
    assert tried > 50 or word == "on"


def corners(way: Candidate, own: Kind, other: Kind, rotation: int) -> list[tuple[Standing, Standing]]:
    """Returns the piece at the corners of its box, and the other one, so turned: about the origin of the room."""
    assert way.attach is not None
    turn = (way.rotation + rotation) % 360
    (width, depth), (wide, deep) = turned(*own.size[:2], turn), turned(*other.size[:2], rotation)
    its = Standing("it", Rect(-(wide // 2), -(deep // 2), wide - wide // 2, deep - deep // 2), rotation)
    right, front = {0: ((1, 0), (0, 1)), 90: ((0, -1), (1, 0)), 180: ((-1, 0), (0, -1)), 270: ((0, 1), (-1, 0))}[rotation]
    found = []
    for across, along in product(way.attach.across_mm, way.attach.along_mm):
        x, z = across * right[0] + along * front[0] - width // 2, across * right[1] + along * front[1] - depth // 2
        found.append((Standing("own", Rect(x, z, x + width, z + depth), turn), its))
    return found


@pytest.mark.parametrize("word", [word for word in RELATION_WORDS if word not in BETWEEN])
def test_a_piece_sent_to_a_region_holds_the_relation_in_its_corners(word: str) -> None:
    tried = 0
    for at_walls, name in product((True, False), ("door", "window") if word in TO_SOMETHING else (None,)):
        spec, own = spec_of(word, of=[name] if name else []), Kind("own", (700, 400, 800), at_walls)
        for way in holding(spec, own, KINDS[0]):
            assert way.within is not None
            (x0, z0, x1, z1), (width, depth) = way.within, way.extent
            for x, z in product((x0, x1 - width), (z0, z1 - depth)):
                tried += 1
                body = Standing("own", Rect(x, z, x + width, z + depth), way.rotation, wall=way.wall)
                assert holds_in_room(SCOPE, spec, body, (name,) if name else ()), (spec, way, x, z)
    assert tried > 3
