"""A .glb on disk -> its JSON, and where its binary part lies: nothing else of the file is read; how large its shapes are.

That is told by what its accessors say of themselves, without their points. Everything that will be followed later is looked at: numbers of
accessors, views and nodes, their lengths, what the file needs beside itself.

Time and memory are bounded whatever the file says of itself.
"""

import json
import math
import os
import stat
import struct
from collections.abc import Iterator, Mapping
from itertools import product
from pathlib import Path
from typing import Any, Final, NamedTuple, NoReturn

MOST_BYTES: Final = 256 << 20
"""Largest file, bytes. Our choice: it is copied into exports and sent to pages."""
MOST_JSON: Final = 4 << 20
"""Longest JSON, bytes: parsed, the worst of it takes 0.1 GB. That of an asset of 30 MB is some ten thousand. Our choice."""
_MAGIC: Final = b"glTF"
_HEADER: Final = struct.Struct("<4sIIII")
_CHUNK: Final = struct.Struct("<II")
_JSON, _BINARY = 0x4E4F534A, 0x004E4942


class GlbFault(Exception):
    """A file is no asset that is read here; says why."""


class GlbFile(NamedTuple):
    """A file's JSON; where its binary part begins, and how long that is, bytes (0: there is none)."""

    document: dict[str, Any]
    start: int
    length: int


def read_glb(path: Path | str) -> GlbFile:
    """Reads what a .glb says of itself.

    Raises:
        GlbFault: it is no whole .glb, or larger than it may be.
    """
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            raise GlbFault("is no file")
        with open(path, "rb", buffering=0) as opened:
            return _read(opened.fileno())
    except (OSError, ValueError) as error:
        raise GlbFault(f"cannot be read: {getattr(error, 'strerror', None) or error}") from None


def _read(number: int) -> GlbFile:
    """Reads the opened file of a number."""
    size = os.fstat(number).st_size
    if size > MOST_BYTES:
        raise GlbFault(f"is {size >> 20} MB; the most is {MOST_BYTES >> 20} MB")
    head = os.read(number, _HEADER.size)
    if len(head) < _HEADER.size or not head.startswith(_MAGIC):
        raise GlbFault("does not begin as a .glb does")
    _, version, total, length, kind = _HEADER.unpack(head)
    if version != 2 or kind != _JSON:
        raise GlbFault(f"is glTF of version {version}, or its JSON is not its first part")
    if total != size:
        raise GlbFault(f"is not whole: {size} bytes, where its header says {total}")
    if _HEADER.size + length > size or length > MOST_JSON:
        raise GlbFault(f"says that its JSON has {length} bytes; the file has {size}, and the most is {MOST_JSON >> 20} MB")
    text = os.pread(number, length, _HEADER.size)
    start = _HEADER.size + length
    return GlbFile(_parsed(text), start + _CHUNK.size, _binary(os.pread(number, _CHUNK.size, start), size - start))


def _binary(head: bytes, rest: int) -> int:
    """Returns the length of the binary part, of whose chunk this is the head and `rest` all bytes that are left."""
    if rest == 0:
        return 0
    if len(head) < _CHUNK.size:
        raise GlbFault("ends within the head of a part")
    length, kind = _CHUNK.unpack(head)
    if kind != _BINARY:
        return 0
    if length > rest - _CHUNK.size:
        raise GlbFault(f"says that its binary part has {length} bytes; {rest - _CHUNK.size} are left")
    return int(length)


