"""Writes recorded_drags.json anew: `python -m tests.core.record_drags`, where what a frame answers was changed for a reason.

Each drag: its opening, where the pointer went, and a digest of all its answers in turn, each the next frame's last. wasmtime, Node and
Chromium are held to the same digests (tests/core/test_drag_bytes.py, web/tests/drag_core.test.ts, tests/browser/test_drag.py).
"""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from struct import pack

from catalogs import load_catalogs
from solver.pipeline.drag import NO_ANSWER, Dragging, opening_of
from tests.pipeline.drags import dense_rooms, spots_of, way

RECORDED = Path(__file__).with_name("recorded_drags.json")
FRAMES, SEEDS = 50, range(1, 4)


@dataclass(frozen=True)
class RecordedDrag:
    """A drag: what the core was sent, where all was at its start, where the pointer went, a digest of the answers."""

    opening: bytes
    start: Sequence[float]
    wishes: Sequence[Sequence[float]]
    digest: str


def digest_of(opening: bytes, start: Sequence[float], wishes: Iterable[Sequence[float]]) -> str:
    """Drags in wasmtime; returns the digest of the answers, as 64-bit floats."""
    drag, spots, digest = Dragging(opening), tuple(start), sha256()
    for x, z in wishes:
        answer = drag.frame(x, z, spots)
        spots = spots if answer.outcome == NO_ANSWER else answer.spots
        digest.update(pack(f"<{2 + len(answer.spots)}d", answer.outcome, answer.work, *answer.spots))
    return digest.hexdigest()


def recorded() -> list[RecordedDrag]:
    """Reads the drags that were recorded."""
    rows = json.loads(RECORDED.read_text(encoding="utf-8"))
    return [RecordedDrag(b64decode(row["opening"]), row["start"], row["wishes"], row["digest"]) for row in rows]


def main() -> None:
    """Records drags of the sofas, beds and tables of a few homes."""
    rows = []
    for seed in SEEDS:
        for scene in dense_rooms(seed)[:2]:
            label = max((piece for piece in scene.rooms[0].furniture if piece.on is None), key=lambda piece: piece.width * piece.depth).id
            opening = opening_of(scene, label, (), load_catalogs())
            if opening is None:
                raise SystemExit(f"{label} of seed {seed} cannot be dragged")
            start, wishes = spots_of(scene), list(way(scene, label, FRAMES))
            sent = b64encode(opening).decode("ascii")
            rows.append({"opening": sent, "start": start, "wishes": wishes, "digest": digest_of(opening, start, wishes)})
    RECORDED.write_text(json.dumps(rows, separators=(",", ":")) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
