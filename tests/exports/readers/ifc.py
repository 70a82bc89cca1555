"""Buildings as IFC, read by ifcopenshell: where furniture is, and its property set."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import ifcopenshell
import ifcopenshell.util.placement

from tests.exports.readers import Seen


def building(files: Mapping[str, bytes]) -> Any:
    """The file."""
    (content,) = files.values()
    return ifcopenshell.file.from_string(content.decode())


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies by id."""
    found: dict[str, Seen] = {}
    file = building(files)
    for relation in file.by_type("IfcRelDefinesByProperties"):
        if relation.RelatingPropertyDefinition.Name != "Compose_Body":
            continue
        (product,) = relation.RelatedObjects
        said = {one.Name: one.NominalValue.wrappedValue for one in relation.RelatingPropertyDefinition.HasProperties}
        frame = ifcopenshell.util.placement.get_local_placement(product.ObjectPlacement)
        turn = math.degrees(math.atan2(frame[1][0], frame[0][0]))
        place = float(frame[0][3]), float(frame[2][3]), -float(frame[1][3]), turn
        found[said["Id"]] = Seen(*place, said["Width"], said["Depth"], said["Height"], said["Mass"])
    return found
