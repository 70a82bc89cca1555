"""A service that is told to stop leaves nothing where it keeps what is temporary."""

from __future__ import annotations

import signal
import sys
import tempfile
from io import StringIO
from multiprocessing import get_context
from pathlib import Path

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


def _stopped_as_it_answers(temporary: str, heard: Path) -> None:
    said = _StoppingReader()
    sys.stderr, tempfile.tempdir = said, temporary
    Workers.start = Here.start  # type: ignore[method-assign,assignment]
    serve(Settings(port=0, store=TEMPORARY), load_catalogs())
    heard.write_text(said.getvalue())


def test_a_service_stopped_as_it_says_where_it_answers_leaves_nothing(tmp_path: Path) -> None:
    """In a process of its own: the tests' may have a loop of events already, in which no other can run."""
    temporary, heard = tmp_path / "temporary", tmp_path / "heard"
    temporary.mkdir()
    service = get_context("spawn").Process(target=_stopped_as_it_answers, args=(str(temporary), heard))
    service.start()
    service.join()
    assert service.exitcode == 0
    assert heard.read_text().splitlines()[-1] == "Compose has stopped."
    assert list(temporary.iterdir()) == []
