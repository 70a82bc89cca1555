"""What carries things inside furniture: where the boards and drawers of shapes are, and nothing in the room above them."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from catalogs import CatalogError, load_catalogs
from catalogs.insides import InsideSurface, insides_of
from catalogs.shapes import Solid
from tests.every import every

KNOWN = load_catalogs()
INSIDES = {kind: found for kind, entry in KNOWN.furniture.items() if (found := insides_of(KNOWN.shapes[kind], entry.size))}
HOLDING = sorted(kind for kind in INSIDES if (entry := KNOWN.decorating.get(KNOWN.name_of(kind))) and entry.holds)
Box = tuple[tuple[float, float], ...]


def metres(kind: str, solid: Solid) -> Box:
    width, depth, height = KNOWN.furniture[kind].size
    (x0, x1), (y0, y1), (z0, z1) = solid.x, solid.y, solid.z
    return ((x0 - 0.5) * width, (x1 - 0.5) * width), (y0 * height, y1 * height), ((z0 - 0.5) * depth, (z1 - 0.5) * depth)


def shared(one: Box, other: Box) -> float:
    return min(min(a[1], b[1]) - max(a[0], b[0]) for a, b in zip(one, other, strict=True))


@every("kind", INSIDES)
def test_an_inside_is_free_and_lies_on_a_board(kind: str) -> None:
    for one in INSIDES[kind]:
        free = one.x, (one.height + 1e-4, one.height + one.clearance), one.z
        assert all(shared(free, metres(kind, solid)) <= 0.0011 for solid in KNOWN.shapes[kind]), one
        below = one.x, (one.height - 0.002, one.height), one.z
        boards = [metres(kind, solid) for solid in KNOWN.shapes[kind] if solid.board is not None and solid.front == one.drawer]
        assert any(all(a[0] <= b[0] + 1e-6 and b[1] - 1e-6 <= a[1] for a, b in zip(board, below, strict=True)) for board in boards)


@every("kind", INSIDES)
def test_what_lies_in_a_drawer_passes_all_that_stays(kind: str) -> None:
    depth = KNOWN.furniture[kind].size[1]
    for one in INSIDES[kind]:
        if one.sort == "drawers":
            way = one.x, (one.height + 1e-4, one.height + one.clearance), (one.z[0], one.z[1] + depth)
            staying = [metres(kind, solid) for solid in KNOWN.shapes[kind] if solid.front != one.drawer]
            assert all(shared(way, other) <= 0.0011 or other[2][0] >= one.z[1] - 0.03 for other in staying), one.drawer


def test_boards_between_uprights_and_drawers_are_told_apart() -> None:
    wardrobe = INSIDES["wardrobe"]
    assert [one.sort for one in wardrobe] == ["shelves"] * 6
    assert [one.x[0] < 0 for one in wardrobe] == [True, False] * 3
    assert [one.drawer for one in INSIDES["dresser"]] == [
        f"{row}_drawer{image}" for row, image in product(("top", "middle", "low"), ("", "_2"))
    ]
    assert {one.sort for one in INSIDES["medium_wardrobe"]} == {"shelves", "drawers"}
    assert "bookshelf" not in INSIDES
    assert "bed" not in INSIDES


def test_mirrored_kinds_have_mirrored_insides() -> None:
    left, right = INSIDES["left_corner_counter"], INSIDES["right_corner_counter"]

    def turned_round(one: InsideSurface) -> tuple[float, ...]:
        return tuple(round(value, 6) for value in (-one.x[1], -one.x[0], *one.z, one.height, one.clearance))

    assert sorted(map(turned_round, left)) == sorted(
        tuple(round(v, 6) for v in (*one.x, *one.z, one.height, one.clearance)) for one in right
    )


def test_clothes_plates_and_food_have_a_place_inside() -> None:
    held = {name for entry in KNOWN.decorating.values() for row in entry.holds for name in row.put}
    assert {"long_clothes", "hanging_clothes", "vegetables", "juice_bottle"} <= held
    assert {"folded_clothes", "plate_stack", "food_can", "food_box", "milk_carton", "silverware", "shoe_pair"} <= held
    assert len(HOLDING) >= 30


@pytest.mark.parametrize("kind", ["wardrobe", "medium_wardrobe", "small_wardrobe"])
def test_clothes_reach_from_a_board_to_the_rail(kind: str) -> None:
    """So that they stand in simulators and are seen to hang: their hooks end at most 2 cm below it."""
    size = KNOWN.furniture[kind].size
    rail = next(solid for solid in KNOWN.shapes[kind] if solid.form == "cylinder" and solid.axis == "x")
    under = [one for one in INSIDES[kind] if one.height + one.clearance == pytest.approx(rail.y[0] * size[2])]
    assert under
    for one in under:
        fits = [KNOWN.decorations[name].size[2] for name in ("long_clothes", "hanging_clothes")]
        assert 0.011 <= one.clearance - max(height for height in fits if height <= one.clearance) <= 0.02


SLIPS = {
    "wardrobe: {holds: [{put: wardrobe_lamp, surface: shelves}]}": ("wardrobe.holds.0.put", "wardrobe_lamp"),
    "wardrobe: {holds: [{put: bowl, surface: top}]}": ("wardrobe.holds.0", "shelves"),
    "wardrobe: {holds: [{put: bowl}]}": ("wardrobe.holds.0.surface", "is missing"),
    "dresser: {holds: [{put: bowl, surface: shelves}]}": ("dresser.holds.0.surface", "no shelves inside"),
    "nightstand: {holds: [{put: storage_box, surface: drawers}]}": ("nightstand.holds.0.put", "larger"),
    "bed: {holds: [{put: bowl, surface: drawers}]}": ("bed.holds.0.surface", "no drawers inside"),
    "wall_shelf: {holds: [{put: bowl, surface: shelves}]}": ("wall_shelf.holds", "furniture alone"),
    "kitchen: {holds: [{put: bowl, surface: shelves}]}": ("kitchen.holds", "furniture alone"),
    "wardrobe: {holds: [{put: bowl, surface: shelves, most: 9}]}": ("wardrobe.holds.0.most", "8"),
}


@pytest.mark.parametrize("row", SLIPS)
def test_a_slip_is_told(tmp_path: Path, row: str) -> None:
    key, says = SLIPS[row]
    (tmp_path / "decorating.yaml").write_text(row)
    with pytest.raises(CatalogError) as caught:
        load_catalogs(tmp_path)
    assert caught.value.key.startswith(key)
    assert says in f"{caught.value.problem} {caught.value.allowed}"


def test_homes_follow_from_what_is_free_inside(tmp_path: Path) -> None:
    """Another board inside what holds things is another fingerprint; another look of what holds none is not."""
    (tmp_path / "shapes").mkdir()
    (tmp_path / "shapes" / "own.yaml").write_text("pantry: [{form: box, hollow: {boards: [0.5]}}]\n")
    assert load_catalogs(tmp_path).fingerprint != KNOWN.fingerprint
    (tmp_path / "shapes" / "own.yaml").write_text("bathtub: [{form: box, y: [0, rim]}]\n")
    assert load_catalogs(tmp_path).fingerprint == KNOWN.fingerprint
