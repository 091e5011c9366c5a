"""What ``urdfkit simulate`` costs on the robots of the corpus that MuJoCo takes.

Usage: python benchmarks/simulate.py [--shared DIRECTORY]

CPU time (user and system) and memory of whole processes, each once.
"""

import argparse
import os
import statistics
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from benchmarks.bench import Robot, corpus  # noqa: E402


class Cost(NamedTuple):
    """What one run took, in s and MB, and its exit code."""

    seconds: float
    megabytes: float
    code: int


def simulate(robot: Robot) -> Cost:
    """Run the command on a robot."""
    command = [sys.executable, "-m", "urdfkit", "simulate", str(robot.file), *robot.arguments]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    kilobytes = usage.ru_maxrss / (1024 if sys.platform == "darwin" else 1)
    return Cost(usage.ru_utime + usage.ru_stime, kilobytes / 1e3, process.returncode)


def main() -> int:
    """Print median and most; 1 if there is no corpus."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared", metavar="DIRECTORY")
    costs: list[Cost] = []
    rejected = 0
    for robot in corpus(parser.parse_args().shared):
        cost = simulate(robot)
        if cost.code in (0, 1):
            costs.append(cost)
            print(f"{robot.title:50}{cost.seconds:8.2f} s{cost.megabytes:8.0f} MB", flush=True)
        else:
            rejected += 1
    if not costs:
        print("no robot of the corpus was simulated", file=sys.stderr)
        return 1
    seconds = [cost.seconds for cost in costs]
    memory = [cost.megabytes for cost in costs]
    print(
        f"{len(costs)} robots, {rejected} rejected: median {statistics.median(seconds):.2f} s, "
        f"{statistics.median(memory):.0f} MB; most {max(seconds):.2f} s, {max(memory):.0f} MB"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
