"""A glTF document as it is being put together: geometry, materials, meshes and nodes by number, each written once."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Sequence
from functools import lru_cache
from json.encoder import encode_basestring as quoted
from typing import Any, Final, NamedTuple

import numpy as np

from solver.exports.model import Paint
from solver.exports.paints import linear
from solver.exports.solid_meshes import SolidSurface
from solver.version import VERSION

_JSON_CHUNK, _BINARY_CHUNK = 0x4E4F534A, 0x004E4942
_VIEWS: Final = ('"byteStride":12,"target":34962', '"byteStride":12,"target":34962', '"target":34963')
"""What the views of the buffer hold: positions, normals, indices."""


class Geometry(NamedTuple):
    """A surface as a buffer holds it: its bytes in each view, and what its accessors say after their offset."""

    content: tuple[bytes, bytes, bytes]
    accessors: tuple[str, str, str]


PaintedGeometry = Sequence[tuple[Geometry, Paint]]
"""What a mesh is made of."""


def geometry_of(surface: SolidSurface) -> Geometry:
    """Returns a surface as a buffer holds it."""
    points, normals = (np.ascontiguousarray(values, dtype="<f4") for values in (surface.points, surface.normals))
    indices = surface.triangles.astype("<u2" if len(points) < 65536 else "<u4").reshape(-1)
    ends = f'"min":{points.min(axis=0).tolist()},"max":{points.max(axis=0).tolist()}'
    vectors = f'"componentType":5126,"count":{len(points)},"type":"VEC3"'
    numbers = f'"componentType":{5123 if indices.itemsize == 2 else 5125},"count":{indices.size},"type":"SCALAR"'
    return Geometry((points.tobytes(), normals.tobytes(), indices.tobytes()), (f"{vectors},{ends}", vectors, numbers))


class GltfBook:
    """What a document holds so far."""

    def __init__(self) -> None:
        self._content: tuple[list[bytes], list[bytes], list[bytes]] = ([], [], [])
        self._lengths = [0, 0, 0]
        self.accessors: list[str] = []
        self._placed: dict[int, tuple[Geometry, int]] = {}
        self._materials: dict[Paint | str, int] = {}
        self.meshes: list[str] = []
        self._nodes: list[str] = []
        self._foreign: list[tuple[bytes, str]] = []
        """Views of other files: their bytes, and what is said of them after their place."""
        self.textures: list[str] = []
        self.images: list[str] = []
        self.samplers: list[str] = []
        self.extensions: set[str] = set()

    def mesh(self, name: str, painted: PaintedGeometry) -> int:
        """Adds a mesh and returns its number; geometry that was met before is not written again."""
        primitives = []
        for geometry, paint in painted:
            first = self._place(geometry)
            material = self.material(paint)
            attributes = f'"attributes":{{"POSITION":{first},"NORMAL":{first + 1}}}'
            primitives.append(f'{{{attributes},"indices":{first + 2},"material":{material}}}')
        return added(self.meshes, f'{{"name":{quoted(name)},"primitives":[{",".join(primitives)}]}}')

    def view(self, content: bytes, says: str) -> int:
        """Adds a view of its own and returns its number; `says` are further members, each after a comma."""
        self._foreign.append((content, says))
        return len(_VIEWS) + len(self._foreign) - 1

    def material(self, look: Paint | str) -> int:
        """Adds a material, a paint or a JSON object's text, and returns its number; equal ones are one."""
        return self._materials.setdefault(look, len(self._materials))

    def node(self, text: str) -> int:
        """Adds a node, a JSON object's text, and returns its number."""
        return added(self._nodes, text)

    def _place(self, geometry: Geometry) -> int:
        """Returns the number of the first of a geometry's three accessors."""
        known = self._placed.get(id(geometry))
        if known:
            return known[1]
        first = len(self.accessors)
        self._placed[id(geometry)] = geometry, first
        for view, (content, rest) in enumerate(zip(geometry.content, geometry.accessors, strict=True)):
            self.accessors.append(f'{{"bufferView":{view},"byteOffset":{self._lengths[view]},{rest}}}')
            self._content[view].append(content)
            self._lengths[view] += len(content)
        return first

    def file(self, root: int | None, warnings: Iterable[str], scene: str) -> bytes:
        """Returns the whole as a .glb with the scene's JSON in it; `root` is the node that all others are under, if there is any."""
        views, content = self._views()
        told = ",".join(map(quoted, warnings))
        under = "" if root is None else f'"nodes":[{root}],'
        lists = {
            "nodes": self._nodes,
            "meshes": self.meshes,
            "materials": [look if isinstance(look, str) else _material(look) for look in self._materials],
            "accessors": self.accessors,
            "textures": self.textures,
            "images": self.images,
            "samplers": self.samplers,
            "extensionsUsed": [*map(quoted, sorted(self.extensions))],
        }
        parts = {
            "asset": f'{{"version":"2.0","generator":"Compose {VERSION}","extras":{{"warnings":[{told}]}}}}',
            "scene": "0",
            "scenes": f'[{{"name":"house",{under}"extras":{{"scene":{scene}}}}}]',
            **{key: _listed(items) for key, items in lists.items() if items},
            **({"bufferViews": _listed(views), "buffers": f'[{{"byteLength":{sum(map(len, content))}}}]'} if self.accessors else {}),
        }
        text = "{" + ",".join(f'"{key}":{value}' for key, value in parts.items()) + "}"
        return _packed(text.encode(), content)

    def _views(self) -> tuple[list[str], list[bytes]]:
        """Returns what the document says of its views, and the bytes of all of them one after another."""
        lengths, starts = self._lengths, (0, self._lengths[0], self._lengths[0] + self._lengths[1])
        views = [
            f'{{"buffer":0,"byteOffset":{start},"byteLength":{length},{kind}}}'
            for start, length, kind in zip(starts, lengths, _VIEWS, strict=True)
        ]
        content, end = [part for contents in self._content for part in contents], sum(lengths)
        for part, says in self._foreign:
            content.append(bytes(-end % 4))
            end += -end % 4
            views.append(f'{{"buffer":0,"byteOffset":{end},"byteLength":{len(part)}{says}}}')
            content.append(part)
            end += len(part)
        return views, content


