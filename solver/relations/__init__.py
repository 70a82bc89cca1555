"""The vocabulary: what each relation between a piece and its room, or another piece, means. One class a relation, one file each.

Comes in: a piece that seeks its place, or a finished room. Goes out: where a relation holds, and whether it does. May import:
catalogs, the ground floor. Not here: making candidates of it (furnish), choosing among them (placement).
"""

from typing import Final

from solver.relations.against_wall import AgainstWall
from solver.relations.aligned_with import AlignedWith
from solver.relations.around import Around
from solver.relations.at_window import AtWindow
from solver.relations.beside import Beside
from solver.relations.centred import Centred
from solver.relations.facing import Facing
from solver.relations.far_from import FarFrom
from solver.relations.far_from_door import FarFromDoor
from solver.relations.in_corner import InCorner
from solver.relations.in_front_of import InFrontOf
from solver.relations.in_row import InRow
from solver.relations.near import Near
from solver.relations.near_door import NearDoor
from solver.relations.on import On
from solver.relations.opposite import Opposite
from solver.relations.relation import Relation
from solver.relations.under import Under

RELATIONS: Final[dict[str, Relation]] = {
    "against_wall": AgainstWall(),
    "in_corner": InCorner(),
    "beside": Beside(),
    "in_front_of": InFrontOf(),
    "opposite": Opposite(),
    "facing": Facing(),
    "near": Near(),
    "far_from": FarFrom(),
    "around": Around(),
    "aligned_with": AlignedWith(),
    "centred": Centred(),
    "in_row": InRow(),
    "at_window": AtWindow(),
    "near_door": NearDoor(),
    "far_from_door": FarFromDoor(),
    "on": On(),
    "under": Under(),
}
"""Every relation by the word that catalogs and requests use; catalogs/schema.py lists the words."""

__all__ = ["RELATIONS", "Relation"]
