"""The catalogs: all data, and the types that describe it.

Comes in: YAML files of this folder. Goes out: `load_catalogs()`, checked and frozen; `CatalogError` says which file, key
and line is wrong. May import: nothing of ours. Not here: what the data leads to (solver).
"""

from catalogs.reading import CatalogError, load_catalogs
from catalogs.schema import Catalogs

__all__ = ["CatalogError", "Catalogs", "load_catalogs"]
