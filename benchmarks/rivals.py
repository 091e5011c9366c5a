"""What other checkers of robot models report of the same files, as the table of docs/comparison.md.

Usage: python benchmarks/rivals.py [--every N] [--environments DIR] [--details FILE] [ROBOT ...]

Each program is installed from PyPI into an environment of its own. Two kinds of defects are planted
one at a time: those of tests/planted.txt into its plain URDF, which the authors of urdfkit wrote,
and those that `simcheck bench` plants, which its author wrote. Then every program reads robots
without a known defect: those of the project, and each ROBOT, a URDF or xacro file.

An error or a warning that a program does not give of the sound robot is a report of the defect. It
names the part if it has the name of a link, joint or file on the edited lines or of the element
around.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import venv
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from tests.test_planted import PLANTS, copied, planted  # noqa: E402

FILE = Path("urdf", "picker.urdf")
PAGE = ROOT / "docs" / "comparison.md"
BEGIN, END = "<!-- written by benchmarks/rivals.py -->", "<!-- end -->"
OWN = (
    ROOT / "models" / "good" / "gripper.urdf",
    ROOT / "models" / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf",
    ROOT / "models" / "good" / "mobile_base" / "urdf" / "mobile_base.urdf.xacro",
)
SEEDS = 1

#: Writes the robots with simcheck's defects, as many for each as there are seeds.
_MUTATE = """
import sys
from pathlib import Path
from simcheck.checks.registry import Context
from simcheck.config import Config
from simcheck.core import load_asset
from simcheck.mutate import MUTATIONS, apply, copy_clean
robot, out, seeds = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
copy_clean(robot, out)
context = Context(load_asset(robot, Config()), Config())
for name in MUTATIONS:
    for seed in range(seeds):
        made = apply(robot, name, out, seed, context)
        if made:
            made[0].rename(out / f"{name}.{seed}.urdf")
