"""Exports over HTTP: a file or an archive, under a name, of the media type of its format."""

from __future__ import annotations

import io
import zipfile
from dataclasses import replace
from typing import Any

import pytest
from starlette.testclient import TestClient

from compose_homes import EXPORT_FORMATS, Furniture, RequestError, Room, Scene, SceneError, export
from solver.export_formats import EXPORTERS
from solver.exports import writers
from solver.exports.writers import packed

SOFA = Furniture("s", "sofa", x=2.0, z=2.5, width=2.0, depth=0.9, height=0.85)
DEN = Scene(rooms=(Room("den", type="office", width=4.0, depth=3.0, furniture=(SOFA,)),))
BROKEN = replace(DEN, rooms=(replace(DEN.rooms[0], furniture=(replace(SOFA, x=9.0),)),))


def body(**more: object) -> dict[str, Any]:
    piece = {"id": "s", "name": "sofa", "x": 2.0, "z": 2.5, "width": 2.0, "depth": 0.9, "height": 0.85, **more}
    return {"scene": {"rooms": [{"id": "den", "type": "office", "width": 4, "depth": 3, "furniture": [piece]}]}}


@pytest.mark.parametrize("format", EXPORTERS)
def test_every_format_is_answered_with_what_the_library_writes(client: TestClient, format: str) -> None:
    answer = client.post(f"/export/{format}", json=body())
    assert answer.status_code == 200, answer.text
    files = export(DEN, format)
    assert "attachment" in answer.headers["content-disposition"]
    if len(files) == 1:
        assert answer.content == next(iter(files.values()))
        assert answer.headers["content-type"].partition(";")[0] == EXPORTERS[format].media_type
    else:
        archive = zipfile.ZipFile(io.BytesIO(answer.content))
        assert {name: archive.read(name) for name in archive.namelist()} == files


def test_the_formats_are_listed(client: TestClient) -> None:
    listed = client.get("/export").json()["formats"]
    assert {one["name"]: one["words"] for one in listed} == EXPORT_FORMATS
    assert all(one["available"] for one in listed)


def test_a_scene_with_errors_is_exported_unless_strict_is_asked_for(client: TestClient) -> None:
    assert client.post("/export/csv", json=body(x=9.0)).status_code == 200
    refused = client.post("/export/csv", json={**body(x=9.0), "strict": True})
    assert (refused.status_code, refused.json()["errors"][0]["field"]) == (422, "scene")
    with pytest.raises(SceneError, match="errors"):
        export(BROKEN, "csv", strict=True)


def test_what_is_free_to_move_is_checked(client: TestClient) -> None:
    assert client.post("/export/csv", json={**body(), "free": "some"}).status_code == 422
    moving = client.post("/export/csv", json={**body(), "free": "standing"}).text
    assert moving.splitlines()[1].endswith("no")
    assert client.post("/export/csv", json=body()).text.splitlines()[1].endswith("yes")


def test_an_unknown_format_and_a_missing_library_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(RequestError, match="csv"):
        export(DEN, "papyrus")
    monkeypatch.setitem(EXPORTERS, "csv", EXPORTERS["csv"]._replace(needs=("no_such_library", "usd")))
    with pytest.raises(RequestError, match=r"compose-homes\[usd\]"):
        export(DEN, "csv")
    assert not writers.is_available("csv")


def test_archives_of_equal_files_are_equal() -> None:
    files = {"a.txt": b"1", "b/c.txt": b"2" * 1000}
    name, media_type, content = packed(files, "both", "text/plain")
    assert (name, media_type) == ("both.zip", "application/zip")
    assert packed(dict(files), "both", "text/plain")[2] == content
    assert {info.date_time[0] for info in zipfile.ZipFile(io.BytesIO(content)).infolist()} == {1980}


@pytest.mark.parametrize("format", EXPORTERS)
def test_equal_scenes_give_equal_bytes(format: str) -> None:
    assert export(DEN, format) == export(DEN, format)
