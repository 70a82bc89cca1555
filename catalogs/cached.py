"""Our own catalogs, checked once and kept in the user's cache folder: to read them back takes a twentieth of the time.

Ours are read anew whenever a file of this folder is another one. Only types of this folder are made of what the file says. A cache that
cannot be had, or is damaged, is none.
"""

import io
import os
import pickle
import sys
from contextlib import suppress
from functools import lru_cache
from hashlib import blake2b
from os import PathLike
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import Any, Final

from pydantic import VERSION

from catalogs.schema import Catalogs

HERE: Final = Path(__file__).parent
_DIGEST: Final = 32
"""Bytes of a digest: the file begins with that of what the catalogs were made from, and that of the rest."""


def load_catalogs(directory: str | PathLike[str] | None = None) -> Catalogs:
    """Reads and checks our catalogs (once), or those with a directory's own laid over them.

    Args:
        directory: holds any of a catalog's files, as ours are (a file's stem in rooms/ is the room type's name).
            What it names anew is added; what ours has too is replaced. A YAML file of any other name is refused.

    Raises:
        CatalogError: a file cannot be read, is not YAML, or says something that cannot be; the first fault found.
    """
    if directory is None:
        return _ours()
    from catalogs.reading import read_catalogs  # noqa: PLC0415 - YAML and all checks take 0.1 s to import

    return read_catalogs(Path(directory))


@lru_cache(maxsize=1)
def _ours() -> Catalogs:
    source = source_digest()
    found = _read(source)
    if found is None:
        from catalogs.reading import read_catalogs  # noqa: PLC0415

        found = read_catalogs()
        _write(source, found)
    return found


def cache_file() -> Path | None:
    """Returns where they are kept; None where the user has no home."""
    with suppress(RuntimeError):
        return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "compose-homes", "catalogs.pickle")
    return None


def source_digest() -> bytes:
    """Returns what changes with any file that they are made from, and with what makes them."""
    digest = blake2b(f"{sys.version} {VERSION} {HERE}".encode(), digest_size=_DIGEST)
    for path in sorted(path for pattern in ("*.yaml", "*/*.yaml", "*.py", "*/*.py") for path in HERE.glob(pattern)):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(HERE)} {len(content)} ".encode() + content)
    return digest.digest()


class _Unpickler(pickle.Unpickler):
    """Makes types of this folder only."""

    def find_class(self, module: str, name: str) -> Any:
        """Refuses all others."""
        if not module.startswith(f"{__package__}."):
            raise pickle.UnpicklingError(f"{module}.{name} is no type of the catalogs")
        return super().find_class(module, name)


def _read(source: bytes) -> Catalogs | None:
    file = cache_file()
    try:
        content = file.read_bytes() if file else b""
    except OSError:
        return None
    head, body = content[: 2 * _DIGEST], content[2 * _DIGEST :]
    if head != source + _of(body):
        return None
    try:
        found = _Unpickler(io.BytesIO(body)).load()
    except pickle.UnpicklingError:
        return None
    return found if isinstance(found, Catalogs) else None


def _write(source: bytes, catalogs: Catalogs) -> None:
    """Keeps them, at once or not at all."""
    file, body = cache_file(), pickle.dumps(catalogs, pickle.HIGHEST_PROTOCOL)
    with suppress(OSError):
        if file is None:
            return
        file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        with NamedTemporaryFile(dir=file.parent, delete=False) as new:
            new.write(source + _of(body) + body)
        os.replace(new.name, file)


def _of(body: bytes) -> bytes:
    return blake2b(body, digest_size=_DIGEST).digest()
