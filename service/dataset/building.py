"""A dataset made from end to end: claimed, its shards made by processes or by a cluster, counted and described."""

from collections.abc import Iterator, Sequence
from functools import partial
from time import process_time
from typing import NamedTuple

from service.dataset.card import write_card
from service.dataset.dataset_plan import OURS, DatasetPlan, Shard
from service.dataset.manifest import claim, is_done, records_of, sweep, widened, write_manifest
from service.dataset.shards import make_shard, record_path
from service.packed_catalogs import warm
from service.pool import spread
from service.progress import progress
from service.standard_streams import say
from solver.errors import ComposeError
from solver.plain import Document


class Built(NamedTuple):
    """A dataset's manifest; how many homes were made now, and the CPU seconds of their processes while they were at them."""

    manifest: Document
    homes: int
    cpu_s: float


def build(plan: DatasetPlan, seeds: tuple[int, int], workers: int, address: str | None = None) -> Built:
    """Makes what of a dataset, from its first to its last seed, is not there yet.

    By `workers` processes of this machine; with an `address` on a Ray cluster, `local` for one here with so many processors.

    Raises:
        FieldError: the folder holds something else, or cannot be written to.
        OSError: it cannot be made.
    """
    claim(plan)
    sweep(plan.folder)
    wanted = plan.shards(*seeds)
    todo = [widened(plan, shard) for shard in wanted if not is_done(plan, shard)]
    for shard in todo:
        record_path(plan.folder, shard).unlink(missing_ok=True)
    homes, left = (sum(len(shard.seeds) for shard in shards) for shards in (wanted, todo))
    if 0 < len(todo) < workers and any(len(shard.seeds) > 1 for shard in todo):
        say(f"there is work for {len(todo)} of {workers} processes: a smaller --shard-size spreads it")
    with progress(max(homes, left), "home", max(homes - left, 0)) as update:
        spent = 0.0
        for record, cpu_s in _made(plan, todo, workers, address):
            spent += cpu_s
            update(record["last"] - record["first"] + 1)
    sweep(plan.folder)  # a process that was killed leaves what it was writing
    manifest = write_manifest(plan.folder, plan.identity, records_of(plan.folder))
    write_card(plan.folder, manifest)
    return Built(manifest, left, spent)


def _made(plan: DatasetPlan, todo: Sequence[Shard], workers: int, address: str | None) -> Iterator[tuple[Document, float]]:
    make = partial(_shard, plan)
    if address is None:
        made = spread(make, todo, min(workers, len(todo)), partial(warm, plan.catalogs[OURS]))
    else:
        from service.dataset.on_ray import on_cluster  # noqa: PLC0415 - an extra

        made = on_cluster(make, todo, workers, address)
    for done in made:
        if isinstance(done, ComposeError):
            raise done
        yield done


def _shard(plan: DatasetPlan, shard: Shard) -> tuple[Document, float] | ComposeError:
    start = process_time()
    try:
        return make_shard(plan, shard), process_time() - start
    except ComposeError as error:
        return error
