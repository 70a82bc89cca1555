"""JSON text <-> documents."""

import json
from sys import get_int_max_str_digits
from typing import Any, Final

from solver.errors import SyntaxFault
from solver.plain import MAX_NESTING, is_text


def load(text: str) -> object:
    """Reads a JSON document; see `text.load_text`."""
    document = parsed(text)
    check(document, text)
    return document


def parsed(text: str) -> object:
    """Reads a JSON text that may be nested deeper, and hold stranger texts, than a document of ours: `check` refuses those."""
    try:
        document: object = json.loads(text, object_pairs_hook=_once)
    except RecursionError:
        raise _too_deep() from None
    except json.JSONDecodeError as error:
        raise SyntaxFault(f"not JSON: {error}") from None
    except ValueError:  # Python reads no whole number of more digits
        raise SyntaxFault(f"not JSON: a whole number of more than {get_int_max_str_digits()} digits") from None
    return document


def check(document: object, text: str) -> None:
    """Refuses a document that is nested too deeply or holds half a surrogate pair; `text` is what it was read from."""
    _check_depth(document)
    if "\\ud" in text or "\\uD" in text:
        _check_texts(document)


def dump(document: Any) -> str:
    """Writes plain values as one line of JSON."""
    return _ENCODER.encode(document) + "\n"


_ENCODER: Final = json.JSONEncoder(ensure_ascii=False, check_circular=False, allow_nan=False, separators=(",", ":"))


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        seen: set[str] = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))  # type: ignore[func-returns-value]
        raise SyntaxFault(f"not JSON: the key {twice!r:.80} is given twice in one object")
    return found


def _too_deep() -> SyntaxFault:
    return SyntaxFault(f"nested too deeply: more than {MAX_NESTING} levels")


def _children(containers: list[Any]) -> list[Any]:
    return [child for outer in containers for child in (outer.values() if isinstance(outer, dict) else outer)]


def _check_depth(document: object) -> None:
    level = [document]
    for _ in range(MAX_NESTING + 1):
        level = [item for item in level if item.__class__ is dict or item.__class__ is list]  # all that json makes
        if not level:
            return
        level = _children(level)
    raise _too_deep()


def _check_texts(document: object) -> None:
    """Refuses lone surrogates, which an escape can smuggle past UTF-8."""
    level = [document]
    while level:
        texts = [item for item in level if isinstance(item, str)]
        texts += [key for item in level if isinstance(item, dict) for key in item]
        if not all(is_text(text) for text in texts):
            raise SyntaxFault("a text holds half a surrogate pair, which is no character")
        level = _children([item for item in level if isinstance(item, (dict, list))])
