"""Kill commands that write, at random instants, and look for anything torn, lost or left over.

    python benchmarks/kills.py [NUMBER] [--seed N]

Each command works in a directory of its own and is killed (SIGKILL) at some instant of the time
that it takes. After every kill, each file must be whole: as before or as after. Then the command
runs to its end: the files must be those of a run that nobody killed, and no others may be there.
"""

import argparse
import os
import random
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

MODELS = Path(__file__).parent.parent / "models"
PROGRAM = [sys.executable, "-m", "urdfkit"]

Files = dict[str, bytes]


class Case(NamedTuple):
    """A command that writes.

    Attributes:
        words: of its command line, in a directory with ``inputs``.
        inputs: files and directories of ``models/``.
        is_state: True for a file that is whole whatever it holds, and holds other things each time.
        first: a command line that has ended before.
        together: a directory whose files change together or not at all.
    """

    words: str
    inputs: tuple[str, ...]
    is_state: Callable[[str], bool] = lambda name: False
    first: str = ""
    together: str = ""


BAD = ("gazebo_pkg",)
ARM = "good/two_link_arm/urdf/two_link_arm.urdf"
MESH = "good/two_link_arm/meshes/forearm.stl"
CASES = {
    "fix": Case("fix gazebo_pkg --unsafe-fixes --no-cache", BAD),
    "format": Case("format gazebo_pkg --width 60", BAD),
    "check --fix": Case("check gazebo_pkg --fix --exit-zero", BAD),
    "report": Case("report good/gripper.urdf --quick -o report.html", ("good",)),
    "mesh": Case("mesh hull good/a.stl -o hull.obj", ("good",)),
    "mesh convert": Case(f"mesh convert {MESH} -o made/a.obj", ("good",)),
    "mesh collision": Case(f"mesh collision {ARM} --write", ("good",)),
    "bundle": Case(f"bundle {ARM} -o made", ("good",), together="made"),
    "bundle --force": Case(
        f"bundle {ARM} -o made --for ros --force",
        ("good",),
        first=f"bundle {ARM} -o made",
        together="made",
    ),
    "bundle zip": Case(
        f"bundle {ARM} -o made.zip --for ros --force", ("good",), first=f"bundle {ARM} -o made.zip"
    ),
    "convert": Case(f"convert {ARM} --to mjcf -o made", ("good",), together="made"),
    "convert --force": Case(
        f"convert {ARM} --to urdf -o made --force",
        ("good",),
        first=f"convert {ARM} --to mjcf -o made",
        together="made",
    ),
    "baseline": Case("check gazebo_pkg --baseline known.json --write-baseline", BAD),
    "cache": Case("check gazebo_pkg --exit-zero", BAD, lambda name: name.startswith("cache/")),
    "scan": Case("scan good -o out", ("good",), lambda name: name.startswith("out/")),
    "scan of an archive": Case(
        "scan good.tar -o out", ("good",), lambda name: name.startswith("out/")
    ),
}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("number", nargs="?", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    killed, faults = run(given.number, given.seed)
    for fault in faults:
        print(fault)
    print(f"{sum(killed.values())} kills {killed}, {len(faults)} faults")
    return bool(faults)


def run(number: int, seed: int, cases: dict[str, Case] = CASES) -> tuple[dict[str, int], list[str]]:
    """Kill commands in turn, so often in all; how often each was killed, and what was wrong."""
    random.seed(seed)
    killed = dict.fromkeys(cases, 0)
    faults: list[str] = []
    with tempfile.TemporaryDirectory(prefix="urdfkit-kills-") as scratch:
        known = {name: _whole(case, Path(scratch, "whole", name)) for name, case in cases.items()}
        while sum(killed.values()) < number and len(faults) < 10:
            for name, case in cases.items():
                before, after, seconds = known[name]
                directory = _prepared(case, Path(scratch, name))
                killed[name] += _kill(case, directory, random.uniform(0, seconds))
                found = _torn(case, before, after, _files(directory))
                _start(case.words, directory).wait()
                found += _differing(case, after, _files(directory))
                faults += [f"{name}: {one}" for one in found]
    return killed, faults


def _prepared(case: Case, directory: Path) -> Path:
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    for one in case.inputs:
        shutil.copytree(MODELS / one, directory / one)
    tetrahedron = "\n".join(
        f"facet normal 0 0 0\nouter loop\n{corners}\nendloop\nendfacet"
        for corners in (
            "vertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0",
            "vertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1",
            "vertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0",
            "vertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1",
        )
    )
    if (directory / "good").exists():
        (directory / "good" / "a.stl").write_text(f"solid a\n{tetrahedron}\nendsolid a\n")
        with tarfile.open(directory / "good.tar", "w") as archive:
            archive.add(MODELS / "good", "good")
    if case.first:
        _start(case.first, directory).wait()
    return directory


def _whole(case: Case, directory: Path) -> tuple[Files, Files, float]:
    """The files before and after a run that nobody kills, and its seconds."""
    before = _files(_prepared(case, directory))
    start = time.monotonic()
    _start(case.words, directory).wait()
    return before, _files(directory), time.monotonic() - start


def _start(words: str, directory: Path) -> subprocess.Popen[bytes]:
    # Temporary directories, too, lie where they are looked for.
    (directory / "tmp").mkdir(exist_ok=True)
    more = {"URDFKIT_CACHE_DIR": str(directory / "cache"), "TMPDIR": str(directory / "tmp")}
    quiet = subprocess.DEVNULL
    return subprocess.Popen(
        [*PROGRAM, *words.split()],
        cwd=directory,
        env={**os.environ, **more},
        stdin=quiet,
        stdout=quiet,
        stderr=quiet,
        start_new_session=True,
    )


def _kill(case: Case, directory: Path, seconds: float) -> int:
    """Kill a command and all that it has started; 0 if it was faster."""
    process = _start(case.words, directory)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.wait()
        return 1
    return 0


def _files(directory: Path) -> Files:
    return {
        path.relative_to(directory).as_posix(): path.read_bytes()
        for path in sorted(directory.rglob("*"))
        if path.is_file()
    }


def _part(files: Files, directory: str) -> Files:
    return {name: data for name, data in files.items() if name.startswith(f"{directory}/")}


def _is_temporary(name: str) -> bool:
    """True for what is written under other names first, and for what is put aside meanwhile."""
    return name.startswith("tmp/") or "/.urdfkit-" in f"/{name}"


def _torn(case: Case, before: Files, after: Files, now: Files) -> list[str]:
    """The files that are neither as before nor as after."""
    aside = {data for name, data in now.items() if _is_temporary(name)}
    kept = [name for name in before if name in after]
    faults = [f"{name} is lost" for name in kept if name not in now and before[name] not in aside]
    if case.together:
        found, *whole = (_part(files, case.together) for files in (now, before, after))
        faults += [f"{case.together} is half of it"] if found and found not in whole else []
    for name, data in now.items():
        if _is_temporary(name) or case.is_state(name):
            continue
        if data not in (before.get(name), after.get(name)):
            faults.append(f"{name} is torn ({len(data)} bytes)")
    return faults


def _differing(case: Case, after: Files, now: Files) -> list[str]:
    """What another run, to its end, has not repaired."""
    faults = [f"{name} is left over" for name in now if _is_temporary(name)]
    faults += [
        f"{name} differs after another run"
        for name in sorted({*after, *now})
        if not (case.is_state(name) or _is_temporary(name)) and after.get(name) != now.get(name)
    ]
    if "out/results.jsonl" in after:
        lines = [now.get("out/results.jsonl", b""), after["out/results.jsonl"]]
        if len({data.count(b"\n") for data in lines}) != 1:
            faults.append("the scan has other rows")
    return faults


if __name__ == "__main__":
    sys.exit(main())
