"""The type of a style: palettes and materials."""

from __future__ import annotations

from catalogs.entries import Entry


class Style(Entry):
    """One style of a home."""
