"""What runs a scan: processes of this machine, or Dask. Both ask the same `Isolated`."""

import threading
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice
from queue import SimpleQueue
from typing import Any

from urdfkit.core.installation import needing
from urdfkit.errors import UrdfkitError
from urdfkit.scan.isolated import Isolated, Settings
from urdfkit.scan.models import Model
from urdfkit.scan.rows import ModelRow

#: Models of one task of Dask: some tenths of a second. A scan that is killed repeats them.
BATCH = 50
#: Tasks for each processor that wait or run, so that none is idle and no list grows.
_AHEAD = 3


def local(models: Iterable[Model], settings: Settings, jobs: int) -> Iterator[ModelRow]:
    """The rows of models, as they are done by processes of this machine.

    Args:
        jobs: how many processes.

    Raises:
        UrdfkitError: a process cannot start, or does not understand the options.
    """
    processes = [Isolated(settings) for _ in range(jobs)]
    idle: SimpleQueue[Isolated] = SimpleQueue()
    for process in processes:
        idle.put(process)

    def check(model: Model) -> ModelRow:
        process = idle.get()
        try:
            return process.check(model)
        finally:
            idle.put(process)

    pool = ThreadPoolExecutor(jobs)
    waiting: set[Future[ModelRow]] = set()
    try:
        for model in models:
            waiting.add(pool.submit(check, model))
            if len(waiting) >= _AHEAD * jobs:
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                yield from (one.result() for one in done)
        while waiting:
            done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            yield from (one.result() for one in done)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in processes:
            process.end()  # the threads wait for these
        pool.shutdown()
        for process in processes:
            process.end()  # one may have begun in between


def dask(
    models: Iterable[Model], settings: Settings, jobs: int, address: str = ""
) -> Iterator[ModelRow]:
    """The rows of models, as they are done by the workers of Dask.

    A worker that dies is replaced by Dask, which gives its tasks to others.

    Args:
        models: on a disk that all workers see under the same path.
        jobs: how many workers a cluster on this machine has.
        address: of a scheduler; that of a new cluster on this machine if empty.

    Raises:
        MissingLibrary: Dask is not installed.
        UrdfkitError: no scheduler answers; a process cannot start, or does not understand the
            options.
    """
    with _dask_client(jobs, address) as client:
        from distributed import as_completed
        from distributed.scheduler import KilledWorker

        source = iter(models)
        batches = iter(lambda: list(islice(source, BATCH)), [])
        given: dict[object, list[Model]] = {}

        def submit(count: int) -> Iterator[object]:
            for batch in islice(batches, count):
                task = client.submit(check_batch, batch, settings, pure=False)
                given[task.key] = batch
                yield task

        tasks = as_completed(list(submit(_AHEAD * max(1, sum(client.nthreads().values())))))
        for task in tasks:
            batch = given.pop(task.key)
            try:
                rows = task.result()
            except KilledWorker:
                rows = [ModelRow(model.name, "died", "its Dask worker died") for model in batch]
            for more in submit(1):
                tasks.add(more)
            yield from rows


def _dask_client(jobs: int, address: str) -> Any:
    with needing("--engine dask", "scan"):
        from distributed import Client
    here = {"n_workers": jobs, "threads_per_worker": 1, "dashboard_address": None}
    try:
        return Client(address) if address else Client(**here)
    except (OSError, ValueError) as error:
        raise UrdfkitError(f"no Dask scheduler at '{address}': {error}") from error


_of_thread = threading.local()


def check_batch(models: list[Model], settings: Settings) -> list[ModelRow]:
    """The rows of some models; a thread of a Dask worker keeps its process for the next ones."""
    kept: tuple[Settings, Isolated] | None = getattr(_of_thread, "kept", None)
    if kept is None or kept[0] != settings:
        if kept is not None:
            kept[1].end()
        kept = _of_thread.kept = (settings, Isolated(settings))
    return [kept[1].check(model) for model in models]
