"""Equal scenes give equal bytes in every process: no set's order, no day and no address is written."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from hashlib import sha256
from itertools import cycle
from typing import Any

import numpy as np

from compose_homes import Decoration, Furniture, Level, Opening, Room, Scene, Size, dump, export
from solver.exchange import write_scene
from solver.export_formats import EXPORTERS
from tests.architecture.tree import ROOT
from tests.exports.agreement import READ_AS
from tests.exports.homes import own

PROGRAM = """
from hashlib import sha256
from compose_homes import export
from solver.export_formats import EXPORTERS
from tests.exports.homes import own
for format in EXPORTERS:
    print(format, sha256(repr(sorted(export(own(), format).items())).encode()).hexdigest())
"""


def elsewhere(seed: str) -> list[str]:
    """What a new process makes whose sets have another order."""
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    run = subprocess.run([sys.executable, "-c", PROGRAM], cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout.splitlines()


def test_every_process_writes_the_same() -> None:
    here = [f"{format} {sha256(repr(sorted(export(own(), format).items())).encode()).hexdigest()}" for format in EXPORTERS]
    assert elsewhere("1" if os.environ.get("PYTHONHASHSEED") != "1" else "7") == here
    assert export(own(), "csv") == export(own(), "csv")


def test_numbers_and_lists_of_all_kinds_are_written_alike() -> None:
    kinds = cycle((int, np.float64, np.float32, np.int64))

    def mixed(number: int) -> Any:
        return next(kinds)(number)

    def home(number: Callable[[int], float], listed: Any = tuple) -> Scene:
        size: dict[str, Any] = {"width": number(2), "depth": number(1), "height": number(1)}
        sofa = Furniture("den/sofa_1", "sofa", x=number(2), z=number(3), rotation=number(90), **size)
        vase = Decoration("den/vase_1", "vase", "den/sofa_1", x=number(2), y=number(1), z=number(3), **size)
        door = Opening("door", wall="south", position=number(2), width=number(1), height=number(2), connects_to="EXTERIOR")
        outline = listed(listed((number(x), number(z))) for x, z in ((0, 0), (4, 0), (4, 3), (3, 3), (3, 5), (0, 5)))
        thickness = listed((number(1), *[None] * 5))
        room = Room("den", width=number(4), depth=number(5), outline=outline, wall_thickness=thickness)
        filled = replace(room, openings=listed([replace(door, wall=None, edge=4)]), furniture=listed([sofa]), decorations=listed([vase]))
        levels, whole = listed([Level(0, number(0), number(3))]), Size(number(4), number(5), number(3))
        triangle = Room("attic", width=number(4), depth=number(5), x=number(9), outline=listed(map(listed, outline[:3])))
        return Scene(rooms=listed([filled, triangle]), levels=levels, size=whole)

    formats = [format for format in EXPORTERS if format not in READ_AS]
    differing = [format for format in formats if export(home(mixed, list), format) != export(home(float), format)]
    assert home(mixed) == home(float)
    assert differing == []
    assert dump(home(mixed, list)) == dump(home(float))
    assert write_scene(home(mixed, list)) == write_scene(home(float))
    assert repr(write_scene(home(mixed))) == repr(write_scene(home(float))), "to the point of a number"
