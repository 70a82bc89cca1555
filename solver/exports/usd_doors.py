"""Door leaves and fronts as USD has them: rigid bodies on joints, leaves on the house, fronts on their furniture."""

from __future__ import annotations

from math import radians
from typing import Final

from solver.exports.colliders import leaf_colliders, parts_of_hung_leaf, z_up
from solver.exports.in_drawers import HeldThing
from solver.exports.model import DoorLeaf, ModelBody
from solver.exports.moving_parts import SLIDE_DAMPING, TURN_DAMPING, MovingPart
from solver.exports.usd_text import guide, moved_by, part_text, placed, prim, said, triple, turned

DAMPING: Final = 1.5
"""What slows a leaf, N m s/rad; USD counts in degrees."""
_NO_TURN: Final = "(1, 0, 0, 0)"


def door_text(leaf: DoorLeaf, name: str) -> str:
    """Returns a leaf, as far open as it stands, its origin at its hinge and its +x along its width; the joint is inside."""
    several = zip(parts_of_hung_leaf(leaf), leaf.paints, strict=True)
    parts = "".join(part_text(f"part_{number}", part, paint, None) for number, (part, paint) in enumerate(several))
    solids = "".join(guide(f"collider_{number}", solid) for number, solid in enumerate(leaf_colliders(leaf)))
    inside = (
        f'float physics:mass = {leaf.mass:.6g}\ntoken[] semantics:labels:class = ["door"]\n'
        f"{_stands(leaf)}{parts}{solids}{_joint(leaf, name)}"
    )
    schemas = "PhysicsRigidBodyAPI", "PhysicsMassAPI", "SemanticsLabelsAPI:class"
    return said("Xform", name, schemas, {"id": leaf.id, "look": leaf.look}, inside)


def _stands(leaf: DoorLeaf) -> str:
    """Returns where a leaf stands: turned open, or lifted."""
    x, y, z = z_up(*leaf.hinge)
    return placed((x, y, z), leaf.closed + leaf.opened) if leaf.motion == "swing" else placed((x, y, z + leaf.opened), leaf.closed)


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


def front_text(front: MovingPart, body: ModelBody, name: str, path: str) -> str:
    """Returns a front, shut, its origin at its hinge; the joint to its furniture, the prim at `path`, is inside."""
    several = zip(front.parts, front.paints, front.solids, strict=True)
    parts = "".join(part_text(f"part_{number}", part, paint, solid) for number, (part, paint, solid) in enumerate(several))
    at = moved_by(z_up(body.x, body.y, body.z), body.turn, front.hinge)
    inside = (
        f"rel physics:filteredPairs = <{path}>\nfloat physics:mass = {front.mass:.6g}\n"
        f'token[] semantics:labels:class = ["{"drawer" if front.slides else "front"}"]\n'
        f"{placed(at, body.turn)}{parts}{_front_joint(front, f'/House/Fronts/{name}', path)}"
    )
    schemas = "PhysicsRigidBodyAPI", "PhysicsMassAPI", "PhysicsFilteredPairsAPI", "SemanticsLabelsAPI:class"
    return said("Xform", name, schemas, {"id": front.id, "body": body.id, "front": front.name}, inside)


def held_text(held: HeldThing, front: str, own: str) -> str:
    """Returns the joint that holds a body in a drawer, both given by their prims' paths."""
    inside = (
        f"rel physics:body0 = <{front}>\nrel physics:body1 = <{own}>\n"
        f"point3f physics:localPos0 = {triple(z_up(*held.at))}\npoint3f physics:localPos1 = (0, 0, 0)\n"
        f"quatf physics:localRot0 = {turned(held.turn)}\nquatf physics:localRot1 = {_NO_TURN}\n"
    )
    return prim("PhysicsFixedJoint", "held", (), inside)


def _front_joint(front: MovingPart, own: str, path: str) -> str:
    """Returns a front's joint to its furniture; shut is 0."""
    low, high = front.limits
    drive, damping = ("linear", SLIDE_DAMPING) if front.slides else ("angular", radians(TURN_DAMPING))
    inside = (
        f'uniform token physics:axis = "{front.axis.upper()}"\nrel physics:body0 = <{path}>\nrel physics:body1 = <{own}>\n'
        f"point3f physics:localPos0 = {triple(front.hinge)}\npoint3f physics:localPos1 = (0, 0, 0)\n"
        f"quatf physics:localRot0 = {_NO_TURN}\nquatf physics:localRot1 = {_NO_TURN}\n"
        f"float physics:lowerLimit = {low:.6g}\nfloat physics:upperLimit = {high:.6g}\n"
        f"float drive:{drive}:physics:damping = {damping:.6g}\nfloat drive:{drive}:physics:stiffness = 0\n"
        f'uniform token drive:{drive}:physics:type = "force"\n'
    )
    return prim("PhysicsPrismaticJoint" if front.slides else "PhysicsRevoluteJoint", "hinge", (f"PhysicsDriveAPI:{drive}",), inside)
