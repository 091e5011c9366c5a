"""A process that checks models, and that a crash, a hang or memory use of a model may kill.

Among the standard pools, `concurrent.futures` has no time limit for a task, and loses all its
processes with one of them; pebble has both, but its licence is the LGPL; billiard cannot start
from a Dask process, which is daemonic. This pool is a process and two pipes.
"""

from __future__ import annotations

import time
from typing import Any

from urdfkit.core.child_process import ChildProcess, Parent, ProcessDied
from urdfkit.core.limits import limit_memory
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.options import Options
from urdfkit.scan.models import Model
from urdfkit.scan.rows import ModelRow, check_model
from urdfkit.workspace.resolve import Resolver

#: Models after which the process is replaced, so that leaks do not add up.
_MODELS_PER_PROCESS = 2000


class Settings(Record):
    """Settings of the checks of a scan."""

    options: Options  # of the check
    seconds: float = 60.0  # time limit of a model
    #: Limit of the address space of a process, in bytes; not available on Windows.
    memory: int = 4 * 2**30


class Isolated:
    """Checks models in a separate process, until `end`."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._process: ChildProcess | None = None
        self._left = 0

    def check(self, model: Model) -> ModelRow:
        """The row of a model, even if the process dies.

        Raises:
            UrdfkitError: the process cannot start or rejects the options.
        """
        if self._left == 0:
            self._start()
        start = time.perf_counter()
        try:
            row: ModelRow = self._ask(model)
        except ProcessDied:
            return self._death(model, time.perf_counter() - start)
        self._left = 0 if row.status == "memory" else self._left - 1
        return row

    def end(self) -> None:
        self._left = 0
        if self._process is not None:
            self._process.end()
            self._process = None

    def _start(self) -> None:
        self.end()
        self._process = ChildProcess("urdfkit.scan.isolated")
        try:
            problem = self._ask(self._settings)
        except ProcessDied as error:
            raise UrdfkitError("no process can be started within the limit of memory") from error
        if problem:
            raise problem
        self._left = _MODELS_PER_PROCESS

    def _ask(self, value: object) -> Any:
        assert self._process is not None
        self._process.send(value)
        return self._process.receive()

    def _death(self, model: Model, seconds: float) -> ModelRow:
        # Another thread may have called `end`.
        code = self._process.exit_code() if self._process else 0
        self.end()
        limit = self._settings.seconds
        if seconds >= limit:
            row = ModelRow(model.name, "timeout", f"not finished after {limit:g} s")
        else:
            how = f"by signal {-code}" if code < 0 else f"with exit code {code}"
            row = ModelRow(model.name, "died", f"its process ended {how}")
        return row._replace(seconds=round(seconds, 4))


def main() -> None:
    """Check the models from standard input until it ends, which it does when the parent dies."""
    import faulthandler
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent handles Ctrl-C
    parent = Parent()
    received = parent.received()
    settings: Settings = next(received)
    limit_memory(settings.memory)
    try:
        options = settings.options.resolved()
    except UrdfkitError as error:
        parent.send(error)
        return
    parent.send(None)
    resolver = Resolver(options.packages)
    for model in received:
        # A native thread: loops in native code do not block it.
        faulthandler.dump_traceback_later(settings.seconds, exit=True)
        row = check_model(model, options, resolver)
        faulthandler.cancel_dump_traceback_later()
        parent.send(row)
