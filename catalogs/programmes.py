"""The type of a preset: a named programme of rooms."""

from __future__ import annotations

from catalogs.entries import Entry


class Preset(Entry):
    """A named programme: how many rooms of which types."""
