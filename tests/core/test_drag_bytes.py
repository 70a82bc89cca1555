"""Frames of recorded drags are answered with the same bytes everywhere: here by wasmtime."""

from __future__ import annotations

import pytest

from tests.core.record_drags import RecordedDrag, digest_of, recorded

LEAST_FRAMES = 300


@pytest.mark.parametrize("drag", recorded(), ids=lambda drag: drag.digest[:8])
def test_wasmtime_answers_as_recorded(drag: RecordedDrag) -> None:
    assert digest_of(drag.opening, drag.start, drag.wishes) == drag.digest


def test_enough_frames_are_recorded_and_they_differ() -> None:
    drags = recorded()
    assert sum(len(drag.wishes) for drag in drags) >= LEAST_FRAMES
    assert len({drag.digest for drag in drags}) == len(drags)
