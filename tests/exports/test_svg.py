"""Plans as SVG: what is drawn where, and whether it can be read."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import combinations

import pytest

from catalogs import load_catalogs
from solver.exports import ExportSettings, describe, written_as
from solver.exports.model import DoorLeaf, HouseModel
from solver.exports.plan_rooms import PlanBox, label_box
from solver.exports.plan_storeys import drawing_ranks, marks_of, open_leaf, storeys_of
from solver.scene import Opening, Room, Scene
from solver.wall_fittings import FRAME
from tests.exports import homes
from tests.exports.readers import svg

ARC = re.compile(r"M(\S+) (\S+)A(\S+) \S+ 0 0 ([01]) (\S+) (\S+)")


def written(model: HouseModel) -> dict[str, bytes]:
    return written_as(model, ExportSettings("svg"))


def centre_of(arc: re.Match[str]) -> tuple[float, float]:
    """The centre of a quarter circle by its ends and the way it is drawn (SVG 1.1, F.6): at its right where it runs clockwise."""
    x0, y0, _, sweep, x1, y1 = map(float, arc.groups())
    way = 1 if sweep else -1
    return (x0 + x1) / 2 - way * (y1 - y0) / 2, (y0 + y1) / 2 + way * (x1 - x0) / 2


@pytest.mark.parametrize("name", ["own", "family"])
def test_arcs_turn_about_their_hinges_and_end_at_the_leaf(name: str) -> None:
    model = homes.described(name)
    (root,) = svg.plans(written(model))
    arcs = [found for path in root.iter(f"{svg.SVG}path") if (found := ARC.fullmatch(path.get("d", "")))]
    swinging = [leaf for leaf in model.leaves if leaf.motion == "swing"]
    assert len(arcs) == len(swinging) >= 7
    for arc, leaf in zip(arcs, swinging, strict=True):
        assert centre_of(arc) == pytest.approx((leaf.hinge[0] * 1000, leaf.hinge[2] * 1000), abs=2)


def test_leaves_open_to_the_side_and_from_the_end_that_the_scene_says() -> None:
    model = homes.described("own")
    leaves: dict[str, DoorLeaf] = {leaf.id: leaf for leaf in model.leaves}
    for opening in (one for one in model.openings if one.kind == "door"):
        stands = open_leaf(leaves[opening.id])
        along, across = (0, 1) if opening.axis == "x" else (1, 0)
        assert (stands.opened[across] - opening.line) * opening.towards > 0.5
        at_hinge, other = (opening.start, opening.end) if opening.hinge == "start" else (opening.end, opening.start)
        assert stands.opened[along] == pytest.approx(at_hinge, abs=FRAME + 0.001)
        assert stands.shut[along] == pytest.approx(other, abs=FRAME + 0.001)


@pytest.mark.parametrize("name", ["own", "family"])
def test_a_mark_points_at_the_main_entrance_from_outside(name: str) -> None:
    model = homes.described(name)
    (root,) = svg.plans(written(model))
    marks = [one for one in root.iter(f"{svg.SVG}polygon") if one.get("class") == "entrance"]
    doors = [one for one in model.openings if one.is_main_entrance]
    assert len(marks) == len(doors) == 1
    corners = [tuple(map(float, pair.split(","))) for pair in marks[0].get("points", "").split()]
    along, across = (0, 1) if doors[0].axis == "x" else (1, 0)
    line, middle = doors[0].line * 1000, (doors[0].start + doors[0].end) * 500
    tip = min(corners, key=lambda corner: abs(corner[across] - line))
    assert tip[along] == pytest.approx(middle, abs=1)
    assert sum(corner[along] for corner in corners) / 3 == pytest.approx(middle, abs=1)
    boxes = [[[pick(corner[axis] for corner in room.corners) * 1000 for axis in (0, 1)] for pick in (min, max)] for room in model.rooms]
    for corner in corners:
        assert abs(corner[across] - line) > doors[0].thickness * 500
        if doors[0].towards * (corner[across] - line) > 0:
            assert abs(corner[across] - line) > (doors[0].end - doors[0].start) * 1000
        assert not any(low[0] < corner[0] < high[0] and low[1] < corner[1] < high[1] for low, high in boxes)


def meet(one: PlanBox, other: PlanBox) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


@pytest.mark.parametrize("name", ["own", "family", "default"])
def test_no_word_is_written_over_another_nor_over_a_wall(name: str) -> None:
    (storey,) = storeys_of(homes.described(name))
    boxes = [label_box(label) for label in storey.labels]
    assert len(boxes) == len(storey.rooms)
    assert [pair for pair in combinations(boxes, 2) if meet(*pair)] == []
    assert [box for box in boxes for wall in storey.walls if meet(box, wall)] == []


def test_rooms_are_named_with_their_clear_areas_and_sizes() -> None:
    (root,) = svg.plans(written(homes.described("own")))
    texts = ["".join(text.itertext()) for text in root.iter(f"{svg.SVG}text")]
    assert {"Living room", "23.9 m²", "Office", "6.5 m²", "14.10", "10.10", "N"} <= set(texts)


def test_rooms_are_named_as_they_are_called() -> None:
    called = {"living_room": "Wohnzimmer <1>", "office": "Büro", "no_such_room": "Nichts"}
    scene = homes.described("own").scene
    rooms = tuple(replace(room, name="Aunt May's") if room.type == "office" else room for room in scene.rooms)
    (root,) = svg.plans(written_as(describe(replace(scene, rooms=rooms), load_catalogs()), ExportSettings("svg", called=called)))
    names = {text.text for text in root.iter(f"{svg.SVG}text") if text.get("class") == "name"}
    assert {"Wohnzimmer <1>", "Aunt May's"} <= names
    assert not {"Living room", "Office", "Büro"} & names


@pytest.mark.parametrize("scale", [75, 300])
def test_names_stay_between_the_walls_in_two_rows_where_one_is_too_long(scale: int) -> None:
    (storey,) = storeys_of(homes.described("family"), scale)
    rows = [label.rows for label in storey.labels]
    assert any(len(one) == 2 for one in rows) == (scale == 300)
    assert [box for box in map(label_box, storey.labels) for wall in storey.walls if meet(box, wall)] == []


@pytest.mark.parametrize("scale", [20, 100, 300])
@pytest.mark.parametrize("name", ["W" * 28, "Mehrzweckraumfüralles " * 3, "Music room of the two elder sisters"])
def test_names_are_cut_at_the_width_of_their_room_and_nowhere_else(name: str, scale: int) -> None:
    room = Room("den", type="living_room", name=name.strip(), width=3.35, depth=3.0)
    (storey,) = storeys_of(describe(Scene(rooms=(room,), wall_thickness=0.1), load_catalogs()), scale)
    (label,) = storey.labels
    assert " ".join(label.rows) == name.strip() or scale > 20
    assert max(map(len, label.rows)) * 0.65 * label.size <= (2.9 if label.upright else 3.25)
    for row, whole in zip(label.rows, (name.strip(),) if len(label.rows) == 1 else label.rows, strict=True):
        assert row == whole or (row.endswith("…") and (len(row) + 2) * 0.66 * label.size > 0.9 * 2.9)


@pytest.mark.parametrize("scale", [50, 75, 100, 125, 150])
@pytest.mark.parametrize("turned", [False, True])
def test_the_name_of_a_room_with_arms_stands_in_one_of_them(scale: int, turned: bool) -> None:
    """A hallway round a bedroom's corner: 4.5 m along one wall and 2.2 m along the other, 1.0 and 1.1 m wide."""
    arms = [(0.0, 1.2, 4.5, 2.2), (3.4, 0.0, 4.5, 2.2)]
    corners = [(3.4, 0.0), (4.5, 0.0), (4.5, 2.2), (0.0, 2.2), (0.0, 1.2), (3.4, 1.2)]
    if turned:
        arms, corners = [(z0, x0, z1, x1) for x0, z0, x1, z1 in arms], [(z, x) for x, z in reversed(corners)]
    width, depth = max(x for x, _ in corners), max(z for _, z in corners)
    hall = Room("hall", type="hallway", width=width, depth=depth, outline=tuple(corners))
    (storey,) = storeys_of(describe(Scene(rooms=(hall,), wall_thickness=0.1), load_catalogs()), scale)
    x0, z0, x1, z1 = label_box(storey.labels[0])
    assert any(a <= x0 and b <= z0 and x1 <= c and z1 <= d for a, b, c, d in arms)


