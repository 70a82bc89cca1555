"""A service that is told to stop leaves nothing where it keeps what is temporary."""

from __future__ import annotations

import os
import signal
import sys
import tempfile
from io import StringIO
from pathlib import Path

import pytest

from catalogs import load_catalogs
from service.server import serve
from service.service_settings import Settings
from service.service_store import TEMPORARY
from service.workers import Workers
from tests.service.here import Here


class _StoppingReader(StringIO):
    """Hears where the service answers, and tells it to stop at once."""

    def write(self, words: str) -> int:
        if "answers at" in words:
            assert signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL, "it would end amid what it does"
            signal.raise_signal(signal.SIGTERM)
        return super().write(words)


def test_a_service_stopped_as_it_says_where_it_answers_leaves_nothing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    said = _StoppingReader()
    monkeypatch.setattr(sys, "stderr", said)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(Workers, "start", Here.start)
    serve(Settings(port=0, store=TEMPORARY), load_catalogs())
    assert said.getvalue().splitlines()[-1] == "Compose has stopped."
    assert os.listdir(tmp_path) == []
