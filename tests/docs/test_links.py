"""Links lead somewhere, and names of files and modules are those of the project."""

from __future__ import annotations

import re

from tests.docs.markdown import ROOT, anchors, documents, links, text_of
from tests.every import every

PATH = re.compile(r"`((?:solver|service|catalogs|web|tests|scripts|docs|compose_homes)/[\w./-]*)`")


@every("name", sorted(documents()))
def test_every_link_leads_to_a_file_and_a_heading(name: str) -> None:
    for link in links(name):
        if link.startswith(("http://127.0.0.1", "#", "https://")):
            assert not link.startswith("https://"), "documents lead to nothing outside the project"
            assert not link.startswith("#") or link[1:] in anchors(name), link
            continue
        path, _, anchor = link.partition("#")
        target = (ROOT / name).parent.joinpath(path).resolve()
        assert target.exists(), f"{name}: {link}"
        if anchor:
            assert anchor in anchors(str(target.relative_to(ROOT))), f"{name}: {link}"


@every("name", sorted(set(documents()) - {"CHANGELOG.md"}))
def test_every_file_that_is_named_is_there(name: str) -> None:
    for path in PATH.findall(documents()[name]):
        assert (ROOT / path).exists(), f"{name}: {path}"


def test_every_document_is_led_to() -> None:
    led = {str((ROOT / name).parent.joinpath(link.split("#")[0]).resolve()) for name in documents() for link in links(name)}
    left = [name for name in documents() if name.startswith("docs/") and str(ROOT / name) not in led]
    assert left == []


def test_every_decision_stands_in_the_list_and_has_its_date() -> None:
    index = text_of("docs/decisions/README.md")
    for path in (ROOT / "docs" / "decisions").glob("2*.md"):
        date = path.name[:10]
        assert f"]({path.name})" in index
        assert f"Decided on {date}." in path.read_text()


def test_every_folder_and_module_of_the_solver_is_in_the_map() -> None:
    names = {path.name for path in (ROOT / "solver").iterdir() if path.is_dir()} - {"__pycache__"}
    assert len(names) > 8
    assert [name for name in sorted(names) if not re.search(rf"\b{name}/", text_of("ARCHITECTURE.md"))] == []


def test_the_documents_name_none_that_the_project_does_not_hold() -> None:
    held = {path.name for path in ROOT.glob("*.md")} | {name.split("/")[-1] for name in documents()}
    for name, text in documents().items():
        assert {found.split("/")[-1] for found in re.findall(r"[\w./-]+\.md\b", text)} <= held, name
