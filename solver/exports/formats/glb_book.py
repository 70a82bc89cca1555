"""A glTF document as it is being put together: geometry, materials, meshes and nodes by number, each written once.

What is shown of own assets is copied into it, with a tree of nodes below each body that is shown as one.
"""

import json
import struct
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from json.encoder import encode_basestring as quoted
from typing import Any, Final, NamedTuple

import numpy as np

from catalogs.assets.asset_entry import Asset
from catalogs.assets.glb_file import MATERIALS, GlbFault
from solver.exports.asset_surfaces import AssetFile, AssetFit, asset_file, changed
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


_DEEPEST: Final = 8
"""How deep a material may be."""
_LOOKS: Final = ("POSITION", "NORMAL", "TANGENT", "TEXCOORD_", "COLOR_")
"""Attributes that are copied begin so."""
_NODE: Final = ("matrix", "translation", "rotation", "scale")
_ACCESSOR: Final = ("componentType", "normalized", "count", "type", "min", "max")
_VIEW: Final = ("byteStride", "target")
_TRANSFORM: Final = "KHR_texture_transform"
_QUANTIZED: Final = "KHR_mesh_quantization"


class _CopiedNode(NamedTuple):
    """A node of an asset: its members but its children; the places of those in the list of its nodes, all before it."""

    text: str
    children: tuple[int, ...]


class AssetNodes:
    """The assets of one document, by name."""

    def __init__(self, book: GltfBook, assets: Mapping[str, Asset]) -> None:
        self._book, self._assets = book, assets
        self._trees: dict[str, tuple[list[_CopiedNode], list[int]]] = {}

    def below(self, name: str, fit: AssetFit) -> int:
        """Returns the number of a node that shows an asset, for below the node of a body.

        Raises:
            RequestError: the asset's file cannot be used any more.
        """
        if name not in self._trees:
            file = asset_file(name, self._assets[name])
            try:
                self._trees[name] = _Copying(self._book, file).tree()
            except (GlbFault, TypeError, AttributeError, KeyError, ValueError) as fault:
                raise changed(name, str(fault)) from None
        nodes, roots = self._trees[name]
        numbers: list[int] = []
        for text, children in nodes:
            below = f',"children":{[numbers[child] for child in children]}' if children else ""
            numbers.append(self._book.node(f"{{{text}{below}}}"))
        turned = f'"rotation":{[round(part, 9) for part in fit.quaternion]},' if fit.turn else ""
        inner = self._book.node(f'{{{turned}"translation":{list(fit.shift)},"children":{[numbers[root] for root in roots]}}}')
        return self._book.node(f'{{"name":{json.dumps(name)},"scale":{list(fit.stretch)},"children":[{inner}]}}')


class _Copying:
    """Copies from one file what is shown of it."""

    def __init__(self, book: GltfBook, file: AssetFile) -> None:
        self._book, self._file = book, file
        self._done: dict[tuple[str, int], int] = {}
        """New numbers by group and old number."""

    def tree(self) -> tuple[list[_CopiedNode], list[int]]:
        """Returns the nodes that show something, each after those below it, and the places of the topmost."""
        nodes: list[_CopiedNode] = []
        places: dict[int, int] = {}
        source, roots = self._file.book, self._file.book.roots()
        left = [(root, False) for root in reversed(roots)]
        while left:
            number, is_left = left.pop()
            node = source.item("nodes", number)
            below = node.get("children", [])
            if not is_left:
                left += [(number, True), *((child, False) for child in reversed(below))]
                continue
            children = tuple(places[child] for child in below if child in places)
            if "mesh" in node or children:
                places[number] = len(nodes)
                nodes.append(_CopiedNode(self._node(node), children))
        return nodes, [places[root] for root in roots if root in places]

    def _node(self, node: Mapping[str, Any]) -> str:
        says = {key: node[key] for key in _NODE if key in node}
        if "mesh" in node:
            says["mesh"] = self._copied("meshes", node["mesh"])
        return _members(says)

    def _copied(self, group: str, number: Any) -> int:
        """Returns the new number of an entry, which is copied where it is met first."""
        key = group, number
        if key not in self._done:
            copy = getattr(self, f"_{group}")
            self._done[key] = copy(self._file.book.item(group, number))
        return self._done[key]

    def _meshes(self, mesh: Mapping[str, Any]) -> int:
        primitives = []
        for primitive in mesh["primitives"]:
            attributes = {name: self._copied("accessors", one) for name, one in primitive["attributes"].items() if name.startswith(_LOOKS)}
            says: dict[str, Any] = {"attributes": attributes}
            if "indices" in primitive:
                says["indices"] = self._copied("accessors", primitive["indices"])
            if "material" in primitive:
                says["material"] = self._copied("materials", primitive["material"])
            if primitive.get("mode", 4) != 4:
                says["mode"] = primitive["mode"]
            primitives.append(says)
        return added(self._book.meshes, _text({"primitives": primitives}))

    def _accessors(self, accessor: Mapping[str, Any]) -> int:
        if _QUANTIZED in self._file.document.get("extensionsUsed", ()):
            self._book.extensions.add(_QUANTIZED)
        says = {key: accessor[key] for key in _ACCESSOR if key in accessor}
        view = self._copied("bufferViews", accessor["bufferView"])
        return added(self._book.accessors, _text({"bufferView": view, "byteOffset": accessor.get("byteOffset", 0), **says}))

    def _bufferViews(self, view: Mapping[str, Any]) -> int:
        start = view.get("byteOffset", 0)
        says = {key: view[key] for key in _VIEW if key in view}
        return self._book.view(self._file.content[start : start + view["byteLength"]], f",{_members(says)}" if says else "")

    def _materials(self, material: Mapping[str, Any]) -> int:
        return self._book.material(_text(self._look({key: part for key, part in material.items() if key != "extras"}, 0)))

    def _look(self, part: Any, depth: int) -> Any:
        """Returns a part of a material, the textures in it by their new numbers."""
        if depth > _DEEPEST:
            raise GlbFault("has a material that is nested too deeply")
        if isinstance(part, list):
            return [self._look(one, depth + 1) for one in part]
        if not isinstance(part, dict):
            return part
        found: dict[str, Any] = {}
        for key, value in part.items():
            if key == "extensions":
                known = {name: self._look(one, depth + 1) for name, one in value.items() if name.startswith((MATERIALS, _TRANSFORM))}
                self._book.extensions.update(known)
                found |= {key: known} if known else {}
            elif key.endswith("Texture"):
                found[key] = {**self._look(value, depth + 1), "index": self._copied("textures", value["index"])}
            else:
                found[key] = self._look(value, depth + 1)
        return found

    def _textures(self, texture: Mapping[str, Any]) -> int:
        says = {key: self._copied(group, texture[key]) for key, group in (("source", "images"), ("sampler", "samplers")) if key in texture}
        return added(self._book.textures, _text(says))

    def _images(self, image: Mapping[str, Any]) -> int:
        says = {"bufferView": self._copied("bufferViews", image["bufferView"]), "mimeType": image["mimeType"]}
        return added(self._book.images, _text(says))

    def _samplers(self, sampler: Mapping[str, Any]) -> int:
        return added(self._book.samplers, _text({key: value for key, value in sampler.items() if isinstance(value, int)}))


def _text(says: Mapping[str, Any]) -> str:
    return json.dumps(says, separators=(",", ":"))


def _members(says: Mapping[str, Any]) -> str:
    return _text(says)[1:-1]