def test_the_whole_is_the_outermost_chain_where_a_side_has_no_openings() -> None:
    """Two rooms beside each other, their doors to the south: what is seen from the north is their wall, then the whole."""
    doors = [(Opening(id=name, kind="door", wall="south", position=2.0, width=0.9, height=2.0),) for name in ("one", "two")]
    rooms = (Room("den", width=4, depth=3, openings=doors[0]), Room("lab", x=4, width=5, depth=3, openings=doors[1]))
    (storey,) = storeys_of(describe(Scene(rooms=rooms), load_catalogs()))
    north = sorted((line for line in storey.outside if line.axis == "x" and line.at < 0), key=lambda line: -line.at)
    assert [len(line.stops) for line in north] == [3, 2]


def test_the_plan_is_to_scale() -> None:
    model = homes.described("family")
    (storey,), (root,) = storeys_of(model), svg.plans(written(model))
    _, _, wide, high = map(float, root.attrib["viewBox"].split())
    on_paper = [float(root.attrib[key].removesuffix("mm")) for key in ("width", "height")]
    assert on_paper == pytest.approx([wide / storey.sheet.scale, high / storey.sheet.scale], abs=0.1)
    assert storey.sheet.scale == 50


A_SERIES = {(round(841 / 2 ** (n / 2)), round(1189 / 2 ** (n / 2))) for n in range(5)}
"""ISO 216: each size has half the floor of the one before, and its sides are as 1 to the root of 2; mm."""


