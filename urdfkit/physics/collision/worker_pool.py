"""Worker processes for sampling, with recovery from crashes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from queue import SimpleQueue
from types import TracebackType
from typing import Any

from urdfkit.core.child_process import ChildProcess, ProcessDied
from urdfkit.errors import UrdfkitError
from urdfkit.physics.collision.batch_kinematics import TreeArrays
from urdfkit.physics.collision.geometry_arrays import CollisionArrays, OmittedCollision
from urdfkit.physics.collision.task import PairFindings, Task

#: Module that a worker process runs.
_MAIN = "urdfkit.physics.collision.worker"

#: Most crashes for one robot.
_MAX_CRASHES = 20


class CollisionError(UrdfkitError):
    """The collisions of a robot cannot be measured."""


class WorkerPool:
    """Worker processes with the bodies of one robot; a context manager.

    Raises:
        CollisionError: a process cannot be started.
    """

    def __init__(
        self, kinematics: TreeArrays, bodies: Sequence[CollisionArrays], count: int
    ) -> None:
        self.bodies = list(bodies)  # bodies that do not crash coal
        self.omitted: list[OmittedCollision] = []  # bodies that crash coal
        self._kinematics = kinematics
        self._crashes = 0
        self._is_over = False
        self._idle: SimpleQueue[_Worker] = SimpleQueue()
        self._all: list[_Worker] = []
        self._count = count

    def __enter__(self) -> WorkerPool:  # noqa: PYI034 - Self is not in Python 3.10
        try:
            self._start()
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._end()

    def run(
        self, tasks: Iterable[Task], done: Callable[[], None]
    ) -> list[list[PairFindings | None]]:
        """The results of tasks, in order; None for a pair that crashes coal.

        Raises:
            CollisionError: too many crashes.
        """
        with ThreadPoolExecutor(self._count) as pool:
            futures = [pool.submit(self._run_task, task) for task in tasks]
            try:
                results = []
                for future in futures:
                    results.append(future.result())
                    done()
                return results
            except BaseException:
                for future in futures:
                    future.cancel()
                self._end()  # the threads wait for these processes
                raise

    def _start(self) -> None:
        """Start all processes; a body that crashes the first one is omitted in all."""
        while True:
            workers = [self._worker() for _ in range(self._count)]
            fatal = workers[0].wait()
            if fatal is None:
                break
            self._kill()
            self._note_crash()
            body = self.bodies.pop(fatal)
            self.omitted.append(OmittedCollision(body.link, body.number, "it crashes coal"))
        for worker in workers:
            self._idle.put(worker)

    def _worker(self) -> _Worker:
        if self._is_over:
            raise CollisionError("the sampling was stopped")
        worker = _Worker(self._kinematics, self.bodies)
        self._all.append(worker)
        return worker

    def _end(self) -> None:
        self._is_over = True
        self._kill()

    def _kill(self) -> None:
        for worker in self._all:
            worker.end()
        self._all.clear()

    def _note_crash(self) -> None:
        self._crashes += 1
        if self._crashes > _MAX_CRASHES:
            raise CollisionError(f"coal crashed {self._crashes} times on this robot")

    def _run_task(self, task: Task) -> list[PairFindings | None]:
        try:
            return self._run_in_worker(task)
        except ProcessDied:
            self._note_crash()
        parts = task.parts()
        if len(parts) == 1:
            return [None]
        return [result for part in parts for result in self._run_task(part)]

    def _run_in_worker(self, task: Task) -> list[PairFindings | None]:
        worker = self._idle.get()
        try:
            result: list[PairFindings | None] = worker.run(task)
        except ProcessDied:
            worker.end()
            worker = self._worker()
            raise
        finally:
            self._idle.put(worker)
        return result


class _Worker(ChildProcess):
    """One worker process."""

    def __init__(self, kinematics: TreeArrays, bodies: Sequence[CollisionArrays]) -> None:
        try:
            super().__init__(_MAIN)
        except OSError as error:
            raise CollisionError(f"cannot start a process: {error.strerror}") from error
        self._total = self._expected = len(bodies)
        try:
            self.send((kinematics, list(bodies)))
        except ProcessDied:
            pass  # `wait` reports it

    def wait(self) -> int | None:
        """Wait until all bodies are built; returns the number of a body that crashes it."""
        while self._expected:
            try:
                self.receive()
            except ProcessDied:
                return self._total - self._expected
            self._expected -= 1
        return None

    def run(self, task: Task) -> Any:
        """Send a task and return its result.

        Raises:
            ProcessDied: the process crashed.
        """
        if self.wait() is not None:
            raise ProcessDied
        self.send(task)
        return self.receive()
