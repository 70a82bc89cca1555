"""Files that mean no good, or are broken: each is refused by name, with the reason, before much of it is read."""

from __future__ import annotations

import json
import os
import struct
import tracemalloc
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from catalogs import CatalogError, add_assets, load_catalogs
from catalogs.assets.glb_file import MOST_BYTES, MOST_JSON, GlbFault, bounds_of, read_glb
from tests.assets.makers import changed, folder, joined, parts, shape, under

GOOD = shape("armchair")
MEGABYTE = 1 << 20


def _set(*way: str | int, to: object) -> bytes:
    """The good file with one value changed."""

    def change(document: Any) -> None:
        for step in way[:-1]:
            document = document[step]
        document[way[-1]] = to

    return changed(GOOD, change)


def _grown(change: Callable[[dict[str, Any]], None]) -> bytes:
    return changed(GOOD, change)


def _below_itself(document: dict[str, Any]) -> None:
    document["nodes"][0]["children"] = [1]
    document["nodes"].append({"children": [0]})


def _diamond(document: dict[str, Any]) -> None:
    document["nodes"] += [{"children": [0]}, {"children": [0]}]
    document["scenes"][0]["nodes"] = [1, 2]


def _two_gigabytes(at: int, content: bytes = GOOD) -> bytes:
    return content[:at] + struct.pack("<I", 2**31) + content[at + 4 :]


def _raw(text: bytes) -> bytes:
    """A .glb of a text that need not be JSON."""
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(text), len(text), 0x4E4F534A) + text


def _many(document: dict[str, Any]) -> None:
    """Nodes and parts without triangles whose product would take for ever."""
    part = {"attributes": {"POSITION": 0}}
    document["accessors"][0]["count"] = 1
    document["meshes"][0]["primitives"] = [part] * 20_000
    document["nodes"] = [{"mesh": 0}] * 50_000
    document["scenes"][0]["nodes"] = list(range(50_000))


JSON_LENGTH = struct.unpack_from("<I", GOOD, 12)[0]
HOSTILE = {
    "empty": b"",
    "no glTF": b"PK\x03\x04" + bytes(100),
    "truncated header": GOOD[:15],
    "truncated JSON": GOOD[:200],
    "truncated binary": GOOD[:-1],
    "something after it": GOOD + b"\0" * 4,
    "version 1": GOOD[:4] + struct.pack("<I", 1) + GOOD[8:],
    "2 GB in all": _two_gigabytes(8),
    "2 GB of JSON": _two_gigabytes(12),
    "2 GB of binary": _two_gigabytes(20 + JSON_LENGTH),
    "2 GB in a buffer": _set("buffers", 0, "byteLength", to=2**31),
    "2 GB in a view": _set("bufferViews", 0, "byteLength", to=2**31),
    "2 GB of points": _set("accessors", 0, "count", to=2**31),
    "10^30 points": _set("accessors", 0, "count", to=10**30),
    "an offset below 0": _set("bufferViews", 0, "byteOffset", to=-4),
    "no JSON": _raw(b"{"),
    "JSON that is deep": _raw(b"[" * 100_000),
    "JSON that is a list": _raw(b"[]"),
    "no UTF-8": _raw(b'{"\xff\xfe": 1}'),
    "a number of 10,000 digits": _raw(b'{"scene": ' + b"9" * 10_000 + b"}"),
    "NaN as an end": changed(GOOD, lambda document: document["accessors"][0].update(max=[1.0, float("nan"), 1.0])),
    "infinity as an end": _raw(json.dumps(parts(GOOD)[0]).replace('"max": [', '"max": [1e999, ', 1).encode()),
    "an end that is a text": _set("accessors", 0, "max", to="large"),
    "ends the wrong way round": _set("accessors", 0, "min", to=[9, 9, 9]),
    "no ends": changed(GOOD, lambda document: document["accessors"][0].pop("max")),
    "NaN as a place": under(GOOD, translation=[0, float("nan"), 0]),
    "a scale beyond all measure": under(GOOD, scale=[1e300, 1, 1]),
    "nodes in a circle": _grown(_below_itself),
    "a node twice": _grown(_diamond),
    "a node that is not there": _set("scenes", 0, "nodes", to=[99]),
    "a node that is no number": _set("scenes", 0, "nodes", to=["../../x"]),
    "a node that is a list": _set("scenes", 0, "nodes", to=[[0]]),
    "a mesh that is not there": _set("nodes", 0, "mesh", to=7),
    "a mesh that is no number": _set("nodes", 0, "mesh", to={"x": 1}),
    "a material that is not there": _set("meshes", 0, "primitives", 0, "material", to=77),
    "a mode that is a list": _set("meshes", 0, "primitives", 0, "mode", to=[4]),
    "an unknown type": _set("accessors", 0, "componentType", to=[5126]),
    "no buffers": changed(GOOD, lambda document: document.pop("buffers")),
    "no binary part": joined(parts(GOOD)[0], b""),
    "a second buffer": changed(GOOD, lambda document: document["bufferViews"][0].update(buffer=1)),
    "a buffer by a path": _set("buffers", 0, "uri", to="../../etc/passwd"),
    "a buffer by an address": _set("buffers", 0, "uri", to="http://127.0.0.1:9/x.bin"),
    "an image by a path": _set("images", to=[{"uri": "textures/../../secret.png"}]),
    "an image that is not there": _set("images", to=[{"bufferView": 99, "mimeType": "image/png"}]),
    "Draco": _set("extensionsRequired", to=["KHR_draco_mesh_compression"]),
    "a skeleton": _set("nodes", 0, "skin", to=0),
    "lines alone": _set("meshes", 0, "primitives", to=[{"attributes": {"POSITION": 0}, "mode": 1}]),
    "flat": under(GOOD, scale=[1, 0, 1]),
    "nothing to see": _set("scenes", 0, "nodes", to=[]),
    "no end of parts": _grown(_many),
}


