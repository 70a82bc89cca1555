"""Homes that are to be accessible: who has to come everywhere, and what the certificate says of it.

Comes in: a request or a scene. Goes out: the same with what its profile asks. May import: the validator.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from catalogs import Catalogs
from solver.certificate import ACCESS
from solver.scene import NO_ACCESS, Request, Scene
from solver.validator import access_of
from solver.validator.accessibility import access_profile


def with_walker(request: Request, catalogs: Catalogs) -> Request:
    """Returns a request whose robot is at least as wide as the walker of its profile.

    Raises:
        RequestError: there is no such profile.
    """
    if request.access is None or request.access == NO_ACCESS:
        return request
    return replace(request, robot_width=max(request.robot_width, access_profile(request.access, catalogs).walker))


def with_access(scene: Scene, catalogs: Catalogs) -> Scene:
    """Returns a scene whose certificate says what of its request's profile is met, and what is not."""
    name = scene.request.get("access") if isinstance(scene.request, Mapping) else None
    if not isinstance(name, str) or name not in catalogs.access:
        return scene
    told = access_of(scene, name, catalogs).document()
    said = {key: told[key] for key in ("profile", "met", "unmet")}
    return replace(scene, certificate={**(scene.certificate or {}), ACCESS: said})
