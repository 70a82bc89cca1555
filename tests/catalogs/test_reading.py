"""Reading the catalogs: what is wrong is named with its file, key and line."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from pydantic import ValidationError

import catalogs
from catalogs import CatalogError, load_catalogs

OURS = Path(catalogs.__file__).parent
Mend = Callable[[str, str, str], Path]


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    for name in ("furniture.yaml", "floorings.yaml", "decorations.yaml", "decorating.yaml", "people.yaml", "rooms"):
        source = OURS / name
        (shutil.copytree if source.is_dir() else shutil.copy)(source, tmp_path / name)
    return tmp_path


@pytest.fixture
def edit(tmp_path: Path) -> Mend:
    """Lays one file of ours, changed, over ours."""

    def change(file: str, old: str, new: str) -> Path:
        text = (OURS / file).read_text()
        assert old in text
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text(text.replace(old, new, 1))
        return tmp_path

    return change


def lines_of(directory: Path, file: str, word: str) -> list[int]:
    lines = (directory / file).read_text().splitlines()
    return [i for i, line in enumerate(lines, 1) if word in line]


def fault(directory: Path) -> CatalogError:
    with pytest.raises(CatalogError) as caught:
        load_catalogs(directory)
    return caught.value


def test_the_default_is_read_once_and_frozen() -> None:
    known = load_catalogs()
    assert load_catalogs() is known
    with pytest.raises(ValidationError):
        known.furniture["bed"].mass = 1.0  # type: ignore[misc]


def test_a_copy_has_the_same_fingerprint(copy: Path) -> None:
    known = load_catalogs(copy)
    assert known == load_catalogs()
    assert len(known.fingerprint) == 12 and int(known.fingerprint, 16) >= 0


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("furniture.yaml", "mass: 65", "mass: 66"),
        ("floorings.yaml", "#b08d57", "#b08d58"),
        ("people.yaml", "most: 4", "most: 3"),
        ("rooms/bedroom.yaml", "typical: 11.5", "typical: 11.6"),
    ],
)
def test_the_fingerprint_follows_every_file(edit: Mend, file: str, old: str, new: str) -> None:
    assert load_catalogs(edit(file, old, new)).fingerprint != load_catalogs().fingerprint


def test_a_comment_leaves_the_fingerprint_alone(edit: Mend) -> None:
    directory = edit("rooms/bedroom.yaml", "area:", "# said differently\narea:")
    assert load_catalogs(directory).fingerprint == load_catalogs().fingerprint


@dataclass(frozen=True)
class Slip:
    """A slip of the pen in a file, and what the error must name: a key, the line that holds a word, a word of the reason."""

    file: str
    old: str
    new: str
    key: str
    word: str
    says: str

    def __str__(self) -> str:
        return f"{self.file} {self.new}"


BEDROOM, KITCHEN, OFFICE, BATHROOM = (f"rooms/{name}.yaml" for name in ("bedroom", "kitchen", "office", "bathroom"))
FURNITURE, FLOORINGS, DECORATIONS, DECORATING, PEOPLE = (
    f"{name}.yaml" for name in ("furniture", "floorings", "decorations", "decorating", "people")
)
SLIPS = [
    Slip(BEDROOM, "flooring: wood", "flooring: lava", "flooring", "lava", "wood"),
    Slip(BEDROOM, "short_side: 2.4", "short_sid: 2.4", "short_sid", "short_sid", "is not known"),
    Slip(BEDROOM, "{kind: small_bed, cost: 1.2}", "{kind: small_bad, cost: 1.2}", "pieces.0.kinds.1.kind", "small_bad", "unknown kind"),
    Slip(BEDROOM, "of: desk,", "of: dask,", "pieces.9.rules.0.of", "of: dask", "nightstand"),
    Slip(BEDROOM, "type: under", "type: below", "pieces.9.rules.0.type", "type: below", "against_wall"),
    Slip(BEDROOM, "min: [7.0,", "min: [17.0,", "area", "17.0", "ordered"),
    Slip(BEDROOM, "single_bed: 1}]", "single_bad: 1}]", "requires.0.single_bad", "single_bad", "unknown piece name"),
    Slip(BEDROOM, "  - piece: nightstand", "  - piece: bed", "pieces.1.piece", "piece: bed", "twice"),
    Slip(KITCHEN, "{stove: 1}", "{stove: 2}", "requires.2", "stove: 2", "required"),
    Slip(KITCHEN, "- [dishwasher, sink,", f"- [{'dishwasher, ' * 16}sink,", "run.orders.0", "dishwasher, dishwasher", "at most 21"),
    Slip(BATHROOM, "behind: [bedroom,", "behind: [castle,", "plan.behind.0", "castle", "unknown room type"),
    Slip(OFFICE, "of: desk, gap: -0.3", "of: plant, gap: -0.3", "pieces.1.rules.0.of", "of: plant, gap", "circle"),
    Slip(OFFICE, "gap: -0.3", "gap: [0.3, 0.1]", "pieces.1.rules.0.gap", "gap: [0.3", "least"),
    Slip(OFFICE, "armchair, weight: 0.05}", "armchair, required: true}", "required", "armchair, required", "degree"),
    Slip(OFFICE, "armchair, weight: 0.05}", "armchair, distance: 1}", "rules.1.distance", "distance: 1", "takes no `distance`"),
    Slip(OFFICE, "armchair, weight: 0.05}", "armchair, cost: 1}", "rules.1.cost", "cost: 1", "takes no `cost`"),
    Slip(OFFICE, "{type: at_window,", "{type: at_window, distance: 1,", "pieces.0.rules.0.distance", "at_window, d", "takes no"),
    Slip(OFFICE, "{type: at_window,", "{type: at_window, of: desk,", "pieces.0.rules.0.of", "at_window, of", "takes no"),
    Slip(OFFICE, "type: under, of: desk, gap", "type: under, gap", "pieces.1.rules.0", "type: under", "needs"),
    Slip(FURNITURE, "height: 0.5, inset", "height: 0.95, inset", "bed.surfaces.0.height", "height: 0.95", "above"),
    Slip(FURNITURE, "size: [1.6, 2.0, 0.9]", "size: [1.605, 2.0, 0.9]", "bed.size.0", "1.605", "centimetres"),
    Slip(FURNITURE, "size: [1.6, 2.0, 0.9]", "size: [-1.6, 2.0, 0.9]", "bed.size.0", "-1.6", "is -1.6 a number above 0"),
    Slip(FURNITURE, "size: [1.6, 2.0, 0.9]", "size: [.nan, 2.0, 0.9]", "bed.size.0", ".nan", "is nan a number above 0"),
    Slip(FURNITURE, 'color: "#4169e1"', 'color: "blue"', "bed.color", "blue", "#rrggbb"),
    Slip(FURNITURE, "name: bed,", "name: bad,", "king_bed.name", "name: bad", "category"),
    Slip(DECORATIONS, "size: [0.09, 0.09, 0.1]", "size: [0.095, 0.09, 0.1]", "mug.size.0", "0.095", "centimetres"),
    Slip(DECORATIONS, "group: drinkware", "group: cups", "mug.group", "group: cups", "soft_goods"),
    Slip(DECORATIONS, "{name: cup, height: 0.06", "{name: cup, height: 0.07", "candle_holder.surfaces.0.height", "height: 0.07", "above"),
    Slip(
        DECORATIONS,
        "{name: cup, height: 0.06, inset: 0.01",
        "{name: cup, height: 0.06, inset: 0.05",
        "surfaces.0.inset",
        "inset: 0.05",
        "area",
    ),
    Slip(DECORATIONS, "mass: 4,\n", "mass: 4, jitter: true,\n", "wall_shelf.jitter", "mass: 4, jitter", "straight"),
    Slip(DECORATING, "armchair:", "armchiar:", "armchiar", "armchiar", "unknown parent"),
    Slip(DECORATING, "put: alarm_clock", "put: alarm_cluck", "nightstand.lies.2.put", "alarm_cluck", "unknown decoration"),
    Slip(
        DECORATING,
        "put: alarm_clock",
        "put: wall_art",
        "nightstand.lies.2.put",
        "put: wall_art, at: [[1, 0.45]]",
        "larger than its surface",
    ),
    Slip(DECORATING, "surface: [lower, upper]", "surface: [lower, uper]", "bunk_bed.lies.0.surface", "uper", "lower, upper"),
    Slip(DECORATING, "on: coaster, chance", "on: saucer, chance", "coffee_table.lies.4.on", "saucer", "unknown carrier"),
    Slip(DECORATING, "on: coaster, chance", "on: magazine, chance", "coffee_table.lies.4.on", "on: magazine", "no surface"),
    Slip(DECORATING, "of: [washer, dryer]", "of: [washer, drier]", "laundry.stands.0.of", "drier", "unknown piece"),
    Slip(DECORATING, "rooms: bathroom", "rooms: bathrom", "sink.lies.1.rooms", "bathrom}", "unknown room type"),
    Slip(DECORATING, "styles: [rustic,", "styles: [rusty,", "dining_chair.lies.0.styles", "rusty", "unknown style"),
    Slip(DECORATING, "where: middle, fill: 0.8, min", "where: centre, fill: 0.8, min", "indoor.stands.0.where", "where: centre", "middle"),
    Slip(DECORATING, "fill: 0.8, widest", "widest", "hallway.stands.0", "widest: 0.8", "go with"),
    Slip(DECORATING, "workshop:\n  stands:", "workshop:\n  lies:", "lies.0.where", "where", "is not known"),
    Slip(
        DECORATING,
        "microwave:\n  lies:\n    - {put: bowl",
        "parasol:\n  lies:\n    - {put: bowl",
        "parasol.lies.0.put",
        "{put: bowl, chance",
        "no surface",
    ),
    Slip(
        DECORATING,
        "wall_shelf:\n  lies:\n",
        "tray:\n  lies:\n    - {put: tray, min_scale: 0.5}\nwall_shelf:\n  lies:\n",
        "tray.lies",
        "  lies:",
        "circle",
    ),
    Slip(PEOPLE, "kinds: [dog, cat]", "kinds: [dog, cow]", "pet.kinds", "cow", "unknown kind"),
    Slip(PEOPLE, "otherwise: [dining_room", "otherwise: [dancing_room", "pet.otherwise", "dancing_room", "unknown room type"),
    Slip(PEOPLE, "poses: [stands, sits]", "poses: [stands, lies]", "people.poses.1", "poses: [stands, lies]", "roams"),
    Slip(PEOPLE, "poses: [roams]", "poses: [roams, sits]", "pet", "pet:", "goes with"),
    Slip(PEOPLE, "heights: [0.35, 0.6]", "heights: [0.65, 0.6]", "people.seats.heights", "seats:", "least"),
    Slip(PEOPLE, "chance: 0.7", "chance: 1.7", "pet.chance", "chance: 1.7", "is 1.7 a number above 0, up to 1"),
    Slip(FLOORINGS, '"#d9d9d4"', "12", "tile.color", "tile", "a text"),
]


@pytest.mark.parametrize("slip", SLIPS, ids=str)
def test_a_fault_names_file_key_and_line(edit: Mend, slip: Slip) -> None:
    directory = edit(slip.file, slip.old, slip.new)
    error = fault(directory)
    assert error.file == str(directory / slip.file)
    assert error.key.endswith(slip.key)
    # A slip that repeats a word is meant at its last place.
    assert error.line in lines_of(directory, slip.file, slip.word)
    assert slip.says in f"{error.problem} {error.allowed}"
    assert f"{slip.file}:{error.line}" in str(error)


@pytest.mark.parametrize(
    ("file", "old", "new", "says"),
    [
        (FURNITURE, "stands:", "stnads:", "stnads: is not known; stands? (allowed: shape, size,"),
        (BEDROOM, "type: under,", "type: unter,", "is 'unter'; under? (allowed: against_wall, "),
        (BEDROOM, "{kind: small_bed,", "{kind: small_bad,", "unknown kind 'small_bad'; small_bed?"),
        (BEDROOM, "of: desk,", "of: dask,", "unknown piece 'dask'; desk?"),
        (DECORATING, "armchair:", "armchiar:", "unknown parent 'armchiar'; armchair?"),
    ],
)
def test_a_misspelled_word_is_told_with_the_one_that_may_be_meant(edit: Mend, file: str, old: str, new: str, says: str) -> None:
    assert says in str(fault(edit(file, old, new)))


@pytest.mark.parametrize(
    ("file", "old", "new", "says"),
    [
        (
            BEDROOM,
            "area: {min: [7.0, 9.0], typical: 11.5, max: 16.0}",
            "area: 11.5",
            "area: is 11.5 (allowed: an object with min, typical, max)",
        ),
        (BEDROOM, "cover: [0.35, 0.46]", "cover: 0.4", "cover: is 0.4 (allowed: a list of 2 entries)"),
        (BEDROOM, "cover: [0.35, 0.46]", "cover: [0.3, 0.4, 0.5]", "cover: has 3 entries (allowed: a list of 2 entries)"),
        (BEDROOM, "flooring: wood\n", "", "flooring: is missing (allowed: a text)"),
        (
            BEDROOM,
            "{kind: small_bed, cost: 1.2}",
            "small_bed",
            "is 'small_bed' (allowed: an object with kind, cost, min_area, max_area, corner)",
        ),
        (BEDROOM, "short_side: 2.4", "short_side: wide", "short_side: is 'wide' (allowed: a number above 0, up to 100)"),
        (BEDROOM, "short_side: 2.4", "short_side: -1", "short_side: is -1 (allowed: a number above 0, up to 100)"),
    ],
)
def test_a_value_of_another_form_is_told_with_the_form_that_is_allowed(edit: Mend, file: str, old: str, new: str, says: str) -> None:
    assert says in str(fault(edit(file, old, new)))


def test_a_place_beyond_its_surface_is_named_by_keys_of_the_file_alone(tmp_path: Path) -> None:
    (tmp_path / "decorating.yaml").write_text("sofa:\n  lies:\n    - {put: pillow, at: [[0.5, 0.5], [1.15, 0.5]]}\n")
    error = fault(tmp_path)
    assert (error.key, error.line) == ("sofa.lies.0.at.1.0", 3)


def fault_of_pieces(directory: Path, *pieces: str) -> str:
    (directory / "rooms").mkdir()
    office = (OURS / OFFICE).read_text()
    lines = "".join(f"  - {{piece: {piece}}}\n" for piece in pieces)
    (directory / "rooms" / "den.yaml").write_text(office[: office.index("requires:")] + f"pieces:\n{lines}")
    return str(fault(directory))


def test_a_required_piece_at_one_that_may_be_left_out_is_said_to_be_that(tmp_path: Path) -> None:
    said = fault_of_pieces(tmp_path, "desk", "office_chair, required: true, rules: [{type: under, of: desk}]")
    assert "pieces.1.rules.0.of: 'office_chair' is required and refers to 'desk', which is not" in said
    assert "later" not in said


def test_a_last_piece_that_stands_with_the_next_is_a_fault(tmp_path: Path) -> None:
    assert "den.yaml:10: pieces.1.with_next: no piece comes after" in fault_of_pieces(tmp_path, "desk", "plant, with_next: true")


def test_a_shape_of_nothing_is_named_with_what_may_be_meant(tmp_path: Path) -> None:
    (tmp_path / "shapes").mkdir()
    (tmp_path / "shapes" / "own.yaml").write_text("sofa:\n  - {form: box, y: [0, seat]}\nsofaa:\n  - {form: box}\n")
    error = fault(tmp_path)
    assert (error.key, error.line) == ("sofaa", 3)
    assert "'sofaa'; sofa?" in str(error)


BROKEN = [
    Slip(BEDROOM, "flooring: wood", "flooring: [wood", "accent", "accent", "YAML"),
    Slip(BEDROOM, "flooring: wood", "flooring: wood\nflooring: tile", "flooring", "flooring: tile", "twice"),
    Slip(FURNITURE, "bench:\n", "bench:\n\t- x\n", "bench", "\t- x", "YAML"),
]


@pytest.mark.parametrize("slip", BROKEN, ids=str)
def test_broken_yaml_names_file_key_and_line(edit: Mend, slip: Slip) -> None:
    directory = edit(slip.file, slip.old, slip.new)
    error = fault(directory)
    assert error.file == str(directory / slip.file)
    assert error.line in lines_of(directory, slip.file, slip.word)
    assert error.key == slip.key
    assert slip.says in error.problem


@pytest.mark.parametrize("name", ["nowhere", "."])
def test_a_directory_without_catalogs_is_named(tmp_path: Path, name: str) -> None:
    assert fault(tmp_path / name).file == str(tmp_path / name)


@pytest.mark.parametrize(
    ("name", "meant"),
    [("rums.yaml", "rooms"), ("furnitures.yaml", "furniture"), ("room/kitchen.yaml", "rooms"), ("rooms/den.yml", "rooms"), ("x.yaml", "")],
)
def test_a_file_that_nobody_would_read_is_named(copy: Path, name: str, meant: str) -> None:
    (copy / name).parent.mkdir(exist_ok=True)
    (copy / name).write_text("{}\n")
    error = fault(copy)
    assert error.file == str(copy / name)
    assert error.problem == "is no file of a catalog" + (f"; {meant}?" if meant else "")
    assert "furniture.yaml" in error.allowed and "rooms/<type>.yaml" in error.allowed


def test_what_a_directory_says_lies_over_ours(tmp_path: Path) -> None:
    (tmp_path / "furniture.yaml").write_text(
        "bed: {category: bed, size: [1.5, 2.0, 0.8], color: '#112233', mass: 50, stands: wall}\n"
        "throne: {category: seating, size: [1.0, 1.0, 1.5], color: '#ddaa00', mass: 80, stands: free}\n"
    )
    ours, known = load_catalogs(), load_catalogs(tmp_path)
    assert known.furniture["bed"].size == (1.5, 2.0, 0.8)
    assert set(known.furniture) == {*ours.furniture, "throne"}
    assert (known.rooms, known.floorings) == (ours.rooms, ours.floorings)
    assert known.fingerprint != ours.fingerprint


def test_a_piece_without_a_surface_over_ours_only_goes_undecorated(tmp_path: Path) -> None:
    (tmp_path / "furniture.yaml").write_text(
        "stove: {category: appliance, size: [0.6, 0.6, 0.9], color: '#112233', mass: 50, stands: wall}\n"
    )
    assert load_catalogs(tmp_path).furniture["stove"].surfaces == ()
    (tmp_path / "decorating.yaml").write_text("stove:\n  lies:\n    - {put: pot}\n")
    error = fault(tmp_path)
    assert (error.file, error.key, error.line) == (str(tmp_path / "decorating.yaml"), "stove.lies.0.put", 3)


def test_a_row_of_ones_own_takes_the_place_of_ours(tmp_path: Path) -> None:
    (tmp_path / "decorations.yaml").write_text(
        "crown: {group: decor, size: [0.2, 0.2, 0.2], color: '#ddaa00', mass: 1, variants: ['#eeeeee']}\n"
    )
    (tmp_path / "decorating.yaml").write_text("nightstand:\n  lies:\n    - {put: crown}\n")
    ours, known = load_catalogs(), load_catalogs(tmp_path)
    assert set(known.decorations) == {*ours.decorations, "crown"}
    assert [row.put for row in known.decorating["nightstand"].lies] == [("crown",)]
    assert known.decorating["bed"] == ours.decorating["bed"]


def test_a_fault_between_the_layers_names_the_file_that_causes_it(tmp_path: Path) -> None:
    (tmp_path / "rooms").mkdir()
    path = tmp_path / "rooms" / "den.yaml"
    path.write_text("area: {min: [4, 4], typical: 5, max: 9}\nflooring: wood\naccent: '#112233'\npieces:\n  - piece: trone\n")
    error = fault(tmp_path)
    assert (error.file, error.key, error.line) == (str(path), "pieces.0.piece", 5)


def test_a_file_that_is_no_mapping_is_a_fault(copy: Path) -> None:
    (copy / "rooms" / "bedroom.yaml").write_text("- a\n- b\n")
    assert fault(copy).file.endswith("bedroom.yaml")


def test_a_new_room_type_is_one_file(tmp_path: Path) -> None:
    text = """
    area: {min: [3, 4], typical: 5, max: 8}
    flooring: wood
    accent: "#aa8866"
    pieces:
      - piece: hall_bench
        rules: [{type: against_wall}]
      - piece: laundry_basket
        rules: [{type: on, of: hall_bench, cost: 1}]
    """
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "sauna.yaml").write_text(text)
    sauna = load_catalogs(tmp_path).rooms["sauna"]
    assert [piece.rules[0].type for piece in sauna.pieces] == ["against_wall", "on"]
