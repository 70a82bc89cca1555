"""Text as XML takes it: what stands for markup written otherwise, and what no XML file may hold left out."""

import re
from bisect import bisect
from functools import lru_cache
from itertools import accumulate
from typing import Final

LONGEST_NAME: Final = 400
"""The most bytes of a name: a joint's line has three, and PyBullet reads 4,000 of a line; 50,000 end libsdformat."""
_MOST_BYTES: Final = 6
"""What XML writes of a letter at most: `&quot;`."""
_SPECIAL: Final = re.compile("[&<>\"'\t\n\r]|[^\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_WRITTEN: Final = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;", "\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}


def xml_text(words: str) -> str:
    """Returns text that reads back from an attribute or an element; a character that XML 1.0 forbids becomes U+FFFD."""
    return _SPECIAL.sub(lambda found: _WRITTEN.get(found[0], "\ufffd"), words)


def xml_name(words: str) -> str:
    """Returns the longest start of a name that XML writes in LONGEST_NAME bytes."""
    if len(words) * _MOST_BYTES <= LONGEST_NAME:
        return words
    sizes = [len(xml_text(letter).encode()) for letter in words[:LONGEST_NAME]]
    return words[: bisect([*accumulate(sizes)], LONGEST_NAME)]


def xml_comment(words: str) -> str:
    """Returns text for a comment, in which two hyphens may not meet, nor a hyphen end it."""
    return xml_text(words).replace("-", "\u2010")


def xml_numbers(*values: float) -> str:
    """Returns numbers with spaces between, rounded to a millionth."""
    return " ".join(map(_number, values))


@lru_cache(maxsize=1 << 14)
def _number(value: float) -> str:
    """Returns a number's text; homes hold few different ones."""
    return f"{round(value, 6) + 0.0:.9g}"
