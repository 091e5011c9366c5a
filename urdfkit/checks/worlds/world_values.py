"""Values in a world that SDF rejects or reads otherwise, and meshes that do not exist.

Sources: ``sdf/1.5`` to ``sdf/1.12`` and ``Param.cc`` of sdformat: a vector ends at its last number,
and a number at the first other character; ``Root.cc``: a world with an error is not loaded.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.checks.worlds.opened_worlds import OpenedWorld
from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.values import leading
from urdfkit.ros.gazebo.worlds import Models, World
from urdfkit.text.document import Element
from urdfkit.workspace.gitignore import is_ignored
from urdfkit.workspace.resolve import Resolver

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
            if not text or child.children or _is_generated(text):
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
    if choices and kind and kind not in choices and not _is_generated(kind):
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


def _is_generated(text: str) -> bool:
    return any(mark in text for mark in _TEMPLATE_MARKS)


def _form(kind: str) -> str:
    return {"pose": "x y z roll pitch yaw", "vector2d": "x y"}.get(kind, "x y z")


def missing_meshes(opened: OpenedWorld, world: World, models: Models, context: Context) -> Findings:
    """Meshes of models and packages of the workspace that do not exist."""
    for element in world.elements:
        uri = element.child("uri") if element.tag == "mesh" else None
        text = uri.text.strip() if uri is not None else ""
        if uri is None or not text or _is_generated(text):
            continue
        if _is_missing(text, opened.path, models, context.resolver):
            yield Finding(
                uri,
                f"{opened.title}: mesh '{text}' is not found",
                "fix the path, or add the file",
                group_key="missing mesh",
                severity=Severity.WARNING,
            )


def _is_missing(uri: str, world: str, models: Models, resolver: Resolver) -> bool:
    """False for models and packages of others, which the robot's computer may have."""
    scheme, _, path = uri.rpartition("://")
    if not scheme and not os.path.isabs(uri):
        return not _exists(f"{os.path.dirname(world)}/{uri}")
    owner, _, file = path.partition("/")
    directories = models.directories.get(owner, []) if scheme == "model" else []
    is_own = directories or any(True for _ in resolver.packages.candidates(owner, world))
    if scheme not in ("model", "package") or not file or not is_own:
        return False
    is_found = resolver.locate(uri, world).path is not None
    return not is_found and not any(_exists(f"{directory}/{file}") for directory in directories)


def _exists(path: str) -> bool:
    """True for files that Git ignores, too, which are made by a build."""
    return disk.is_file(path) or is_ignored(path)
