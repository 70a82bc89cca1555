"""How a problem document is read in tests: strictly, by RFC 9457 and what the service promises."""

from __future__ import annotations

import re
from typing import Any

from httpx2 import Response

TRACE = re.compile(r"Traceback|File \"|\.py\b|line \d+, in ")


def problem_of(answer: Response) -> dict[str, Any]:
    """Returns an answer's problem document after checking that it is one."""
    assert answer.headers["content-type"] == "application/problem+json", answer.text[:300]
    document = answer.json()
    assert set(document) == {"type", "title", "status", "detail", "errors"}
    assert document["type"] == "about:blank"
    assert document["status"] == answer.status_code
    assert document["title"].strip()
    assert document["detail"].strip()
    assert all(set(entry) == {"field", "problem", "allowed"} for entry in document["errors"])
    assert all(isinstance(text, str) for entry in document["errors"] for text in entry.values())
    assert not TRACE.search(answer.text)
    assert len(answer.content) < 20_000
    return dict(document)


def entry_of(answer: Response, status: int) -> dict[str, str]:
    """Returns the first entry of a refusal that names what is wrong; each field is named once."""
    assert answer.status_code == status, answer.text[:300]
    entries = problem_of(answer)["errors"]
    assert all(entry["field"] and entry["problem"] for entry in entries)
    assert len({entry["field"] for entry in entries}) == len(entries) > 0
    return dict(entries[0])
