"""The build hook that puts the built page into the wheel; an editable install goes without, `make page` builds its page."""

import subprocess
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "scripts"))

from page import NODE_PACKAGE, system_node  # noqa: E402 - the build frontend puts no folder of ours on the path


class PageHook(BuildHookInterface):
    """Build the page before the wheel is packed."""

    PLUGIN_NAME = "custom"

    def dependencies(self) -> list[str]:
        """Ask for the packaged Node where the system's does not suit."""
        return [] if system_node() else [NODE_PACKAGE]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the page for a wheel.

        Args:
            version: `standard`, or `editable` for an install that reads the page from the work tree.
            build_data: What hatchling packs; the page is named among the artifacts in pyproject.toml.

        Raises:
            CalledProcessError: the page could not be built.
        """
        if self.target_name == "wheel" and version == "standard":
            subprocess.run([sys.executable, str(ROOT / "scripts" / "page.py"), "build"], check=True)
