"""Shapes under test, from the YAML as it is written and the catalogs as they are served; nothing here is the loader's."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

import catalogs
from catalogs import CatalogError, load_catalogs
from tests.every import every

OURS = Path(catalogs.__file__).parent


def plain(file: Path) -> dict[str, Any]:
    """Returns what a file of YAML says; libyaml reads it ten times as fast."""
    return dict(yaml.load(file.read_text(), yaml.CSafeLoader))


FILES = sorted((OURS / "shapes").glob("*.yaml"))
WRITTEN: dict[str, list[dict[str, Any]]] = {
    name: parts for file in FILES for name, parts in plain(file).items()
}  # fmt: skip
MATERIALS: dict[str, Any] = plain(OURS / "materials.yaml")
KNOWN = load_catalogs().model_dump(mode="json")
KINDS: dict[str, Any] = KNOWN["furniture"] | KNOWN["decorations"]
FORMS = {"box", "rounded", "cylinder", "cone", "ball", "capsule"}
ROUND = {"cylinder", "cone", "ball", "capsule"}
Ends = dict[str, tuple[float, float]]


def box_of(kind: str, part: dict[str, Any]) -> Ends:
    """Returns a served part's ends in metres of its kind."""
    width, depth, height = KINDS[kind]["size"]
    return {axis: (part[axis][0] * length, part[axis][1] * length) for axis, length in (("x", width), ("y", height), ("z", depth))}


def shared(one: Ends, other: Ends, axes: str) -> list[float]:
    return [min(one[axis][1], other[axis][1]) - max(one[axis][0], other[axis][0]) for axis in axes]


def area_of(kind: str, surface: dict[str, Any]) -> Ends:
    width, depth, _ = KINDS[kind]["size"]
    inset = surface["inset"]
    return {"x": (inset, width - inset), "z": (inset, depth - inset)}


@every("kind", KINDS)
def test_every_kind_has_a_shape(kind: str) -> None:
    assert 1 <= len(KNOWN["shapes"][kind]) <= 48


def test_no_shape_stands_in_two_files_or_is_of_no_use() -> None:
    assert len(WRITTEN) == sum(len(plain(file)) for file in FILES)
    names = {entry.get("shape") or kind for kind, entry in KINDS.items()} | {entry.get("name") for entry in KINDS.values()}
    poses = {f"{kind}_{pose}" for kind in KINDS for pose in ("seated", "upright")}
    assert set(WRITTEN) <= names | poses


@every("kind", KINDS)
def test_parts_are_ones_and_lie_within_the_body(kind: str) -> None:
    for part in KNOWN["shapes"][kind]:
        assert part["form"] in FORMS and part["material"] in MATERIALS and part["axis"] in ("x", "y", "z")
        assert all(0 <= part[axis][0] < part[axis][1] <= 1 for axis in "xyz"), part
        assert (part["taper"] == 0) == (part["form"] == "cone") and part["taper"] >= 0


@every("kind", KINDS)
def test_no_part_stands_twice(kind: str) -> None:
    places = [tuple(tuple(round(end, 6) for end in part[axis]) for axis in "xyz") for part in KNOWN["shapes"][kind]]
    assert len(places) == len(set(places))


@every("kind", [kind for kind, entry in KNOWN["furniture"].items() if entry["category"] != "dynamic"])
def test_the_parts_reach_the_bodys_box(kind: str) -> None:
    boxes = [box_of(kind, part) for part in KNOWN["shapes"][kind]]
    for axis, length in zip("xzy", KINDS[kind]["size"], strict=True):
        assert min(box[axis][0] for box in boxes) <= 0.02, axis
        assert max(box[axis][1] for box in boxes) >= length - 0.02, axis


