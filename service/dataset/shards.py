"""One shard of a dataset: its homes made, counted and written, as tables a split and as archives, each file whole or not there.

A home's rows and files depend on the plan and its seed alone, so that it makes no difference who makes the shard, or how often.
"""

import io
import json
import os
import socket
import sys
import tarfile
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, suppress
from functools import cache, partial
from hashlib import file_digest, sha256
from importlib.machinery import BuiltinImporter
from pathlib import Path, PurePosixPath
from typing import Any, Final

import pyarrow as pa
import pyarrow.parquet as pq

from service.dataset.dataset_plan import JSON, DatasetPlan, MadeHome, Shard, request_text, split_of
from service.packed_catalogs import unpacked
from solver.errors import FieldError, system_words
from solver.exchange import dump_plain
from solver.exports import packed
from solver.exports.table_rows import Row, rows_of
from solver.pipeline.export import export_each
from solver.plain import Document
from solver.scene import Scene
from solver.scene_bodies import counted
from solver.version import VERSION

REAL, TEXT = pa.float64(), pa.string()
COLUMN_KINDS: Final[dict[str, pa.DataType]] = {
    "text": TEXT, "flag": pa.bool_(), "real": REAL, "whole": pa.int64(), "texts": pa.list_(TEXT), "points": pa.list_(pa.list_(REAL)),
}  # fmt: skip
"""What columns hold, by the word for it in `TABLE_COLUMNS`."""
TABLE_COLUMNS: Final = {
    "houses": """
        whole: seed; text: id split status program style request catalog catalog_fingerprint version; real: width depth area;
        whole: rooms doors windows furniture decorations people errors warnings proven best left_out missing; texts: unjoined notes issues;
        text: refused digest scene
    """,
    "rooms": """
        whole: seed; text: id; whole: index; text: type; whole: level; flag: outdoor; real: x z width depth area; points: polygon;
        text: flooring; whole: furniture decorations; real: cost; flag: proven best; texts: left_out
    """,
    "pieces": "whole: seed; text: id room sort name kind category; real: x y z turn width depth height mass; text: color parent under wall",
    "receptacles": "whole: seed; text: id piece room surface front; real: x y z turn width depth clearance",
    "doors": """
        whole: seed; text: id kind; whole: level; text: axis; real: x z width sill head; text: room_a room_b hinge swing;
        flag: main_entrance
    """,
    "graph": "whole: seed; text: a b edge door",
    "fronts": "whole: seed; text: piece front; real: opens; text: meets",
}
"""The columns of each table in their order, behind what they hold; every row names its home by `seed`."""


def _schema(columns: str) -> pa.Schema:
    parts = [part.split(":") for part in columns.split(";")]
    return pa.schema([pa.field(name, COLUMN_KINDS[kind.strip()]) for kind, names in parts for name in names.split()])


SCHEMAS: Final[dict[str, pa.Schema]] = {table: _schema(columns) for table, columns in TABLE_COLUMNS.items()}
"""The schemas by table."""


RECORDS: Final = "shards"
"""The folder of the shards' records."""
TABLES: Final = "tables"
ARCHIVES: Final = "archives"
PART: Final = ".part"
"""What the name of a file ends with that is being written."""
ROW_GROUP: Final = 50
"""Homes whose rows are written at a time: memory does not grow with the shard."""


def record_path(folder: Path, shard: Shard) -> Path:
    """Returns where a shard's record is."""
    return folder / RECORDS / f"{shard.name}.json"


def table_path(table: str, split: str, shard: Shard) -> str:
    """Returns where a shard's rows of a table are, within the dataset."""
    return f"{TABLES}/{table}/{split}-{shard.name}.parquet"


def make_shard(plan: DatasetPlan, shard: Shard) -> Document:
    """Makes a shard and returns its record, which tells its seeds, digests, files and what is in them.

    Raises:
        FieldError: a file cannot be written; says which and why.
    """
    files = _ShardFiles(plan, shard)
    try:
        for seed in shard.seeds:
            files.add(plan.home(seed))
        record = files.finished()
        _write(record_path(plan.folder, shard), (json.dumps(record, separators=(",", ":")) + "\n").encode())
    except OSError as error:
        problem = f"{plan.folder} cannot be written to: {system_words(error)}"
        raise FieldError("--out", problem, "what is done is kept: the same command goes on") from None
    finally:
        files.close()
    return record


