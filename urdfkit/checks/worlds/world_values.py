"""Values in a world that SDF rejects or reads otherwise.

Sources: ``sdf/1.5`` to ``sdf/1.12`` and ``Param.cc`` of sdformat: a vector ends at its last number,
and a number, also in a pose or a colour, at the first other character; sdformat 9, of Gazebo
Classic, reads a vector, a pose or a colour as far as it can. ``Root.cc``: a world with an error is
not loaded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from urdfkit.checks.worlds.opened_worlds import OpenedWorld
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.values import leading
from urdfkit.ros.gazebo.worlds import World
from urdfkit.ros.launch.worlds import CLASSIC
from urdfkit.text.document import Element

_COUNTS = {"pose": 6, "vector2d": 2, "vector3": 3}
_NAMED = ("model", "link", "joint", "collision", "visual", "light", "sensor")
#: Characters of values that a template replaces.
_TEMPLATE_MARKS = ("$", "{", "<")
_REJECTED = "SDF rejects it"
#: Kinds of values whose errors Gazebo Classic does not notice.
_UNCHECKED = (*_COUNTS, "color")


def invalid_values(opened: OpenedWorld, world: World) -> Findings:
    """Values of another type than that of SDF, unknown types, and missing names."""
    known: dict[str, str] = data("worlds")["children"]
    types = {
        name: kind for kind, names in data("worlds")["types"].items() for name in names.split()
    }
    is_classic = opened.started.generation == CLASSIC
    for element in world.elements:
        for message, help in _wrong_attributes(element):
            yield Finding(element, f"{opened.title}: {message}", help)
        for child in element.children if element.tag in known else ():
            kind = types.get(child.tag) or types.get(f"{element.tag}/{child.tag}", "")
            text = child.text.strip()
            if not text or child.children or is_generated(text):
                continue
            if problem := _problem(kind, text, child, numbers if is_classic else _tokens):
                severity, message, help = problem
                if is_classic and kind in _UNCHECKED:
                    severity = Severity.WARNING
                    message = message.replace(_REJECTED, "Gazebo Classic reads the rest as 0")
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


def _problem(
    kind: str, text: str, at: Element, read: Callable[[str], Sequence[float] | None]
) -> tuple[Severity | None, str, str] | None:
    """Severity, message and help for a value of a type; None if it is valid.

    Args:
        read: gives the numbers of a pose or a colour.
    """
    if kind in _COUNTS or kind == "color":
        return _of_numbers(kind, text, at, read)
    if kind == "bool" and text.lower() not in ("true", "false", "1", "0"):
        return None, f"must be true or false: {_REJECTED}", "write true or false"
    if kind in ("double", "int") and number(text) is None:
        first, rest = leading(text, whole=kind == "int")
        if not first:
            return None, f"must be a number: {_REJECTED}", "write a number"
        if rest:
            return Severity.WARNING, f"and is read as {first}", f"write {first}, without '{rest}'"
    return None


def _of_numbers(
    kind: str, text: str, at: Element, read: Callable[[str], Sequence[float] | None]
) -> tuple[Severity | None, str, str] | None:
    """The problem of a vector, a pose or a colour."""
    if kind == "pose" and (at.get("rotation_format") or at.get("degrees")):
        return None
    is_read_by_words = kind in ("pose", "color")
    values = read(text) if is_read_by_words else numbers(text)
    if kind == "color":
        bound, help = "3 or 4 numbers from 0 to 1", "write r g b a"
        is_right = values and len(values) in (3, 4) and all(0 <= value <= 1 for value in values)
    else:
        count = _COUNTS[kind]
        bound, help = f"{count} numbers", "write " + _form(kind)
        is_right = values and (len(values) == count or (kind != "pose" and len(values) > count))
    if not is_right:
        return None, f"must be {bound}: {_REJECTED}", help
    if is_read_by_words and _has_other_characters(text):
        return Severity.WARNING, "of which only numbers are read", help
    return None


def _tokens(text: str) -> Sequence[float] | None:
    """The numbers at which the words of a text begin; None if one does not begin with a number."""
    return numbers(" ".join(leading(word)[0] or "?" for word in text.split()))


def _has_other_characters(text: str) -> bool:
    """True if a word has more than a number and a comma, such as a decimal comma."""
    return any(leading(word)[1].strip(",") for word in text.split())


def is_generated(text: str) -> bool:
    """True for a text that a template replaces."""
    return any(mark in text for mark in _TEMPLATE_MARKS)


def _form(kind: str) -> str:
    return {"pose": "x y z roll pitch yaw", "vector2d": "x y"}.get(kind, "x y z")