@every("kind", [kind for kind, entry in KINDS.items() if entry["surfaces"]])
def test_every_surface_is_the_top_of_parts(kind: str) -> None:
    """Counted on a grid of points: what lies there is carried by what is drawn."""
    parts = [(part["form"], box_of(kind, part)) for part in KNOWN["shapes"][kind]]
    for surface in KINDS[kind]["surfaces"]:
        area = area_of(kind, surface)
        tops = [(form, box) for form, box in parts if abs(box["y"][1] - surface["height"]) <= 0.01]
        points = [tuple(low + (high - low) * (i + 0.5) / 20 for low, high in [area[axis]]) for axis in "xz" for i in range(20)]
        carried = sum(any(under(x[0], z[0], form, box) for form, box in tops) for x in points[:20] for z in points[20:])
        assert carried >= 80, surface["name"]


def under(x: float, z: float, form: str, box: Ends) -> bool:
    u, v = ((2 * at - sum(box[axis])) / (box[axis][1] - box[axis][0]) for at, axis in ((x, "x"), (z, "z")))
    return u * u + v * v <= 1 if form in ROUND else max(abs(u), abs(v)) <= 1


@every("kind", [kind for kind, entry in KNOWN["furniture"].items() if entry["surfaces"]])
def test_nothing_of_a_piece_rises_through_its_surfaces(kind: str) -> None:
    for surface in KINDS[kind]["surfaces"]:
        free = area_of(kind, surface) | {"y": (surface["height"] + 0.012, surface["height"] + (surface["clearance"] or 9.0))}
        for part in KNOWN["shapes"][kind]:
            assert min(shared(box_of(kind, part), free, "xyz")) <= 0.005, (surface["name"], part)


@every("kind", KNOWN["furniture"])
def test_no_two_faces_flicker(kind: str) -> None:
    """Two boxes' faces that look the same way, share an area and lie in one plane would be drawn by turns."""
    parts = [box_of(kind, part) for part in KNOWN["shapes"][kind] if part["form"] in ("box", "rounded")]
    for i, one in enumerate(parts):
        for other in parts[:i]:
            for axis in "xyz":
                for end in (0, 1):
                    flush = abs(one[axis][end] - other[axis][end]) < 0.0035
                    area = shared(one, other, "xyz".replace(axis, ""))
                    assert not flush or min(area) <= 0.002 or is_covered(one, other, (axis, end), parts), (one, other, axis)


def is_covered(one: Ends, other: Ends, face: tuple[str, int], parts: list[Ends]) -> bool:
    """Tells whether the middle of two faces' common area lies in or under another part, or on the floor."""
    axis, end = face
    middle = {way: (max(one[way][0], other[way][0]) + min(one[way][1], other[way][1])) / 2 for way in "xyz"}
    middle[axis] = one[axis][end] + (-0.004, 0.004)[end]
    on_floor = axis == "y" and end == 0 and middle["y"] < 0
    return on_floor or any(all(part[way][0] <= middle[way] <= part[way][1] for way in "xyz") for part in parts)


def test_mirror_images_and_surfaces_are_written_out() -> None:
    legs = [part for part in WRITTEN["dining_table"] if part.get("mirror") == "xz"]
    assert len(legs) == 1
    (low, high), height = legs[0]["x"], KINDS["dining_table"]["size"][2]
    served = [part for part in KNOWN["shapes"]["dining_table"] if part["y"] == legs[0]["y"]]
    ends = {tuple(round(end, 6) for end in part["x"]) for part in served}
    assert len(served) == 4 and ends == {(low, high), (round(1 - high, 6), round(1 - low, 6))}
    top = next(part for part in KNOWN["shapes"]["dining_table"] if part["y"][1] == 1)
    assert top["y"][1] * height == KINDS["dining_table"]["surfaces"][0]["height"]


THRONE = "throne: {category: seating, size: [1.0, 1.0, 2.0], color: '#ddaa00', mass: 80, stands: free, surfaces: [%s]}\n"
SEAT = "{name: seat, height: 0.5}"


