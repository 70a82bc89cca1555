"""What a start costs, in seconds of the processor: `python -m tests.targets imports`."""

from __future__ import annotations

import resource
import subprocess
import sys
from typing import Final

from tests.architecture.tree import ROOT

LIMITS: Final = {
    "import compose_homes": 0.6,
    "from solver.scene import Scene": 0.6,
    "from service.cli import main; main(['schema'])": 0.8,
}
"""CPU s of a whole process."""


def seconds(program: str) -> float:
    """The processor's time of a Python that runs a program; the best of three."""

    def once() -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", program], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    return min(once() for _ in range(3))


def imports() -> bool:
    """Prints what starts cost; returns whether the targets are met."""
    found = {program: seconds(program) for program in LIMITS}
    for program, cost in found.items():
        print(f"{program:60} {cost:5.2f} CPU s of {LIMITS[program]:.1f}")
    return all(cost <= LIMITS[program] for program, cost in found.items())
