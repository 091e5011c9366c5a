"""What `urdfkit check` costs next to stock xacro and other tools, without and with the extras.

Usage: python benchmarks/bench.py [--lean PYTHON] [--all PYTHON] [--rounds N] [--corpus-rounds N]
                                  [--shared DIRECTORY]

CPU time of whole processes, user and system, bytecode compiled. The contestants take turns, so that
a busy machine slows all of them alike; the least of all rounds is compared. The two installs are
made in `build/benchmarks` if none are named.
"""

import argparse
import compileall
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import venv
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[1]
MISSION = ROOT / "models" / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
PLAIN = ROOT / "models" / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf"
PEER = Path(__file__).with_name("peer.py")

STUB = """\
DIRECTORIES = {directories!r}

class PackageNotFoundError(KeyError):
    pass

def get_package_share_directory(name):
    try:
        return DIRECTORIES[name]
    except KeyError:
        raise PackageNotFoundError(name) from None
"""

NOTHING, XACRO, LEAN, ALL = "python -c pass", "xacro", "urdfkit", "urdfkit[all]"
#: Stock xacro where [all] is installed: packages of the extras slow each start of Python.
XACRO_ALL = "xacro, [all]"
#: The second check of the same files, whose result is kept.
AGAIN = "unchanged"
#: Other tools; one that reads no xacro pays for the stock command, too.
PEERS = ("check_urdf", "yourdfpy", "pinocchio")
#: The columns of the table.
COLUMNS = (NOTHING, LEAN, ALL, AGAIN, *PEERS)

#: The median of the corpus with all extras, of the time without, and the most of any, in s.
MEDIAN, MOST = 1.5, 1.0

Contest = dict[str, Callable[[], float]]


class Robot(NamedTuple):
    """A description, the xacro arguments it wants, and whether it needs no xacro at all."""

    title: str
    file: Path
    arguments: tuple[str, ...] = ()
    plain: bool = False


class Budget(NamedTuple):
    """A contestant costs at most ``bound`` times as much as another one."""

    robot: Robot
    contestant: str
    other: str
    bound: float


class Bench:
    """Runs the contestants.

    Attributes:
        lean: the Python that has urdfkit without extras.
        full: the Python that has urdfkit[all]; the other tools run in it.
        tools: those that it has.

    Args:
        lean, full: these.
        scratch: a directory for what the runs write.
        directories: of ROS packages by name, from which stock xacro resolves them in place of ROS.
    """

    def __init__(self, lean: Path, full: Path, scratch: Path, directories: dict[str, str]) -> None:
        self.lean, self.full = lean, full
        self._scratch = scratch
        stub = scratch / "stub" / "ament_index_python"
        stub.mkdir(parents=True)
        (stub / "__init__.py").touch()
        (stub / "packages.py").write_text(STUB.format(directories=directories), encoding="utf-8")
        self._environment = os.environ | {
            "PYTHONPATH": str(stub.parent),
            "URDFKIT_CACHE_DIR": str(scratch / "cache"),
        }
        self.tools = [tool for tool in ("yourdfpy", "pinocchio") if self._has(tool)]

    def _has(self, module: str) -> bool:
        find = f"import importlib.util, sys; sys.exit(not importlib.util.find_spec({module!r}))"
        command: list[str | Path] = [self.full, "-c", find]
        return subprocess.run(command, capture_output=True, check=False).returncode == 0

    def run(self, *command: str | Path, out: Path | None = None) -> float:
        """CPU seconds of a command."""
        with open(out or os.devnull, "wb") as file:
            process = subprocess.Popen(
                [str(word) for word in command],
                stdout=file,
                stderr=subprocess.DEVNULL,
                env=self._environment,
            )
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        return usage.ru_utime + usage.ru_stime

    def check(self, python: Path, robot: Robot) -> float:
        """The command that users type, on a robot that was not checked before."""
        shutil.rmtree(self._scratch / "cache" / "results", ignore_errors=True)
        return self.check_again(python, robot)

    def check_again(self, python: Path, robot: Robot) -> float:
        """The same command, whatever is kept of earlier ones."""
        return self.run(python.with_name("urdfkit"), "check", robot.file, *robot.arguments)

    def xacro(self, robot: Robot, python: Path) -> float:
        """The stock command, where it is needed; leaves what it wrote in ``expanded``."""
        if robot.plain:
            return 0.0
        command = python.with_name("xacro")
        return self.run(command, robot.file, *robot.arguments, out=self.expanded(robot))

    def expanded(self, robot: Robot) -> Path:
        """The plain URDF of a robot."""
        return robot.file if robot.plain else self._scratch / f"{robot.title}.urdf"

    def reader(self, robot: Robot, *command: str | Path) -> float:
        """Expand, then read with another tool."""
        return self.xacro(robot, self.lean) + self.run(*command, self.expanded(robot))

    def ours(self, robot: Robot) -> Contest:
        """urdfkit without the extras, twice, and with them."""
        return {
            LEAN: partial(self.check, self.lean, robot),
            AGAIN: partial(self.check_again, self.lean, robot),
            ALL: partial(self.check, self.full, robot),
        }

    def everybody(self, robot: Robot) -> Contest:
        """Whole processes; a tool that reads no xacro pays for the stock command too."""
        contest: Contest = {NOTHING: partial(self.run, self.lean, "-c", "pass")}
        if not robot.plain:
            contest[XACRO] = partial(self.xacro, robot, self.lean)
            contest[XACRO_ALL] = partial(self.xacro, robot, self.full)
        contest |= self.ours(robot)
        if shutil.which("check_urdf"):
            contest["check_urdf"] = partial(self.reader, robot, "check_urdf")
        for tool in self.tools:
            contest[tool] = partial(self.reader, robot, self.full, PEER, tool)
        return contest


