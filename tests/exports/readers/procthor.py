"""Reads a ProcTHOR house: left-handed, x east, y up, z north, yaw clockwise; fronts towards +z."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from tests.exports.readers import Seen


def house_of(files: Mapping[str, bytes]) -> dict[str, Any]:
    """The document."""
    (content,) = files.values()
    found: dict[str, Any] = json.loads(content)
    return found


def objects_of(objects: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Every object, what is carried behind what carries it."""
    for one in objects:
        yield one
        yield from objects_of(one["children"])


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies; sizes and masses from what we say beside the schema."""
    found = {}
    for one in objects_of(house_of(files)["objects"]):
        at, size = one["position"], one["compose"]["size"]
        turn = (180 - one["rotation"]["y"]) % 360
        y = at["y"] - size["y"] / 2
        found[one["id"]] = Seen(at["x"], y, -at["z"], turn, size["x"], size["z"], size["y"], one["compose"]["mass"])
    return found
