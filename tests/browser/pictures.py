"""`make pictures`: the pictures of the README, taken of the real page: a house, and a drag that makes its neighbours move."""

from __future__ import annotations

import argparse
from io import BytesIO
from pathlib import Path
from typing import Any

from PIL import Image, ImageOps
from playwright.sync_api import Browser, Page, ViewportSize, sync_playwright

from tests.browser.service_process import ROOT, running
from tests.browser.visit import Visit
from tests.chromium import FLAGS, bring

FOLDER = ROOT / "web" / "pictures"
STARTS = ROOT / "web" / "src" / "starts"
START_PIXELS = (204, 138)
FAINT = 100
"""What is seen less than this, of 255, is the shade beside a home."""
HOUSE = "?program=family&decorate=true&style=scandi&seed=11"
ROOM = "?program=one_bed&decorate=true&style=mid_century&seed=12"
PAGE_SIZE: ViewportSize = {"width": 1440, "height": 860}
DRAG_SIZE: ViewportSize = {"width": 1180, "height": 620}
DRAG_M = 1.2
NEARER = 7
"""How often the wheel is turned towards the room."""
RISE_PX = 40
"""The wheel is turned this much north of the sofa: towards the middle of its room."""
STEPS = 16
FRAME_MS = 90
PAUSE_MS = 1200
"""How long the first and the last frame stand [ms]."""
ANSWERED_MS = 350
"""How long a step waits for its answer and the slide towards it [ms]."""


def house(browser: Browser, address: str, to: Path) -> None:
    """Takes the whole page with a decorated house."""
    page = browser.new_page(viewport=PAGE_SIZE)
    visit = Visit(page, address)
    visit.open(HOUSE)
    visit.settle()
    Image.open(BytesIO(page.screenshot())).convert("RGB").save(to, quality=86, method=6)
    page.close()


def starts(browser: Browser, address: str) -> None:
    """Takes the homes that the page offers to begin with, small, each as its link asks for it, on clear ground for light pages and dark."""
    page = browser.new_page(viewport={"width": 1100, "height": 640}, color_scheme="light")
    visit = Visit(page, address)
    visit.open(ROOM)
    for link in page.locator("#starts a").all():
        visit.after(link.click)
        page.locator("#stage > :not(canvas)").evaluate_all("all => all.forEach(one => { one.style.visibility = 'hidden'; })")
        page.locator("html, body, #stage").evaluate_all("all => all.forEach(one => { one.style.background = 'none'; })")
        seen = Image.open(BytesIO(page.locator("#stage > canvas").screenshot(omit_background=True))).convert("RGBA")
        name = str(link.get_attribute("href")).partition("program=")[2].partition("&")[0]
        home = seen.crop(seen.getchannel("A").point(lambda alpha: 255 * (alpha > FAINT)).getbbox())
        ImageOps.pad(home, START_PIXELS, color=(0, 0, 0, 0)).save(STARTS / f"{name}.webp", quality=82, method=6)
    page.close()


def drag(browser: Browser, address: str, to: Path) -> None:
    """Takes a drag of a sofa through its room, a frame a step."""
    page = browser.new_page(viewport=DRAG_SIZE)
    visit = Visit(page, address)
    scene = visit.open(ROOM)["scene"]
    sofa = next(piece for room in scene["rooms"] for piece in room["furniture"] if piece["name"] == "sofa")
    _come_near(visit, sofa["id"])
    frames = [_frame(page)]
    at = page.evaluate("id => compose.whereIs(id)", sofa["id"])
    scale = _pixels_a_metre(visit, scene)
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    for step in range(1, STEPS + 1):
        page.mouse.move(at["x"], at["y"] - DRAG_M * scale * step / STEPS)
        page.wait_for_timeout(ANSWERED_MS)
        frames.append(_frame(page))
    page.mouse.up()
    visit.settle()
    frames.append(_frame(page))
    pauses = [PAUSE_MS, *[FRAME_MS] * (len(frames) - 2), PAUSE_MS]
    frames[0].save(to, save_all=True, append_images=frames[1:], duration=pauses, loop=0, quality=72, method=6)
    page.close()


def _come_near(visit: Visit, id_of: str) -> None:
    """Looks from above, as near as a room is large."""
    visit.page.keyboard.press("2")
    visit.settle()
    at = visit.page.evaluate("id => compose.whereIs(id)", id_of)
    visit.page.mouse.move(at["x"], at["y"] - RISE_PX)
    for _ in range(NEARER):
        visit.page.mouse.wheel(0, -120)
        visit.settle()


def _frame(page: Page) -> Image.Image:
    """The canvas with its labels as it is now."""
    return Image.open(BytesIO(page.locator("#stage").screenshot())).convert("RGB")


def _pixels_a_metre(visit: Visit, scene: dict[str, Any]) -> float:
    """How many pixels a metre is where two pieces of the scene are seen from above."""
    seen = []
    for room in scene["rooms"]:
        for piece in room["furniture"]:
            at = visit.page.evaluate("id => compose.whereIs(id)", piece["id"])
            if at:
                seen.append((room["x"] + piece["x"], at["x"]))
    (west, left), (east, right) = min(seen), max(seen)
    return float((right - left) / (east - west))


def main() -> None:
    """Takes the pictures, or those that are named."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", nargs="?", choices=["house", "starts", "drag"], help="which; by default all")
    name = parser.parse_args().name
    FOLDER.mkdir(exist_ok=True)
    STARTS.mkdir(exist_ok=True)
    executable = bring()
    with running() as service, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=FLAGS)
        if name in (None, "house"):
            house(browser, service.address, FOLDER / "house.webp")
        if name in (None, "starts"):
            starts(browser, service.address)
        if name in (None, "drag"):
            drag(browser, service.address, FOLDER / "drag.webp")
        browser.close()


if __name__ == "__main__":
    main()
