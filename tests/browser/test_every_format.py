"""A file of each kind that is read, dropped on the page: it becomes a home there, and its empty rooms are furnished."""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from io import BytesIO
from typing import Final
from zipfile import ZipFile

from playwright.sync_api import expect

from compose_homes import Request, dump, export, generate
from solver.imports import READERS
from solver.pipeline.import_plan import OWN
from solver.scene import Scene
from tests.browser.test_rooms_and_files import drawn_plan
from tests.browser.visit import SMALL, Visit
from tests.imports.test_foreign_formats import apartment
from tests.sweeps import seeds

DROP = """([name, text]) => {
    const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
    const transfer = new DataTransfer();
    transfer.items.add(new File([bytes], name));
    for (const type of ['dragover', 'drop'])
        window.dispatchEvent(new DragEvent(type, {dataTransfer: transfer, bubbles: true, cancelable: true}));
}"""


@cache
def bare() -> Scene:
    """A small home without furniture."""
    scene = generate(Request(seed=4, program="studio")).scene
    return replace(scene, rooms=tuple(replace(room, furniture=(), decorations=()) for room in scene.rooms), dynamic=(), certificate=None)


def exported(format: str) -> bytes:
    (content,) = export(bare(), format).values()
    return content


FILES: Final[dict[str, tuple[str, Callable[[], bytes]]]] = {
    "home.json": (OWN, lambda: dump(bare(), format="json").encode()),
    "home.yaml": (OWN, lambda: dump(bare(), format="yaml").encode()),
    "home.glb": (OWN, lambda: exported("glb")),
    "flat.geojson": ("geojson", lambda: drawn_plan().encode()),
    "house.json": ("procthor", lambda: exported("procthor")),
    "apartment.json": ("rplan", lambda: json.dumps(apartment()).encode()),
    "home.sh3d": ("sh3d", lambda: exported("sh3d")),
    "Home.xml": ("sh3d", lambda: ZipFile(BytesIO(exported("sh3d"))).read("Home.xml")),
    "plan.dxf": ("dxf", lambda: exported("dxf")),
    "plan.svg": ("svg", lambda: exported("svg")),
    "building.ifc": ("ifc", lambda: exported("ifc")),
}


def test_there_is_a_file_of_each_format() -> None:
    assert {format for format, _ in FILES.values()} == {OWN, *READERS}


def test_each_dropped_file_becomes_a_home_and_is_furnished(visit: Visit) -> None:
    """Furnished once it is a home it is as any other: of some formats in `make test`, of all in `make targets`."""
    visit.open(SMALL.format(4))
    page = visit.page
    furnish = page.get_by_role("button", name="Furnish empty rooms")
    for name, (format, content) in FILES.items():
        page.evaluate(DROP, [name, b64encode(content()).decode()])
        expect(page).to_have_title(f"Compose: {name}")
        visit.settle()
        expected = {"geojson": 2, "rplan": 3}.get(format, len(bare().rooms))
        assert (name, page.evaluate("compose.scene.rooms.length"), visit.count("furniture")) == (name, expected, 0)
        expect(furnish).to_be_visible()
        if name not in seeds([*FILES], 4):
            continue
        furnish.click()
        expect(furnish).to_be_hidden()
        visit.settle()
        assert visit.count("furniture") > 2, name  # of a seed that the page draws
        assert [issue for issue in page.evaluate("compose.scene.issues ?? []") if issue["severity"] == "error"] == [], name
    assert visit.console == []
