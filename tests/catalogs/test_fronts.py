"""Which kinds open, and how: shapes as they are served, and the table of docs/fronts.md."""

from __future__ import annotations

import re
from math import hypot
from pathlib import Path

import pytest

from catalogs import CatalogError, load_catalogs
from catalogs.fronts import floor_before, fronts_of
from catalogs.shapes import Solid
from tests.architecture.tree import ROOT
from tests.catalogs.test_shapes import overlay
from tests.every import every

KNOWN = load_catalogs()
OPENING = {kind: found for kind in KNOWN.furniture if (found := fronts_of(KNOWN.shapes[kind]))}
STILL = {
    "is lain or sat on, and has no box": {
        "bed", "bunk_bed", "single_bed", "sofa", "armchair", "dining_chair", "office_chair", "bench", "hall_bench", "ottoman", "bar_stool",
        "kids_chair", "bean_bag", "outdoor_sofa", "outdoor_armchair", "deck_chair", "bistro_chair",
    },
    "is a top on legs": {"dining_table", "coffee_table", "side_table", "kids_table", "patio_table", "bistro_table"},
    "is open shelves": {"bookshelf", "storage_shelf", "toy_shelf"},
    "is a machine or a basin whose front is closed": {
        "water_heater", "drill_press", "table_saw", "wash_basin", "bathtub", "fireplace", "fire_pit", "pool", "hot_tub", "piano",
        "treadmill",
    },
    "is a hull without doors of its own in its shape": {"car", "bicycle", "lawn_mower", "play_tent"},
    "is open above": {"laundry_basket", "planter", "flower_bed"},
    "has a lid that swings by itself": {"trash_bin"},
    "hangs, shines, grows or lives": {
        "floor_lamp", "garden_lamp", "plant", "tree", "standing_mirror", "tv", "speaker", "swing_set", "parasol", "coat_rack",
        "drying_rack", "person", "child", "dog", "cat",
    },
}  # fmt: skip
"""Kinds without a front, by what scenes call them or by their own name, and why."""


def test_every_kind_opens_or_it_is_said_why_not() -> None:
    said = set().union(*STILL.values())
    for kind in KNOWN.furniture:
        is_said = kind in said or (KNOWN.name_of(kind) in said and kind not in OPENING)
        assert is_said != (kind in OPENING), kind
    assert said <= set(KNOWN.furniture) | {KNOWN.name_of(kind) for kind in KNOWN.furniture}
    assert len(OPENING) >= 29


def test_nothing_lies_on_a_lid_that_opens() -> None:
    lids = {
        KNOWN.name_of(kind): KNOWN.shapes[kind][front.parts[0]]
        for kind, fronts in OPENING.items()
        for front in fronts
        if front.opens == "lid"
    }
    assert {"toy_chest", "garden_box", "grill", "toilet"} <= set(lids)
    on_top = {name for name, lid in lids.items() if lid.y[1] >= 1.0 and KNOWN.decorating.get(name) and KNOWN.decorating[name].lies}
    assert on_top == set()


def test_a_lid_is_flat_or_hinged_at_something() -> None:
    """Open, the panel stands at its hinge: what is below the hinge there, shut, holds it."""
    for kind, fronts in OPENING.items():
        for front in fronts:
            lid, size = KNOWN.shapes[kind][front.parts[0]], KNOWN.furniture[kind].size
            thick = (lid.y[1] - lid.y[0]) * size[2]
            behind = any(one.front is None and one.y[1] >= lid.y[1] and one.z[1] <= lid.z[0] + 0.01 for one in KNOWN.shapes[kind])
            assert front.opens != "lid" or thick < 0.05 or behind, kind


def test_a_lid_that_no_floor_is_kept_for_stays_over_its_piece() -> None:
    """Its lower front edge, as far from its hinge as the diagonal, is what comes out first; what touches the piece would stop it."""
    found = set[str]()
    for kind, fronts in OPENING.items():
        (_, depth, height), solids = KNOWN.furniture[kind].size, KNOWN.shapes[kind]
        for lid in (solids[front.parts[0]] for front in fronts if front.opens == "lid"):
            edge = hypot((lid.z[1] - lid.z[0]) * depth, (lid.y[1] - lid.y[0]) * height)
            stays = lid.z[0] * depth + edge <= depth
            assert stays or floor_before(solids, KNOWN.furniture[kind].size) is not None, kind
            found |= {kind} if stays else set()
    assert "toilet" in found


def test_what_is_labelled_openable_opens() -> None:
    assert {kind for kind, entry in KNOWN.furniture.items() if "openable" in entry.labels} <= set(OPENING)


