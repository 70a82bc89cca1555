"""The Chromium of the browser tests; `python -m tests.chromium` brings one where there is none."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

SCRIPTS = Path(__file__).resolve().parents[1] / "scripts"
PLAYWRIGHT = [sys.executable, "-m", "playwright"]
# The shell has no windows: to go on to another home, and to edit it, costs a fifth less than in a whole browser.
PACKAGES = ("chromium-headless-shell", "chromium")
NAMES = (*PACKAGES, "chromium-browser", "google-chrome", "google-chrome-stable")

# A page with WebGL but no graphics card, as root in a container, calling nobody.
FLAGS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-compositing",  # only the canvas is worth shaders that a processor runs; the rest of the page is painted without
    "--disable-gpu-rasterization",  # which Debian's own flags ask for
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]


def executable() -> Path | None:
    """Return the path of a Chromium: the system's, else the one that playwright fetched, else None."""
    for name in NAMES:
        found = shutil.which(name)
        if found:
            return Path(found)
    with sync_playwright() as playwright:
        fetched = Path(playwright.chromium.executable_path)
    return fetched if fetched.exists() else None


def bring() -> Path:
    """Return the path of a Chromium, installing one if need be: one of Debian's packages, the shell first, else playwright's build.

    Raises:
        SystemExit: neither could be had.
    """
    sys.path.insert(0, str(SCRIPTS))
    import debian  # type: ignore[import-not-found]

    if not debian.run([*PLAYWRIGHT, "--version"]):
        debian.install("libatomic1")  # what playwright's own Node loads, and a bare Debian lacks
    found = executable()
    if found:
        return found
    if not (debian.is_debian() and any(debian.install(package) for package in PACKAGES)):
        libraries = ["--with-deps"] if debian.as_root() is not None else []
        debian.run([*PLAYWRIGHT, "install", *libraries, "chromium"])
    found = executable()
    if not found:
        raise SystemExit("Chromium is missing and could not be fetched: install chromium, and try again")
    return found


if __name__ == "__main__":
    print(f"Browser tests run in {bring()}")
