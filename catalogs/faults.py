"""Faults of a catalog: what cannot be, and where it is said; and the base of all errors, which the solver's have too.

It stands here because catalogs import nothing of ours.
"""

import errno
from dataclasses import dataclass
from pathlib import Path
from typing import Final

Key = tuple[str | int, ...]
"""Where in a file: keys of mappings and indices of lists, from the outside in."""


@dataclass(frozen=True)
class Fault:
    """Something that cannot be: in which file (its path without `.yaml`), at which key, what, what is allowed."""

    file: str
    at: Key
    problem: str
    allowed: str = ""

    @property
    def entry(self) -> tuple[str, str]:
        """The section it is in and the name of the entry."""
        section, _, name = self.file.partition("/")
        return section, name or str(self.at[0])


_SYSTEM_WORDS: Final = {
    errno.EISDIR: "is a folder, not a file",
    errno.EEXIST: "is a file, not a folder",
    errno.EACCES: "may not be read or written here",
    errno.EPERM: "may not be read or written here",
    errno.EROFS: "is on a disk that is not written to",
    errno.ENOSPC: "the disk is full",
    errno.EADDRINUSE: "something listens at that address and port already: --port names another one, 0 any that is free",
}


def system_words(error: OSError) -> str:
    """Says in plain words what the system refused, and the file that it is about if it names one."""
    name = error.filename
    if name is not None and error.errno in (errno.ENOENT, errno.ENOTDIR):
        above = Path(name).parent
        return f"no such file: {name}" if above.is_dir() else f"no such folder: {above}"
    words = _SYSTEM_WORDS.get(error.errno or 0) or error.strerror or str(error)
    return words if name is None else f"{name}: {words}"


class ComposeError(Exception):
    """Base of everything this project raises on purpose."""


class CatalogError(ComposeError):
    """A catalog cannot be used.

    Args:
        file: the file's path.
        key: which key, such as `bed.size` or `pieces.3.rules.0.of`; empty if the file as a whole is meant.
        line: its line, from 1; 0 where no line of it is meant.
        problem: what is wrong, in words.
        allowed: what would be accepted, in words; empty if there is nothing to add.
    """

    def __init__(self, file: str, key: str, line: int, problem: str, allowed: str = "") -> None:
        self.file, self.key, self.line, self.problem, self.allowed = file, key, line, problem, allowed
        where = file + (f":{line}" if line else "") + (f": {key}" if key else "")
        super().__init__(f"{where}: {problem}" + (f" (allowed: {allowed})" if allowed else ""))

    def __reduce__(self) -> "tuple[type[CatalogError], tuple[str, str, int, str, str]]":
        """Lets it go from one process to another: a pool raises it again."""
        return type(self), (self.file, self.key, self.line, self.problem, self.allowed)
