"""The catalogs: all data, and the types that describe it.

Comes in: YAML files of this folder. Goes out: `load_catalogs()`, checked and frozen. May import: nothing of ours.
"""

from catalogs.schema import Catalogs

__all__ = ["Catalogs"]
