"""The public names that stand on the catalogs: imported when the first of them is named."""

from catalogs import CatalogError, Catalogs, load_catalogs
from catalogs.schema import RelationSpec
from solver.pipeline import fix, generate, place, reroll, validate
from solver.requested import Answered, Held, PieceRequest, Placement, Unplaced

__all__ = [
    "Answered",
    "CatalogError",
    "Catalogs",
    "Held",
    "PieceRequest",
    "Placement",
    "RelationSpec",
    "Unplaced",
    "fix",
    "generate",
    "load_catalogs",
    "place",
    "reroll",
    "validate",
]
