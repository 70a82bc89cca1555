"""The page's types are held against the service's: the file that tells them is as it would be written now."""

from __future__ import annotations

from scripts.contract import FILE, contract


def test_the_types_that_the_page_is_held_against_are_the_services() -> None:
    assert FILE.read_text(encoding="utf-8") == contract(), "python -m scripts.contract writes it anew"
