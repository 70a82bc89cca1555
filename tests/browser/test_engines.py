"""The core answers the same in wasmtime, Node and Chromium: every call of two homes and of a drag, by results and by memory."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser

from solver import Request, generate
from tests.core.engines import frames_of_drags, in_chromium, in_node, recording_of
from tests.core.recording import recorded
from tests.sweeps import times

FRAMES = times(300, 120)


@pytest.fixture(scope="module")
def recordings() -> list[bytes]:
    """What the core was asked; and the same with another number at the end of its last call, which must be noticed."""
    true = recording_of(range(5, 7), frames=6)
    return [true, true[:-1] + bytes([true[-1] ^ 1])]


@pytest.fixture(scope="module")
def frames() -> bytes:
    """What the core was asked for many frames of drags, over the rooms of a home."""
    scene = generate(Request(seed=3, program="family", decorate=True)).scene
    with recorded() as recorder:
        frames_of_drags(scene, FRAMES // len(scene.rooms) + 1)
    return recorder.content


def test_frames_of_drags_are_answered_the_same(browser: Browser, frames: bytes) -> None:
    for (answer,) in (in_node([frames]), in_chromium(browser, [frames])):
        assert answer["calls"] >= FRAMES
        assert answer["differences"] == []


def test_node_answers_the_same(recordings: list[bytes]) -> None:
    same, other = in_node(recordings)
    assert same["calls"] > 150
    assert same["differences"] == []
    assert [one["call"] for one in other["differences"]] == [same["calls"]]


def test_chromium_answers_the_same(browser: Browser, recordings: list[bytes]) -> None:
    same, other = in_chromium(browser, recordings)
    assert same["calls"] > 150
    assert same["differences"] == []
    assert [one["call"] for one in other["differences"]] == [same["calls"]]
