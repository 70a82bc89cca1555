"""Files of others, opened with bounds: archives that would unpack to more, XML that would grow.

XML is read by defusedxml: no entity is resolved but those that stand for a plain text, as drawing programmes write them for addresses of
namespaces.
"""

import re
import zlib
from collections.abc import Iterator
from gzip import GzipFile
from io import BytesIO
from typing import Any, Final
from xml.etree.ElementTree import Element, ParseError, TreeBuilder
from zipfile import BadZipFile, ZipFile

from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import DefusedXMLParser

from solver.errors import SyntaxFault
from solver.export_formats import SCENE_FILE

MOST_BYTES: Final = 32 << 20
"""A file, or a member of an archive, is not larger, bytes."""
MOST_ELEMENTS: Final = 200_000
"""Elements of an XML file."""
MOST_MEMBERS: Final = 20_000
ZIP: Final = b"PK\x03\x04"
GZIP: Final = b"\x1f\x8b"
WIDE: Final = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16", b"<\0": "utf-16-le", b"\0<": "utf-16-be"}
"""How files begin whose characters are of two bytes."""
PICTURE: Final = "pictures are not read here: trace them as SVG or DXF"
NOT_READ: Final = {
    b"%PDF": "PDF is not read here: save the drawing as SVG or DXF", b"AC10": "DWG is not read here: save the drawing as DXF",
    b"\x89PNG": PICTURE, b"\xff\xd8\xff": PICTURE, b"GIF8": PICTURE, b"RIFF": PICTURE, b"II*\0": PICTURE, b"MM\0*": PICTURE,
}  # fmt: skip
"""How files begin that people have plans in and that are not read, and what helps."""
PACKED: Final = tuple(
    re.compile(name, re.IGNORECASE | re.DOTALL)
    for name in (r"Home\.xml", rf"(?!__MACOSX/)(?:.*/)?{re.escape(SCENE_FILE)}", r"(?!__MACOSX/).*\.(?:ifc|ifcxml|dxf|svg|geojson|json)")
)
"""The file of a zip archive that is read: of a home of Sweet Home 3D or an export of ours, else the only plan in it, as in an .ifczip."""
OLD_HOME: Final = "Home"
"""What homes of Sweet Home 3D before version 5.3 hold instead."""
IFC_XML: Final = re.compile(rb"<(?:\w+:)?(?:iso_10303_28|ifcXML)[\s>]")
"""How ifcXML begins, of IFC 2x3 and 4."""
DECLARED: Final = re.compile(r"\A\s*<\?xml[^>]*\?>")


def said(error: Exception) -> str:
    """Returns what a library says of what it cannot read, on one line and without the point at its end; its sort, where it says nothing.

    What Python says of what lacks a part is no word about the file.
    """
    if isinstance(error, TypeError | AttributeError | IndexError | KeyError):
        return "a part of it is missing, or is of another sort"
    if "missing ENDSEC" in str(error):
        return "it is cut off"
    return f"{' '.join(str(error).split()).rstrip('.') or type(error).__name__:.100}"


def unpacked(content: bytes) -> bytes:
    """Returns a file without what is around it: a compressed one as it was before, one of wide characters as UTF-8.

    Raises:
        SyntaxFault: it cannot be read so, is larger than MOST_BYTES, or of a sort that is not read.
    """
    for start, words in NOT_READ.items():
        if content.startswith(start):
            raise SyntaxFault(words)
    if content.startswith(GZIP):
        try:
            content = GzipFile(fileobj=BytesIO(content)).read(MOST_BYTES + 1)
        except (zlib.error, EOFError, OSError) as error:
            raise SyntaxFault(f"a compressed file that cannot be read: {said(error)}") from None
        if len(content) > MOST_BYTES:
            raise SyntaxFault(f"what is compressed in it is larger than {MOST_BYTES >> 20} MB")
    if content.startswith(ZIP):
        content = _plan_in(content)
    if IFC_XML.search(content[:2_000]):
        raise SyntaxFault("ifcXML is not read here: save it as IFC")
    if content[:2] not in WIDE:
        return content
    try:
        return DECLARED.sub("", content.decode(WIDE[content[:2]]), count=1).encode()
    except UnicodeError as error:
        raise SyntaxFault(f"the text is not UTF-16: {error}") from None


def _plan_in(archive: bytes) -> bytes:
    """Returns the plan in a zip archive; refuses one without, or of several."""
    try:
        with ZipFile(BytesIO(archive)) as opened:
            names = dict.fromkeys(opened.namelist())
            if len(names) > MOST_MEMBERS:
                raise SyntaxFault(f"an archive of more than {MOST_MEMBERS:,} files")
            found = next(filter(None, ([name for name in names if one.fullmatch(name)] for one in PACKED)), [])
            if len(found) != 1:
                old = "a home of Sweet Home 3D before version 5.3: save it again with a newer one"
                several = f"an archive of {len(found)} plans: one is read, such as an .ifc"
                raise SyntaxFault(old if OLD_HOME in names else several if found else "an archive without a plan, such as an .ifc")
            with opened.open(found[0]) as file:
                content = file.read(MOST_BYTES + 1)
    except (BadZipFile, zlib.error, EOFError, OSError, ValueError, RuntimeError, NotImplementedError) as error:
        raise SyntaxFault(f"a zip archive that cannot be read: {said(error)}") from None
    if len(content) > MOST_BYTES:
        raise SyntaxFault(f"{found[0]:.60} in it is larger than {MOST_BYTES >> 20} MB")
    return content


def xml_of(content: bytes) -> Element:
    """Returns the root of an XML file.

    Raises:
        SyntaxFault: it is none, declares entities, or is larger than any plan.
    """
    if len(content) > MOST_BYTES:
        raise SyntaxFault(f"larger than {MOST_BYTES >> 20} MB")
    try:
        parser = _PlainEntities(content.count(b"&"))
        parser.feed(content)
        root: Element = parser.close()
    except DefusedXmlException as refused:
        raise SyntaxFault(f"XML that declares entities, which is not read here: {type(refused).__name__}") from None
    except (ParseError, LookupError, ValueError) as error:
        raise SyntaxFault(f"not XML: {error}") from None
    if sum(1 for _ in root.iter()) > MOST_ELEMENTS:
        raise SyntaxFault(f"of more than {MOST_ELEMENTS:,} elements")
    return root


class _PlainEntities(DefusedXMLParser):
    """Reads XML whose entities stand for texts without others in them, that make the file no larger than any plan."""

    def __init__(self, uses: int) -> None:
        self._uses = uses
        super().__init__(target=TreeBuilder())

    def defused_entity_decl(self, name: str, is_parameter_entity: bool, value: str | None, *more: Any) -> None:
        """Refuses an entity that is none such."""
        if value is None or is_parameter_entity or "&" in value or "<" in value or len(value) * self._uses > MOST_BYTES:
            super().defused_entity_decl(name, is_parameter_entity, value or "", *more)


def numbered(elements: Iterator[Element], file: str) -> Iterator[tuple[Element, str]]:
    """Yields elements with their places in a file: its name, the tag, and the how many-th of that tag it is."""
    counts: dict[str, int] = {}
    for element in elements:
        tag = str(element.tag).rpartition("}")[2]
        number = counts.get(tag, 0)
        counts[tag] = number + 1
        yield element, f"{file} {tag}[{number}]"
