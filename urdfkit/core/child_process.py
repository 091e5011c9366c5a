"""A child process that exchanges pickled values with its parent over the standard streams."""

import os
import pickle
import subprocess
import sys
from collections.abc import Iterator
from typing import Any

#: ``sys.path`` is passed on, so that nothing is imported from the working directory.
_BOOT = "import sys; sys.path[:] = sys.argv[2:]; __import__(sys.argv[1], fromlist=['main']).main()"
#: Child processes share the processors, so that none of them may start threads.
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


class ProcessDied(Exception):
    """The child process ended without an answer."""


class ChildProcess:
    """Runs the function ``main`` of a module in a child process; ``main`` creates a `Parent`.

    Raises:
        OSError: the process cannot be started.
    """

    def __init__(self, module: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-I", "-c", _BOOT, module, *sys.path],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={**os.environ, **dict.fromkeys(_THREADS, "1")},
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._stdin, self._stdout = self._process.stdin, self._process.stdout

    def send(self, value: object) -> None:
        try:
            pickle.dump(value, self._stdin)
            self._stdin.flush()
        except (OSError, ValueError) as error:
            raise ProcessDied from error

    def receive(self) -> Any:
        try:
            return pickle.load(self._stdout)
        except (EOFError, OSError, ValueError, pickle.UnpicklingError) as error:
            raise ProcessDied from error

    def exit_code(self) -> int:
        """Exit code of a process that has died; negative for a signal."""
        return self._process.wait()

    def end(self) -> None:
        """Kill the process."""
        self._process.kill()
        self._process.wait()
        for pipe in (self._stdin, self._stdout):
            try:
                pipe.close()
            except OSError:
                pass  # unsent data in the buffer


class Parent:
    """The parent of this process; whatever libraries print goes to standard error."""

    def __init__(self) -> None:
        self._answers = os.fdopen(os.dup(1), "wb")
        os.dup2(2, 1)

    def received(self) -> Iterator[Any]:
        """Values that the parent sends, until it closes the pipe."""
        while True:
            try:
                value = pickle.load(sys.stdin.buffer)
            except EOFError:
                return
            yield value

    def send(self, value: object) -> None:
        pickle.dump(value, self._answers)
        self._answers.flush()