def _parsed(text: bytes) -> dict[str, Any]:
    try:
        document = json.loads(text, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise GlbFault(f"has JSON that cannot be read: {error!s:.120}") from None
    if not isinstance(document, dict):
        raise GlbFault("has JSON that is no object")
    return document


def _no_number(word: str) -> NoReturn:
    raise ValueError(f"{word} is no number")


Vector = tuple[float, float, float]
Affine = tuple[float, float, float, float, float, float, float, float, float, float, float, float]
"""Three rows of four: a turn and stretch, then a shift."""
MOST_TRIANGLES: Final = 2_000_000
"""Most triangles that an asset may have, a mesh counted wherever it stands. Our choice: a page draws no more."""
MOST_DRAWS: Final = 1000
"""Most parts that it may be drawn in, likewise."""
LEAST: Final = 1e-9
"""What has less extent along an axis is flat."""
LARGEST: Final = 1e6
"""Largest coordinate or factor."""
READ_EXTENSIONS: Final = frozenset({"KHR_mesh_quantization", "KHR_texture_transform"})
"""What a file may require, beside how materials look."""
MATERIALS: Final = "KHR_materials_"
_SIZES: Final = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_GREATEST: Final = {5120: 127.0, 5121: 255.0, 5122: 32767.0, 5123: 65535.0}
_WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_TRIANGLES: Final = {4: lambda count: count // 3, 5: lambda count: max(0, count - 2), 6: lambda count: max(0, count - 2)}
"""How many triangles so many corners make, by a primitive's mode."""
_IDENTITY: Final[Affine] = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)


class GlbBounds(NamedTuple):
    """The box around all shapes in the file's own units, y up; how many triangles they have, and in how many draw calls."""

    low: Vector
    high: Vector
    triangles: int
    draws: int


class PlacedMesh(NamedTuple):
    """A mesh by its number, and where one of its nodes puts it."""

    mesh: int
    place: Affine


def bounds_of(file: GlbFile) -> GlbBounds:
    """Measures the shapes of a .glb.

    Raises:
        GlbFault: it refers to what is not there, needs another file or an extension that is not read, or holds nothing to measure.
    """
    try:
        return _measured(GlbBook(file))
    except (TypeError, AttributeError, KeyError, OverflowError) as error:
        raise GlbFault(f"is not put together as glTF is: {error!s:.120}") from None


def _measured(book: "GlbBook") -> GlbBounds:
    low, high, triangles, draws = [math.inf] * 3, [-math.inf] * 3, 0, 0
    meshes: dict[int, GlbBounds | None] = {}
    for number, place in book.meshes():
        if number not in meshes:
            meshes[number] = _of_mesh(book, number)
        mesh = meshes[number]
        if mesh is None:
            continue
        triangles, draws = triangles + mesh.triangles, draws + mesh.draws
        if triangles > MOST_TRIANGLES or draws > MOST_DRAWS:
            raise GlbFault(f"has more than {MOST_TRIANGLES} triangles, or is drawn in more than {MOST_DRAWS} parts")
        for point in _corners(mesh.low, mesh.high, place):
            for k in range(3):
                low[k], high[k] = min(low[k], point[k]), max(high[k], point[k])
    if not triangles:
        raise GlbFault("has no triangles")
    if any(not to - at > LEAST for at, to in zip(low, high, strict=True)):
        raise GlbFault("is flat: it has no extent along one axis")
    return GlbBounds((low[0], low[1], low[2]), (high[0], high[1], high[2]), triangles, draws)


def _of_mesh(book: "GlbBook", number: int) -> GlbBounds | None:
    """Returns the box around a mesh's triangles; None where it has none."""
    boxes, triangles = [], 0
    for primitive in _list(book.item("meshes", number), "primitives"):
        mode = primitive.get("mode", 4)
        if mode not in _TRIANGLES:
            continue
        attributes = primitive.get("attributes")
        if not isinstance(attributes, Mapping) or "POSITION" not in attributes:
            raise GlbFault(f"mesh {number} has a part without points")
        counts = [book.accessor(accessor) for name, accessor in attributes.items() if name != "POSITION"]
        box, count = book.box(attributes["POSITION"])
        if any(other != count for other in counts):
            raise GlbFault(f"mesh {number} has attributes of different lengths")
        triangles += _TRIANGLES[mode](book.accessor(primitive["indices"]) if "indices" in primitive else count)
        if "material" in primitive:
            book.item("materials", primitive["material"])
        boxes.append(box)
    if not boxes:
        return None
    lows, highs = zip(*boxes, strict=True)
    (x0, y0, z0), (x1, y1, z1) = map(min, *lows, lows[0]), map(max, *highs, highs[0])
    return GlbBounds((x0, y0, z0), (x1, y1, z1), triangles, len(boxes))


def _corners(low: Vector, high: Vector, place: Affine) -> Iterator[Vector]:
    a, b, c, x, d, e, f, y, g, h, i, z = place
    for u, v, w in product(*zip(low, high, strict=True)):
        yield a * u + b * v + c * w + x, d * u + e * v + f * w + y, g * u + h * v + i * w + z


class GlbBook:
    """What a .glb's JSON says, looked up with care.

    Raises:
        GlbFault: the file needs another file, or an extension that is not read here.
    """

    def __init__(self, file: GlbFile) -> None:
        self.document, self._length = file.document, file.length
        self._counts: dict[int, int] = {}
        for name in map(str, _list(self.document, "extensionsRequired")):
            if name not in READ_EXTENSIONS and not name.startswith(MATERIALS):
                raise GlbFault(f"needs {name!r:.60}, which is not read here")
        for group in ("buffers", "images"):
            for number, entry in enumerate(_list(self.document, group)):
                if not isinstance(entry, Mapping) or "uri" in entry:
                    where = entry.get("uri") if isinstance(entry, Mapping) else entry
                    raise GlbFault(f"names another file for {group} {number}: {where!r:.60}; an asset holds all that it needs")
        for image in _list(self.document, "images"):
            self.view(image.get("bufferView"), 0, 1)

    def item(self, group: str, number: object) -> Mapping[str, Any]:
        """Returns an entry of a list.

        Raises:
            GlbFault: there is none of that number.
        """
        entries = _list(self.document, group)
        if not isinstance(number, int) or isinstance(number, bool) or not 0 <= number < len(entries):
            raise GlbFault(f"refers to {group} {number!r:.30}, of which there are {len(entries)}")
        found = entries[number]
        if not isinstance(found, Mapping):
            raise GlbFault(f"has {group} {number} that is no object")
        return found

    def view(self, number: object, offset: int, length: int) -> None:
        """Checks that a buffer view has so many bytes from an offset, in the file's own buffer."""
        view = self.item("bufferViews", number)
        buffer, start, size = (_whole(view, key, 0) for key in ("buffer", "byteOffset", "byteLength"))
        declared = _whole(self.item("buffers", buffer), "byteLength", 0)
        if buffer != 0 or declared > self._length:
            raise GlbFault(f"lacks buffer {buffer} of {declared} bytes: its binary part has {self._length}")
        if offset + length > size or start + size > declared:
            raise GlbFault(f"has bufferViews {number} that ends beyond its buffer")

    def accessor(self, number: Any) -> int:
        """Checks an accessor and returns how many elements it has."""
        if number in self._counts:
            return self._counts[number]
        accessor = self.item("accessors", number)
        count, offset = _whole(accessor, "count", 0), _whole(accessor, "byteOffset", 0)
        size = _SIZES.get(accessor.get("componentType", 0), 0) * _WIDTHS.get(accessor.get("type", ""), 0)
        if not size or not count or "sparse" in accessor or "bufferView" not in accessor:
            raise GlbFault(f"has accessors {number} that is empty, sparse or of an unknown type")
        step = _whole(self.item("bufferViews", accessor["bufferView"]), "byteStride", 0) or size
        self.view(accessor["bufferView"], offset, step * (count - 1) + size)
        self._counts[number] = count
        return count

    def box(self, number: Any) -> tuple[tuple[Vector, Vector], int]:
        """Returns the box that an accessor of points says they are in, and how many they are."""
        count, accessor = self.accessor(number), self.item("accessors", number)
        if accessor.get("type") != "VEC3":
            raise GlbFault(f"has points in accessors {number} that are no VEC3")
        share = _GREATEST.get(accessor["componentType"], 1.0) if accessor.get("normalized") else 1.0
        ends = [_numbers(accessor.get(key), 3, f"{key} of accessors {number}") for key in ("min", "max")]
        low, high = ((x / share, y / share, z / share) for x, y, z in ends)
        if any(a > b for a, b in zip(low, high, strict=True)):
            raise GlbFault(f"has accessors {number} whose min is above its max")
        return (low, high), count

    def meshes(self) -> Iterator[PlacedMesh]:
        """Yields all meshes that the file shows, where it shows them.

        Raises:
            GlbFault: nodes are not a tree, or bent by a skeleton.
        """
        left = [(root, _IDENTITY) for root in reversed(self.roots())]
        seen: set[int] = set()
        while left:
            number, above = left.pop()
            node = self.item("nodes", number)
            if number in seen:
                raise GlbFault(f"has nodes {number} below itself, or twice")
            seen.add(number)
            if "skin" in node:
                raise GlbFault("is bent by a skeleton (skin); bake it first")
            place = _below(above, node, number)
            if "mesh" in node:
                yield PlacedMesh(node["mesh"], place)
            left += [(child, place) for child in reversed(_list(node, "children"))]

    def roots(self) -> list[Any]:
        """Returns the numbers of the nodes of the scene that is shown."""
        if "scenes" not in self.document:
            nodes = [node for node in _list(self.document, "nodes") if isinstance(node, Mapping)]
            below = {child for node in nodes for child in _list(node, "children") if isinstance(child, int)}
            return [number for number in range(len(_list(self.document, "nodes"))) if number not in below]
        return _list(self.item("scenes", self.document.get("scene", 0)), "nodes")


def _list(document: Mapping[str, Any], key: str) -> list[Any]:
    found = document.get(key, [])
    if not isinstance(found, list):
        raise GlbFault(f"has {key} that is no list")
    return found


def _whole(entry: Mapping[str, Any], key: str, default: int) -> int:
    value = entry.get(key, default)
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value < 1 << 32:
        raise GlbFault(f"has {key} {value!r:.30}, which is no length or number")
    return value


def _numbers(values: object, count: int, what: str) -> tuple[float, ...]:
    if not isinstance(values, list) or len(values) != count or not all(map(_sane, values)):
        raise GlbFault(f"has no {count} finite numbers as {what}")
    return tuple(values)


def _sane(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and -LARGEST <= value <= LARGEST


def _below(above: Affine, node: Mapping[str, Any], number: int) -> Affine:
    """Returns where a node's shapes are, by where those of the node above it are."""
    if "matrix" in node:
        m = _numbers(node["matrix"], 16, f"matrix of nodes {number}")
        return _times(above, (m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]))
    if not node.keys() & {"translation", "rotation", "scale"}:
        return above
    tx, ty, tz = _numbers(node.get("translation", [0, 0, 0]), 3, f"translation of nodes {number}")
    sx, sy, sz = _numbers(node.get("scale", [1, 1, 1]), 3, f"scale of nodes {number}")
    x, y, z, w = _numbers(node.get("rotation", [0, 0, 0, 1]), 4, f"rotation of nodes {number}")
    turned: Affine = (
        (1 - 2 * (y * y + z * z)) * sx, 2 * (x * y - z * w) * sy, 2 * (x * z + y * w) * sz, tx,
        2 * (x * y + z * w) * sx, (1 - 2 * (x * x + z * z)) * sy, 2 * (y * z - x * w) * sz, ty,
        2 * (x * z - y * w) * sx, 2 * (y * z + x * w) * sy, (1 - 2 * (x * x + y * y)) * sz, tz,
    )  # fmt: skip
    return _times(above, turned)


def _times(one: Affine, other: Affine) -> Affine:
    if one is _IDENTITY:
        return other
    rows = [one[0:4], one[4:8], one[8:12]]
    columns = [other[k::4] for k in range(4)]
    made = [
        sum(a * b for a, b in zip(row, column, strict=False)) + (row[3] if k == 3 else 0)
        for row in rows
        for k, column in enumerate(columns)
    ]
    if not all(map(_sane, made)):
        raise GlbFault("has nodes that stretch or shift beyond all measure")
    return made[0], made[1], made[2], made[3], made[4], made[5], made[6], made[7], made[8], made[9], made[10], made[11]
