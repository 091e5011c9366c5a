"""Values in a world that SDF rejects or reads otherwise.

Sources: ``sdf/1.5`` to ``sdf/1.12`` and ``Param.cc`` of sdformat: a vector ends at its last number,
and a number at the first other character; ``Root.cc``: a world with an error is not loaded.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.worlds.opened_worlds import OpenedWorld
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.values import leading
from urdfkit.ros.gazebo.worlds import World
from urdfkit.text.document import Element

_COUNTS = {"pose": 6, "vector2d": 2, "vector3": 3}
_NAMED = ("model", "link", "joint", "collision", "visual", "light", "sensor")
#: Characters of values that a template replaces.
_TEMPLATE_MARKS = ("$", "{", "<")


def invalid_values(opened: OpenedWorld, world: World) -> Findings:
    """Values of another type than that of SDF, unknown types, and missing names."""
    known: dict[str, str] = data("worlds")["children"]
    types = {
        name: kind for kind, names in data("worlds")["types"].items() for name in names.split()
    }
    for element in world.elements:
        for message, help in _wrong_attributes(element):
            yield Finding(element, f"{opened.title}: {message}", help)
        for child in element.children if element.tag in known else ():
            kind = types.get(child.tag) or types.get(f"{element.tag}/{child.tag}", "")
            text = child.text.strip()
            if not text or child.children or is_generated(text):
                continue
            if problem := _problem(kind, text, child):
                severity, message, help = problem
                message = f"{opened.title}: <{child.tag}> is '{text}', {message}"
                yield Finding(child, message, help, severity=severity)


def _wrong_attributes(element: Element) -> Iterator[tuple[str, str]]:
    # A text alone is the name of another element, as in <contact><collision>.
    is_reference = bool(element.text.strip()) and not element.children
    if element.tag in _NAMED and not element.get("name") and not is_reference:
        yield f"<{element.tag}> has no name, which SDF requires", 'write name="..."'
    choices = data("worlds")["choices"].get(element.tag, "").split()
    kind = element.get("type")
    if choices and kind and kind not in choices and not is_generated(kind):
        hint = did_you_mean(kind, choices)
        yield f"unknown type '{kind}' of <{element.tag}>{hint}", f"write {', '.join(choices)}"


def _problem(kind: str, text: str, at: Element) -> tuple[Severity | None, str, str] | None:
    """Severity, message and help for a value of a type; None if it is valid."""
    if kind in _COUNTS:
        count, given = _COUNTS[kind], len(text.split())
        is_pose = kind == "pose"
        if is_pose and (at.get("rotation_format") or at.get("degrees")):
            return None
        if given < count or (is_pose and given > count) or numbers(text) is None:
            return None, f"must be {count} numbers: SDF rejects it", "write " + _form(kind)
    elif kind == "color":
        values = numbers(text) or ()
        if len(values) not in (3, 4) or not all(0 <= value <= 1 for value in values):
            return None, "must be 3 or 4 numbers from 0 to 1: SDF rejects it", "write r g b a"
    elif kind == "bool" and text.lower() not in ("true", "false", "1", "0"):
        return None, "must be true or false: SDF rejects it", "write true or false"
    elif kind in ("double", "int") and number(text) is None:
        read, rest = leading(text, whole=kind == "int")
        if not read:
            return None, "must be a number: SDF rejects it", "write a number"
        if rest:
            return Severity.WARNING, f"and is read as {read}", f"write {read}, without '{rest}'"
    return None


def is_generated(text: str) -> bool:
    """True for a text that a template replaces."""
    return any(mark in text for mark in _TEMPLATE_MARKS)


def _form(kind: str) -> str:
    return {"pose": "x y z roll pitch yaw", "vector2d": "x y"}.get(kind, "x y z")
