"""The public names that stand on the catalogs: imported when the first of them is named."""

from catalogs import CatalogError, Catalogs, add_assets, load_catalogs
from catalogs.schema import RelationSpec
from solver.answers import ChosenEntrance, Explained, FurnishedPlan, Hold, ImportSettings, PlanImport, RoomGuess
from solver.export_formats import EXPORTERS
from solver.pipeline.import_plan import import_plan
from solver.requested import Answered, Held, PieceRequest, Placement, Unplaced

EXPORT_FORMATS = {name: exporter.words for name, exporter in EXPORTERS.items()}
"""What `export` writes: what each format is for, by its name."""

__all__ = [
    "EXPORT_FORMATS",
    "Answered",
    "CatalogError",
    "Catalogs",
    "ChosenEntrance",
    "Explained",
    "FurnishedPlan",
    "Held",
    "Hold",
    "ImportSettings",
    "PieceRequest",
    "Placement",
    "PlanImport",
    "RelationSpec",
    "RoomGuess",
    "Unplaced",
    "add_assets",
    "import_plan",
    "load_catalogs",
]