@pytest.mark.parametrize("name", ["own", "family", "default"])
@pytest.mark.parametrize("scale", [None, 50, 75, 100])
def test_a_sheet_is_a_paper_with_the_house_in_its_middle_within_a_frame(name: str, scale: int | None) -> None:
    model = homes.described(name)
    (root,) = svg.plans(written_as(model, ExportSettings("svg", scale=scale)))
    left, top, wide, high = map(float, root.attrib["viewBox"].split())
    paper = tuple(sorted(float(root.attrib[key].removesuffix("mm")) for key in ("width", "height")))
    assert any(paper == pytest.approx(one, abs=1) for one in A_SERIES)
    if scale is None:
        assert paper[0] <= 297
    (drawn,) = (one.get("d", "") for one in root.iter(f"{svg.SVG}path") if one.get("class") == "frame")
    x0, z0, x1, z1, _, _, block = (float(number) for number in re.findall(r"-?\d+", drawn)[:7])
    unit = wide / float(root.attrib["width"].removesuffix("mm"))
    assert left < x0 < x1 < left + wide and top < z0 < block < z1 < top + high
    lines = "".join(one.get("d", "") for one in root.iter(f"{svg.SVG}path") if one.get("class") == "line")
    marks = [(float(x), float(z)) for x, z in re.findall(r"M(-?\d+) (-?\d+)", lines)]
    assert marks and all(x0 < x < x1 and z0 < z < block for x, z in marks)
    floors = [one.get("points", "") for one in root.iter(f"{svg.SVG}polygon") if one.get("class") == "floor"]
    xs, zs = zip(*(map(float, corner.split(",")) for points in floors for corner in points.split()), strict=True)
    assert abs(min(xs) + max(xs) - x0 - x1) < 2 * unit and abs(min(zs) + max(zs) - z0 - block) < 2 * unit


