"""Text as XML takes it: what stands for markup written otherwise, and what no XML file may hold left out."""

import re
from functools import lru_cache
from typing import Final

_SPECIAL: Final = re.compile("[&<>\"'\t\n\r]|[^\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_WRITTEN: Final = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;", "\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}


def xml_text(words: str) -> str:
    """Returns text that reads back from an attribute or an element; a character that XML 1.0 forbids becomes U+FFFD."""
    return _SPECIAL.sub(lambda found: _WRITTEN.get(found[0], "\ufffd"), words)


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
