"""What `urdfkit check` costs next to stock xacro and other tools, with and without the extras.

Usage: python benchmarks/bench.py --all PYTHON [--rounds N] [--corpus-rounds N] [--shared FOLDER]

CPU time of whole processes, user and system, bytecode compiled. The contestants take turns, so that
a busy machine slows all of them alike; the least of all rounds is compared.
"""

from __future__ import annotations

import argparse
import compileall
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[1]
MISSION = ROOT / "models" / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
PLAIN = ROOT / "models" / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf"
PEER = Path(__file__).with_name("peer.py")

STUB = """\
FOLDERS = {folders!r}

class PackageNotFoundError(KeyError):
    pass

def get_package_share_directory(name):
    try:
        return FOLDERS[name]
    except KeyError:
        raise PackageNotFoundError(name) from None
"""

NOTHING, XACRO, LEAN, ALL = "python -c pass", "xacro", "urdfkit check", "urdfkit[all] check"

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
        scratch: a folder for what the runs write.
        folders: of ROS packages by name; stock xacro finds them through ROS, for which this stands.
    """

    def __init__(self, full: Path, scratch: Path, folders: dict[str, str]) -> None:
        self.lean, self.full = Path(sys.executable), full
        self._scratch = scratch
        stub = scratch / "stub" / "ament_index_python"
        stub.mkdir(parents=True)
        (stub / "__init__.py").touch()
        (stub / "packages.py").write_text(STUB.format(folders=folders), encoding="utf-8")
        self._environment = os.environ | {
            "PYTHONPATH": str(stub.parent),
            "URDFKIT_CACHE_DIR": str(scratch / "measures"),
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
        """The command that users type."""
        return self.run(python.with_name("urdfkit"), "check", robot.file, *robot.arguments)

    def xacro(self, robot: Robot) -> float:
        """The stock command, where it is needed; leaves what it wrote in ``expanded``."""
        if robot.plain:
            return 0.0
        command = self.lean.with_name("xacro")
        return self.run(command, robot.file, *robot.arguments, out=self.expanded(robot))

    def expanded(self, robot: Robot) -> Path:
        """The plain URDF of a robot."""
        return robot.file if robot.plain else self._scratch / f"{robot.title}.urdf"

    def reader(self, robot: Robot, *command: str | Path) -> float:
        """Expand, then read with another tool."""
        return self.xacro(robot) + self.run(*command, self.expanded(robot))

    def ours(self, robot: Robot) -> Contest:
        """urdfkit without and with the extras."""
        return {
            LEAN: partial(self.check, self.lean, robot),
            ALL: partial(self.check, self.full, robot),
        }

    def everybody(self, robot: Robot) -> Contest:
        """Whole processes; a tool that reads no xacro pays for the stock command too."""
        contest: Contest = {NOTHING: partial(self.run, self.lean, "-c", "pass")}
        if not robot.plain:
            contest[XACRO] = partial(self.xacro, robot)
        contest |= self.ours(robot)
        before = "" if robot.plain else "xacro, "
        if shutil.which("check_urdf"):
            contest[before + "check_urdf"] = partial(self.reader, robot, "check_urdf")
        for tool in self.tools:
            contest[before + tool] = partial(self.reader, robot, self.full, PEER, tool)
        return contest


def take_turns(contest: Contest, rounds: int) -> dict[str, float]:
    """The least seconds of every contestant, each of which runs once a round."""
    for run in contest.values():
        run()  # what is cached is measured when it is
    runs = [{name: run() for name, run in contest.items()} for _ in range(rounds)]
    return {name: min(one[name] for one in runs) for name in contest}


def show(robot: Robot, costs: dict[str, float]) -> None:
    """Print the ratios to stock xacro, or to a Python that does nothing."""
    other = NOTHING if robot.plain else XACRO
    print(f"\n{robot.title:24}{'ms':>10}{'/ ' + other:>20}")
    for name, cost in costs.items():
        print(f"{name:24}{1e3 * cost:10.1f}{cost / costs[other]:20.2f}")


def corpus(shared: Path) -> Iterator[Robot]:
    """The robots of the corpus that expand as their folders lie there."""
    for repository in manifest(shared):
        for model in repository["models"]:
            plain = model["kind"] == "urdf"
            if plain or model["expands_with_source_tree_layout"]:
                file = shared / "corpus" / repository["dir"] / model["path"]
                yield Robot(model["id"], file, tuple(model["xacro_args"]), plain)


def packages(shared: Path) -> dict[str, str]:
    """The folder of every ROS package at hand."""
    folders = {"gazebo_pkg": str(ROOT / "models" / "gazebo_pkg")}
    for repository in manifest(shared):
        for name, folder in repository["packages"].items():
            folders.setdefault(name, str(shared / "corpus" / repository["dir"] / folder))
    return folders


def manifest(shared: Path) -> list[dict[str, Any]]:
    """What the corpus says of itself; nothing where there is none."""
    file = shared / "corpus" / "MANIFEST.json"
    if not file.is_file():
        return []
    repositories: list[dict[str, Any]] = json.loads(file.read_text(encoding="utf-8"))["repos"]
    return repositories


def measure_robots(bench: Bench, shared: Path, rounds: int) -> list[str]:
    """Print a table for each robot with a budget; which budgets are kept."""
    ur = shared / "corpus" / "Universal_Robots_ROS2_Description" / "urdf" / "ur.urdf.xacro"
    nao = shared / "corpus" / "nao_robot" / "nao_description" / "urdf" / "naoV40_generated_urdf"
    mission = Robot("mission", MISSION)
    budgets = [
        Budget(Robot("two_link_arm", PLAIN, plain=True), LEAN, NOTHING, 5),
        Budget(mission, LEAN, XACRO, 2),
        Budget(mission, ALL, XACRO, 2.5),
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
            show(robot, costs[robot])
        ratio = costs[robot][contestant] / costs[robot][other]
        kept.append(_verdict(f"{robot.title}, {contestant} / {other}", ratio, bound))
    return kept


def measure_corpus(bench: Bench, robots: list[Robot], rounds: int) -> list[str]:
    """Print what the extras cost on real robots; which budgets are kept."""
    costs = {robot: take_turns(bench.ours(robot), rounds) for robot in robots}
    ratios = {robot: cost[ALL] / cost[LEAN] for robot, cost in costs.items()}
    print(f"\n{len(robots)} models of the corpus{LEAN + ' ms':>24}{ALL + ' ms':>24}{'ratio':>8}")
    for robot in sorted(robots, key=lambda robot: -ratios[robot])[:12]:
        lean, full = (1e3 * costs[robot][name] for name in (LEAN, ALL))
        print(f"{robot.file.name[:28]:29}{lean:18.1f}{full:24.1f}{ratios[robot]:8.2f}")
    for name in (LEAN, ALL):
        every = [cost[name] for cost in costs.values()]
        print(f"{name}: median {1e3 * statistics.median(every):.1f} ms, most {max(every):.2f} s")
    most = max(cost[ALL] for cost in costs.values())
    return [
        _verdict(f"corpus, median of {ALL} / {LEAN}", statistics.median(ratios.values()), MEDIAN),
        _verdict(f"corpus, most of {ALL} in s", most, MOST),
    ]


def _verdict(title: str, value: float, bound: float) -> str:
    return f"{'pass' if value <= bound else 'OVER'}  {title}: {value:.2f} of {bound:g}"


def main() -> int:
    """Measure, print, and answer 1 if a budget is exceeded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--all", type=Path, required=True, metavar="PYTHON")
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--corpus-rounds", type=int, default=3)
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared", metavar="FOLDER")
    options = parser.parse_args()
    compileall.compile_dir(ROOT / "urdfkit", quiet=1)  # where that is what is installed
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(options.all, Path(scratch), packages(options.shared))
        kept = measure_robots(bench, options.shared, options.rounds)
        if robots := list(corpus(options.shared)):
            kept += measure_corpus(bench, robots, options.corpus_rounds)
    missing = {"yourdfpy", "pinocchio"} - set(bench.tools)
    if missing:
        print(f"\nNot measured, because {options.all} has not got them: {', '.join(missing)}")
    print("\nBudgets", *kept, sep="\n")
    return int(any(line.startswith("OVER") for line in kept))


if __name__ == "__main__":
    sys.exit(main())
