"""The build hook of the wheel: the built core and page, and everything under the one name `compose_homes`.

In the tree `catalogs/`, `solver/` and `service/` stand side by side. An installed wheel must not take such names from others, so there
they are packages of `compose_homes`, and their imports of each other say so. An editable install reads the tree as it is.
"""

import ast
import subprocess
import sys
from pathlib import Path
from shutil import copyfile
from tempfile import TemporaryDirectory
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).resolve().parent
PUBLIC = "compose_homes"
INSIDE = ("catalogs", "solver", "service")
LEFT_OUT = (".cpp", ".hpp", ".built-from")
sys.path.insert(0, str(ROOT / "scripts"))

from core import COMPILER, packaged_compiler  # noqa: E402 - the build frontend puts no folder of ours on the path
from page import NODE_PACKAGE, system_node  # noqa: E402


def inside(source: str) -> str:
    """Return a Python source that imports `solver.scene` as `compose_homes.solver.scene`, and so on.

    Raises:
        ValueError: it says `import solver.scene`, which would bind another name; only `from solver.scene import` is moved.
    """
    lines = source.splitlines(keepends=True)
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import) and any(alias.name.split(".")[0] in INSIDE for alias in node.names):
            raise ValueError(f"line {node.lineno}: {ast.unparse(node)!r} cannot be moved: say `from ... import ...`")
        if isinstance(node, ast.ImportFrom) and not node.level and (node.module or "").split(".")[0] in INSIDE:
            line, start = lines[node.lineno - 1], node.col_offset + len("from ")
            lines[node.lineno - 1] = f"{line[:start]}{PUBLIC}.{line[start:]}"
    return "".join(lines)


def gather(target: Path) -> None:
    """Write what the wheel holds into a folder: the public package with the others inside."""
    for name in (PUBLIC, *INSIDE):
        for path in sorted((ROOT / name).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts and path.suffix not in LEFT_OUT:
                to = target / path.relative_to(ROOT / PUBLIC if name == PUBLIC else ROOT)
                to.parent.mkdir(parents=True, exist_ok=True)
                if path.suffix == ".py":
                    to.write_bytes(inside(path.read_bytes().decode()).encode())
                else:
                    copyfile(path, to)


class WheelHook(BuildHookInterface):
    """Build the core and the page, and gather the packages before the wheel is packed."""

    PLUGIN_NAME = "custom"

    def dependencies(self) -> list[str]:
        """Ask for the core's compiler where the tree has none, and for the packaged Node where the system's does not suit."""
        return [*([] if packaged_compiler() else [COMPILER]), *([] if system_node() else [NODE_PACKAGE])]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Prepare a wheel.

        Args:
            version: `standard`, or `editable` for an install that reads the work tree.
            build_data: What hatchling packs; the gathered folder is added.

        Raises:
            CalledProcessError: the core or the page could not be built.
        """
        if self.target_name == "wheel" and version == "standard":
            for tool in ("core.py", "page.py"):
                subprocess.run([sys.executable, str(ROOT / "scripts" / tool), "build"], check=True)
            self.gathered = TemporaryDirectory()
            gather(Path(self.gathered.name))
            build_data["force_include"][self.gathered.name] = PUBLIC
