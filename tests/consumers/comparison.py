"""What programs make of real robots, next to what ``--target NAME`` says of them.

A robot is given to a program expanded, with the absolute paths of its meshes: where a program
looks for meshes is a question of its own.
"""

import re
from itertools import chain
from math import dist, isclose
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from tests.conftest import CORPUS, MODELS, ROOT, manifest
from tests.consumers.reading import Reading, oracle, read
from urdfkit.errors import Unavailable
from urdfkit.lint import engine, rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.lint.rules import Need
from urdfkit.lint.runner import run_rules
from urdfkit.text.diagnostic import Severity

#: Reported of how a robot is given: absolute paths answer the one, an argument of xacro the other.
OF_HANDLING = frozenset(("MSH039", "XAC020"))

#: A package that a robot may have, and this machine does not: no error of the robot.
NOT_HERE = "XAC011"

#: What rules need that report no errors about a program, and take most of the time.
_SLOW = frozenset((Need.COLLISIONS,))

#: In m: some programs compute with 32 bits.
_NEAR = 1e-4

#: A robot, and its arguments.
Robot = tuple[Path, dict[str, str]]


class Verdict(NamedTuple):
    """What a program and urdfkit say of one robot.

    Attributes:
        refusal: the program's error; empty if it takes the robot.
        cause: of the refusal; ``other`` for one without a name here.
        told: codes of the errors of urdfkit about the cause, and of what only this machine lacks.
        errors: codes of all errors of urdfkit.
        differences: of the program's masses and frames from those that are written.
    """

    refusal: str = ""
    cause: str = ""
    told: tuple[str, ...] = ()
    errors: tuple[str, ...] = ()
    differences: str = ""

    def __str__(self) -> str:
        if self.refusal:
            return f"refused: {self.cause} ({' '.join(self.told) or 'not told'})"
        errors = f"error {' '.join(self.errors)}" if self.errors else ""
        return "; ".join(filter(None, ("taken", errors, self.differences)))


def robots() -> list[Robot]:
    """The robots of the corpus and of the project, with their arguments."""
    corpus = [(robot.path, robot.arguments) for robot in manifest()]
    own = [path for path in sorted(MODELS.rglob("*")) if path.suffix in (".urdf", ".xacro")]
    return corpus + [(path, {}) for path in own]


def label(robot: Robot) -> str:
    """The file of a robot, seen from the checkout or the corpus, and its arguments."""
    path, arguments = robot
    place = path.relative_to(CORPUS if path.is_relative_to(CORPUS) else ROOT)
    return " ".join([str(place), *(f"{key}:={value}" for key, value in arguments.items())])


def verdict(name: str, robot: Robot) -> Verdict | None:
    """What a program and urdfkit say of one robot; None for what is no whole robot."""
    path, arguments = robot
    options = Options(arguments=arguments, targets=(name,), only_errors=_SLOW).resolved()
    context = next(iter(engine.contexts(options, [path])), None)
    if context is None:
        return None
    try:
        text = with_absolute_paths(context)
    except (Unavailable, ElementTree.ParseError):
        return None
    if context.is_part or context.reading.missing_arguments:
        return None
    result = run_rules(context, rule_index.codes(), options)
    found = {one.code for one in result.diagnostics if one.severity is Severity.ERROR}
    errors = tuple(sorted(found - OF_HANDLING))
    reading = read(name, text, path.parent)
    if isinstance(reading, str):
        cause, codes = cause_of(name, reading)
        lacking = {one.code for one in result.diagnostics if one.code == NOT_HERE}
        return Verdict(reading, cause, tuple(sorted((found | lacking) & codes)), errors)
    return Verdict(errors=errors, differences="; ".join(_differences(context, reading)))


def with_absolute_paths(context: Context) -> bytes:
    """The expanded URDF, with the places of the meshes that are there, and its declaration."""
    declared = re.match(rb"\s*<\?xml.*?\?>", context.text)
    declaration = declared.group() if declared else b""
    robot = ElementTree.fromstring(context.text[len(declaration) :])
    paths = {mesh.at.value: mesh.located.path for mesh in context.files.meshes}
    for mesh in robot.iter("mesh"):
        if path := paths.get(mesh.get("filename", "")):
            mesh.set("filename", path)
    for compiler in robot.iter("compiler"):
        compiler.attrib.pop("meshdir", None)
        compiler.attrib.pop("strippath", None)
    return declaration + ElementTree.tostring(robot)


def cause_of(name: str, refusal: str) -> tuple[str, set[str]]:
    """The cause of a refusal, and the rules that report it."""
    for pattern, (cause, codes) in oracle(name).CAUSES.items():
        if re.search(pattern, refusal):
            return cause, set(codes.split())
    return "other", set()


def _differences(context: Context, reading: Reading) -> list[str]:
    """How the program's robot differs from the written one."""
    found = []
    mass = sum(link.mass or 0.0 for link in context.model.links)
    if not isclose(reading.mass, mass, rel_tol=1e-5, abs_tol=1e-9):
        found.append(f"mass {reading.mass:.6g} kg, written {mass:.6g} kg")
    moved = [
        name
        for name, place in context.tree.frames.items()
        if (frame := reading.frames.get(name))
        and dist(frame, (*place.position, *chain(*place.rotation))) > _NEAR
    ]
    if moved:
        found.append(f"frames moved: {len(moved)}")
    return found
