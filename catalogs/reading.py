"""Reading: YAML files -> plain documents -> checked, frozen `Catalogs`; every fault with its file, key and line."""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from hashlib import blake2b
from pathlib import Path
from typing import Any, Final

import yaml
from pydantic import ValidationError

from catalogs.access_profiles import AccessProfile
from catalogs.checks import faults, holding_faults
from catalogs.decoration_types import Decorating, DecorationKind
from catalogs.entries import DrawnName, Dweller, Evidence, Mark, Preset, Synonym
from catalogs.faults import CatalogError, Fault
from catalogs.insides import insides_of
from catalogs.misfits import misfit, reader_of, schema_of
from catalogs.references import near
from catalogs.schema import Catalogs, FlooringSpec, FurnitureSpec, Habit, RoomType
from catalogs.shapes import Material, ShapeParts
from catalogs.shapes_checks import shaped
from catalogs.styles import Style
from catalogs.yaml_reading import LOADER, YamlFault, read_yaml

HERE = Path(__file__).parent
_ROOMS = "rooms"
_SHAPES = "shapes"
ROW_KEY: Final = 2
"""The key of a row of decorating.yaml is longer: entry, list, number."""
_SECTIONS: Final[dict[str, Any]] = {
    "furniture": dict[str, FurnitureSpec],
    "floorings": dict[str, FlooringSpec],
    "decorations": dict[str, DecorationKind],
    "decorating": dict[str, Decorating],
    "styles": dict[str, Style],
    "presets": dict[str, Preset],
    "people": dict[str, Dweller],
    "materials": dict[str, Material],
    "habits": dict[str, Habit],
    "synonyms": dict[str, Synonym],
    "room_names": dict[str, Synonym],
    "drawn_names": dict[DrawnName, Synonym],
    "access": dict[str, AccessProfile],
    "guessing": dict[Mark, Evidence],
}
"""What each file of a catalog holds: `<section>.yaml`."""
_FILES: Final = (*(f"{section}.yaml" for section in _SECTIONS), f"{_ROOMS}/<type>.yaml", f"{_SHAPES}/<any>.yaml")
_SHAPE_FILE: Final[Any] = dict[str, ShapeParts]
"""What each file of shapes/ holds: shapes by name, whatever the file is called."""
_LOOKS: Final[Any] = {
    "fingerprint": True, "assets": True, "shapes": True, "materials": True, "synonyms": True, "room_names": True, "habits": True,
    "access": True, "guessing": True, "drawn_names": True,
    "styles": {"__all__": {"materials"}},
    "furniture": {"__all__": {"shape", "friction", "moves", "labels"}},
    "decorations": {"__all__": {"shape", "friction", "moves", "labels"}},
}  # fmt: skip
"""What no home depends on: a seed makes the same home however its pieces are drawn, so its fingerprint stays too; but what is free inside
what holds things counts."""


def read_catalogs(directory: Path | None = None) -> Catalogs:
    """Reads and checks our catalogs, or those with a directory's own laid over them; see `cached.load_catalogs`."""
    if directory is None:
        return _checked(_ours())
    _refuse_strays(directory)
    return _checked(_laid_over(_ours(), _layer(directory)), over_ours=True)


@dataclass(frozen=True)
class _Layer:
    """What one directory says by section, and by (section, name) which file says it."""

    entries: dict[str, dict[str, Any]]
    files: dict[tuple[str, str], Path]


def _layer(directory: Path) -> _Layer:
    paths = {section: directory / f"{section}.yaml" for section in _SECTIONS}
    room_files = {path.stem: path for path in sorted((directory / _ROOMS).glob("*.yaml"))}
    shape_files = sorted((directory / _SHAPES).glob("*.yaml"))
    if not room_files and not shape_files and not any(path.exists() for path in paths.values()):
        problem = "holds no catalog" if directory.is_dir() else "is no folder"
        raise CatalogError(str(directory), "", 0, problem, ", ".join(_FILES))
    entries = {section: read_entries(path, _SECTIONS[section]) if path.exists() else {} for section, path in paths.items()}
    entries[_ROOMS] = {name: read_entries(path, RoomType) for name, path in room_files.items()}
    files = {(section, name): paths[section] for section in paths for name in entries[section]}
    files |= {(_ROOMS, name): path for name, path in room_files.items()}
    entries[_SHAPES], shapes_in = _shapes(shape_files)
    return _Layer(entries, files | shapes_in)


@cache
def _ours() -> _Layer:
    """Returns what our own files say, read once in a process: any number of folders may be laid over them."""
    return _layer(HERE)


def _refuse_strays(directory: Path) -> None:
    """Refuses a directory with a YAML file, in it or one folder down, that nobody would read; says which may have been meant."""
    for path in sorted(path for pattern in ("*.y*ml", "*/*.y*ml") for path in directory.glob(pattern)):
        folder, name = path.parent.relative_to(directory).name, path.name
        if not (name in _FILES if not folder else folder in (_ROOMS, _SHAPES) and path.suffix == ".yaml"):
            meant = near(folder, (_ROOMS, _SHAPES)) if folder else near(path.stem, (*_SECTIONS, _ROOMS, _SHAPES))
            raise CatalogError(str(path), "", 1, f"is no file of a catalog{meant}", ", ".join(_FILES))