@cache
def _leave_pandas_out() -> None:
    """Lets pyarrow look for pandas in vain, once: it asks pandas what it is given, and to import that takes 0.9 s of CPU in every process.

    Whatever needs pandas later finds it.
    """
    finders, sys.meta_path = sys.meta_path, [BuiltinImporter]
    try:
        pa.array([0])
    finally:
        sys.meta_path = finders


class _ShardFiles:
    """The files of a shard while they are written."""

    def __init__(self, plan: DatasetPlan, shard: Shard) -> None:
        _leave_pandas_out()
        self.plan, self.shard = plan, shard
        self._waiting: dict[tuple[str, str], list[Row]] = {}
        self._tables: dict[str, pq.ParquetWriter] = {}
        self._archives: dict[str, tarfile.TarFile] = {}
        self._parts: dict[str, Path] = {}
        self._open = ExitStack()
        self._digests: dict[int, str] = {}
        self._counts: dict[str, Counter[str]] = {"rows": Counter(), "splits": Counter(), "status": Counter()}

    def add(self, home: MadeHome) -> None:
        """Takes a home's rows and files."""
        seed = home.request.seed or 0
        split = split_of(seed)
        row = house_row(self.plan, home, split)
        tables = {"houses": [tuple(map(row.get, SCHEMAS["houses"].names))]}
        if home.scene is not None:
            catalogs = unpacked(self.plan.catalogs[home.catalog])
            tables |= rows_of(home.scene, catalogs)
            if self.plan.exported:
                archive = self._archive(split)
                for info, content in members_of(self.plan, home):
                    archive.addfile(info, content)
        for table, rows in tables.items():
            self._waiting.setdefault((table, split), []).extend(rows)
            self._counts["rows"][table] += len(rows)
        self._digests[seed] = home.digest
        self._counts["splits"][split] += 1
        self._counts["status"][row["status"]] += 1
        if len(self._digests) % ROW_GROUP == 0:
            self._flush()

    def finished(self) -> Document:
        """Puts all files under their names and returns the shard's record."""
        self._flush()
        self._open.close()
        files = {}
        for name, part in sorted(self._parts.items()):
            with part.open("rb+") as file:
                digest = file_digest(file, sha256)
                os.fsync(file.fileno())
            files[name] = {"sha256": digest.hexdigest(), "bytes": part.stat().st_size}
            part.replace(self.plan.folder / name)
        self._parts.clear()
        counts = {name: dict(sorted(found.items())) for name, found in self._counts.items()}
        digests = {str(seed): digest for seed, digest in self._digests.items()}
        return {"first": self.shard.first, "last": self.shard.last, **counts, "files": files, "digests": digests}

    def close(self) -> None:
        """Removes what is not finished."""
        for table in self._tables.values():
            table.is_open = False  # or, thrown away, it would write its end still, and tell of the full disk itself
        self._open.pop_all()
        for archive in self._archives.values():
            with suppress(OSError):  # what waits to be written has no room
                archive.fileobj.close()
        for part in self._parts.values():
            part.unlink(missing_ok=True)

    def _flush(self) -> None:
        for (table, split), rows in self._waiting.items():
            name = table_path(table, split, self.shard)
            if name not in self._tables:
                opened = partial(pq.ParquetWriter, schema=SCHEMAS[table], compression="zstd")
                self._tables[name] = self._open.enter_context(opened(self._part(name)))
            columns = list(zip(*rows, strict=True)) or [()] * len(SCHEMAS[table])
            arrays = [pa.array(values, kind) for values, kind in zip(columns, SCHEMAS[table].types, strict=True)]
            self._tables[name].write_table(pa.Table.from_arrays(arrays, schema=SCHEMAS[table]))
        self._waiting.clear()

    def _archive(self, split: str) -> tarfile.TarFile:
        name = f"{ARCHIVES}/{split}-{self.shard.name}.tar"
        if name not in self._archives:
            opened = partial(tarfile.open, mode="w", format=tarfile.USTAR_FORMAT)
            self._archives[name] = self._open.enter_context(opened(self._part(name)))
        return self._archives[name]

    def _part(self, name: str) -> Path:
        path = self.plan.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        self._parts[name] = part = part_of(path)
        return part


