"""Equal scenes give equal bytes in every process: no set's order, no day and no address is written."""

from __future__ import annotations

import os
import subprocess
import sys
from hashlib import sha256

from compose_homes import export
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