def test_the_file_they_are_made_of_is_good(tmp_path: Path) -> None:
    path = tmp_path / "good.glb"
    path.write_bytes(GOOD)
    assert bounds_of(read_glb(path)).triangles > 100


@pytest.mark.parametrize("name", HOSTILE)
def test_is_refused_by_name_with_little_memory(name: str, tmp_path: Path) -> None:
    at = folder(tmp_path, {"bad.glb": HOSTILE[name]}, {"bad": {"file": "bad.glb", "kinds": ["armchair"]}})
    catalogs = load_catalogs()
    tracemalloc.start()
    with pytest.raises(CatalogError, match=r"bad\.file: bad\.glb ") as refusal:
        add_assets(catalogs, at)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert Path(refusal.value.file) == at / "assets.yaml"
    assert most < len(HOSTILE[name]) * 30 + 4 * MEGABYTE


def _counted(real: Callable[..., bytes], read: list[int], *words: object) -> bytes:
    """Reads, and keeps how much that was."""
    found = real(*words)
    read.append(len(found))
    return found


def test_only_what_a_file_says_of_itself_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not a byte of its points: those of a file may be anything, and as many as they are."""
    document, binary = parts(GOOD)
    paths = [tmp_path / "good.glb", tmp_path / "noise.glb"]
    paths[0].write_bytes(GOOD)
    paths[1].write_bytes(joined(document, b"\xff" * len(binary)))
    read: list[int] = []
    for name in ("read", "pread"):
        real = getattr(os, name)
        monkeypatch.setattr(os, name, partial(_counted, real, read))
    bounds = [bounds_of(read_glb(path)) for path in paths]
    assert bounds[0] == bounds[1]
    assert sum(read) == sum(path.stat().st_size - len(binary) for path in paths)


@pytest.mark.parametrize("size", [MOST_BYTES + 1, 2**31 + 4])
def test_a_huge_file_is_not_read(size: int, tmp_path: Path) -> None:
    """A sparse file: it takes no room on the disk."""
    path = tmp_path / "huge.glb"
    with path.open("wb") as opened:
        opened.write(GOOD[:20])
        opened.truncate(size)
    with pytest.raises(GlbFault, match="the most is 256 MB"):
        read_glb(path)


def test_long_json_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "long.glb"
    path.write_bytes(_raw(b" " * (MOST_JSON + 4)))
    with pytest.raises(GlbFault, match="the most is 4 MB"):
        read_glb(path)


def test_what_is_no_file_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.glb")
    (tmp_path / "folder.glb").mkdir()
    for name in ("pipe.glb", "folder.glb", "nobody.glb"):
        with pytest.raises(GlbFault):
            read_glb(tmp_path / name)


@pytest.mark.parametrize("file", ["../x.glb", "/etc/x.glb", "a/../../x.glb", "a\\x.glb", "C:x.glb", "./x.glb", "x.gltf", "a//x.glb", ""])
def test_a_file_outside_the_folder_is_refused(file: str, tmp_path: Path) -> None:
    at = folder(tmp_path, {}, {"bad": {"file": file, "kinds": ["armchair"]}})
    with pytest.raises(CatalogError, match=r"bad\.file"):
        add_assets(load_catalogs(), at)


@pytest.mark.parametrize("name", ["../x", "a/b", "", ".hidden", "a b", "x" * 101, "\u00e9"])
def test_a_name_that_is_a_path_is_refused(name: str, tmp_path: Path) -> None:
    at = folder(tmp_path, {"x.glb": GOOD}, {name: {"file": "x.glb", "kinds": ["armchair"]}})
    with pytest.raises(CatalogError):
        add_assets(load_catalogs(), at)