def added(entries: list[str], text: str) -> int:
    """Adds an entry to a list of a document, a JSON object's text, and returns its number."""
    entries.append(text)
    return len(entries) - 1


def _listed(items: Iterable[str]) -> str:
    return f"[{','.join(items)}]"


def _packed(text: bytes, content: Sequence[bytes]) -> bytes:
    pieces = [*_chunk(_JSON_CHUNK, [text], b" "), *(_chunk(_BINARY_CHUNK, content, b"\0") if content else ())]
    return b"".join((struct.pack("<4sII", b"glTF", 2, 12 + sum(map(len, pieces))), *pieces))


def _chunk(kind: int, content: Sequence[bytes], filler: bytes) -> tuple[bytes, ...]:
    """Returns a chunk in pieces: its head, its content, what fills it up to whole words."""
    length = sum(map(len, content))
    missing = -length % 4
    return struct.pack("<II", length + missing, kind), *content, filler * missing


@lru_cache(maxsize=4096)
def _material(paint: Paint) -> str:
    color = linear(paint.color)
    look: dict[str, Any] = {
        "baseColorFactor": [*color, paint.opacity],
        "metallicFactor": paint.metalness,
        "roughnessFactor": paint.roughness,
    }
    texts = [f'"name":{quoted(" ".join(filter(None, (paint.texture, paint.color))))}', f'"pbrMetallicRoughness":{_object(look)}']
    if paint.glow:
        texts.append(f'"emissiveFactor":{[round(channel * paint.glow, 6) for channel in color]}')
    if paint.opacity < 1:
        texts.append('"alphaMode":"BLEND"')
    return f"{{{','.join(texts)}}}"


def _object(values: dict[str, Any]) -> str:
    return "{" + ",".join(f'"{key}":{value}' for key, value in values.items()) + "}"