def take_turns(contest: Contest, rounds: int) -> dict[str, float]:
    """The least seconds of every contestant, each of which runs once a round."""
    for run in contest.values():
        run()  # what is cached is measured when it is
    runs = [{name: run() for name, run in contest.items()} for _ in range(rounds)]
    return {name: min(one[name] for one in runs) for name in contest}


def row(title: str, reference: str, cost: float, costs: dict[str, float]) -> str:
    """A row of the table: the reference in ms, and how many times as much the others cost."""
    ratios = (f"{costs[name] / cost:.2f}" if name in costs else "" for name in COLUMNS)
    cells = "".join(f"{cell:>14}" for cell in ratios)
    return f"{title:16}{reference:16}{1e3 * cost:8.1f}{cells}"


def corpus(shared: Path) -> Iterator[Robot]:
    """The robots of the corpus that expand as their directories lie there."""
    for repository in manifest(shared):
        for model in repository["models"]:
            plain = model["kind"] == "urdf"
            if plain or model["expands_with_source_tree_layout"]:
                file = shared / "corpus" / repository["dir"] / model["path"]
                yield Robot(model["id"], file, tuple(model["xacro_args"]), plain)


def packages(shared: Path) -> dict[str, str]:
    """The directory of every ROS package at hand."""
    directories = {"gazebo_pkg": str(ROOT / "models" / "gazebo_pkg")}
    for repository in manifest(shared):
        for name, directory in repository["packages"].items():
            directories.setdefault(name, str(shared / "corpus" / repository["dir"] / directory))
    return directories


def manifest(shared: Path) -> list[dict[str, Any]]:
    """What the corpus says of itself; nothing where there is none."""
    file = shared / "corpus" / "MANIFEST.json"
    if not file.is_file():
        return []
    repositories: list[dict[str, Any]] = json.loads(file.read_text(encoding="utf-8"))["repos"]
    return repositories


