"""Engines of a scan: local processes, or Dask. Both use `Isolated`."""

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

#: Models of a Dask task: some tenths of a second. A killed scan repeats them.
BATCH = 50
#: Waiting and running tasks per processor: enough to keep it busy, few enough for memory.
_MAX_TASKS = 3


def local(models: Iterable[Model], settings: Settings, jobs: int) -> Iterator[ModelRow]:
    """The rows of models in the order of completion, from processes of this machine.

    Args:
        jobs: number of processes.

    Raises:
        UrdfkitError: a process cannot start or rejects the options.
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
            if len(waiting) >= _MAX_TASKS * jobs:
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                yield from (task.result() for task in done)
        while waiting:
            done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            yield from (task.result() for task in done)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in processes:
            process.end()  # for which the threads wait
        pool.shutdown()
        for process in processes:
            process.end()  # a thread may have started it again in between


def dask(
    models: Iterable[Model], settings: Settings, jobs: int, address: str = ""
) -> Iterator[ModelRow]:
    """The rows of models in the order of completion, from Dask workers.

    Dask replaces a worker that dies, and gives its tasks to others.

    Args:
        models: on a disk with the same path for all workers.
        jobs: number of workers of a cluster on this machine.
        address: of a scheduler; empty for a new cluster on this machine.

    Raises:
        MissingLibrary: Dask is not installed.
        UrdfkitError: no scheduler answers, or a process cannot start or rejects the options.
    """
    with _dask_client(jobs, address) as client:
        from distributed import as_completed
        from distributed.scheduler import KilledWorker

        source = iter(models)
        batches = iter(lambda: list(islice(source, BATCH)), [])
        batches_by_task: dict[object, list[Model]] = {}

        def submit(count: int) -> Iterator[object]:
            for batch in islice(batches, count):
                task = client.submit(check_batch, batch, settings, pure=False)
                batches_by_task[task.key] = batch
                yield task

        tasks = as_completed(list(submit(_MAX_TASKS * max(1, sum(client.nthreads().values())))))
        for task in tasks:
            batch = batches_by_task.pop(task.key)
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
    local_cluster = {"n_workers": jobs, "threads_per_worker": 1, "dashboard_address": None}
    try:
        return Client(address) if address else Client(**local_cluster)
    except (OSError, ValueError) as error:
        raise UrdfkitError(f"no Dask scheduler at '{address}': {error}") from error


_thread_data = threading.local()


def check_batch(models: list[Model], settings: Settings) -> list[ModelRow]:
    """The rows of models; a thread of a Dask worker reuses its process."""
    kept: tuple[Settings, Isolated] | None = getattr(_thread_data, "kept", None)
    if kept is None or kept[0] != settings:
        if kept is not None:
            kept[1].end()
        kept = _thread_data.kept = (settings, Isolated(settings))
    return [kept[1].check(model) for model in models]