@pytest.mark.parametrize("scale", [20, 47, 75, 100, 163, 500])
def test_the_scale_bar_is_as_long_as_it_says(scale: int) -> None:
    (root,) = svg.plans(written_as(homes.described("own"), ExportSettings("svg", scale=scale)))
    (bar,) = (one for one in root.iter(f"{svg.SVG}g") if one.get("class") == "bar")
    parts = [(float(one.get("x", "")), float(one.get("width", ""))) for one in bar.iter(f"{svg.SVG}rect")]
    (words,) = (text.text or "" for text in bar.iter(f"{svg.SVG}text") if (text.text or "").endswith(" m"))
    assert sum(wide for _, wide in parts) == pytest.approx(float(words.removesuffix(" m")) * 1000)
    assert [x + wide for x, wide in parts[:-1]] == pytest.approx([x for x, _ in parts[1:]])
    assert 25 <= sum(wide for _, wide in parts) / scale <= 60


def test_a_scale_that_is_asked_for_is_kept() -> None:
    model = homes.described("family")
    for scale in (100, 200):
        files = written_as(model, ExportSettings("svg", scale=scale))
        (root,) = svg.plans(files)
        _, _, wide, _ = map(float, root.attrib["viewBox"].split())
        assert float(root.attrib["width"].removesuffix("mm")) == pytest.approx(wide / scale, abs=0.01)
        assert any(f"Scale 1:{scale} " in "".join(text.itertext()) for text in root.iter(f"{svg.SVG}text"))


def test_words_are_never_on_dark_furniture() -> None:
    """Relative luminance of every fill under a name at least 0.45: a contrast of 7:1 with the black of the names (WCAG AAA)."""
    text = written(homes.described("family"))["house_2024.svg"].decode()
    symbols = text[text.index("<defs>") : text.index("</defs>")]
    fills = set(re.findall(r'fill="#(\w{6})"', symbols))
    assert len(fills) > 20
    for fill in fills:
        linear = [((value / 255 + 0.055) / 1.055) ** 2.4 for value in bytes.fromhex(fill)]
        assert 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2] > 0.45


def test_what_lies_on_a_piece_is_drawn_over_it_unless_it_is_covered() -> None:
    model = homes.described("family")
    ranks = drawing_ranks(model.bodies)
    pillows = [body for body in model.bodies if body.name == "pillow" and body.parent]
    assert pillows
    assert all(ranks[body.id] > ranks[body.parent or ""] for body in pillows)
    assert drawing_ranks(model.bodies[::-1]) == ranks, "in whatever order they come"
    ring = [pillows[0]._replace(id=f"{k}", parent=f"{(k + 1) % 3000}") for k in range(3000)]
    assert drawing_ranks(ring).keys() == {body.id for body in ring}
    assert any(ranks[body.id] < ranks[body.parent] for body in model.bodies if body.parent in ranks)


def test_what_is_hidden_from_above_is_not_drawn() -> None:
    table = next(body for body in homes.described("family").bodies if body.name == "dining_table")
    marks = marks_of(table.parts)
    assert 0 < len(marks) < len(table.parts)
    assert math.isclose(marks[-1].width, table.width, abs_tol=1e-6)


def test_storeys_are_files_of_their_own_and_warnings_stand_inside() -> None:
    scene = Scene(rooms=(Room("a", width=4, depth=3), Room("b", level=2, width=3, depth=3)), seed=5)
    files = written(describe(scene, load_catalogs(), warnings=["<bad> & worse"]))
    assert list(files) == ["house_5_level_0.svg", "house_5_level_2.svg"]
    assert [[one.text for one in root.iter(f"{svg.SVG}desc")] for root in svg.plans(files)] == [["<bad> & worse"]] * 2


def test_a_house_without_rooms_is_an_empty_sheet() -> None:
    files = written(describe(Scene(), load_catalogs()))
    assert [root.tag for root in svg.plans(files)] == [f"{svg.SVG}svg"]
