"""Plans, buildings and homes by the dozen, opened by what reads them: `python -m tests.targets plans sh3d`."""

from __future__ import annotations

import base64
import math
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from itertools import combinations
from pathlib import Path

import ifcopenshell.validate
from tqdm import tqdm

from catalogs import load_catalogs
from solver import Request, generate
from solver.exports import ExportSettings, HouseModel, describe, written_as
from solver.exports.plan_rooms import label_box
from solver.exports.plan_storeys import storeys_of
from tests.exports import homes
from tests.exports.agreement import differences
from tests.exports.readers import Seen, dxf, ifc, sh3d, svg
from tests.exports.test_svg import meet

PROGRAMS = (None, "family", "large")
READERS = {"svg": svg.read, "dxf": dxf.read, "ifc": ifc.read, "sh3d": sh3d.read}
VALIDATED = 6
"""How many homes have their IFC validated by its schema, which takes half a minute each; one, a family home, also by its rules."""
JAR = Path(os.environ.get("SWEETHOME3D_JAR", "/usr/share/sweethome3d/sweethome3d.jar"))
"""Sweet Home 3D's own library, of Debian's package sweethome3d; OpenAgain.java is run with it."""


def drawn_home(seed: int) -> list[str]:
    """Writes one decorated home in every format of this kind; returns what is wrong."""
    program = PROGRAMS[seed % len(PROGRAMS)]
    model = describe(generate(Request(seed=seed, program=program, decorate=True)).scene, load_catalogs())
    wrong = []
    for name, read in READERS.items():
        files = written_as(model, ExportSettings(name))
        wrong += [f"{name}: {one}" for one in differences(model, read(files))]
        if name == "dxf":
            audits = [drawing.audit() for drawing in dxf.drawings(files)]
            wrong += [f"dxf: {one.message}" for audit in audits for one in (*audit.errors, *audit.fixes)]
        if name == "ifc" and seed < VALIDATED:
            told = ifcopenshell.validate.json_logger()
            ifcopenshell.validate.validate(ifc.building(files), told, express_rules=seed == 1)
            wrong += [f"ifc: {one}" for one in told.statements]
    for storey in storeys_of(model):
        boxes = [*map(label_box, storey.labels)]
        wrong += [f"svg: words meet at {one}" for one, other in combinations(boxes, 2) if meet(one, other)]
        wrong += [f"svg: words on a wall at {box}" for box in boxes for wall in storey.walls if meet(box, wall)]
    return [f"{program or 'default'} {seed}: {one}" for one in wrong]


def drawings(count: int, workers: int) -> bool:
    """Prints what is wrong with plans and buildings of homes; returns whether nothing is."""
    with ProcessPoolExecutor(workers) as pool:
        found = list(tqdm(pool.map(drawn_home, range(count)), total=count, desc="plans", file=sys.stderr))
    wrong = [line for lines in found for line in lines]
    print(f"plans: {count} homes as {', '.join(READERS)}, {len(wrong)} complaints")
    print(*(f"  {line:.200}" for line in wrong[:20]), sep="\n")
    return not wrong


def sweet_homes() -> bool:
    """Has Sweet Home 3D's own library open homes and write them again; returns whether nothing is lost or moved."""
    if not (shutil.which("java") and shutil.which("javac") and JAR.exists()):
        print(f"sh3d: FAULT: not checked: no Java or no {JAR} (Debian: sweethome3d, default-jdk-headless; or set SWEETHOME3D_JAR)")
        return False
    equal = [_opened_again(name, homes.described(name)) for name in ("own", "hostile", "storeys", "family", "default")]
    return all(equal)


def _opened_again(name: str, model: HouseModel) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder, "home.sh3d")
        (content,) = written_as(model, ExportSettings("sh3d")).values()
        home.write_bytes(content)
        words = ["java", "-Djava.awt.headless=true", "-cp", str(JAR), str(Path(__file__).parent / "OpenAgain.java"), str(home)]
        done = subprocess.run([*words, str(Path(folder, "again.sh3d"))], capture_output=True, text=True, check=False)
    if done.returncode:
        print(f"sh3d {name}: {done.stderr:.400}")
        return False
    counts = [line.partition(" ")[2] for line in done.stdout.splitlines() if "\t" not in line]
    wrong = list(differences(model, dict(_seen(line) for line in done.stdout.splitlines() if "\t" in line)))
    print(f"sh3d {name}: {counts[0]}; written again: {'equal' if counts[0] == counts[1] else counts[1]}; {len(wrong)} bodies moved")
    return counts[0] == counts[1] and not wrong


def _seen(line: str) -> tuple[str, Seen]:
    name, *numbers = line.split("\t")
    x, z, y, angle, width, depth, height = map(float, numbers)
    place = x / 100, y / 100, z / 100, -math.degrees(angle)
    return base64.b64decode(name).decode(), Seen(*place, width / 100, depth / 100, height / 100)
