"""What `urdfkit check` costs beside its peers, and whether it keeps its budgets.

Usage: python benchmarks/bench.py [--rounds N] [--peers PYTHON] [--shared FOLDER]

CPU time of whole processes (user and system, from wait4) and inside a process. The contestants
take turns, A B A B, so that a busy machine slows all of them; the minimum is compared.
"""

from __future__ import annotations

import argparse
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
INSIDE = Path(__file__).with_name("inside.py")

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


NOTHING = "python -c pass"
OURS = "urdfkit check"


class Robot(NamedTuple):
    """A description, the xacro arguments it wants, and whether it needs no xacro at all."""

    title: str
    file: Path
    arguments: tuple[str, ...] = ()
    plain: bool = False


class Budget(NamedTuple):
    """At most ``bound`` times the cost of another contestant, whole process."""

    robot: Robot
    beside: str
    bound: float


class Cost(NamedTuple):
    """CPU seconds of several runs."""

    runs: tuple[float, ...]

    @property
    def least(self) -> float:
        """The run that was disturbed least."""
        return min(self.runs)

    @property
    def median(self) -> float:
        """The usual run."""
        return statistics.median(self.runs)


Contest = dict[str, Callable[[], float]]


class Bench:
    """Runs the contestants.

    Attributes:
        lean: the Python that has urdfkit.
        peers: the Python that has yourdfpy and pinocchio; may be the same.
        scratch: a folder for what the runs write.
        libraries: those that the peers' Python has.
    """

    def __init__(self, peers: Path, scratch: Path, folders: dict[str, str]) -> None:
        self.lean = Path(sys.executable)
        self.peers = peers
        self.scratch = scratch
        stub = scratch / "stub" / "ament_index_python"
        stub.mkdir(parents=True)
        (stub / "__init__.py").touch()
        (stub / "packages.py").write_text(STUB.format(folders=folders), encoding="utf-8")
        # Stock xacro finds packages through ROS; this maps the same names to the same folders.
        self.with_stub = os.environ | {"PYTHONPATH": str(stub.parent)}
        self.libraries = [tool for tool in ("yourdfpy", "pinocchio") if self.has(tool)]

    def has(self, module: str) -> bool:
        """True if the peers' Python can import a module."""
        find = f"import importlib.util, sys; sys.exit(not importlib.util.find_spec({module!r}))"
        command: list[str | Path] = [self.peers, "-c", find]
        return subprocess.run(command, capture_output=True, check=False).returncode == 0

    def run(
        self, *command: str | Path, out: Path | None = None, codes: tuple[int, ...] = ()
    ) -> float:
        """CPU seconds of a command, which must end with one of the codes, if any are given."""
        with open(out or os.devnull, "wb") as file:
            process = subprocess.Popen(
                [str(word) for word in command],
                stdout=file,
                stderr=subprocess.DEVNULL,
                env=self.with_stub,
            )
            _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if codes and process.returncode not in codes:
            sys.exit(f"exit code {process.returncode}: {' '.join(map(str, command))}")
        return usage.ru_utime + usage.ru_stime

    def python(self) -> float:
        """A Python that does nothing."""
        return self.run(self.lean, "-c", "pass")

    def urdfkit(self, robot: Robot) -> float:
        """The command that users type."""
        command = self.lean.with_name("urdfkit")
        return self.run(command, "check", robot.file, *robot.arguments, codes=(0, 1))

    def xacro(self, robot: Robot) -> float:
        """The stock command, where it is needed; leaves what it wrote in ``expanded``."""
        if robot.plain:
            return 0.0
        command = self.lean.with_name("xacro")
        out = self.expanded(robot)
        return self.run(command, robot.file, *robot.arguments, out=out, codes=(0,))

    def expanded(self, robot: Robot) -> Path:
        """The plain URDF of a robot."""
        return robot.file if robot.plain else self.scratch / f"{robot.title}.urdf"

    def check_urdf(self, robot: Robot) -> float:
        """Expand, then read with urdfdom."""
        return self.xacro(robot) + self.run("check_urdf", self.expanded(robot))

    def peer(self, tool: str, robot: Robot) -> float:
        """Expand, then read with a library."""
        plain = self.expanded(robot)
        return self.xacro(robot) + self.run(self.peers, INSIDE, tool, "0", plain)

    def whole(self, robot: Robot) -> Contest:
        """Whole processes; a peer that reads no xacro pays for the stock command too."""
        contest: Contest = {NOTHING: self.python, OURS: partial(self.urdfkit, robot)}
        if not robot.plain:
            contest["xacro"] = partial(self.xacro, robot)
        before = "" if robot.plain else "xacro, "
        if shutil.which("check_urdf"):
            contest[before + "check_urdf"] = partial(self.check_urdf, robot)
        for tool in self.libraries:
            contest[before + tool] = partial(self.peer, tool, robot)
        return contest

    def inside(self, robot: Robot, repeats: int) -> dict[str, Cost]:
        """Runs inside a process each, after imports and a first run."""
        commands: dict[str, list[str | Path]] = {
            "urdfkit": [self.lean, INSIDE, "urdfkit", str(repeats), robot.file, *robot.arguments]
        }
        if not robot.plain:
            commands["xacro"] = [commands["urdfkit"][0], INSIDE, "xacro", *commands["urdfkit"][3:]]
        for tool in self.libraries:
            commands[tool] = [self.peers, INSIDE, tool, str(repeats), self.expanded(robot)]
        costs: dict[str, list[float]] = {tool: [] for tool in commands}
        for _ in range(3):
            for tool, command in commands.items():
                result = subprocess.run(
                    command, capture_output=True, text=True, env=self.with_stub, check=True
                )
                costs[tool] += map(float, result.stdout.split())
        return {tool: Cost(tuple(runs)) for tool, runs in costs.items()}

    def sum(self, robots: list[Robot]) -> dict[str, Cost]:
        """One round of whole processes over many robots, added up; xacro where it is needed."""
        total: dict[str, float] = {}
        for robot in robots:
            for name, seconds in take_turns(self.whole(robot), 1).items():
                if name != "xacro":  # which plain robots do without
                    tool = name.removeprefix("xacro, ")
                    total[tool] = total.get(tool, 0.0) + seconds.least
        return {name: Cost((seconds,)) for name, seconds in total.items()}


