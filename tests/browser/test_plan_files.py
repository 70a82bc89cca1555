"""The plan as SVG, as a picture and on paper, at a scale; its lengths are the scene's own."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from playwright.sync_api import expect

from tests.browser.visit import SMALL, Visit

SVG = "{http://www.w3.org/2000/svg}"
PRINTS = "() => { globalThis.print = () => new Promise(done => { globalThis.printed = done; }); }"
A4 = (210, 297)


@pytest.mark.own_page
def test_the_plan_goes_along_as_svg_png_and_paper_at_a_scale(visit: Visit, tmp_path: Path) -> None:
    page, scene = visit.page, visit.open(SMALL.format(4))["scene"]
    page.locator("#plan_scale").select_option("100")
    with page.expect_download() as caught:
        page.get_by_role("button", name="Plan as SVG").click()
    caught.value.save_as(tmp_path / "plan.svg")
    root = ElementTree.parse(tmp_path / "plan.svg").getroot()
    wide = float(root.attrib["viewBox"].split()[2])
    assert float(root.attrib["width"].removesuffix("mm")) == round(wide / 100, 6)
    floors = {one.attrib["data-id"]: one.attrib["points"] for one in root.iter(f"{SVG}polygon") if one.attrib["class"] == "floor"}
    for room in scene["rooms"]:
        corners = [tuple(map(int, point.split(","))) for point in floors[room["id"]].split()]
        assert min(x for x, _ in corners) == round(room["x"] * 1000)
        assert max(x for x, _ in corners) == round((room["x"] + room["width"]) * 1000)
        assert max(z for _, z in corners) - min(z for _, z in corners) == round(room["depth"] * 1000)
    with page.expect_download() as caught:
        page.get_by_role("button", name="Plan as PNG").click()
    caught.value.save_as(tmp_path / "plan.png")
    header = (tmp_path / "plan.png").read_bytes()[:24]
    assert int.from_bytes(header[16:20]) == round(wide / 100 * 300 / 25.4)
    page.evaluate(PRINTS)
    page.get_by_role("button", name="Print the plan").click()
    page.wait_for_function("() => globalThis.printed !== undefined")
    sheets = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", page.pdf(prefer_css_page_size=True))
    assert [sorted(round(float(side) / 72 * 25.4) for side in sides) for sides in sheets] == [list(A4)]
    page.evaluate("globalThis.printed()")
    expect(page.locator("#plan_print")).to_be_hidden()
    page.evaluate("delete globalThis.printed")
    page.locator("#stage").focus()
    page.keyboard.press("Control+p")  # beside the house in 3D, where the page has nothing of its own to print
    page.wait_for_function("() => globalThis.printed !== undefined")
    page.evaluate("globalThis.printed()")
    expect(page.locator("#plan_print")).to_be_hidden()
    page.emulate_media(media="print")
    expect(page.locator(".print-words")).to_be_visible()
    page.emulate_media(media="screen")
    expect(page.locator(".print-words")).to_be_hidden()
    assert visit.console == []
