"""Where compiled code is kept, and that one process compiles while others that ask for it wait.

The cache lies beside the sources, in the user's cache folder where that cannot be written, or where `NUMBA_CACHE_DIR` says; in
a folder named after a digest of the kernel's sources, so that no stale code is ever loaded. Where nothing can be written the
kernel is compiled in every process anew.
"""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent


def digest() -> str:
    """Returns 16 hex digits that stand for the kernel's sources."""
    return hashlib.sha256(b"".join(path.read_bytes() for path in sorted(HERE.glob("*.py")))).hexdigest()[:16]


def roots() -> list[Path]:
    """Returns the folders to try, best first."""
    asked = os.environ.get("NUMBA_CACHE_DIR")
    if asked:
        return [Path(asked) / "compose"]
    home = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return [HERE / "__pycache__", Path(home) / "compose"]


def folder() -> Path | None:
    """Returns the folder of this source's code, made if need be; None where none can be written."""
    name = digest()
    for root in roots():
        try:
            (root / name).mkdir(parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=root / name).close()
        except OSError:
            continue
        return root / name
    return None


def say(words: str) -> None:
    """Tells whoever started the program."""
    print(f"compose: {words}", file=sys.stderr, flush=True)


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Holds a file's lock; where the system has none, several processes may do the same work."""
    with path.open("a") as file:
        if sys.platform != "win32":
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX)
        yield


@contextmanager
def one_compiles(own: Path | None, machine: tuple[Any, ...]) -> Iterator[None]:
    """What is done inside compiles, where nobody has yet, or loads.

    Args:
        own: the folder of this source's code, or None.
        machine: what the code is for besides, such as processor and compiler.
    """
    if own is None:
        say("compiling the placement kernel, about a minute; there is no folder to keep it in")
        yield
        return
    where = (sys.implementation.cache_tag, str(HERE), *machine)
    mark = own / f"{hashlib.sha256(repr(where).encode()).hexdigest()[:16]}.whole"
    if mark.exists():
        yield
        return
    with locked(own / "lock"):
        if not mark.exists():
            say("compiling the placement kernel, about a minute; once, until its sources change")
        yield
        mark.touch()
