"""Which documents are floor plans of other programs: what reads a scene refuses them, what imports plans reads them."""

from collections.abc import Callable, Mapping
from typing import Final


def is_features(document: object) -> bool:
    """Tells whether a document is GeoJSON."""
    return isinstance(document, Mapping) and document.get("type") in ("FeatureCollection", "Feature")


def is_procthor(document: object) -> bool:
    """Tells whether a document is a house of ProcTHOR."""
    if not isinstance(document, Mapping) or not isinstance(document.get("rooms"), (list, tuple)):
        return False
    first = next((room for room in document["rooms"] if isinstance(room, Mapping)), {})
    return "floorPolygon" in first


def is_rplan(document: object) -> bool:
    """Tells whether a document is an apartment of RPLAN."""
    return isinstance(document, Mapping) and {"room_type", "boxes", "edges", "ed_rm"} <= document.keys()


FOREIGN_DOCUMENTS: Final[Mapping[str, Callable[[object], bool]]] = {"geojson": is_features, "procthor": is_procthor, "rplan": is_rplan}
"""How documents of other programs are known, by format."""
