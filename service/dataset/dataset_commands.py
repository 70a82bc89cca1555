"""What `compose dataset` does: makes a dataset, one of its homes again, or checks it."""

from argparse import Namespace
from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

from catalogs import Catalogs, load_catalogs
from service.command_files import read_file
from service.dataset.dataset_plan import OURS, DatasetPlan, again, check_names, made_home, packed_all, varied
from service.standard_streams import put, say
from solver.errors import FieldError
from solver.exchange import dump_scene, format_of_name, read_request
from solver.export_formats import EXPORTERS

CLEAN: Final = 0
ERRORS_FOUND: Final = 1


def run_dataset(options: Namespace, catalogs: Catalogs, request: Mapping[str, Any]) -> int:
    """Runs the task that the options name and returns the exit status: 1 where homes have errors or what is checked is not as it was.

    Raises:
        FieldError: an option is missing or wrong, or the folder holds something else.
        OSError: a file cannot be read or written.
    """
    _need("pyarrow", "dataset", "the tables of datasets")
    if options.task == "make":
        return _make_again(options, catalogs)
    if options.task == "check":
        return _check(options, catalogs)
    return _build(options, catalogs, request)


def _build(options: Namespace, catalogs: Catalogs, request: Mapping[str, Any]) -> int:
    from service.dataset.building import build

    for name in ("out", "seeds"):
        if getattr(options, name) is None:
            raise FieldError(f"--{name}", "is missing", {"out": "a folder", "seeds": "the first and the last, such as 0-999"}[name])
    if options.ray is not None:
        _need("ray", "ray", "--ray")
    for name in _formats(options, *EXPORTERS):
        needs = EXPORTERS[name].needs if name in EXPORTERS else None
        if needs:
            _need(*needs, f"the format {name}")
    built = build(plan_of(options, catalogs, request), options.seeds, options.workers, options.ray)
    manifest = built.manifest
    told = ", ".join(f"{number:,} {status}" for status, number in manifest["status"].items())
    spent = f"; {built.homes:,} made now, {1000 * built.cpu_s / built.homes:.1f} ms of CPU each" if built.homes else ""
    say(f"{manifest['homes']:,} homes in {options.out}: {told}; digest {manifest['digest'][:16]}{spent}")
    return CLEAN if set(manifest["status"]) <= {"clean"} else ERRORS_FOUND


def plan_of(options: Namespace, catalogs: Catalogs, request: Mapping[str, Any]) -> DatasetPlan:
    """Returns what the options ask for.

    Raises:
        FieldError: the request, or how requests differ, is wrong.
    """
    document: Any = None if options.vary is None else read_file(options.vary)
    read_request(request, "request")
    requests = varied({name: value for name, value in request.items() if name != "seed"}, document or {})
    known = {name: catalogs if name == OURS else load_catalogs(name) for name in requests.catalogs}
    check_names(requests, known.values())
    return DatasetPlan(
        folder=Path(options.out).absolute(),
        requests=requests,
        formats=_formats(options, *EXPORTERS),
        shard_size=options.shard_size,
        catalogs=packed_all(known),
        fingerprints={name: one.fingerprint for name, one in known.items()},
        vary=document,
    )


def _formats(options: Namespace, *others: str) -> tuple[str, ...]:
    """Returns the formats asked for, of json and others; refuses those of another task."""
    if foreign := [name for name in options.formats or () if name not in ("json", *others)]:
        raise FieldError("--format", f"is {foreign[0]!r}, which is of another task", ", ".join(("json", *others)))
    return tuple(options.formats or ("json",))


def _make_again(options: Namespace, catalogs: Catalogs) -> int:
    """Makes one home of a dataset again from its row, and refuses to give another one out for it."""
    from service.dataset.dataset_check import row_of

    if options.folder is None or options.seed is None:
        raise FieldError("--seed" if options.folder else "DIR", "is missing", "compose dataset make DIR --seed N")
    row = row_of(Path(options.folder), options.seed)
    home = made_home(*again(row, catalogs))
    if home.scene is None:
        raise FieldError("--seed", f"the home of seed {options.seed} was refused: {home.refused}", "that of another seed")
    if home.digest != row["digest"]:
        raise FieldError("--seed", f"the home of seed {options.seed} is not the one of the row", "the version and catalogs of the dataset")
    format = _formats(options, "yaml")[0] if options.formats else format_of_name(options.output) or "json"
    content = dump_scene(home.scene, format)
    put(content, options.output)
    return CLEAN if row["status"] == "clean" else ERRORS_FOUND


def _check(options: Namespace, catalogs: Catalogs) -> int:
    from service.dataset.dataset_check import check_dataset

    if options.folder is None:
        raise FieldError("DIR", "is missing", "compose dataset check DIR")
    found = check_dataset(Path(options.folder), catalogs, None if options.all else options.sample or 100)
    for fault in found.faults:
        say(f"wrong: {fault}")
    said = "nothing is wrong" if not found.faults else f"{len(found.faults)} things are wrong"
    say(f"{found.homes:,} homes, {found.files:,} files, {found.made:,} homes made again and validated: {said}")
    return ERRORS_FOUND if found.faults else CLEAN


def _need(module: str, extra: str, what: str) -> None:
    if find_spec(module) is None:
        raise FieldError(what, f"needs {module}, which is not installed", f"pip install 'compose-homes[{extra}]'")
