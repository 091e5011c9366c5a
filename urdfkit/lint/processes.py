"""Checks in several processes, which a robot may crash."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import count
from typing import TYPE_CHECKING

from urdfkit.core import disk, expansion_limits
from urdfkit.core.file_log import FileLog
from urdfkit.core.own_sources import log_sources
from urdfkit.lint import rule_index
from urdfkit.lint.check_job import check_one_of_many, failed
from urdfkit.lint.merging import Checked
from urdfkit.lint.options import Options
from urdfkit.lint.plan import Job
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from collections import deque
    from concurrent.futures import Future, ProcessPoolExecutor
    from typing import TypeAlias


#: Initial data of a process: rules of other packages, options, True to log dependencies, and the
#: files that the user named.
Known: TypeAlias = "tuple[Mapping[str, str], Options, bool, tuple[str, ...]]"
#: The results of some robots, and the log of their dependencies.
Batch: TypeAlias = "tuple[list[list[Checked]], FileLog | None]"
#: Most robots that are sent to a process at a time.
MAX_BATCH = 16
#: Numbers of checks: the batches of one share the caches of a process.
_checks = count(1)


class Workers:
    """Processes for repeated checks, which keep their caches of packages and meshes."""

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None
        self._begun: object = None  # their initial data

    def pool(self, count: int, known: Known) -> ProcessPoolExecutor:
        """The processes; reused from an earlier check with the same data."""
        external, options, is_noting, admitted = known
        begun = (external, options.packages, options.config, options.trust, is_noting, admitted)
        if self._pool is None or self._begun != begun:
            self.end()
            for code in options.select:
                rule_index.get(code)  # imported once, as forked processes share the modules
            self._pool, self._begun = _pool(count, known), begun
        return self._pool

    def end(self) -> None:
        """End the processes at once, with what they are doing; later checks start new ones."""
        if self._pool is not None:
            processes = list((self._pool._processes or {}).values())
            self._pool.shutdown(wait=False, cancel_futures=True)
            for process in processes:  # terminate_workers() of Python 3.14
                process.terminate()
            self._pool = None


def in_processes(
    jobs: list[Job], known: Known, processes: int, workers: Workers
) -> Iterator[list[Checked]]:
    """The results of jobs in their order, computed by several processes.

    If a process dies, its pool ends. Its unfinished jobs are then checked one by one, to find the
    robot that crashes the process.
    """
    from collections import deque
    from concurrent.futures.process import BrokenProcessPool

    size = max(1, min(MAX_BATCH, len(jobs) // (8 * processes)))
    batches = deque(jobs[start : start + size] for start in range(0, len(jobs), size))
    waiting: deque[tuple[list[Job], Future[Batch]]] = deque()
    pool, options, check = workers.pool(processes, known), known[1], next(_checks)

    def submit(batch: list[Job]) -> Future[Batch]:
        return pool.submit(_check_batch, batch, options, check)

    try:
        yield from _in_order(submit, batches, waiting, 4 * processes)
    except BrokenProcessPool:
        workers.end()
    if waiting:
        yield from _one_by_one([job for batch, _ in waiting for job in batch], known)
    if batches:
        rest = [job for batch in batches for job in batch]
        yield from in_processes(rest, known, processes, workers)


def _in_order(
    submit: Callable[[list[Job]], Future[Batch]],
    batches: deque[list[Job]],
    waiting: deque[tuple[list[Job], Future[Batch]]],
    most: int,
) -> Iterator[list[Checked]]:
    """The results of batches; unfinished ones stay in ``batches`` and ``waiting``.

    Args:
        most: largest number of waiting batches, which limits the memory of results.
    """
    while batches or waiting:
        while batches and len(waiting) < most:
            waiting.append((batches[0], submit(batches[0])))
            batches.popleft()
        done = waiting[0][1].result()
        waiting.popleft()
        yield from _noted(done)


def _one_by_one(jobs: list[Job], known: Known) -> Iterator[list[Checked]]:
    """The results of jobs that may crash their process."""
    from concurrent.futures.process import BrokenProcessPool

    workers, check = Workers(), next(_checks)
    try:
        for job in jobs:
            try:
                pool = workers.pool(1, known)
                checked = pool.submit(_check_batch, [job], known[1], check).result()
            except BrokenProcessPool:
                workers.end()
                yield [(job, failed(job, RuntimeError("the process of its check died")))]
            else:
                yield from _noted(checked)
    finally:
        workers.end()


def _pool(count: int, known: Known) -> ProcessPoolExecutor:
    from concurrent.futures import ProcessPoolExecutor

    return ProcessPoolExecutor(count, initializer=_begin, initargs=known)


#: Resolver of a process of a pool, with its caches of packages and directories.
_own: Resolver
#: Number of the current check, and its resolver, with its caches of launch files.
_current: tuple[int, Resolver] | None = None


def _begin(
    external: Mapping[str, str], options: Options, is_noting: bool, admitted: tuple[str, ...]
) -> None:
    """Initialise a process of a pool."""
    import signal
    from threading import Thread

    Thread(target=_end_with_parent, daemon=True).start()
    # Ctrl-C reaches every process of the terminal; the main process handles it, and ends this one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # a main process with limits handles it, too
    rule_index.register(external)
    disk.log_to(FileLog() if is_noting else None)
    global _own  # noqa: PLW0603 - a process has one
    _own = Resolver(options.packages, texts=options.texts)
    expansion_limits.allow(options.config.limits)
    for path in admitted:
        _own.admit(path, trust=options.trust)


def _end_with_parent() -> None:
    """End this process when the main one is gone, which SIGKILL does not let it announce."""
    import os
    from multiprocessing import parent_process

    parent = parent_process()
    assert parent is not None
    parent.join()
    os._exit(1)


def _check_batch(jobs: list[Job], options: Options, check: int) -> Batch:
    global _current  # noqa: PLW0603 - a process has one
    if _current is None or _current[0] != check:
        _current = check, _own.with_texts(options.texts)
    resolver = _current[1]
    checked = [check_one_of_many(job, options, resolver) for job in jobs]
    log = disk.log()
    if log is not None:
        log_sources()
        disk.log_to(FileLog())
    return checked, log


def _noted(batch: Batch) -> list[list[Checked]]:
    """The results of a batch; adds their dependencies to the log of this process."""
    checked, log = batch
    own = disk.log()
    if own is not None and log is not None:
        own.add(log)
    return checked
