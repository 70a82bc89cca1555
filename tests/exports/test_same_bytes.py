"""Equal scenes give equal bytes in every process: no set's order, no day and no address is written."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from hashlib import sha256
from typing import Any

from compose_homes import Furniture, Room, Scene, export
from solver.export_formats import EXPORTERS
from tests.architecture.tree import ROOT
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


def test_whole_numbers_are_written_as_others() -> None:
    def home(number: Callable[[int], float]) -> Scene:
        size: dict[str, Any] = {"width": number(2), "depth": number(1), "height": number(1)}
        sofa = Furniture("den/sofa_1", "sofa", x=number(2), z=number(3), rotation=number(90), **size)
        return Scene(rooms=(Room("den", width=number(4), depth=number(5), furniture=(sofa,)),))

    differing = [format for format in EXPORTERS if export(home(int), format) != export(home(float), format)]
    assert home(int) == home(float)
    assert differing == []
