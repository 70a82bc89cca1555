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
DECLARED: Final = re.compile(r"\A\s*<\?xml[^>]*\?>")


def said(error: Exception) -> str:
    """Returns what a library says of what it cannot read, on one line and without the point at its end; its sort, where it says nothing."""
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
    if content[:2] not in WIDE:
        return content
    try:
        return DECLARED.sub("", content.decode(WIDE[content[:2]]), count=1).encode()
    except UnicodeError as error:
        raise SyntaxFault(f"the text is not UTF-16: {error}") from None


def member_of(archive: bytes, name: str) -> bytes | None:
    """Returns a file in a zip archive; None where there is none of that name.

    Raises:
        SyntaxFault: the archive is broken, or the file larger than MOST_BYTES.
    """
    try:
        with ZipFile(BytesIO(archive)) as opened:
            if len(opened.namelist()) > MOST_MEMBERS:
                raise SyntaxFault(f"an archive of more than {MOST_MEMBERS:,} files")
            if name not in opened.namelist():
                return None
            with opened.open(name) as file:
                content = file.read(MOST_BYTES + 1)
    except (BadZipFile, zlib.error, EOFError, OSError, ValueError, RuntimeError, NotImplementedError) as error:
        raise SyntaxFault(f"a zip archive that cannot be read: {said(error)}") from None
    if len(content) > MOST_BYTES:
        raise SyntaxFault(f"{name} in it is larger than {MOST_BYTES >> 20} MB")
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