def test_the_table_of_the_docs_tells_what_opens() -> None:
    text = (ROOT / "docs" / "fronts.md").read_text()
    rows = dict(re.findall(r"^\| ([a-z_]+) \| (\d.+?) \|", text, re.M))
    assert set(rows) == set(OPENING)
    for kind, fronts in OPENING.items():
        counts = {opens: sum(front.opens == opens for front in fronts) for opens in ("left", "right", "up", "down", "lid", "drawer")}
        assert rows[kind] == ", ".join(f"{count} {opens}" for opens, count in counts.items() if count), kind


def metres(kind: str, solid: Solid) -> list[tuple[float, float]]:
    width, depth, height = KNOWN.furniture[kind].size
    return [(span[0] * size, span[1] * size) for span, size in ((solid.x, width), (solid.y, height), (solid.z, depth))]


def deep(one: list[tuple[float, float]], other: list[tuple[float, float]]) -> float:
    return min(min(a[1], b[1]) - max(a[0], b[0]) for a, b in zip(one, other, strict=True))


@every("kind", OPENING)
def test_a_front_is_apart_from_all_that_does_not_move_with_it(kind: str) -> None:
    solids = KNOWN.shapes[kind]
    for front in OPENING[kind]:
        for number in front.parts:
            for other in solids:
                if other.front != front.name:
                    assert deep(metres(kind, solids[number]), metres(kind, other)) <= 0.0015, (front.name, solids[number], other)


@every("kind", OPENING)
def test_a_drawer_comes_out_past_all_that_is_before_it(kind: str) -> None:
    """Drawn out whole, and on its way, nothing of it is in what does not move."""
    depth = KNOWN.furniture[kind].size[1]
    for front in OPENING[kind]:
        if front.slides:
            assert 0.1 < front.end * depth < depth
            still = [metres(kind, solid) for solid in KNOWN.shapes[kind] if solid.front != front.name]
            for number in front.parts:
                x, y, (low, high) = metres(kind, KNOWN.shapes[kind][number])
                assert all(deep([x, y, (low, high + front.end * depth)], other) <= 0.0015 for other in still), front.name


@every("kind", OPENING)
def test_a_drawer_is_a_tray(kind: str) -> None:
    for front in OPENING[kind]:
        if front.slides:
            trays = [solid for number in front.parts if (solid := KNOWN.shapes[kind][number]).board is not None]
            assert len(trays) == 4
            (bottom, *sides) = sorted((metres(kind, solid) for solid in trays), key=lambda box: box[1][1])
            assert all(abs(side[1][0] - bottom[1][1]) < 1e-6 and side[1][1] - side[1][0] > 0.02 for side in sides)


SLIPS = {
    "{form: box, y: [0, seat], opens: left}": ("throne.0", "name"),
    "{form: box, y: [0, seat], name: door}": ("throne.0", "name"),
    "{form: box, y: [0, seat], with: door}": ("throne.0.with", "no front"),
    "{form: box, y: [0, seat], name: door, opens: drawer}": ("throne.0.opens", "hollow"),
    "{form: box, y: [0, seat], name: door, opens: drawer, range: 40}": ("throne.0", "range"),
    "{form: ball, y: [0, seat], hollow: {}}": ("throne.0", "only a box"),
    "{form: box, x: [0, 0.03], y: [0, seat], hollow: {}}": ("throne.0.hollow", "18 mm"),
    "{form: box, y: [0, seat], mirror: z, name: door, opens: left}": ("throne.0", "mirrored"),
    "{form: box, x: [0, 0.4], y: [0, seat], mirror: x, name: door, opens: left}\n  - {form: box, y: [0, 0.1], with: door}":
        ("throne.1.with", "mirrored"),
    "{form: box, y: [0, seat], name: door, opens: left}\n  - {form: box, y: [0, 0.1], name: door, opens: up}":
        ("throne.0.name", "two fronts"),
    "{form: box, y: [0, seat], name: door, opens: sideways}": ("throne.0.opens", "left"),
}  # fmt: skip


@pytest.mark.parametrize("shape", SLIPS)
def test_a_fault_is_told(tmp_path: Path, shape: str) -> None:
    key, says = SLIPS[shape]
    with pytest.raises(CatalogError) as caught:
        load_catalogs(overlay(tmp_path, shape))
    assert caught.value.key.startswith(key)
    assert says in f"{caught.value.problem} {caught.value.allowed}"


def test_mirror_images_of_fronts_open_the_other_way(tmp_path: Path) -> None:
    shape = "{form: box, x: [0, 0.4], y: [0, seat], mirror: x, name: door, opens: left, range: 70}"
    known = load_catalogs(overlay(tmp_path, shape))
    assert [(front.name, front.opens, front.end) for front in fronts_of(known.shapes["throne"])] == [
        ("door", "left", -70.0), ("door_2", "right", 70.0),
    ]  # fmt: skip
