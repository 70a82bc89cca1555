"""Homes by the hundred in MuJoCo, and as other simulators' own programs read them: `python -m tests.targets physics`."""

from __future__ import annotations

import math
import statistics
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from shutil import which

from tqdm import tqdm

from catalogs import load_catalogs
from solver import Request, generate
from solver.exports import ExportSettings, HouseModel, describe, written_as
from solver.exports.moving_parts import still_part
from solver.scene import Scene
from tests.exports.driving import drive
from tests.exports.physics import mjcf, settle, swung
from tests.exports.readers import drake_poses

PROGRAMS = (None, "family", "large")
"""The plain request and two programmes, in turn."""
DRIVEN = 5
"""The base drives through one home of so many."""
SDF_SOURCE = Path(__file__).parent / "readers" / "sdf_models.cpp"


@dataclass
class Proven:
    """What one home, or all, did: free things, doors; what is wrong, in words; steps a second by programme."""

    homes: int = 0
    free: int = 0
    doors: int = 0
    driven: int = 0
    rooms: int = 0
    wrong: list[str] = field(default_factory=list)
    speeds: dict[str, list[float]] = field(default_factory=dict)


def decorated(seed: int) -> Scene:
    """Returns a seed's decorated home."""
    return generate(Request(seed=seed, program=PROGRAMS[seed % len(PROGRAMS)], decorate=True)).scene


def physics_home(seed: int) -> Proven:
    """Lets one home be for 5 s, swings its doors; drives a base through one of DRIVEN."""
    scene, program = decorated(seed), PROGRAMS[seed % len(PROGRAMS)] or "default"
    model = describe(scene, load_catalogs())
    text = mjcf(model)
    done = settle(text)
    wrong = [f"moved: {line}" for line in done.moved] + [f"door: {line}" for line in swung(text)]
    proven = Proven(1, done.free, sum(leaf.motion == "swing" for leaf in model.leaves), speeds={program: [done.speed]})
    if seed % DRIVEN == 0:
        drove = drive(describe(scene, load_catalogs(), free="none"))
        proven.driven, proven.rooms = 1, drove.rooms
        wrong += [f"base touches {name}" for name in sorted(drove.touched)]
        wrong += [f"base does not reach {name}" for name in sorted(drove.missed)]
    proven.wrong = [f"{program} {seed}: {line}" for line in wrong]
    return proven


def physics(homes: int, workers: int) -> bool:
    """Prints what homes do in MuJoCo, and what other readers say of them; returns whether nothing is wrong."""
    total = Proven()
    with ProcessPoolExecutor(workers) as pool:
        for one in tqdm(pool.map(physics_home, range(homes)), total=homes, desc="physics", file=sys.stderr):
            total.homes, total.free, total.doors = total.homes + one.homes, total.free + one.free, total.doors + one.doors
            total.driven, total.rooms = total.driven + one.driven, total.rooms + one.rooms
            total.wrong += one.wrong
            for program, speeds in one.speeds.items():
                total.speeds.setdefault(program, []).extend(speeds)
    print(f"mjcf: {total.homes} homes, {total.free:,} free things in 5 s, {total.doors} doors swung, {len(total.wrong)} complaints")
    print(f"mjcf: a base of 0.5 m drove through {total.driven} homes of {total.rooms} rooms")
    for program, speeds in total.speeds.items():
        print(f"mjcf: {program}: median {statistics.median(speeds):,.0f}, least {min(speeds):,.0f} steps a second of processor time")
    for line in total.wrong[:40]:
        print(f"  {line}")
    findings = list(other_readers(describe(decorated(1), load_catalogs())))
    for line in findings:
        print(line)
    return not total.wrong and not any(line.startswith("FAULT") for line in findings)


def other_readers(model: HouseModel) -> Iterator[str]:
    """Yields what the programs that are installed here say of a home; FAULT begins what is wrong."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for format_name in ("mjcf", "urdf", "sdf"):
            for path, content in written_as(model, ExportSettings(format_name)).items():
                (folder / path).parent.mkdir(exist_ok=True)
                (folder / path).write_bytes(content)
        yield _check_urdf(folder / f"{model.name}.urdf", model)
        yield _libsdformat(folder, model)
        if find_spec("pydrake") is None:
            yield "FAULT drake: not installed: pip install drake"
        else:
            yield from drake_poses.findings(folder, model)


def _check_urdf(path: Path, model: HouseModel) -> str:
    if which("check_urdf") is None:
        return "FAULT check_urdf: not installed: apt-get install liburdfdom-tools"
    done = subprocess.run(["check_urdf", str(path)], capture_output=True, text=True, check=False)
    told = Counter(line.partition(":")[2].strip() for line in done.stdout.splitlines() if line.lstrip().startswith("child("))
    ids = [*(body.id for body in model.bodies), *(leaf.id for leaf in model.leaves)]
    wrong = [name for name in ids if told[name] != 1]
    if done.returncode or wrong:
        return f"FAULT check_urdf: {wrong[:3]}: {done.stderr[:300]}"
    return f"check_urdf: {len(told) + 1} links, each body and leaf once"


def _libsdformat(folder: Path, model: HouseModel) -> str:
    """Compiles and runs sdf_models.cpp; compares its poses and masses with the model's."""
    flags = _package_flags()
    if which("g++") is None or not flags:
        return "FAULT libsdformat: not installed: apt-get install g++ pkg-config libsdformat-dev"
    program = folder / "sdf_models"
    subprocess.run(["g++", "-O0", str(SDF_SOURCE), "-o", str(program), *flags], check=True)
    done = subprocess.run([str(program), str(folder / f"{model.name}.sdf")], capture_output=True, text=True, check=False)
    if done.returncode or done.stderr:
        return f"FAULT libsdformat: {done.stderr[:300]}"
    rows = {row[0]: [float(value) for value in row[1:]] for row in (line.split("\t") for line in done.stdout.splitlines())}
    for body in model.bodies:
        x, y, z, yaw, mass, static, _ = rows[body.id]
        still = still_part(body, {body.id})
        turned = (math.degrees(yaw) - body.turn + 180) % 360 - 180
        same = max(abs(x - body.x), abs(y + body.z), abs(z - body.y)) < 1e-3 and abs(turned) < 0.1
        if not same or abs(mass - still.mass) > 1e-3 * still.mass or bool(static) != (body.fixed and not body.fronts):
            return f"FAULT libsdformat: {body.id} reads back as {rows[body.id]}"
    return f"libsdformat: 0 errors, {len(rows)} models, poses, masses and freedom as described"


def _package_flags() -> list[str]:
    if which("pkg-config") is None:
        return []
    listed = subprocess.run(["pkg-config", "--list-package-names"], capture_output=True, text=True, check=False).stdout.split()
    found = [name for name in listed if name.startswith("sdformat")]
    if not found:
        return []
    return subprocess.run(["pkg-config", "--cflags", "--libs", max(found)], capture_output=True, text=True, check=True).stdout.split()
