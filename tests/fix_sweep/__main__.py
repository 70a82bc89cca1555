"""Throws pieces of generated homes about and prints how `/fix` repairs them.

    python -m tests.fix_sweep [--homes 150] [--first 5000] [--ways 1 3 "30 %" "30 %, one locked"] [--workers 2] [--turned] [--remove]

A home was valid before its pieces were thrown, so every "cannot" about it is false. Exit status 1 where there is one.
"""

from __future__ import annotations

import argparse
import sys

from tests.fix_sweep.ruler import thrown_about
from tests.fix_sweep.thrown import WAYS


def main() -> int:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--homes", type=int, default=150)
    parser.add_argument("--first", type=int, default=5000)
    parser.add_argument("--ways", nargs="*", default=list(WAYS))
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--turned", action="store_true", help="pieces are turned any quarter, too")
    parser.add_argument("--remove", action="store_true", help="what cannot stand is taken out")
    asked = parser.parse_args()
    good = thrown_about(asked.homes, asked.workers, asked.ways, first=asked.first, turn=asked.turned, remove=asked.remove)
    return int(not good)


if __name__ == "__main__":
    sys.exit(main())
