"""Folders of own assets for tests: GLBs made of our own shapes, in any unit, size and turn; and files that mean no good."""

from __future__ import annotations

import atexit
import json
import struct
import zlib
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory, mkdtemp
from typing import Any

import numpy as np
import yaml

from catalogs import load_catalogs
from compose_homes import Furniture, Room, Scene, export
from solver.scene import Decoration

Document = dict[str, Any]
Size = tuple[float, float, float]


@cache
def shape(kind: str, size: Size | None = None) -> bytes:
    """A .glb of a kind's shape, m, as large as the kind or as said: width, depth, height."""
    catalogs = load_catalogs()
    spec = catalogs.furniture.get(kind) or catalogs.decorations[kind]
    width, depth, height = size or spec.size
    here: dict[str, Any] = {
        "id": "thing",
        "x": 5.0,
        "z": 5.0,
        "width": width,
        "depth": depth,
        "height": height,
        "color": spec.color,
        "kind": kind,
    }
    if kind in catalogs.furniture:
        room = Room("room", width=10, depth=10, furniture=(Furniture(name=catalogs.name_of(kind), **here),))
    else:
        room = Room("room", width=10, depth=10, decorations=(Decoration(name=kind, **here),))
    files = export(Scene(rooms=(room,)), "habitat")
    (content,) = (content for name, content in files.items() if name.startswith("objects/") and name.endswith(".glb"))
    return content


def parts(content: bytes) -> tuple[Document, bytes]:
    """The JSON of a .glb, and its binary part."""
    (length,) = struct.unpack_from("<I", content, 12)
    return json.loads(content[20 : 20 + length]), content[28 + length :]


def joined(document: Document, binary: bytes) -> bytes:
    """A .glb of its two parts."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunk = struct.pack("<II", len(binary), 0x004E4942) + binary if binary else b""
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(chunk), len(text), 0x4E4F534A) + text + chunk


def changed(content: bytes, change: Callable[[Document], None]) -> bytes:
    """A .glb whose JSON was changed."""
    document, binary = parts(content)
    change(document)
    return joined(document, binary)


def under(content: bytes, **node: object) -> bytes:
    """A .glb all of which is below one more node, such as `scale=[100, 100, 100]`."""

    def wrap(document: Document) -> None:
        document["nodes"].append({"name": "above", "children": document["scenes"][0]["nodes"], **node})
        document["scenes"][0]["nodes"] = [len(document["nodes"]) - 1]

    return changed(content, wrap)


def picture(side: int, color: tuple[int, int, int] = (200, 60, 30)) -> bytes:
    """A square .png of one colour."""
    rows = (b"\0" + bytes(color) * side) * side

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def textured(content: bytes, side: int = 2) -> bytes:
    """A .glb whose first material has a picture, and points on it."""
    document, binary = parts(content)
    views, accessors = document["bufferViews"], document["accessors"]

    def add(more: bytes, **says: int) -> int:
        nonlocal binary
        binary += bytes(-len(binary) % 4)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(more), **says})
        binary += more
        return len(views) - 1

    primitive = document["meshes"][0]["primitives"][0]
    count = accessors[primitive["attributes"]["POSITION"]]["count"]
    points = add(struct.pack("<2f", 0.25, 0.75) * count, target=34962)
    accessors.append({"bufferView": points, "componentType": 5126, "count": count, "type": "VEC2"})
    primitive["attributes"]["TEXCOORD_0"] = len(accessors) - 1
    document["images"] = [{"bufferView": add(picture(side)), "mimeType": "image/png"}]
    document["samplers"], document["textures"] = [{"wrapS": 10497}], [{"source": 0, "sampler": 0}]
    document["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    binary += bytes(-len(binary) % 4)
    document["buffers"] = [{"byteLength": len(binary)}]
    return joined(document, binary)


def dense(content: bytes, side: int) -> bytes:
    """A .glb with one more part: a hilly sheet of side x side points within its box."""
    document, binary = parts(content)
    ends = document["accessors"][document["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]
    low, high = np.array(ends["min"]), np.array(ends["max"])
    u, v = (grid.reshape(-1) for grid in np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side)))
    points = (low + (high - low) * np.stack([u, 0.5 + 0.4 * np.sin(20 * u) * np.cos(20 * v), v], axis=1)).astype("<f4")
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).reshape(-1)
    triangles = np.stack([corner, corner + side, corner + 1, corner + 1, corner + side, corner + side + 1], axis=1).astype("<u4")
    normals = np.tile(np.array([0, 1, 0], "<f4"), (len(points), 1))
    says = {"POSITION": (points, 34962), "NORMAL": (normals, 34962), "indices": (triangles, 34963)}
    numbers = {}
    for name, (values, target) in says.items():
        binary += bytes(-len(binary) % 4)
        document["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": values.nbytes, "target": target})
        binary += values.tobytes()
        kind = (
            {"componentType": 5125, "count": values.size, "type": "SCALAR"}
            if name == "indices"
            else {"componentType": 5126, "count": len(values), "type": "VEC3"}
        )
        more = {"min": points.min(0).tolist(), "max": points.max(0).tolist()} if name == "POSITION" else {}
        document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1, **kind, **more})
        numbers[name] = len(document["accessors"]) - 1
    indices = numbers.pop("indices")
    document["meshes"][0]["primitives"].append({"attributes": numbers, "indices": indices, "material": 0})
    document["buffers"] = [{"byteLength": len(binary)}]
    return joined(document, binary)


@cache
def _kept() -> Path:
    """Where folders stand until this process ends."""
    made = TemporaryDirectory(prefix="assets-")
    atexit.register(made.cleanup)
    return Path(made.name)


def kept_folder(files: Mapping[str, bytes], entries: Mapping[str, Mapping[str, object]]) -> Path:
    """A folder that several tests share: an asset's file is read again where it is exported."""
    return folder(Path(mkdtemp(dir=_kept())), files, entries)


def folder(at: Path, files: Mapping[str, bytes], entries: Mapping[str, Mapping[str, object]] | None = None) -> Path:
    """Writes a folder of assets; without entries it has no `assets.yaml`."""
    for name, content in files.items():
        path = at / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    if entries is not None:
        (at / "assets.yaml").write_text(yaml.safe_dump({name: dict(entry) for name, entry in entries.items()}))
    return at
