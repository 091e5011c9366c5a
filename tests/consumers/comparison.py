"""What programs say of real robots, next to what ``--target NAME`` says of them.

A robot is given to a program expanded, with the absolute paths of its meshes: where a program
looks for meshes is a question of its own. The programs end a process now and then, so that each
robot has one of its own.
"""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from tests.conftest import MODELS, ROOT, manifest
from tests.update_corpus_findings import arguments_of
from urdfkit.lint import engine, rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.description_file import Unavailable
from urdfkit.lint.options import Options
from urdfkit.lint.runner import run_rules
from urdfkit.text.diagnostic import Severity

#: Seconds for one program with one robot.
LIMIT = 300

#: Reported of how a robot is given: absolute paths answer the one, an argument of xacro the other.
OF_HANDLING = frozenset(("MSH039", "XAC020"))


class Program(NamedTuple):
    """A program that reads URDF.

    Attributes:
        module: that must be there.
        reads: takes the path of a URDF; raises an error for one that the program rejects.
        causes: by a part of its error, as a pattern: the cause, and the rules that report it.
    """

    module: str
    reads: str
    causes: dict[str, tuple[str, str]]


_NOT_FOUND = "MSH001 MSH039 XAC011"

PROGRAMS = {
    "mujoco": Program(
        "mujoco",
        "import mujoco; mujoco.MjModel.from_xml_path(path)",
        {
            "Error opening file": ("mesh not found", _NOT_FOUND),
            "no decoder found": ("mesh format", "MSH007"),
            r"stl_decoder": ("STL that it does not load", "MSH007 MSH009 MSH019"),
            r"mesh (volume|surface)|vertices": ("mesh without volume", "MSH015 MSH009 GEO001"),
            r"A \+ B >= C": ("triangle inequality", "INE003"),
            "positive eigenvalues": ("singular inertia", "INE003 INE005"),
            "mass and inertia of moving": ("no mass or inertia", "INE001 INE004 INE005"),
            "repeated element": ("repeated element", "URD007"),
            "repeated (URDF )?name": ("repeated name", "NAM001"),
            "parent or child missing": ("unknown link", "REF001"),
            "multiple parents": ("two parents", "TRE004"),
            "body not found": ("cycle", "TRE003"),
            "missing element|required attribute": ("missing part", "URD001 URD003 URD004 GEO002"),
            "geometry specification": ("unknown shape", "URD001 URD004 GEO002"),
            r"size \d must be positive": ("size", "GEO001"),
            "bad format|enough data|too much data|problem reading": ("number", "URD005"),
            "axis too small": ("axis of length 0", "JNT006"),
            "invalid joint type": ("joint type", "JNT001"),
        },
    ),
}


class Verdict(NamedTuple):
    """What a program and urdfkit say of one robot.

    Attributes:
        robot: its file and arguments.
        refusal: the program's error; empty if it takes the robot.
        cause: of the refusal; ``other`` for one without a name here.
        is_told: True if an error of urdfkit is about the cause.
        errors: codes of the errors of urdfkit.
    """

    robot: str
    refusal: str
    cause: str
    is_told: bool
    errors: tuple[str, ...]


def has(name: str) -> bool:
    """True if a program is installed."""
    return importlib.util.find_spec(PROGRAMS[name].module.partition(".")[0]) is not None


def robots() -> list[tuple[Path, dict[str, str]]]:
    """The robots of the corpus and of the project, with their arguments."""
    corpus = [(folder / model["path"], arguments_of(model)) for folder, model in manifest()]
    own = [path for path in sorted(MODELS.rglob("*")) if path.suffix in (".urdf", ".xacro")]
    return corpus + [(path, {}) for path in own]


def verdict(name: str, path: Path, arguments: dict[str, str]) -> Verdict | None:
    """What a program and urdfkit say of one robot; None for what is no whole robot."""
    options = Options(arguments=arguments, targets=(name,)).resolved()
    subject = next(iter(engine.subjects(options, [path])), None)
    if subject is None:
        return None
    try:
        text = with_absolute_paths(subject)
    except (Unavailable, ElementTree.ParseError):
        return None
    if subject.is_part or subject.reading.missing_arguments:
        return None
    refusal = refusal_of(name, text, path.parent)
    result = run_rules(subject, rule_index.codes(), options)
    errors = {one.code for one in result.diagnostics if one.severity is Severity.ERROR}
    cause, codes = cause_of(name, refusal)
    place = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
    robot = " ".join([str(place), *(f"{key}:={value}" for key, value in arguments.items())])
    told = not errors.isdisjoint(codes)
    return Verdict(robot, refusal, cause, told, tuple(sorted(errors - OF_HANDLING)))


def with_absolute_paths(subject: Context) -> bytes:
    """The expanded URDF, with the places of the meshes that are there."""
    text = re.sub(rb"^\s*<\?xml.*?\?>", b"", subject.text)
    robot = ElementTree.fromstring(text)
    paths = {mesh.at.value: mesh.located.path for mesh in subject.files.meshes}
    for mesh in robot.iter("mesh"):
        if path := paths.get(mesh.get("filename", "")):
            mesh.set("filename", path)
    for compiler in robot.iter("compiler"):
        compiler.attrib.pop("meshdir", None)
        compiler.attrib.pop("strippath", None)
    return ElementTree.tostring(robot)


def refusal_of(name: str, text: bytes, folder: Path) -> str:
    """The error of a program for a URDF in a folder; empty if it takes it."""
    code = f"import sys; path = sys.argv[1]; {PROGRAMS[name].reads}"
    with tempfile.TemporaryDirectory() as scratch:
        urdf = Path(scratch, "robot.urdf")
        urdf.write_bytes(text)
        command = [sys.executable, "-c", code, str(urdf)]
        try:
            run = subprocess.run(
                command, check=False, cwd=folder, capture_output=True, timeout=LIMIT
            )
        except subprocess.TimeoutExpired:
            return f"no end within {LIMIT} s"
    lines = run.stderr.decode(errors="replace").strip().splitlines()
    return "" if run.returncode == 0 else " ".join(lines[-3:]) or f"exit code {run.returncode}"


def cause_of(name: str, refusal: str) -> tuple[str, set[str]]:
    """The cause of a refusal, and the rules that report it."""
    for pattern, (cause, codes) in PROGRAMS[name].causes.items():
        if re.search(pattern, refusal):
            return cause, set(codes.split())
    return ("other" if refusal else ""), set()
