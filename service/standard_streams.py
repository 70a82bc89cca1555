"""The standard streams of a command, also where whoever started it has closed some of them."""

import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Final

from solver.whole_files import write_whole

STREAM: Final = "-"
"""The file name that stands for a standard stream."""


def read_standard_input() -> bytes:
    """Reads standard input to its end.

    Raises:
        OSError: it is closed.
    """
    if sys.stdin is None:
        raise OSError("standard input is closed")
    return sys.stdin.buffer.read()


def write_standard_output(content: bytes) -> None:
    """Writes to standard output, and sees to it that it arrives.

    Raises:
        OSError: it is closed, or takes no more.
    """
    if sys.stdout is None:
        raise OSError("standard output is closed")
    sys.stdout.buffer.write(content)
    sys.stdout.buffer.flush()


def read_content(name: str) -> bytes:
    """Reads a file, or standard input."""
    return read_standard_input() if name == STREAM else Path(name).read_bytes()


def put(content: bytes, name: str) -> None:
    """Writes a file as a whole, or to standard output."""
    if name == STREAM:
        write_standard_output(content)
    else:
        write_whole(name, content)


def say(words: str) -> None:
    """Tells a person something, on standard error if it takes it."""
    if sys.stderr is None:
        return
    with suppress(OSError):
        print(words, file=sys.stderr, flush=True)


def give_up_output() -> None:
    """Lets what standard output does not take go nowhere, so that the end of the program does not try again."""
    if sys.stdout is None:
        return
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
