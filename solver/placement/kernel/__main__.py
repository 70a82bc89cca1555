"""`python -m solver.placement.kernel` brings the cache of compiled code up to date; set-up calls it.

What the cache lacks is compiled; what is left of earlier sources then goes.
"""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

from solver.placement.kernel import compiled_kernel, jit


def outdated(current: Path) -> list[Path]:
    """Returns the folders beside the current one that hold code compiled from other sources, sorted."""
    found = [path for path in current.parent.iterdir() if re.fullmatch(r"[0-9a-f]{16}", path.name) and path.is_dir()]
    return sorted(path for path in found if path != current)


def main() -> None:
    """Says where the compiled code is, on stderr, once it is there and nothing else is."""
    compiled_kernel()
    current = jit.FOLDER
    if current is None:
        print("placement kernel: runs uncompiled, nothing to prepare", file=sys.stderr)
        return
    if current.is_dir():
        for folder in outdated(current):
            shutil.rmtree(folder, ignore_errors=True)
    print(f"placement kernel: compiled in {current}", file=sys.stderr)


if __name__ == "__main__":
    main()
