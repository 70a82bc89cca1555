"""The page, its files, the description of the calls, and the headers around them."""

from __future__ import annotations

import gzip
import re
from base64 import b64encode
from hashlib import sha256
from html.parser import HTMLParser
from pathlib import Path
from unittest.mock import Mock

import pytest
from starlette.testclient import TestClient

from service import page
from service.app import create_app
from solver.core import WASM

HTML = '<!doctype html><html><head><script type="module" src="./assets/index-1a2b.js"></script></head><body>ours</body></html>'


class Tags(HTMLParser):
    """Collects a page's tags with their attributes."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.seen: list[tuple[str, dict[str, str | None]]] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.append((tag, dict(attrs)))


@pytest.fixture
def built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> TestClient:
    """A client of an application whose page is built."""
    (tmp_path / "assets").mkdir()
    (tmp_path / "index.html").write_text(HTML)
    (tmp_path / "embed.html").write_text(HTML)
    (tmp_path / "assets" / "index-1a2b.js").write_text("export const house = 1;\n")
    monkeypatch.setattr(page, "STATIC", tmp_path)
    return TestClient(create_app())


def test_the_built_page_is_served_and_asked_for_anew(built: TestClient) -> None:
    answer = built.get("/")
    assert (answer.status_code, answer.text) == (200, HTML)
    assert answer.headers["content-type"].startswith("text/html")
    assert answer.headers["cache-control"] == "no-cache"
    assert built.head("/").status_code == 200


def test_the_files_of_the_page_may_be_kept(built: TestClient) -> None:
    answer = built.get("/assets/index-1a2b.js")
    assert answer.text == "export const house = 1;\n"
    assert re.match(r"(text|application)/javascript", answer.headers["content-type"])
    assert "immutable" in answer.headers["cache-control"]
    again = built.get("/assets/index-1a2b.js", headers={"if-none-match": answer.headers["etag"]})
    assert (again.status_code, again.text) == (304, "")
    assert built.get("/assets/%2e%2e/index.html").status_code == 404


@pytest.mark.parametrize("path", ["/", "/assets/long-1a2b.js", "/catalog", "/core.wasm", "/openapi.json", "/docs"])
def test_what_is_large_comes_packed_to_who_takes_it_so(built: TestClient, path: str) -> None:
    (page.STATIC / "assets" / "long-1a2b.js").write_text("export const house = 1;\n" * 10_000)
    (page.STATIC / "index.html").write_text(HTML + " " * 10_000)
    plain, refused, packed = (built.get(path, headers={"accept-encoding": coding}) for coding in ("identity", "gzip;q=0, *", "br, gzip"))
    assert "content-encoding" not in {**plain.headers, **refused.headers}
    assert packed.headers["content-encoding"] == "gzip"
    assert "accept-encoding" in packed.headers["vary"].lower()
    assert packed.content == plain.content
    assert packed.num_bytes_downloaded < 0.6 * plain.num_bytes_downloaded
    assert packed.headers["x-content-type-options"] == "nosniff"


def test_what_the_page_loads_is_packed_once_for_all_until_it_is_built_anew(built: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    packing = Mock(wraps=gzip.compress)
    monkeypatch.setattr(gzip, "compress", packing)
    pages = [HTML + f"{name:10000}" for name in ("one of this test", "the next of this test")]
    for html in pages:
        (page.STATIC / "index.html").write_text(html)
        assert [built.get("/", headers={"accept-encoding": "gzip"}).text for _ in range(3)] == [html] * 3
    assert "http://localhost:7/" in built.get("/docs", headers={"host": "localhost:7", "accept-encoding": "gzip"}).text  # for one, not kept
    assert [call.args[0] for call in packing.call_args_list] == [html.encode() for html in pages]


@pytest.mark.parametrize("path", ["/", "/embed", "/core.wasm", "/favicon.ico"])
@pytest.mark.parametrize("coding", ["identity", "gzip"])
def test_what_a_browser_has_is_not_sent_again_until_it_changes(
    built: TestClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, path: str, coding: str
) -> None:
    files = {"/": "index.html", "/embed": "embed.html", "/core.wasm": "core.wasm", "/favicon.ico": "assets/icon-1a2b.svg"}
    monkeypatch.setattr(page, "WASM", tmp_path / "core.wasm")
    file = tmp_path / files[path]
    file.write_text("before" * 1000)
    first = built.get(path, headers={"accept-encoding": coding})
    known = {"accept-encoding": coding, "if-none-match": first.headers["etag"]}
    again = built.get(path, headers=known)
    assert (again.status_code, again.content) == (304, b"")
    for name in ("cache-control", "content-security-policy", "x-frame-options"):
        assert again.headers.get(name) == first.headers.get(name)
    file.write_text("after" * 1000)
    changed = built.get(path, headers=known)
    assert (changed.status_code, changed.text) == (200, "after" * 1000)


def test_files_come_packed_to_who_takes_them_so_unless_they_are_zip_files(client: TestClient) -> None:
    scene = {"rooms": [{"width": 4, "depth": 3}]}
    for format, coding in (("mjcf", "gzip"), ("ifc", "gzip"), ("usdz", "gzip"), ("boxes", None)):
        plain, packed = (client.post(f"/export/{format}", json=scene, headers={"accept-encoding": one}) for one in ("identity", "gzip"))
        assert (plain.headers.get("content-encoding"), packed.headers.get("content-encoding")) == (None, coding), format
        assert packed.content == plain.content, format


def test_answers_to_calls_come_as_they_are(client: TestClient) -> None:
    answer = client.post("/generate", json={"seed": 3, "program": "studio"}, headers={"accept-encoding": "gzip"})
    assert answer.status_code == 200
    assert len(answer.content) > 10_000
    assert "content-encoding" not in answer.headers


def test_a_page_that_is_not_built_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page, "STATIC", tmp_path / "nothing")
    client = TestClient(create_app())
    answer = client.get("/")
    assert answer.status_code == 503
    assert answer.headers["content-type"].startswith("text/plain")
    assert "make run" in answer.text
    assert client.get("/assets/index.js").status_code == 404
    assert client.get("/healthz").status_code == 200


@pytest.mark.parametrize("path", ["/", "/assets/index-1a2b.js", "/docs", "/healthz", "/openapi.json", "/nothing"])
def test_every_answer_carries_the_security_headers(built: TestClient, path: str) -> None:
    headers = built.get(path).headers
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["x-frame-options"] == "DENY"
    assert headers["referrer-policy"] == "same-origin"
    assert headers["cross-origin-opener-policy"] == "same-origin"
    policy = dict(part.strip().partition(" ")[::2] for part in headers["content-security-policy"].split(";"))
    assert policy["default-src"] == "'none'"
    assert policy["frame-ancestors"] == "'none'"
    assert "unsafe" not in headers["content-security-policy"]
    assert "http" not in headers["content-security-policy"]


def test_other_places_show_the_page_of_frames_alone(built: TestClient) -> None:
    answer, page_itself = built.get("/embed"), built.get("/")
    assert (answer.status_code, answer.text) == (200, HTML)
    assert "x-frame-options" not in answer.headers
    policy, whole = answer.headers["content-security-policy"].split("; "), page_itself.headers["content-security-policy"].split("; ")
    assert sorted(set(policy) ^ set(whole)) == ["frame-ancestors 'none'", "frame-ancestors *", "worker-src 'none'", "worker-src 'self'"]
    others = {
        name: value
        for name, value in page_itself.headers.items()
        if name in answer.headers and name.startswith(("x-c", "ref", "perm", "cross"))
    }
    assert len(others) == 4
    assert {name: answer.headers[name] for name in others} == others
    assert built.get("/embed/x").headers["x-frame-options"] == "DENY"


def test_the_page_may_run_its_own_scripts_only(built: TestClient) -> None:
    policy = built.get("/").headers["content-security-policy"]
    assert "script-src 'self';" in policy
    assert "connect-src 'self' blob:;" in policy


def test_the_worker_alone_may_compile_the_core(built: TestClient) -> None:
    (page.STATIC / "assets" / f"{page.WORKER}1a2b.js").write_text("postMessage('core')")
    assert "script-src 'self' 'wasm-unsafe-eval';" in built.get(f"/assets/{page.WORKER}1a2b.js").headers["content-security-policy"]
    assert "wasm" not in built.get("/assets/index-1a2b.js").headers["content-security-policy"]


def test_the_core_is_served_as_it_is_run_here(built: TestClient) -> None:
    answer = built.get("/core.wasm")
    assert (answer.status_code, answer.headers["content-type"]) == (200, "application/wasm")
    assert answer.content == WASM.read_bytes()
    assert answer.headers["cache-control"] == "no-cache"


def test_the_description_needs_no_script_and_nothing_from_elsewhere(client: TestClient) -> None:
    answer = client.get("/docs")
    tags = Tags(answer.text).seen
    assert answer.status_code == 200
    assert {tag for tag, _ in tags}.isdisjoint({"script", "link", "img", "iframe"})
    assert all(not name.startswith("on") and name != "style" for _, attributes in tags for name in attributes)
    assert not re.search(r"(src|href)=[\"']https?:", answer.text)
    style = answer.text.partition("<style>")[2].partition("</style>")[0]
    digest = b64encode(sha256(style.encode()).digest()).decode()
    assert f"style-src 'sha256-{digest}'" in answer.headers["content-security-policy"]
    assert "script-src" not in answer.headers["content-security-policy"]


def test_the_description_shows_every_call_and_every_key(client: TestClient) -> None:
    text = client.get("/docs").text
    document = client.get("/openapi.json").json()
    assert len(document["paths"]) >= 10
    assert all(f"</b> {path}</h2>" in text for path in document["paths"])
    assert all(f"<code>{name}</code>" in text for name in document["components"]["schemas"]["Request"]["properties"])
    targets = {attributes["id"] for _, attributes in Tags(text).seen if "id" in attributes}
    links = {str(attributes["href"])[1:] for tag, attributes in Tags(text).seen if tag == "a" and str(attributes["href"]).startswith("#")}
    assert len(links) > 10
    assert links <= targets


def test_the_description_escapes_where_it_is(client: TestClient) -> None:
    text = client.get("/docs", headers={"host": 'a"><script>alert(1)</script>'}).text
    assert "<script" not in text


def test_browsers_find_an_icon_beside_answers_that_name_none(built: TestClient) -> None:
    assert built.get("/favicon.ico").status_code == 204
    (page.STATIC / "assets" / "icon-1a2b.svg").write_text("<svg/>")
    answer = built.get("/favicon.ico")
    assert (answer.status_code, answer.text, answer.headers["content-type"]) == (200, "<svg/>", "image/svg+xml")