def measure_robots(bench: Bench, shared: Path, rounds: int) -> list[str]:
    """Print a row for each robot with a budget; which budgets are kept."""
    ur = shared / "corpus" / "Universal_Robots_ROS2_Description" / "urdf" / "ur.urdf.xacro"
    nao = shared / "corpus" / "nao_robot" / "nao_description" / "urdf" / "naoV40_generated_urdf"
    mission = Robot("mission", MISSION)
    budgets = [
        Budget(Robot("two_link_arm", PLAIN, plain=True), LEAN, NOTHING, 5),
        Budget(mission, LEAN, XACRO, 2.2),
        Budget(mission, ALL, XACRO_ALL, 2.5),
        Budget(mission, AGAIN, NOTHING, 1.6),
        Budget(Robot("ur5e", ur, ("name:=ur", "ur_type:=ur5e")), LEAN, XACRO, 1.2),
        Budget(Robot("nao", nao / "nao_robot.xacro"), LEAN, XACRO, 1.2),
    ]
    costs: dict[Robot, dict[str, float]] = {}
    kept = []
    for robot, contestant, other, bound in budgets:
        if not robot.file.is_file():
            kept.append(f"not measured  {robot.title}: {robot.file} is not here")
            continue
        if robot not in costs:
            costs[robot] = take_turns(bench.everybody(robot), rounds)
            print(row(robot.title, other, costs[robot][other], costs[robot]), flush=True)
        ratio = costs[robot][contestant] / costs[robot][other]
        kept.append(_verdict(f"{robot.title}, {contestant} / {other}", ratio, bound))
    return kept


def measure_corpus(bench: Bench, robots: list[Robot], rounds: int) -> list[str]:
    """Print a row for the median of real robots, and the slowest; which budgets are kept."""
    costs = {robot: take_turns(bench.ours(robot), rounds) for robot in robots}
    ratio = statistics.median(cost[ALL] / cost[LEAN] for cost in costs.values())
    lean = statistics.median(cost[LEAN] for cost in costs.values())
    print(row(f"median of {len(robots)}", LEAN, lean, {LEAN: lean, ALL: ratio * lean}))
    slowest = max(robots, key=lambda robot: costs[robot][ALL])
    return [
        _verdict(f"median, {ALL} / {LEAN}", ratio, MEDIAN),
        _verdict(f"{slowest.file.name}, {ALL} in s", costs[slowest][ALL], MOST),
    ]


def _verdict(title: str, value: float, bound: float) -> str:
    return f"{'pass' if value <= bound else 'OVER'}  {title}: {value:.2f} of {bound:g}"


def installed(name: str, what: str) -> Path:
    """The Python of an environment of this benchmark, with urdfkit as it is now.

    Args:
        name: of the environment.
        what: the extras, in brackets.
    """
    directory = ROOT / "build" / "benchmarks" / name
    python = directory / "bin" / "python"
    if not python.exists():
        venv.create(directory, with_pip=True, upgrade_deps=True)
    install = ["-m", "pip", "install", "-q", f"{ROOT}{what}"]
    subprocess.run([str(python), *install], check=True)
    return python


def main() -> int:
    """Measure, print, and answer 1 if a budget is exceeded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--lean", type=Path, metavar="PYTHON", help="has urdfkit without extras")
    parser.add_argument("--all", type=Path, metavar="PYTHON", help="has urdfkit[all]")
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--corpus-rounds", type=int, default=3, help="0 leaves the corpus out")
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared", metavar="DIRECTORY")
    options = parser.parse_args()
    lean = options.lean or installed("lean", "")
    full = options.all or installed("all", "[all]")
    compileall.compile_dir(ROOT / "urdfkit", quiet=1)  # which a named one may be installed from
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(lean, full, Path(scratch), packages(options.shared))
        heads = "".join(f"{name:>14}" for name in COLUMNS)
        print(f"{'CPU time of':16}{'reference':16}{'ms':>8}{heads}")
        kept = measure_robots(bench, options.shared, options.rounds)
        robots = list(corpus(options.shared))
        if robots and options.corpus_rounds:
            kept += measure_corpus(bench, robots, options.corpus_rounds)
    print("", *kept, sep="\n")
    return int(any(line.startswith("OVER") for line in kept))


if __name__ == "__main__":
    sys.exit(main())
