"""A folder of own assets -> catalogs that know them. Every fault says which file, key and line."""

from os import PathLike
from pathlib import Path
from typing import Any, Final, Literal

from catalogs.assets.asset_entry import Asset, AssetEntry, AssetName
from catalogs.assets.asset_measures import KindTable, kind_table, measured
from catalogs.assets.glb_file import GlbFault
from catalogs.faults import CatalogError, Fault
from catalogs.reading import located, read_entries
from catalogs.references import near
from catalogs.schema import Catalogs

ASSET_FILE: Final = "assets.yaml"
LicenseChoice = Literal["commercial", "any"]
"""Which assets are used: those whose licence allows commercial use, or any."""
_ENTRIES: Final[Any] = dict[AssetName, AssetEntry]


def add_assets(catalogs: Catalogs, folder: str | PathLike[str], license: LicenseChoice = "commercial") -> Catalogs:
    """Returns catalogs that know the assets of a folder, too.

    Args:
        catalogs: what else there is.
        folder: holds `assets.yaml` and the .glb files that it names (docs/assets.md).
        license: "commercial" leaves out assets whose licence forbids commercial use or is unsaid.

    Raises:
        CatalogError: there is no `assets.yaml`, an entry of it is wrong, or a file is refused; the first fault found.
    """
    path, kinds = Path(folder) / ASSET_FILE, kind_table(catalogs.furniture, catalogs.decorations)
    if not path.is_file():
        raise CatalogError(str(path), "", 1, "is missing", f"`compose assets check {folder} -o {path}` writes one")
    found: dict[str, Asset] = {}
    for name, entry in sorted(entries_of(path).items()):
        _check_kinds(path, name, entry, kinds)
        try:
            found[name] = measured(Path(folder), entry, kinds)
        except GlbFault as fault:
            raise located(path, Fault("", (name, "file"), f"{entry.file} {fault}")) from None
    allowed = {name: asset for name, asset in found.items() if license == "any" or asset.is_commercial}
    return catalogs.model_copy(update={"assets": allowed})


def entries_of(path: Path) -> dict[str, AssetEntry]:
    """Reads `assets.yaml`.

    Raises:
        CatalogError: it cannot be read, is no YAML, or an entry is none.
    """
    entries: dict[str, AssetEntry] = read_entries(path, _ENTRIES)
    return entries


def _check_kinds(path: Path, name: str, entry: AssetEntry, kinds: KindTable) -> None:
    for number, word in enumerate(entry.kinds):
        if not kinds.keys_of((word,)):
            known = [*kinds.specs, *kinds.named]
            problem = f"unknown kind {word!r}{near(word, known)}"
            raise located(path, Fault("", (name, "kinds", number), problem, "a key of furniture.yaml or decorations.yaml"))