def part_of(path: Path) -> Path:
    """Returns the name of a file while it is written: that of no other process, on no other machine."""
    return path.with_name(f"{path.name}.{socket.gethostname()}.{os.getpid()}{PART}")


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    part = part_of(path)
    try:
        with part.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


CLEAN, WITH_ERRORS, REFUSED = "clean", "errors", "refused"
"""What became of a home: it breaks no rule that must hold; it breaks one; its request cannot be met."""
_MISSING: Final = "missing_required"


def house_row(plan: DatasetPlan, home: MadeHome, split: str) -> Document:
    """Returns a home's row of the table of houses, by its columns; what it does not say is null."""
    asked = home.request.program
    errors = sum(issue.severity == "error" for issue in home.issues)
    row: Document = {
        "seed": home.request.seed,
        "id": f"house_{home.request.seed}",
        "split": split,
        "status": REFUSED if home.scene is None else WITH_ERRORS if errors else CLEAN,
        "program": asked if asked is None or isinstance(asked, str) else dump_plain(dict(asked), JSON).decode().strip(),
        "request": request_text(home.request),
        "catalog": home.catalog,
        "catalog_fingerprint": plan.fingerprints[home.catalog],
        "version": VERSION,
        "errors": errors,
        "warnings": len(home.issues) - errors,
        "missing": sum(issue.rule == _MISSING for issue in home.issues),
        "issues": [f"{issue.severity} {issue.rule} {issue.room or ''}: {issue.message}" for issue in home.issues],
        "refused": home.refused,
        "digest": home.digest or None,
    }
    return row if home.scene is None else {**row, **_figures(home.scene), "scene": home.text.decode() if JSON in plan.formats else None}


def _figures(scene: Scene) -> Document:
    certificate: Mapping[str, Any] = scene.certificate or {}
    counts, reports = counted(scene.rooms, scene.dynamic), list(certificate["rooms"].values())
    size = scene.size
    return {
        "style": (scene.request or {}).get("style"),
        "width": size.width if size else None,
        "depth": size.depth if size else None,
        "area": round(sum(room.floor_m2 for room in scene.rooms if not room.outdoor), 4),
        **{name: counts[name] for name in ("rooms", "doors", "windows", "furniture", "decorations")},
        "people": counts["dynamic"],
        "proven": sum(bool(report["proven"]) for report in reports),
        "best": sum(bool(report["best"]) for report in reports),
        "left_out": sum(len(report["left_out"]) for report in reports),
        "unjoined": [" ".join(pair) for pair in certificate["unjoined"]],
        "notes": list(certificate["notes"]),
    }


def members_of(plan: DatasetPlan, home: MadeHome) -> Iterator[tuple[tarfile.TarInfo, io.BytesIO]]:
    """Yields a home's files as an archive takes them, `<seed>.<format>` as webdataset groups them; several of one format as one ZIP.

    Files of one format refer to each other by their names, which webdataset could not tell from keys.
    """
    if home.scene is None:
        return
    if JSON in plan.formats:
        yield _member(f"{home.request.seed}.{JSON}", home.text)
    catalogs = unpacked(plan.catalogs[home.catalog])
    written = export_each(home.scene, plan.exported, catalogs, home.issues, "light")
    for format, files in written.items():
        name, _, content = packed(files, format, "")
        suffix = PurePosixPath(name).suffix
        yield _member(f"{home.request.seed}.{format if suffix == f'.{format}' else f'{format}{suffix}'}", content)


def _member(name: str, content: bytes) -> tuple[tarfile.TarInfo, io.BytesIO]:
    """Returns a file for an archive whose bytes must not depend on the day or on who writes it."""
    info = tarfile.TarInfo(name)
    info.size = len(content)
    return info, io.BytesIO(content)