def take_turns(contest: Contest, rounds: int) -> dict[str, Cost]:
    """Run every contestant once a round."""
    runs: dict[str, list[float]] = {name: [] for name in contest}
    for _ in range(rounds):
        for name, run in contest.items():
            runs[name].append(run())
    return {name: Cost(tuple(seconds)) for name, seconds in runs.items()}


def show(title: str, costs: dict[str, Cost], ours: str) -> None:
    """Print a table."""
    print(f"\n{title}\n{'':24}{'min ms':>10}{'median ms':>11}{'urdfkit / this':>16}")
    for name, cost in costs.items():
        ratio = costs[ours].least / cost.least
        print(f"{name:24}{1e3 * cost.least:10.1f}{1e3 * cost.median:11.1f}{ratio:16.2f}")


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


def measure(bench: Bench, shared: Path, rounds: int) -> int:
    """Print all tables; 1 if a budget is exceeded."""
    ur = shared / "corpus" / "Universal_Robots_ROS2_Description" / "urdf" / "ur.urdf.xacro"
    nao = shared / "corpus" / "nao_robot" / "nao_description" / "urdf" / "naoV40_generated_urdf"
    budgets = [
        Budget(Robot("two_link_arm", PLAIN, plain=True), NOTHING, 5),
        Budget(Robot("mission", MISSION), "xacro", 2),
        Budget(Robot("ur5e", ur, ("name:=ur", "ur_type:=ur5e")), "xacro", 1.2),
        Budget(Robot("nao", nao / "nao_robot.xacro"), "xacro", 1.2),
    ]
    kept = []
    for budget in budgets:
        robot = budget.robot
        if not robot.file.is_file():
            kept.append(f"not measured  {robot.title}: {robot.file} is not here")
            continue
        costs = take_turns(bench.whole(robot), rounds)
        show(f"{robot.title}, whole process", costs, OURS)
        show(f"{robot.title}, inside the process", bench.inside(robot, rounds), "urdfkit")
        ratio = costs[OURS].least / costs[budget.beside].least
        verdict = "pass" if ratio <= budget.bound else "OVER"
        kept.append(f"{verdict}  {robot.title}: {ratio:.2f} of {budget.bound} x {budget.beside}")
    missing = {"yourdfpy", "pinocchio"} - set(bench.libraries)
    if missing:
        print(f"\nNot measured, because {bench.peers} has not got them: {', '.join(missing)}")
    robots = list(corpus(shared))
    if robots:
        show(f"{len(robots)} models of the corpus, whole process", bench.sum(robots), OURS)
    print("\nBudgets, whole process", *kept, sep="\n")
    return int(any(line.startswith("OVER") for line in kept))


def main() -> int:
    """Measure, print, and answer 1 if a budget is exceeded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--peers", type=Path, default=Path(sys.executable), metavar="PYTHON")
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared", metavar="FOLDER")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(options.peers, Path(scratch), packages(options.shared))
        return measure(bench, options.shared, options.rounds)


if __name__ == "__main__":
    sys.exit(main())
