"""glb and usd of many homes, judged by Khronos' validator, usd-core's and Blender: `python -m tests.targets glb usd`."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from tqdm import tqdm

from compose_homes import Request, export, generate
from tests.architecture.tree import ROOT
from tests.exports.readers.usd import findings, stage_of

PROGRAMS = (None, "family", "large")
"""The plain request and two programmes, in turn."""
BLENDER = "bpy==5.0.1"
_IMPORT = """
import bpy, sys
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=sys.argv[-1])
print("bodies", sum("sort" in one.keys() for one in bpy.data.objects))
"""


def _written(seed: int, format: str) -> bytes:
    scene = generate(Request(seed=seed, program=PROGRAMS[seed % len(PROGRAMS)], decorate=True)).scene
    (content,) = export(scene, format).values()
    return content


def _glb(seed: int) -> bytes:
    return _written(seed, "glb")


def _usd(seed: int) -> list[str]:
    return [f"usd {seed}: {line}" for line in findings(stage_of({"house.usda": _written(seed, "usd")}))]


def _many(work: Callable[[int], Any], homes: int, workers: int, name: str) -> list[Any]:
    with ProcessPoolExecutor(workers) as pool:
        return list(tqdm(pool.map(work, range(homes), chunksize=2), total=homes, desc=name, file=sys.stderr))


def usd_homes(homes: int, workers: int) -> bool:
    """Prints what usd-core's validators find in many homes; returns whether it is nothing."""
    found = [line for lines in _many(_usd, homes, workers, "usd") for line in lines]
    print("\n".join([f"usd: {homes} homes, {len(found)} findings", *found[:20]]))
    return not found


def glb_homes(homes: int, workers: int) -> bool:
    """Prints what Khronos' validator finds in many homes, and whether Blender takes one; returns whether all is well."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder, f"{seed}.glb") for seed in range(homes)]
        for path, content in zip(paths, _many(_glb, homes, workers, "glb"), strict=True):
            path.write_bytes(content)
        report = Path(folder, "report.json")
        command = [sys.executable, str(ROOT / "scripts" / "page.py"), "validate-glb", str(report), *map(str, paths)]
        subprocess.run(command, check=True, capture_output=True)
        found = [message for one in json.loads(report.read_text()) for message in one["issues"]["messages"]]
        print("\n".join([f"glb: {homes} homes, {len(found)} findings", *map(str, found[:20])]))
        return not found and _blender(paths[1])


def _blender(path: Path) -> bool:
    """Imports a house into Blender, where it is installed; returns whether all its bodies came."""
    if find_spec("bpy") is None:
        print(f"glb: FAULT: not imported into Blender, which is not installed here (pip install {BLENDER})")
        return False
    run = subprocess.run([sys.executable, "-c", _IMPORT, str(path)], check=True, capture_output=True, text=True)
    content = path.read_bytes()
    (line,) = [line for line in run.stdout.splitlines() if line.startswith("bodies ")]
    print(f"glb: Blender imports {line}")
    return int(line.split()[1]) == content.count(b'"sort":"')
