"""Own assets within a glTF document: what of a file is shown, copied once; its tree of nodes below each body that is shown as it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, Final, NamedTuple

from catalogs.assets.asset_entry import Asset
from catalogs.assets.glb_bounds import MATERIALS
from catalogs.assets.glb_file import GlbFault
from solver.exports.asset_files import AssetFile, AssetFit, asset_file, changed
from solver.exports.formats.glb_book import GltfBook, added

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
