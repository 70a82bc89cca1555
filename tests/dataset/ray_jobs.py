"""`compose dataset` on a local Ray cluster, where a fault of the core comes first in each shard's process, and after Ray in this one.

python -m tests.dataset.ray_jobs OPTIONS: those of `compose`. A fault that nobody is told of ends the process that had it.
"""

from __future__ import annotations

import sys
from typing import Any

from service.cli import main
from service.dataset import building
from solver.core.host import CoreFailed, CoreInstance

_shard = building._shard


def faulty() -> None:
    """Asks the core for what ends in a fault of it.

    Raises:
        AssertionError: the fault is not told.
    """
    core = CoreInstance()
    try:
        core.call("open_drag", core.write(b"no request"), 10)
    except CoreFailed:
        return
    raise AssertionError("no fault")


def after_fault(plan: Any, shard: Any) -> Any:
    """Makes a shard in a process whose core had a fault."""
    faulty()
    return _shard(plan, shard)


if __name__ == "__main__":
    faulty()
    building._shard = after_fault
    status = main(sys.argv[1:])
    faulty()
    sys.exit(status)
