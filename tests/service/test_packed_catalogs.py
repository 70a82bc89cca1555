"""Catalogs on their way to other processes: each process has them once."""

from __future__ import annotations

from catalogs import load_catalogs
from service.packed_catalogs import KEPT, KNOWN, packed, unpacked


def test_a_process_has_the_catalogs_once_that_it_sends_and_is_sent() -> None:
    ours = packed(load_catalogs())
    assert unpacked(ours) is load_catalogs()
    KNOWN.clear()
    sent = unpacked(ours)
    assert sent == load_catalogs() and sent is not load_catalogs()
    assert unpacked(bytes(bytearray(ours))) is sent
    assert unpacked(packed(load_catalogs())) is load_catalogs()
    for number in range(2 * KEPT):
        packed(load_catalogs().model_copy(update={"fingerprint": str(number)}))
    assert len(KNOWN) == KEPT
