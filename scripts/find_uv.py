"""Print the path of uv, the installer of everything else; fetch it into .tools/ where there is none.

Runs on the machine's own Python, 3.8 or newer, with nothing installed. Ways to get uv, in order: the one on PATH, pip, the pip of a
fresh virtual environment (ensurepip), Debian's pip.
"""

from __future__ import annotations

import importlib.util
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

from debian import install, run, say

UV = "uv==0.13.8"
TOOLS = Path(__file__).resolve().parents[1] / ".tools"


def on_path() -> Path | None:
    """Return the uv on PATH."""
    found = shutil.which("uv")
    return Path(found) if found else None


def fetched() -> Path | None:
    """Return the uv that an earlier run fetched."""
    found = shutil.which("uv", path=str(TOOLS / "uv" / "bin"))
    return Path(found) if found else None


def by_pip() -> Path | None:
    """Fetch uv with this Python's pip."""
    return fetch_with(sys.executable) if has("pip") else None


def by_environment() -> Path | None:
    """Fetch uv with the pip that a new virtual environment brings along."""
    environment = TOOLS / "pip"
    if not has("ensurepip") or not run([sys.executable, "-m", "venv", "--clear", str(environment)]):
        return None
    return fetch_with(str(environment / "bin" / "python"))


def by_debian() -> Path | None:
    """Fetch uv with Debian's pip, installed for it."""
    return fetch_with(sys.executable) if install("python3-pip", "python3-venv") else None


def has(module: str) -> bool:
    """Say whether this Python has a module."""
    return importlib.util.find_spec(module) is not None


def fetch_with(python: str) -> Path | None:
    """Fetch uv with a Python's pip into a folder of its own, so that no system's Python is touched."""
    say(f"Fetching {UV}")
    run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--upgrade", "--target", str(TOOLS / "uv"), UV])
    return fetched()


def find_uv() -> Path:
    """Return the path of uv, fetched if need be.

    Raises:
        SystemExit: there is none and no way to fetch it; the message says what to install.
    """
    ways: list[Callable[[], Path | None]] = [on_path, fetched, by_pip, by_environment, by_debian]
    for way in ways:
        found = way()
        if found:
            return found
    raise SystemExit("uv is missing and could not be fetched: install uv, or pip for python3, and try again")


if __name__ == "__main__":
    print(find_uv())
