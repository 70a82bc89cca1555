"""Debian's packages, where this user may install them. Runs on the machine's own Python, 3.8 or newer."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path


def is_debian() -> bool:
    """Say whether this is Debian itself: Ubuntu's `chromium` is a snap, which containers cannot start."""
    release = Path("/etc/os-release")
    return release.exists() and "ID=debian" in release.read_text().splitlines() and shutil.which("apt-get") is not None


def as_root() -> list[str] | None:
    """Return what to put before a command to run it as root without a password, or None where that cannot be."""
    if os.geteuid() == 0:
        return []
    sudo = shutil.which("sudo")
    if sudo and subprocess.run([sudo, "-n", "true"], stdin=subprocess.DEVNULL, capture_output=True, check=False).returncode == 0:
        return [sudo, "-n"]
    return None


def install(*packages: str) -> bool:
    """Install packages with apt-get, refreshing its index first; say whether that worked."""
    root = as_root()
    if root is None or shutil.which("apt-get") is None:
        return False
    apt = [*root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq"]
    say(f"Installing {' '.join(packages)} with apt-get")
    # A failed refresh is no reason to stop: the index there is may do.
    run([*apt, "update"])
    return run([*apt, "install", "-y", "--no-install-recommends", *packages])


def run(command: list[str]) -> bool:
    """Run a command with its output on standard error, so that standard output stays the answer; say whether it worked."""
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=sys.stderr, check=False).returncode == 0
    except OSError as problem:
        say(f"{command[0]}: {problem}")
        return False


def say(line: str) -> None:
    """Write a line of progress to standard error."""
    print(line, file=sys.stderr, flush=True)