def _shapes(paths: list[Path]) -> tuple[dict[str, Any], dict[tuple[str, str], Path]]:
    """Reads all files of shapes: the shapes by name, and which file says each."""
    shapes: dict[str, Any] = {}
    files: dict[tuple[str, str], Path] = {}
    for path in paths:
        read = read_entries(path, _SHAPE_FILE)
        for name in read:
            if name in shapes:
                raise located(path, Fault(_SHAPES, (name,), f"the shape is in {files[_SHAPES, name].name} too"))
            files[_SHAPES, name] = path
        shapes |= read
    return shapes, files


def _laid_over(below: _Layer, above: _Layer) -> _Layer:
    merged = {section: named | above.entries[section] for section, named in below.entries.items()}
    return _Layer(merged, below.files | above.files)


def _checked(layer: _Layer, over_ours: bool = False) -> Catalogs:
    """Checks that everything fits together and gives it its fingerprint.

    A row of our own decorating.yaml that a piece of another directory has no surface for is no fault: its things are left out.
    Neither is a shape of ours that does not fit such a piece: it goes without one.
    """
    written = {section: named for section, named in layer.entries.items() if section != _SHAPES}
    catalogs, shapes = Catalogs(**written, fingerprint=""), layer.entries[_SHAPES]
    _refuse(faults(catalogs, shapes), layer, over_ours)
    catalogs = catalogs.model_copy(update={"shapes": shaped(catalogs, shapes)})
    _refuse(holding_faults(catalogs), layer, over_ours)
    return catalogs.model_copy(update={"fingerprint": fingerprint(catalogs)})


def _refuse(found: Iterable[Fault], layer: _Layer, over_ours: bool) -> None:
    for fault in found:
        file = layer.files[fault.entry]
        is_row_of_ours = file.parent == HERE and fault.file == "decorating" and len(fault.at) > ROW_KEY
        is_shape_of_ours = file.parent == HERE / _SHAPES
        if not (over_ours and (is_row_of_ours or is_shape_of_ours)):
            raise located(file, fault)


def fingerprint(catalogs: Catalogs) -> str:
    """Returns 12 hex digits that change with any word or number that homes follow from, and with the order of pieces."""
    holding = {kind: entry.size for kind, entry in catalogs.furniture.items() if _holds_things(catalogs, kind)}
    insides = {kind: insides_of(catalogs.shapes.get(kind, ()), size) for kind, size in holding.items()}
    content = catalogs.model_dump(mode="json", exclude=_LOOKS), insides
    return blake2b(json.dumps(content, sort_keys=True).encode(), digest_size=6).hexdigest()


def _holds_things(catalogs: Catalogs, kind: str) -> bool:
    entry = catalogs.decorating.get(catalogs.name_of(kind))
    return entry is not None and bool(entry.holds)


def read_entries(path: Path, of: Any) -> Any:
    """Reads a file as a type: entries by name, or one.

    Raises:
        CatalogError: it cannot be read, is no YAML, or an entry is none.
    """
    try:
        return reader_of(of).validate_python(read_yaml(path.read_bytes()))
    except OSError as error:
        raise CatalogError(str(path), "", 1, f"cannot be read: {error.strerror}") from error
    except YamlFault as fault:
        key = _key_above(path, fault.line) if fault.line else ""
        raise CatalogError(str(path), key, fault.line or 1, f"is not YAML: {fault}") from fault
    except ValidationError as error:
        raise located(path, misfit(error, schema_of(of))) from error


def _key_above(path: Path, line: int) -> str:
    """Returns the last key that a broken text names at or above a line (from 1)."""
    above = path.read_text(encoding="utf-8", errors="replace").splitlines()[:line]
    keys = [text.split(":")[0].strip(" -{") for text in above if ":" in text and not text.lstrip().startswith("#")]
    return keys[-1] if keys else ""


def located(path: Path, fault: Fault) -> CatalogError:
    """Finds the line of a fault's key by reading the file once more, with marks."""
    node = yaml.compose(path.read_bytes(), LOADER)
    line = node.start_mark.line if node else 0
    for part in fault.at:
        child = _child(node, part)
        if child is None:
            break
        node, line = child
    return CatalogError(str(path), ".".join(map(str, fault.at)), line + 1, fault.problem, fault.allowed)


def _child(node: Any, part: str | int) -> tuple[Any, int] | None:
    """Returns the value under a key or index and the line the key stands in, or None."""
    if isinstance(node, yaml.MappingNode):
        return next(((value, key.start_mark.line) for key, value in node.value if key.value == part), None)
    if isinstance(node, yaml.SequenceNode) and isinstance(part, int) and part < len(node.value):
        return node.value[part], node.value[part].start_mark.line
    return None
