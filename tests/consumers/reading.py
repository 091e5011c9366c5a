"""What a program makes of a robot.

Each robot has a process of its own, since programs end theirs now and then.
"""

import json
import multiprocessing
import os
import sys
import tempfile
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple, Protocol

#: Seconds for one program with one robot.
LIMIT = 600

#: Imported once, for all processes: they start no thread, which a fork would lose.
SHARED = ("mujoco", "pinocchio", "pybullet")

#: The programs; each has a file in ``oracles``.
PROGRAMS = ("mujoco", "pinocchio", "drake", "yourdfpy", "newton", "pybullet", "genesis")


class Reading(NamedTuple):
    """What a program makes of a robot.

    Attributes:
        mass: of all links, in kg.
        frames: of the links that it keeps, with all joints at 0: the position in m, and the
            rotation matrix row by row.
    """

    mass: float
    frames: dict[str, list[float]]


class Oracle(Protocol):
    """A file of ``oracles``.

    Attributes:
        PACKAGE: that is installed from PyPI.
        MODULE: that must be there.
        CAUSES: by a part of its error, as a pattern: the cause, and the rules that report it.
    """

    PACKAGE: str
    MODULE: str
    CAUSES: dict[str, tuple[str, str]]

    @staticmethod
    def read(path: str) -> Reading:
        """What it makes of a URDF; raises any error for one that it rejects."""


def oracle(name: str) -> Oracle:
    """The file of a program."""
    found: Oracle = import_module(f"tests.consumers.oracles.{name}")  # type: ignore[assignment]
    return found


def is_installed(name: str) -> bool:
    """True if a program can be asked."""
    return find_spec(oracle(name).MODULE.partition(".")[0]) is not None


def read(name: str, text: bytes, folder: Path) -> Reading | str:
    """What a program makes of a URDF in a directory; its error if it rejects it."""
    with tempfile.TemporaryDirectory() as scratch:
        urdf = Path(scratch, "robot.urdf")
        urdf.write_bytes(text)
        code = run(_read, name, urdf, folder)
        if code is None:
            return f"no end within {LIMIT} s"
        if code:
            said = urdf.with_suffix(".txt").read_text(encoding="utf-8", errors="replace")
            return said.strip() or f"exit code {code}"
        return Reading(**json.loads(urdf.with_suffix(".json").read_bytes()))


def run(function: Callable[..., None], *arguments: object) -> int | None:
    """Call a function in a process of its own; its exit code, or None if it does not end."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["__main__", *filter(find_spec, SHARED)])
    process = context.Process(target=function, args=arguments)
    process.start()
    process.join(LIMIT)
    if process.exitcode is None:
        process.kill()
    return process.exitcode


def _read(name: str, urdf: Path, folder: Path) -> None:
    """The process: the program's messages go to a file next to the URDF, and what it made."""
    os.chdir(folder)
    with urdf.with_suffix(".txt").open("wb") as file:
        for stream in (sys.stdout, sys.stderr):
            os.dup2(file.fileno(), stream.fileno())
    found = oracle(name).read(str(urdf))
    urdf.with_suffix(".json").write_text(json.dumps(found._asdict()), encoding="utf-8")
