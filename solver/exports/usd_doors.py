"""Door leaves and fronts as USD has them: rigid bodies on joints, leaves on the house, fronts on their furniture."""

from __future__ import annotations

from math import radians
from typing import Final

from solver.exports.colliders import z_up
from solver.exports.in_drawers import HeldThing
from solver.exports.model import DoorLeaf, ModelBody
from solver.exports.moving_parts import MovingPart, moving_leaf
from solver.exports.usd_text import guide, moved_by, part_text, placed, prim, said, triple, turned

_NO_TURN: Final = "(1, 0, 0, 0)"


def door_text(leaf: DoorLeaf, name: str) -> str:
    """Returns a leaf, as far open as it stands, its origin at its hinge and its +x along its width; the joint is inside."""
    hung = moving_leaf(leaf)
    several = zip(hung.parts, hung.paints, strict=True)
    parts = "".join(part_text(f"part_{number}", part, paint, None) for number, (part, paint) in enumerate(several))
    solids = "".join(guide(f"collider_{number}", solid) for number, solid in enumerate(hung.solids))
    joint = _joint(hung, ("/House", f"/House/Doors/{name}"), leaf.mass if hung.slides else hung.damping)
    inside = f'float physics:mass = {leaf.mass:.6g}\ntoken[] semantics:labels:class = ["door"]\n{_stands(leaf)}{parts}{solids}{joint}'
    schemas = "PhysicsRigidBodyAPI", "PhysicsMassAPI", "SemanticsLabelsAPI:class"
    return said("Xform", name, schemas, {"id": leaf.id, "look": leaf.look}, inside)


def _stands(leaf: DoorLeaf) -> str:
    """Returns where a leaf stands: turned open, or lifted."""
    x, y, z = z_up(*leaf.hinge)
    return placed((x, y, z), leaf.closed + leaf.opened) if leaf.motion == "swing" else placed((x, y, z + leaf.opened), leaf.closed)


def front_text(front: MovingPart, body: ModelBody, name: str, path: str) -> str:
    """Returns a front, shut, its origin at its hinge; the joint to its furniture, the prim at `path`, is inside."""
    several = zip(front.parts, front.paints, front.solids, strict=True)
    parts = "".join(part_text(f"part_{number}", part, paint, solid) for number, (part, paint, solid) in enumerate(several))
    at = moved_by(z_up(body.x, body.y, body.z), body.turn, front.hinge)
    inside = (
        f"rel physics:filteredPairs = <{path}>\nfloat physics:mass = {front.mass:.6g}\n"
        f'token[] semantics:labels:class = ["{"drawer" if front.slides else "front"}"]\n'
        f"{placed(at, body.turn)}{parts}{_joint(front, (path, f'/House/Fronts/{name}'), front.damping)}"
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


def _joint(part: MovingPart, ends: tuple[str, str], damping: float) -> str:
    """Returns the joint of what moves to what it hangs on, two prims' paths; shut is 0. Damping is in N m s/rad: USD counts in degrees."""
    (held, own), (low, high) = ends, part.limits
    drive, slowed = ("linear", damping) if part.slides else ("angular", radians(damping))
    inside = (
        f'uniform token physics:axis = "{part.axis.upper()}"\nrel physics:body0 = <{held}>\nrel physics:body1 = <{own}>\n'
        f"point3f physics:localPos0 = {triple(part.hinge)}\npoint3f physics:localPos1 = (0, 0, 0)\n"
        f"quatf physics:localRot0 = {_NO_TURN if part.turn is None else turned(part.turn)}\nquatf physics:localRot1 = {_NO_TURN}\n"
        f"float physics:lowerLimit = {low:.6g}\nfloat physics:upperLimit = {high:.6g}\n"
        f"float drive:{drive}:physics:damping = {slowed:.6g}\nfloat drive:{drive}:physics:stiffness = 0\n"
        f'uniform token drive:{drive}:physics:type = "force"\n'
    )
    return prim("PhysicsPrismaticJoint" if part.slides else "PhysicsRevoluteJoint", "hinge", (f"PhysicsDriveAPI:{drive}",), inside)