def overlay(folder: Path, shape: str, surfaces: str = SEAT) -> Path:
    (folder / "shapes").mkdir()
    (folder / "furniture.yaml").write_text(THRONE % surfaces)
    (folder / "shapes" / "seats.yaml").write_text(f"throne:\n  - {shape}\n")
    return folder


def test_a_shape_of_ones_own_is_served_and_makes_no_other_home(tmp_path: Path) -> None:
    (tmp_path / "materials.yaml").write_text("gilt: {color: '#ffd700', metalness: 0.9}\n")
    known = load_catalogs(overlay(tmp_path, "{form: box, y: [0.1, seat], material: gilt}\n  - {form: cone, y: [seat, 1]}"))
    assert [(part.form, part.y, part.taper) for part in known.shapes["throne"]] == [("box", (0.1, 0.25), 1), ("cone", (0.25, 1), 0)]
    assert known.materials["gilt"].color == "#ffd700" and known.shapes["bed"] == load_catalogs().shapes["bed"]
    (tmp_path / "shapes" / "seats.yaml").write_text("throne:\n  - {form: ball, y: [0, seat]}\n")
    assert load_catalogs(tmp_path).fingerprint == known.fingerprint


def test_a_kind_of_ones_own_may_go_without(tmp_path: Path) -> None:
    (tmp_path / "furniture.yaml").write_text(
        THRONE % SEAT + "bed: {category: bed, size: [1, 2, 1], color: '#112233', mass: 9, stands: wall}\n"
    )
    known = load_catalogs(tmp_path)
    assert not {"throne", "bed"} & set(known.shapes), "ours is no shape for a bed without a mattress"
    assert "sofa" in known.shapes


SLIPS = {
    "{form: box, material: gold}": ("throne.0.material", "unknown material"),
    "{form: box, y: [0, sat]}": ("throne.0.y", "no surface"),
    "{form: box, y: [0.5, seat]}": ("throne.0.y", "0.250"),
    "{form: box, y: [0, 0.4]}": ("throne", "hardly any part"),
    "{form: box, x: [0.2, 1.2]}": ("throne.0.x.1", "is 1.2 a number from 0 to 1"),
    "{form: box, y: [0.2, 1.2]}": ("throne.0.y", "within"),
    "{form: box, x: [0.6, 0.2]}": ("throne.0.x", "lower"),
    "{form: egg}": ("throne.0.form", "box"),
    "{form: ball, axis: x}": ("throne.0", "no axis"),
    "{form: box, taper: 0.5}": ("throne.0", "no taper"),
    "{form: cone, mirror: x, axis: x}": ("throne.0", "mirrored"),
    "{form: box, colour: red}": ("throne.0.colour", "is not known"),
}


@pytest.mark.parametrize("shape", SLIPS)
def test_a_fault_names_file_key_and_line(tmp_path: Path, shape: str) -> None:
    key, says = SLIPS[shape]
    with pytest.raises(CatalogError) as caught:
        load_catalogs(overlay(tmp_path, shape))
    error = caught.value
    assert error.file == str(tmp_path / "shapes" / "seats.yaml")
    assert (error.key.startswith(key), error.line) == (True, 1 if key == "throne" else 2), str(error)
    assert says in f"{error.problem} {error.allowed}"


def test_a_style_changes_only_what_it_names(tmp_path: Path) -> None:
    (tmp_path / "styles.yaml").write_text("bare: {palette: {}, materials: {wood: {color: '#ffffff', texture: null}}}\n")
    assert load_catalogs(tmp_path).model_dump(mode="json")["styles"]["bare"]["materials"] == {"wood": {"color": "#ffffff", "texture": None}}
    (tmp_path / "styles.yaml").write_text("bare: {palette: {}, materials: {wod: {roughness: 1}}}\n")
    with pytest.raises(CatalogError, match="unknown material"):
        load_catalogs(tmp_path)
