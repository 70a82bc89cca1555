"""The catalogs: all data, and the types that describe it.

Comes in: YAML files of this folder. Goes out: `load_catalogs()`, checked and frozen; `CatalogError` says which file, key
and line is wrong. May import: nothing of ours. Not here: what the data leads to (solver).
"""

from importlib import import_module
from typing import TYPE_CHECKING

from catalogs.faults import CatalogError

if TYPE_CHECKING:
    from catalogs.assets.asset_folder import add_assets
    from catalogs.cached import load_catalogs
    from catalogs.schema import Catalogs
else:

    def __getattr__(name: str) -> object:
        """Imports what reads the files when it is first named: the errors cost none of it."""
        module = {"add_assets": "assets.asset_folder", "Catalogs": "schema"}.get(name, "cached")
        return getattr(import_module(f"{__name__}.{module}"), name)


__all__ = ["CatalogError", "Catalogs", "add_assets", "load_catalogs"]
