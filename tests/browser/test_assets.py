"""The page shows the user's own assets, goes on while they come, and does without those that do not."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from catalogs import add_assets, load_catalogs
from compose_homes import Request, generate
from solver.exchange import write_scene
from tests.assets.makers import dense, folder, shape, textured, under
from tests.browser.service_process import ServiceProcess, running
from tests.browser.visit import Visit, first, intercept

pytestmark = pytest.mark.own_page

KINDS = ("toilet", "bathtub", "vanity", "shoe_cabinet", "coat_rack", "dining_chair")
HOME = "?seed=3&program=studio&decorate=true&outdoor=false"


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with an asset for each of some kinds: in centimetres, turned, with a picture; one of them large."""
    files, entries = {}, {}
    for kind in KINDS:
        made = dense(shape(kind), 120) if kind == "toilet" else shape(kind)
        files[f"{kind}.glb"] = textured(under(made, scale=[100] * 3, rotation=[0, 0.5**0.5, 0, 0.5**0.5]))
        heights = [surface.height for surface in load_catalogs().furniture[kind].surfaces]
        entries[f"own_{kind}"] = {"file": f"{kind}.glb", "kinds": [kind], "front": "+x", "license": "CC0-1.0", "surfaces": heights}
    return folder(tmp_path_factory.mktemp("own"), files, entries)


@pytest.fixture(scope="module")
def keeper(own: Path) -> Iterator[ServiceProcess]:
    """A service with these assets."""
    with running(0, "--assets", str(own)) as process:
        yield process


@pytest.fixture
def furnished(page: Page, keeper: ServiceProcess) -> Visit:
    """A visit to the service with these assets."""
    return Visit(page, keeper.address)


def come(visit: Visit) -> dict[str, int]:
    """Waits until no asset is on its way; how many were wanted, came and did not."""
    expect(visit.page.locator("#assets_shown")).not_to_contain_text("loaded…")
    count: dict[str, int] = visit.state()["assets"]
    assert count["come"] + count["missing"] == count["wanted"]
    return count


def test_assets_are_shown_and_offered_and_change_nothing_else(furnished: Visit, own: Path) -> None:
    scene = furnished.open(HOME)["scene"]
    named = {piece["asset"] for room in scene["rooms"] for piece in room["furniture"] if "asset" in piece}
    assert named
    made = generate(Request(seed=3, program="studio", decorate=True, outdoor=False), catalogs=add_assets(load_catalogs(), own)).scene
    assert write_scene(made)["rooms"] == scene["rooms"]
    assert come(furnished) == {"wanted": len(named), "come": len(named), "missing": 0}
    expect(furnished.page.locator("#assets_shown")).to_be_hidden()
    with_assets = furnished.state()["drawCalls"]
    furnished.page.keyboard.press("a")
    furnished.page.get_by_role("searchbox", name="Add a piece").fill("own toilet")
    expect(furnished.page.locator("#palette button[data-kind=own_toilet]")).to_be_visible()
    assert with_assets <= 60 + 8 * len(named)
    assert furnished.console == []


def test_the_page_goes_on_while_an_asset_is_awaited_and_without_one_that_does_not_come(furnished: Visit) -> None:
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    intercept(furnished.page, "**/asset/*", hold)
    furnished.open(HOME)
    expect(furnished.page.locator("#assets_shown")).to_contain_text("Assets: 0 of")
    furnished.page.keyboard.press("2")
    furnished.held("ArrowLeft")
    wanted = furnished.state()["assets"]["wanted"]
    for _ in range(wanted):
        first(furnished.page, held).abort()
        del held[0]
    count = come(furnished)
    assert count["come"] == 0 < count["missing"]
    expect(furnished.page.locator("#assets_shown")).to_contain_text("plain shapes stand for them")


def test_an_asset_is_served_by_its_name_alone(furnished: Visit, own: Path) -> None:
    fetched = furnished.page.request.get(furnished.address + "asset/own_toilet")
    assert (fetched.status, fetched.headers["content-type"]) == (200, "model/gltf-binary")
    assert fetched.body() == (own / "toilet.glb").read_bytes()
    for name in ("nobody", "..%2Ftoilet.glb", "toilet.glb", "%2Fetc%2Fpasswd", "__proto__"):
        assert furnished.page.request.get(f"{furnished.address}asset/{name}").status == 404
    assert str(own) not in furnished.page.request.get(furnished.address + "catalog").text()
