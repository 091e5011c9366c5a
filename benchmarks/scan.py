"""What `urdfkit check` and `scan` cost on many robots; all engines, and a killed run, agree.

Usage: python benchmarks/scan.py CORPUS SCRATCH [--count N] [--kills N] [--jobs N]

CORPUS is a directory of robots; SCRATCH gets N variants of the small ones, and the results. Runs on
Linux, in a Python that has urdfkit[scan].
"""

import argparse
import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import psutil

import urdfkit
from urdfkit.errors import UrdfkitError

#: Robots with more links are left out: a scan is about many, not about large ones.
LINKS = 20
#: Every so many variants one is a copy of the one before, or is broken in the middle.
COPIES, BROKEN = 50, 500
_URDFKIT = [sys.executable, "-c", "import sys; from urdfkit.cli import main; sys.exit(main())"]
#: Loads each robot without its meshes, and keeps none.
_PEER = """
import pathlib, sys, yourdfpy
for path in pathlib.Path(sys.argv[1]).rglob("*.urdf"):
    try:
        yourdfpy.URDF.load(path, load_meshes=False, build_scene_graph=False)
    except Exception:
        pass  # every 500th is broken
"""
_NUMBER = re.compile(r'(?<=<mass value=")[^"]*|(?<=\bxyz=")[^"]*')


class Run(NamedTuple):
    """What a run took: seconds of the clock and of processors, and the most memory in MB."""

    wall: float
    cpu: float
    parent: float
    worker: float


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("scratch", type=Path)
    parser.add_argument("--count", type=int, default=20_000)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    collection = asked.scratch / f"variants-{asked.count}"
    if not collection.is_dir():
        make(asked.corpus, collection, asked.count)
    alone = ("--no-cache", "--jobs", "1", "--exit-zero")
    checked = run([*_URDFKIT, "check", str(collection), *alone])
    print(f"check: {show(checked, asked.count)}", flush=True)
    loaded = run([sys.executable, "-c", _PEER, str(collection)])
    print(f"yourdfpy, which loads them: {show(loaded, asked.count)}", flush=True)
    time_ratio, memory_ratio = checked.cpu / loaded.cpu, checked.parent / loaded.parent
    print(f"check to yourdfpy: {time_ratio:.2f} x CPU time, {memory_ratio:.2f} x memory")
    results = {}
    for name, options in (
        ("1 process", ("--jobs", "1")),
        (f"{asked.jobs} processes", ("--jobs", str(asked.jobs))),
        (f"Dask, {asked.jobs} workers", ("--engine", "dask", "--jobs", str(asked.jobs))),
    ):
        out = asked.scratch / f"results-{name.replace(' ', '-').replace(',', '')}"
        print(f"{name}: {show(run(command(collection, out, *options)), asked.count)}", flush=True)
        results[name] = rows(out)
    out = asked.scratch / "results-killed"
    kills = kill_and_resume(collection, out, asked.kills, asked.jobs)
    results[f"killed {kills} times"] = rows(out)
    expected, *others = results.values()
    same = all(found == expected for found in others)
    complete = len(expected) == asked.count
    print(f"{', '.join(results)}: {'the same' if same and complete else 'DIFFERENT'} rows")
    return 0 if same and complete else 1


def make(corpus: Path, directory: Path, count: int) -> None:
    """Write variants of the small robots of a corpus; the same each time."""
    texts = list(_expanded(corpus))
    for number in range(count):
        chance = random.Random(number - (number % COPIES == COPIES - 1))
        text = texts[chance.randrange(len(texts))]
        text = _varied(text, chance)
        if number % BROKEN == BROKEN - 1:
            text = text[: len(text) // 2]
        place = directory / f"{number // 1000:03}" / f"{number:06}"
        place.mkdir(parents=True)
        (place / "robot.urdf").write_text(text, encoding="utf-8")


def _expanded(corpus: Path) -> Iterator[str]:
    for path in sorted(corpus.rglob("*")):
        if path.name.endswith((".urdf", ".urdf.xacro")):
            try:
                if 0 < len(urdfkit.load(path).links) <= LINKS:
                    yield urdfkit.read(path).text.decode()
            except UrdfkitError:
                pass


def _varied(text: str, chance: random.Random) -> str:
    """A robot with other masses and places."""

    def scaled(match: re.Match[str]) -> str:
        try:
            values = [float(word) * chance.uniform(0.5, 2) for word in match[0].split()]
        except ValueError:
            return match[0]
        return " ".join(f"{value:.6g}" for value in values)

    return _NUMBER.sub(scaled, text)


def command(collection: Path, out: Path, *options: str) -> list[str]:
    return [*_URDFKIT, "scan", str(collection), "-o", str(out), *options]


def run(words: list[str]) -> Run:
    """Run a command and look at its memory while it lasts."""
    start, parent, worker = time.perf_counter(), 0.0, 0.0
    null = subprocess.DEVNULL
    process = psutil.Popen(words, stdout=null, stderr=null)
    while (ended := os.wait4(process.pid, os.WNOHANG))[0] == 0:
        try:
            parent = max(parent, process.memory_info().rss / 1e6)
            for child in process.children(recursive=True):
                worker = max(worker, child.memory_info().rss / 1e6)
        except psutil.Error:
            pass  # it has just ended
        time.sleep(0.5)
    usage = ended[2]
    assert ended[1] == 0, words
    return Run(time.perf_counter() - start, usage.ru_utime + usage.ru_stime, parent, worker)


def show(taken: Run, count: int) -> str:
    return (
        f"{count / taken.wall:.1f} models/s, {1000 * taken.cpu / count:.1f} ms CPU each; "
        f"parent {taken.parent:.0f} MB, worker {taken.worker:.0f} MB at most"
    )


def kill_and_resume(collection: Path, out: Path, kills: int, jobs: int) -> int:
    """Kill a scan after random parts of its work, and let the next one go on; how often it was."""
    chance, done = random.Random(0), 0
    total = sum(1 for _ in collection.rglob("*.urdf"))
    for number in range(kills):
        upto = done + chance.uniform(0.5, 1.5) * (total - done) / (kills - number + 1)
        process = subprocess.Popen(command(collection, out, "--jobs", str(jobs)))
        while process.poll() is None and done < upto:
            time.sleep(0.05)
            done = _lines(out / "results.jsonl")
        if process.poll() is not None:
            return number
        process.send_signal(signal.SIGKILL)
        process.wait()
    subprocess.run(command(collection, out, "--jobs", str(jobs)), check=True)
    return kills


def _lines(path: Path) -> int:
    try:
        return path.read_bytes().count(b"\n")
    except FileNotFoundError:
        return 0


def rows(out: Path) -> list[str]:
    """The rows of a scan, sorted, without the times."""
    found = []
    for line in (out / "results.jsonl").read_text().splitlines():
        row = json.loads(line)
        del row["seconds"], row["cpu_seconds"]
        found.append(json.dumps(row, sort_keys=True))
    return sorted(found)


if __name__ == "__main__":
    sys.exit(main())
