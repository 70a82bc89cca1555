"""Door leaves as USD has them: a rigid body on a joint that hangs on the house.

Comes in: leaves. Goes out: the text of prims. May import: the model, colliders, usd_text.
"""

from __future__ import annotations

from math import radians
from typing import Final

from solver.exports.colliders import leaf_colliders, parts_of_hung_leaf, z_up
from solver.exports.model import DoorLeaf
from solver.exports.usd_text import guide, part_text, placed, prim, said, triple, turned

DAMPING: Final = 1.5
"""What slows a leaf, N m s/rad; USD counts in degrees."""
_NO_TURN: Final = "(1, 0, 0, 0)"


def door_text(leaf: DoorLeaf, name: str) -> str:
    """Returns a leaf, closed, its origin at its hinge and its +x along its width; the joint is inside."""
    several = zip(parts_of_hung_leaf(leaf), leaf.paints, strict=True)
    parts = "".join(part_text(f"part_{number}", part, paint, None) for number, (part, paint) in enumerate(several))
    solids = "".join(guide(f"collider_{number}", solid) for number, solid in enumerate(leaf_colliders(leaf)))
    inside = (
        f'float physics:mass = {leaf.mass:.6g}\ntoken[] semantics:labels:class = ["door"]\n'
        f"{placed(z_up(*leaf.hinge), leaf.closed)}{parts}{solids}{_joint(leaf, name)}"
    )
    schemas = "PhysicsRigidBodyAPI", "PhysicsMassAPI", "SemanticsLabelsAPI:class"
    return said("Xform", name, schemas, {"id": leaf.id, "look": leaf.look}, inside)


def _joint(leaf: DoorLeaf, name: str) -> str:
    """Returns a leaf's joint to the house; open is the limit that is not 0."""
    turns = leaf.motion == "swing"
    low, high = sorted((0.0, leaf.swing if turns else leaf.height))
    drive = "angular" if turns else "linear"
    damping = radians(DAMPING) if turns else leaf.mass
    inside = (
        f'uniform token physics:axis = "Z"\nrel physics:body0 = </House>\nrel physics:body1 = </House/Doors/{name}>\n'
        f"point3f physics:localPos0 = {triple(z_up(*leaf.hinge))}\npoint3f physics:localPos1 = (0, 0, 0)\n"
        f"quatf physics:localRot0 = {turned(leaf.closed)}\nquatf physics:localRot1 = {_NO_TURN}\n"
        f"float physics:lowerLimit = {low:.6g}\nfloat physics:upperLimit = {high:.6g}\n"
        f"float drive:{drive}:physics:damping = {damping:.6g}\nfloat drive:{drive}:physics:stiffness = 0\n"
        f'uniform token drive:{drive}:physics:type = "force"\n'
    )
    return prim("PhysicsRevoluteJoint" if turns else "PhysicsPrismaticJoint", "hinge", (f"PhysicsDriveAPI:{drive}",), inside)
