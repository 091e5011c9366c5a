"""Running a harness on damaged inputs, in processes that may die."""

import gc
import hashlib
import mmap
import os
import resource
import signal
import sys
import tempfile
import traceback
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from types import FrameType
from typing import NamedTuple

from fuzz.harnesses import HARNESSES, Harness
from fuzz.mutations import MAX_SIZE, mutate
from fuzz.seeds import ROOT
from urdfkit.errors import NotEnoughMemory, UrdfkitError

#: Of the processor, that one input may take.
SECONDS = 5.0
#: Bytes of address space that a process may take beyond what it has when it begins.
MEMORY = 512 * 1024**2
#: Inputs of one process, so that what it keeps does not add up.
_BATCH = 5000


class Hang(BaseException):
    """An input took longer than SECONDS; nothing that catches errors catches it."""


class Defect(NamedTuple):
    """What an input brought to light.

    Attributes:
        title: the error and where it was raised; the same for inputs that fail alike.
        details: the traceback.
        data: the input.
    """

    title: str
    details: str
    data: bytes


def execute(harness: Harness, data: bytes) -> Defect | None:
    """Give one input to a harness."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        harness.run(data)
    except (Exception, Hang) as error:
        if isinstance(error, UrdfkitError) and not isinstance(error, NotEnoughMemory):
            return None
        places = [
            frame
            for frame in traceback.extract_tb(error.__traceback__)
            if f"{os.sep}urdfkit{os.sep}" in frame.filename
        ]
        file, line = (places[-1].filename, places[-1].lineno) if places else ("", 0)
        where = f"{os.path.relpath(file, ROOT)}:{line}" if file else "outside of urdfkit"
        # Of a rule that failed, its own traceback has been quoted.
        text = str(error) if type(error).__name__ == "CrashedRule" else traceback.format_exc()
        title = text.strip().splitlines()[0] if "CrashedRule" in type(error).__name__ else ""
        return Defect(f"{title or type(error).__name__} at {where}", text, data)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    return None


def fuzz(name: str, count: int, seed: int = 0) -> Iterator[Defect]:
    """The defects that so many damaged inputs bring to light, each kind once.

    Args:
        name: of a harness.
        count: of inputs.
        seed: another one gives other inputs.
    """
    harness = HARNESSES[name]
    with _scratch():
        seeds = [one[:MAX_SIZE] for one in harness.seeds()]
        seen: set[str] = set()
        done = 0
        while done < count:
            last = min(count, done + _BATCH)
            batch = _Batch(name, harness, seeds, range(done, last), seed)
            for defect in batch.run():
                if defect.title not in seen:
                    seen.add(defect.title)
                    yield defect
            done = batch.done


def damaged(name: str, seeds: list[bytes], seed: int, number: int) -> bytes:
    """The input with a number."""
    random = Random(f"{name} {seed} {number}")
    return mutate(random.choice(seeds), seeds, random)


class _Batch:
    """Some inputs in a process of their own.

    Attributes:
        done: the number of the first input that is not done.
    """

    def __init__(
        self, name: str, harness: Harness, seeds: list[bytes], numbers: range, seed: int
    ) -> None:
        self._name = name
        self._harness = harness
        self._seeds = seeds
        self._numbers = numbers
        self._seed = seed
        self.done = numbers.start

    def run(self) -> Iterator[Defect]:
        """Run them; a defect that ends the process is the last."""
        at = mmap.mmap(-1, 8)  # shared with the process
        with tempfile.TemporaryDirectory() as found:
            process = os.fork()
            if process == 0:
                self._run_here(at, found)
            _, status = os.waitpid(process, 0)
            for file in sorted(Path(found).iterdir()):
                title, details, input_number = file.read_text(encoding="utf-8").split("\0")
                yield Defect(title, details, self._input(int(input_number)))
        self.done = self._numbers.stop
        if status:
            number = int.from_bytes(at[:], "little")
            self.done = number + 1
            how = os.waitstatus_to_exitcode(status)
            yield Defect(f"the process ended with {how}", "", self._input(number))

    def _input(self, number: int) -> bytes:
        return damaged(self._name, self._seeds, self._seed, number)

    def _run_here(self, at: mmap.mmap, found: str) -> None:
        """The life of the process: it never returns."""
        try:
            _limit()
            for number in self._numbers:
                at[:] = number.to_bytes(8, "little")
                defect = execute(self._harness, self._input(number))
                if defect is not None:
                    text = "\0".join((defect.title, defect.details, str(number)))
                    name = hashlib.sha256(defect.title.encode()).hexdigest()
                    Path(found, name).write_text(text, encoding="utf-8", errors="replace")
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            os._exit(1)


def _limit() -> None:
    """Bound this process, and let it be told of a hang."""

    def hang(_: int, __: FrameType | None) -> None:
        raise Hang(f"more than {SECONDS:g} s")

    signal.signal(signal.SIGPROF, hang)
    warnings.simplefilter("error")  # a warning of numpy would reach the user
    gc.collect()
    gc.freeze()
    if sys.platform == "linux":
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        most = pages * resource.getpagesize() + MEMORY
        resource.setrlimit(resource.RLIMIT_AS, (most, most))


@contextmanager
def _scratch() -> Iterator[None]:
    """A current directory of its own, in no package."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)
