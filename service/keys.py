"""The keys of those who may ask: read from a text, compared in constant time, kept as digests alone."""

import re
from collections.abc import Iterable, Iterator, Mapping
from hashlib import sha256
from hmac import compare_digest
from typing import Final

from solver.errors import FieldError
from solver.exchange import load_text

LEAST_LETTERS: Final = 16
"""How long a key is at least. Our choice: what `openssl rand -hex 16` draws is twice as long."""
DIGEST: Final = re.compile(r"sha256:([0-9a-f]{64})")
NAME: Final = re.compile(r"[\w.@-]{1,100}")
ALLOWED: Final = f"a text of at least {LEAST_LETTERS} letters without spaces, or sha256: and its digest"


class KeyRing:
    """Keys with the names of those who have them; without any, everybody may ask.

    Args:
        keys: name and key, the key itself or `sha256:` and its digest in hexadecimal; a name may have several.

    Raises:
        FieldError: a name or a key cannot be one, or two names have the same key. Says the name, never the key.
    """

    def __init__(self, keys: Iterable[tuple[str, str]] = ()) -> None:
        self._owners: dict[bytes, str] = {}
        for name, key in keys:
            if not NAME.fullmatch(name):
                raise FieldError("keys", f"{name!r:.60} is no name", "1 to 100 letters, digits, and . @ _ -")
            digest = _digest_of(name, key)
            if self._owners.setdefault(digest, name) != name:
                raise FieldError(f"keys.{name}", f"is the key of {self._owners[digest]}, too", "a key of its own")

    def __bool__(self) -> bool:
        return bool(self._owners)

    def owner_of(self, sent: str) -> str | None:
        """Returns whose key a text is, or None. It takes as long whatever the text is."""
        digest, found = sha256(sent.encode("utf-8", "surrogatepass")).digest(), None
        for known, name in self._owners.items():
            if compare_digest(known, digest):
                found = name
        return found


def _digest_of(name: str, key: str) -> bytes:
    if digest := DIGEST.fullmatch(key):
        return bytes.fromhex(digest.group(1))
    if len(key) < LEAST_LETTERS or not key.isascii() or not key.isprintable() or " " in key:
        raise FieldError(f"keys.{name}", "is no key", ALLOWED)
    return sha256(key.encode()).digest()


def read_keys(text: bytes) -> list[tuple[str, str]]:
    """Reads a file of keys: YAML or JSON, a key by its owner's name, or a list of them.

    Raises:
        FieldError: something in it is no key.
        SyntaxFault: it is no YAML.
    """
    document = load_text(text, "yaml") if text.strip() else {}
    if not isinstance(document, Mapping):
        raise FieldError("keys", "is no mapping", "name: key, one a line")
    return list(_pairs(document))


def _pairs(document: Mapping[object, object]) -> Iterator[tuple[str, str]]:
    for name, keys in document.items():
        for key in keys if isinstance(keys, list) else [keys]:
            if not isinstance(key, str):
                raise FieldError(f"keys.{name}"[:60], "is no key", f"{ALLOWED}; in quotes where it is a number")
            yield str(name), key


def listed_keys(pairs: Iterable[str]) -> list[tuple[str, str]]:
    """Reads pairs such as `ann=KEY`.

    Raises:
        FieldError: one is no such pair.
    """
    found = [(name, key) for name, _, key in (pair.partition("=") for pair in pairs)]
    if any(not key for _, key in found):
        raise FieldError("keys", "are not all NAME=KEY", "pairs of a name and a key")
    return found
