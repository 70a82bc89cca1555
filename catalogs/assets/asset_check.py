"""A folder of .glb files -> its `assets.yaml`: what is not said is measured, or guessed and marked as guessed; what is refused, and why.

Guessed are kinds (by words of the file's path and, among those, by size), the unit, the front (glTF's +z) and the licence (unsaid). Units
are never guessed where several fit, or none.
"""

import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Final, NamedTuple

import yaml

from catalogs.assets import ASSET_NAME
from catalogs.assets.asset_entry import UNSAID, Asset, AssetEntry, Front
from catalogs.assets.asset_folder import ASSET_FILE, entries_of
from catalogs.assets.asset_measures import KindTable, fitting_units, kind_table, measured, turned_extents
from catalogs.assets.glb_file import GlbFault, bounds_of, read_glb
from catalogs.faults import CatalogError, ComposeError
from catalogs.schema import Catalogs
from catalogs.synonyms import words_of

FRONTS: Final[tuple[Front, ...]] = ("+z", "+x")
"""Fronts that are guessed: glTF's, or the one across it where only that gives a kind's proportions."""
MOST_FILES: Final = 20_000
"""Most files that a folder is searched for, in it and below. Our choice."""
LEVEL: Final = 0.02
"""A surface of an asset is one of its kind's if it is so near, m, once the asset is as high as the kind."""
_ORDER: Final = ("file", "kinds", "front", "size", "surfaces", "mass", "license", "source", "author", "guessed")


LevelFinder = Callable[[str, Asset], tuple[float, ...]]
"""Returns the heights at which things may lie on an asset, m, by its name; or raises a `ComposeError`."""


class CheckedFolder(NamedTuple):
    """What was found: the entries, as YAML too; why files are refused; what else is to be said; how many entries are guessed in part."""

    entries: dict[str, AssetEntry]
    text: str
    refused: dict[str, str]
    notes: list[str]

    @property
    def guessed(self) -> int:
        """How many entries have something that nobody said."""
        return sum(bool(entry.guessed) for entry in self.entries.values())


def checked_folder(folder: Path, catalogs: Catalogs, levels: LevelFinder | None = None) -> CheckedFolder:
    """Checks a folder of .glb files, in it or below; what its `assets.yaml` says, if there is one, stays.

    `levels` finds the surfaces of an asset whose kinds have some, where nobody says them; without it they stay unsaid.

    Raises:
        CatalogError: there is no such folder, or its `assets.yaml` cannot be read.
    """
    if not folder.is_dir():
        raise CatalogError(str(folder), "", 0, "is no folder", "a folder of .glb files")
    kinds = kind_table(catalogs.furniture, catalogs.decorations)
    said = entries_of(folder / ASSET_FILE) if (folder / ASSET_FILE).is_file() else {}
    known = {entry.file for entry in said.values()}
    wanted: dict[str, AssetEntry | str] = dict(said)
    for file in _files(folder):
        if file not in known:
            wanted[_name(file, wanted)] = file
    entries, refused, notes = {}, {}, []
    for name, entry in sorted(wanted.items()):
        file = entry if isinstance(entry, str) else entry.file
        try:
            asset_entry = _guessed(folder, entry, kinds, catalogs) if isinstance(entry, str) else entry
            unknown = [word for word in asset_entry.kinds if not kinds.keys_of((word,))]
            if unknown:
                raise GlbFault(f"stands for {', '.join(unknown)}, which no catalog knows")
            asset = measured(folder, asset_entry, kinds)
            if levels and not asset.surfaces and any(kinds.specs[key].surfaces for key in kinds.keys_of(asset.kinds)):
                found = levels(name, asset)
                guessed = {"surfaces": found, "guessed": (*asset.guessed, "surfaces")} if found else {}
                asset, asset_entry = asset.model_copy(update=guessed), asset_entry.model_copy(update=guessed)
        except (GlbFault, ComposeError, ValueError) as fault:
            refused[file] = str(fault)
            continue
        entries[name] = asset_entry.model_copy(update={"size": asset.size, "guessed": asset.guessed})
        notes += [f"{name}: {words}" for words in _remarks(asset, kinds)]
    return CheckedFolder(entries, _text(entries), refused, notes)


