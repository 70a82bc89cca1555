"""A dataset read back. Is it as it was made? Digests of files and scenes, schemas, counts; homes made again and validated."""

import json
import tarfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import file_digest, sha256
from pathlib import Path
from typing import Any, Final, cast

import pyarrow.parquet as pq

from catalogs import Catalogs
from service.dataset.dataset_plan import Shard, again, made_home, split_of
from service.dataset.manifest import digest_of, manifest_of, records_of
from service.dataset.shards import SCHEMAS, table_path
from solver.errors import FieldError
from solver.exchange import load_text, read_scene
from solver.plain import Document
from solver.streams import Stream
from solver.validator import validate

COLUMNS: Final = ["seed", "split", "status", "request", "catalog", "catalog_fingerprint", "version", "errors", "digest", "scene"]
MOST_FAULTS: Final = 50


@dataclass(frozen=True)
class DatasetVerdict:
    """What was looked at, and what is wrong, in words."""

    homes: int
    files: int
    made: int
    faults: tuple[str, ...]


def check_dataset(folder: Path, catalogs: Catalogs, sample: int | None) -> DatasetVerdict:
    """Checks a dataset; so many of its homes (None: all), drawn by their seeds, are made again and validated.

    Raises:
        FieldError: there is no dataset in the folder; or its homes are of another version or other catalogs.
    """
    manifest, records = manifest_of(folder), records_of(folder)
    faults = [*_of_manifest(manifest, records), *(fault for record in records for fault in _of_files(folder, record))]
    digests = {int(seed): digest for record in records for seed, digest in record["digests"].items()}
    chosen = _chosen(list(digests), sample)
    made = 0
    if not faults:
        seen: Counter[int] = Counter()
        for row in rows_of_houses(folder, COLUMNS):
            seen[row["seed"]] += 1
            faults += _of_row(row, digests)
            if row["seed"] in chosen:
                made += 1
                faults += _of_home(row, catalogs)
        faults += [f"seed {seed} has {seen[seed]} rows" for seed in digests if seen[seed] != 1]
    return DatasetVerdict(len(digests), sum(len(record["files"]) for record in records), made, tuple(faults[:MOST_FAULTS]))


def _chosen(seeds: list[int], sample: int | None) -> set[int]:
    """Returns the seeds with the smallest hashes: a sample that is the same each time."""
    if sample is None:
        return set(seeds)
    return set(sorted(seeds, key=lambda seed: Stream(seed, "checked sample").bits())[:sample])


def _of_manifest(manifest: Document, records: list[Document]) -> Iterator[str]:
    digest, counts = digest_of(records), Counter[str]()
    for record in records:
        counts.update(record["rows"])
    if digest != manifest["digest"]:
        yield f"the homes' digest is {digest[:16]}, and the manifest says {manifest['digest'][:16]}"
    if dict(counts) != manifest["rows"]:
        yield f"the shards hold {dict(counts)} rows, and the manifest says {manifest['rows']}"


def _of_files(folder: Path, record: Document) -> Iterator[str]:
    rows: Counter[str] = Counter()
    for name, said in record["files"].items():
        path = folder / name
        if not path.is_file():
            yield f"{name} is missing"
        elif _digest(path) != said["sha256"]:
            yield f"{name} is not as it was written"
        elif path.suffix == ".tar":
            with tarfile.open(path) as archive:
                seeds = {member.name.partition(".")[0] for member in archive}
            if strange := sorted(seeds - record["digests"].keys()):
                yield f"{name} holds files of {strange[0]}, which is no seed of its shard"
        else:
            table = path.parent.name
            with pq.ParquetFile(path) as file:
                rows[table] += file.metadata.num_rows
                if not file.schema_arrow.equals(SCHEMAS[table]):
                    yield f"{name} has other columns than {table} have"
    if not rows.items() <= record["rows"].items() or sum(rows.values()) != sum(record["rows"].values()):
        yield f"the shard from seed {record['first']} has {dict(rows)} rows instead of {record['rows']}"


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return file_digest(file, sha256).hexdigest()


def _of_row(row: Document, digests: dict[int, str]) -> Iterator[str]:
    seed = row["seed"]
    if row["split"] != split_of(seed):
        yield f"seed {seed} is in {row['split']} instead of {split_of(seed)}"
    if (row["digest"] or "") != digests.get(seed):
        yield f"the row of seed {seed} has another digest than its shard's record"
    if row["scene"] is not None and sha256(row["scene"].encode()).hexdigest() != row["digest"]:
        yield f"the scene of seed {seed} is not as it was made"


def _of_home(row: Document, catalogs: Catalogs) -> Iterator[str]:
    """Makes a home again from its row, and validates what the row holds."""
    home = made_home(*again(row, catalogs))
    if home.digest != (row["digest"] or ""):
        yield f"the home of seed {row['seed']} is another one when it is made again"
    scene: Any = home.scene if row["scene"] is None else read_scene(load_text(row["scene"], "json"))
    if scene is not None:
        errors = sum(issue.severity == "error" for issue in validate(scene, again(row, catalogs)[2]))
        if errors != row["errors"]:
            yield f"the home of seed {row['seed']} has {errors} errors, and its row says {row['errors']}"
    json.loads(row["request"])


def row_of(folder: Path, seed: int) -> Document:
    """Returns the row of a seed's home.

    Raises:
        FieldError: there is no dataset in the folder, or no such home in it.
    """
    size = manifest_of(folder)["shard_size"]
    path = folder / table_path("houses", split_of(seed), Shard(seed // size, seed, seed))
    rows = pq.read_table(path, filters=[("seed", "=", seed)]).to_pylist() if path.is_file() else []
    if not rows:
        raise FieldError("--seed", f"{folder} holds no home of seed {seed}", "a seed of its manifest")
    return cast(Document, rows[0])


def rows_of_houses(folder: Path, columns: list[str]) -> Iterator[dict[str, Any]]:
    """Yields some columns of every house, split by split, a batch of rows at a time in memory."""
    for path in sorted((folder / "tables" / "houses").glob("*.parquet")):
        for batch in pq.ParquetFile(path).iter_batches(batch_size=500, columns=columns):
            yield from batch.to_pylist()