"""
_YOURDFPY = """
import sys, yourdfpy
robot = yourdfpy.URDF.load(sys.argv[1], load_meshes=False, build_scene_graph=False)
robot.validate()
print("\\n".join(map(str, robot.errors)))
"""

Findings = Iterable[str]


class Program(NamedTuple):
    """A checker."""

    name: str
    package: str  # on PyPI; empty for one that is here
    command: tuple[str, ...]  # with {bin}, {python}, {file} and {out}, a directory to write to
    findings: Callable[[str, Path], Findings]  # of its standard output, and what it wrote


def _json(text: str) -> Any:
    return json.loads(text[min(i for i in (text.find("{"), text.find("[")) if i >= 0) :])


def _simcheck(text: str, _: Path) -> Iterator[str]:
    for result in _json(text)[0]["results"]:
        for one in result["findings"]:
            if one["severity"] != "info":
                yield f"{one['check']} {one['target']} {one['message']}"


def _isaaclab(text: str, _: Path) -> Iterator[str]:
    for one in _json(text)["findings"]:
        if one["severity"] != "INFO":
            yield f"{one['id']} {one['subject']} {one['message']}"


def _truerig(text: str, _: Path) -> Iterator[str]:
    for one in _json(text)["events"]:
        if one["severity"] != "info":
            yield f"{one['category']} {one['element']} {one['message']}"


def _urdf_validator(_: str, out: Path) -> Iterator[str]:
    def walk(value: Any) -> Iterator[str]:
        if isinstance(value, dict):
            for key in ("critical_issues", "warnings"):
                yield from map(str, value.get(key) or ())
            if value.get("status") in ("WARN", "FAIL"):
                yield " ".join(str(value.get(key, "")) for key in ("name", "joint_name", "status"))
            value = list(value.values())
        if isinstance(value, list):
            for one in value:
                yield from walk(one)

    for file in out.glob("*.json"):
        yield from walk(json.loads(file.read_text(encoding="utf-8")))


def _urdfkit(text: str, _: Path) -> Iterator[str]:
    for one in _json(text)["diagnostics"]:
        if one["severity"] != "info":
            yield f"{one['code']} {one['element']} {one['message']}"


def _lines(text: str, _: Path) -> Iterator[str]:
    return (line for line in text.split("\n") if line.strip())


def _errors(text: str, _: Path) -> Iterator[str]:
    return (line for line in text.split("\n") if re.match(r"\s*(Error|Warning)", line))


PROGRAMS = (
    Program("check_urdf", "", ("check_urdf", "{file}"), _errors),
    Program("yourdfpy", "yourdfpy", ("{python}", "-c", _YOURDFPY, "{file}"), _lines),
    Program(
        "urdf-validator",
        "urdf-validator",
        ("{bin}/urdf_validate", "{file}", "--output-dir", "{out}"),
        _urdf_validator,
    ),
    Program(
        "isaaclab-robot-doctor",
        "isaaclab-robot-doctor",
        ("{bin}/isaaclab-robot-doctor", "check", "{file}", "--json"),
        _isaaclab,
    ),
    Program(
        "TrueRig",
        "truerig",
        ("{bin}/truerig", "validate", "{file}", "--report", "json"),
        _truerig,
    ),
    Program(
        "simcheck",
        "simcheck",
        ("{bin}/simcheck", "check", "{file}", "--no-config", "--format", "json"),
        _simcheck,
    ),
    Program(
        "urdfkit",
        "",
        (
            sys.executable, "-m", "urdfkit", "check", "{file}", "--isolated", "--no-cache",
            "--format", "json",
        ),
        _urdfkit,
    ),
)  # fmt: skip


class Installed(NamedTuple):
    """A program that can be run."""

    program: Program
    directory: Path  # of its environment
    version: str

    def findings(self, file: Path, packages: Path) -> set[str]:
        """Its errors and warnings of a robot; of one that it rejects without, the last line."""
        python = self.directory / "bin" / "python"
        with tempfile.TemporaryDirectory() as out:
            words = {"bin": python.parent, "python": python, "file": file, "out": out}
            command = [
                word if word == _YOURDFPY else word.format(**words) for word in self.program.command
            ]
            environment = {**os.environ, "NO_COLOR": "1", "ROS_PACKAGE_PATH": str(packages)}
            try:
                done = subprocess.run(
                    command, check=False, capture_output=True, text=True, timeout=300,
                    cwd=out, env=environment,
                )  # fmt: skip
            except subprocess.TimeoutExpired:
                return {"no result within 300 s"}
            output = done.stderr if self.program.name == "check_urdf" else done.stdout
            try:
                found = set(self.program.findings(output, Path(out)))
            except ValueError:  # neither a report nor JSON
                found = set()
            said = (done.stderr.strip() or done.stdout.strip() or "silent").split("\n")[-1]
            return found or ({f"exit code {done.returncode}: {said}"} if done.returncode else set())


def installed(environments: Path) -> Iterator[Installed]:
    """Every program, in an environment of its own."""
    for program in PROGRAMS:
        directory = environments / f"v-{program.package or 'none'}"
        if not program.package:
            if program.name == "check_urdf" and not shutil.which("check_urdf"):
                continue
            from urdfkit import __version__

            version = _urdfdom() if program.name == "check_urdf" else __version__
            yield Installed(program, directory, version)
            continue
        python = directory / "bin" / "python"
        if not python.exists():
            venv.create(directory, with_pip=True)
            subprocess.run([python, "-m", "pip", "install", "-q", program.package], check=True)
        code = f"from importlib.metadata import version; print(version({program.package!r}))"
        said = subprocess.run([python, "-c", code], check=True, capture_output=True, text=True)
        yield Installed(program, directory, said.stdout.strip())


def _urdfdom() -> str:
    words = ["dpkg-query", "-W", "-f", "${Version}", "liburdfdom-tools"]
    return subprocess.run(words, check=False, capture_output=True, text=True).stdout.split("-")[0]


class Defect(NamedTuple):
    """A robot with one defect."""

    name: str
    file: Path
    sound: Path  # the same without it
    names: frozenset[str]  # of the parts that are edited


def of_the_project(directory: Path, every: int) -> Iterator[Defect]:
    """The defects of the project in its plain URDF."""
    sound = Path(copied("picker", directory / "sound" / "picker")[0])
    wanted = [one for one in PLANTS if one.robot == "picker" and Path(one.file) == FILE]
    for number, plant in enumerate(wanted[::every]):
        place = directory / f"planted{number}" / "picker"
        file = Path(copied("picker", place)[0])
        planted(plant, place)
        yield Defect(f"{plant.code} {plant.new!r}", file, sound, _names(sound, file))


def mutated(directory: Path, python: Path) -> Iterator[Defect]:
    """The defects of simcheck in the same robot."""
    robot = Path(copied("picker", directory / "simcheck" / "picker")[0])
    words = [str(python), "-c", _MUTATE, str(robot), str(robot.parent), str(SEEDS)]
    subprocess.run(words, check=True)
    sound = robot.parent / "picker__clean.urdf"
    texts = {sound.read_text(encoding="utf-8")}
    for file in sorted(robot.parent.glob("*.*.urdf")):
        text = file.read_text(encoding="utf-8")
        if text not in texts:
            texts.add(text)
            yield Defect(f"simcheck {file.stem}", file, sound, _names(sound, file))


def _names(sound: Path, file: Path) -> frozenset[str]:
    """Names on the lines that differ, and of the links and joints around them."""
    import difflib

    before, after = (one.read_text(encoding="utf-8").split("\n") for one in (sound, file))
    found: set[str] = set()
    matcher = difflib.SequenceMatcher(None, before, after, autojunk=False)
    for kind, first, last, begin, end in matcher.get_opcodes():
        if kind != "equal":
            for lines, start, stop in ((before, first, last), (after, begin, end)):
                found |= {name for line in lines[start:stop] for name in _quoted(line)}
                around = [line for line in lines[: stop or 1] if re.match(r"  <\w+ name=", line)]
                found |= set(_quoted(around[-1]) if around else ())
    return frozenset(found)


def _quoted(line: str) -> Iterator[str]:
    for value in re.findall(r"""\b(?:name|link|joint|filename)=["']([^"']+)["']""", line):
        yield os.path.basename(value)


def sound_robots(directory: Path, others: Iterable[str]) -> Iterator[tuple[Path, bool]]:
    """Robots without a known defect, each with its files next to it, and whether it is ours."""
    for number, robot in enumerate([*map(str, OWN), *others]):
        out = directory / f"robot{number}"
        command = [sys.executable, "-m", "urdfkit", "bundle", robot, "-o", str(out)]
        done = subprocess.run(command, check=False, capture_output=True, text=True)
        if not out.is_dir():
            print(f"left out: {robot}: {done.stderr.strip()}", file=sys.stderr)
            continue
        yield next(out.glob("*.urdf")), number < len(OWN)


def main() -> None:
    """Run every program on every file, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robots", nargs="*", metavar="ROBOT")
    parser.add_argument("--every", type=int, default=1, help="take every Nth planted defect")
    parser.add_argument("--environments", type=Path, help="where they are kept for the next run")
    parser.add_argument("--details", type=Path, help="write every report to this file")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        directory = Path(scratch)
        programs = list(installed(given.environments or directory / "environments"))
        simcheck = next(one for one in programs if one.program.name == "simcheck")
        defects = [
            list(of_the_project(directory, given.every)),
            list(mutated(directory, simcheck.directory / "bin" / "python")),
        ]
        robots = list(sound_robots(directory, given.robots))
        details: list[str] = []
        with ThreadPoolExecutor(len(programs)) as pool:
            rows = list(pool.map(lambda one: _row(one, defects, robots, details), programs))
    if given.details:
        given.details.write_text("\n".join(details) + "\n", encoding="utf-8")
    own = sum(is_own for _, is_own in robots)
    heads = (
        "program",
        f"{len(defects[0])} defects of urdfkit's authors",
        f"{len(defects[1])} of simcheck's author",
        f"alarms on {own} sound robots of ours",
        f"on {len(robots) - own} published",
    )
    lines = [
        f"| {' | '.join(heads)} |",
        "|" + " --- |" * len(heads),
        *rows,
        "",
        f"Measured on {date.today()}.",
    ]
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    text = "\n".join([before + BEGIN, "", *lines, "", END + after])
    PAGE.write_text(text, encoding="utf-8")