def _files(folder: Path) -> list[str]:
    """Returns the .glb files in a folder and below, by their paths from it."""
    found = []
    for path in folder.rglob("*"):
        if path.suffix.lower() == ".glb":
            found.append(path.relative_to(folder).as_posix())
        if len(found) > MOST_FILES:
            raise OSError(f"{folder} holds more than {MOST_FILES} .glb files")
    return sorted(found)


def _name(file: str, taken: Iterable[str]) -> str:
    """Returns a name for an asset that no other has: its file's, without what names may not hold."""
    stem = re.sub(r"[^A-Za-z0-9_.-]+", "_", file.rpartition(".")[0].rpartition("/")[2])[:90].lstrip("_.-") or "asset"
    names = set(taken)
    name = next(name for number in range(1, len(names) + 2) if (name := stem if number == 1 else f"{stem}_{number}") not in names)
    assert re.match(ASSET_NAME, name)
    return name


def _guessed(folder: Path, file: str, kinds: KindTable, catalogs: Catalogs) -> AssetEntry:
    """Returns the entry of a file of which nothing is said; a GlbFault where it is refused, or no kind can be guessed."""
    entry = AssetEntry(file=file, kinds=("?",), guessed=("kinds", "front", "license"))
    bounds = bounds_of(read_glb(folder / file))
    words = set(words_of(file.rpartition(".")[0]))
    best: dict[str, int] = {}
    for key, spec in kinds.specs.items():
        names = (key, getattr(spec, "name", None) or key, *spec.labels)
        fit = max((len(parts) for name in names if (parts := set(words_of(name))) and parts <= words), default=0)
        if fit:
            best[key] = fit
    most = max(best.values(), default=0)
    named = [key for key, fit in best.items() if fit == most]
    if not named:
        raise GlbFault("has a name that is none of a kind's; say its `kinds`")
    fits = {front: [key for key in named if fitting_units(turned_extents(bounds, front), [kinds.specs[key].size])] for front in FRONTS}
    front = next((front for front, keys in fits.items() if keys), entry.front)
    called = tuple(dict.fromkeys(catalogs.name_of(key) for key in fits[front] or named))
    return entry.model_copy(update={"kinds": called, "front": front, "license": UNSAID})


def _remarks(asset: Asset, kinds: KindTable) -> list[str]:
    """Says what is guessed of an asset, and on which of its kinds nothing can lie."""
    found = [f"guessed {', '.join(asset.guessed)}: {', '.join(asset.kinds)}, front {asset.front}"] if asset.guessed else []
    bare = []
    for key in kinds.keys_of(asset.kinds):
        spec = kinds.specs[key]
        surfaces = [height * spec.size[2] / asset.size[2] for height in asset.surfaces or (asset.size[2],)]
        if any(all(abs(surface.height - height) > LEVEL for height in surfaces) for surface in spec.surfaces):
            bare.append(key)
    if bare:
        found.append(f"not for a {' or '.join(bare)} that carries something: its `surfaces` are not theirs")
    return found


def _text(entries: Mapping[str, AssetEntry]) -> str:
    """Returns entries as YAML; keys that hold their defaults are left out, but not the front and the licence."""
    lines = ["# Written by `compose assets check`. `guessed` names what nobody has said: look at it, then take it out.\n"]
    for name, entry in entries.items():
        said: dict[str, Any] = entry.model_dump(mode="json", exclude_defaults=True) | {"front": entry.front, "license": entry.license}
        ordered = {key: said[key] for key in _ORDER if key in said}
        lines.append(yaml.safe_dump({name: ordered}, default_flow_style=None, sort_keys=False, allow_unicode=True, width=140))
    return "".join(lines)
