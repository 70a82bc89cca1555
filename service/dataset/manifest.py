"""The manifest of a dataset, dataset.json: what its homes were made from, which seeds there are, and what all of them amount to."""

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any, Final

from service.dataset.dataset_plan import DatasetPlan, Shard
from service.dataset.shards import PART, RECORDS, record_path
from solver.errors import FieldError
from solver.plain import Document
from solver.whole_files import write_whole

MANIFEST: Final = "dataset.json"
_OF_SHARDS: Final = ("rows", "splits", "status")
"""What the records of shards count."""


def claim(plan: DatasetPlan) -> None:
    """Says in a folder what its homes are made from, before there are any.

    Raises:
        FieldError: the folder holds something else, or homes that were made from something else.
        OSError: nothing can be written there.
    """
    plan.folder.mkdir(parents=True, exist_ok=True)
    path = plan.folder / MANIFEST
    if path.exists():
        known = manifest_of(plan.folder)
        for key, value in plan.identity.items():
            if known.get(key) != json.loads(json.dumps(value)):
                problem = f"{plan.folder} holds homes made with {key} {_short(known.get(key))}, not {_short(value)}"
                raise FieldError("--out", problem, "the same as there, or a new folder")
        return
    if others := sorted(one.name for one in plan.folder.iterdir() if not one.name.endswith(PART)):
        raise FieldError("--out", f"{plan.folder} holds {others[0]!r:.80} and no {MANIFEST}", "a new folder, or one of a dataset")
    write_manifest(plan.folder, plan.identity, [])


def _short(value: object) -> str:
    text = json.dumps(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def manifest_of(folder: Path) -> Document:
    """Reads a dataset's manifest.

    Raises:
        FieldError: there is none, or it is none of ours.
        OSError: it cannot be read.
    """
    path = folder / MANIFEST
    if not path.is_file():
        raise FieldError("dataset", f"{folder} holds no {MANIFEST}", "the folder of a dataset")
    try:
        found = json.loads(path.read_bytes())
    except ValueError:
        found = None
    if not isinstance(found, dict) or not str(found.get("format", "")).startswith("compose-dataset/"):
        raise FieldError("dataset", f"{path} is no manifest of a dataset", "the folder of a dataset")
    return found


def digest_of(records: Iterable[Document]) -> str:
    """Returns the digest of all homes of shards, by their own."""
    lines = (f"{seed} {digest}\n" for record in records for seed, digest in record["digests"].items())
    return sha256("".join(lines).encode()).hexdigest()


def write_manifest(folder: Path, identity: Mapping[str, Any], records: Sequence[Document]) -> Document:
    """Writes what all shards amount to, and returns it."""
    counts: dict[str, Counter[str]] = {name: Counter() for name in _OF_SHARDS}
    ranges = list[list[int]]()
    for record in records:
        for name, found in counts.items():
            found.update(record[name])
        if ranges and ranges[-1][1] + 1 == record["first"]:
            ranges[-1][1] = record["last"]
        else:
            ranges.append([record["first"], record["last"]])
    told = {name: dict(sorted(found.items())) for name, found in counts.items()}
    manifest = {**identity, "seeds": ranges, "homes": sum(counts["splits"].values()), **told, "digest": digest_of(records)}
    write_whole(folder / MANIFEST, (json.dumps(manifest, indent=2) + "\n").encode())
    return manifest


def records_of(folder: Path) -> list[Document]:
    """Reads the records of all shards that are done, by their seeds."""
    return [json.loads(path.read_bytes()) for path in sorted((folder / RECORDS).glob("*.json"))]


def is_done(plan: DatasetPlan, shard: Shard) -> bool:
    """Tells whether all of a shard is there, perhaps more of its seeds than were asked for."""
    path = record_path(plan.folder, shard)
    if not path.is_file():
        return False
    record = json.loads(path.read_bytes())
    whole = all(_size(plan.folder / name) == file["bytes"] for name, file in record["files"].items())
    return whole and record["first"] <= shard.first and shard.last <= record["last"]


def widened(plan: DatasetPlan, shard: Shard) -> Shard:
    """Returns a shard with the seeds that are there of it already: its files are written anew with all of them."""
    path = record_path(plan.folder, shard)
    if not path.is_file():
        return shard
    record = json.loads(path.read_bytes())
    return shard._replace(first=min(shard.first, record["first"]), last=max(shard.last, record["last"]))


def _size(path: Path) -> int:
    return path.stat().st_size if path.is_file() else -1


def sweep(folder: Path) -> None:
    """Removes what an ended run was writing."""
    for path in folder.glob(f"**/*{PART}"):
        path.unlink(missing_ok=True)
