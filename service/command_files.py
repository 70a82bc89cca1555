"""Files that a command reads: scenes, requests and lists in JSON or YAML, told from floor plans of other programs."""

from collections.abc import Callable
from typing import TypeVar

from service.standard_streams import STREAM, read_content
from solver.errors import FieldError, SyntaxFault
from solver.exchange import A_SCENE, format_of_file, load_text

T = TypeVar("T")


def read_file(name: str) -> object:
    """Reads a file or standard input, by its name's ending or else by how it begins."""
    return parsed(name, read_content(name))


def parsed(name: str, content: bytes) -> object:
    """Reads the content of a file."""
    return checked(name, lambda: load_text(content, format_of_file(name, content)))


def checked(name: str | None, work: Callable[[], T]) -> T:
    """Does some work on a document; what is wrong with the document is said with its file's name."""
    try:
        return work()
    except FieldError as error:
        raise FieldError(f"{spoken(name)}{error.field}", error.problem, error.allowed) from None
    except SyntaxFault as fault:
        raise SyntaxFault(f"{spoken(name)}{fault}") from None


def spoken(name: str | None) -> str:
    """Returns how what is wrong with a file begins."""
    return "" if name is None else f"{'standard input' if name == STREAM else name}: "


def scene_of_file(name: str) -> object:
    """Reads a scene; of an answer that holds one, that one.

    Raises:
        FieldError: it is a floor plan of another program.
    """
    content = read_content(name)
    try:
        document, fault = parsed(name, content), None
    except SyntaxFault as error:
        document, fault = None, error
    if not isinstance(document, dict) and (format := format_of_foreign(name, content)):
        raise FieldError(f"{spoken(name)}scene", f"is a floor plan of the format {format}", A_SCENE)
    if fault is not None:
        raise fault
    return held_scene(document)


def held_scene(document: object) -> object:
    """Returns the scene of an answer that holds one, else the document itself."""
    return document["scene"] if isinstance(document, dict) and "scene" in document and "rooms" not in document else document


def format_of_foreign(name: str, content: bytes) -> str | None:
    """Returns the format of a file that is a floor plan of another program; None where it is none."""
    from solver.pipeline.import_plan import plan_format  # noqa: PLC0415 - that is much to load for a scene

    return plan_format("" if name == STREAM else name, content)