def _row(
    program: Installed,
    defects: list[list[Defect]],
    robots: list[tuple[Path, bool]],
    details: list[str],
) -> str:
    """The cells of a program: defects reported (and named), and alarms on sound robots."""
    name = program.program.name
    cells = []
    of_sound: dict[Path, set[str]] = {}
    for group in defects:
        reported = named = 0
        for defect in group:
            packages = defect.file.parents[2]
            if defect.sound not in of_sound:
                of_sound[defect.sound] = program.findings(defect.sound, packages)
            new = program.findings(defect.file, packages) - of_sound[defect.sound]
            is_named = any(one in text for one in defect.names for text in new)
            reported, named = reported + bool(new), named + is_named
            verdict = "named" if is_named else "reported" if new else "silent"
            details.append(f"{name}\t{defect.name}\t{verdict}\t{' | '.join(sorted(new))[:600]}")
        cells.append(f"{reported} reported, {named} with the part")
    for is_own in (True, False):
        alarms = [program.findings(file, file.parent) for file, own in robots if own is is_own]
        details.extend(f"{name}\tsound\t{text}" for found in alarms for text in sorted(found))
        cells.append(f"{sum(map(len, alarms))} on {sum(map(bool, alarms))}")
    print(name, *cells, sep=" | ", file=sys.stderr)
    return f"| {name} {program.version} | {' | '.join(cells)} |"


if __name__ == "__main__":
    main()
