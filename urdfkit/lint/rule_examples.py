"""Tests of the examples of rules: BAD, GOOD and FIXED.

A rule's file defines ``BAD`` and ``GOOD``, and ``FIXED`` if its findings have a fix: robots as
text, either whole or the content of ``<robot name="example">``. ``FILES`` contains the files next
to the robot, by relative path, ``FIXED_FILES`` those that fixes change, after the fixes;
``DIRECTORY`` stands for their directory. ``NAME`` is the file name of the example, by default
``example.urdf``; ``TARGETS`` are the targets to check for, by default the detected ones. The same
functions test the rules of other packages.
"""

from __future__ import annotations

import os
import re
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.context import Context
from urdfkit.lint.findings import diagnose
from urdfkit.lint.rules import Rule
from urdfkit.ros.targets import parse
from urdfkit.text.diagnostic import Diagnostic, Edit
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.lint.context import Simulate

#: Placeholder in examples for the absolute path of the robot's directory.
DIRECTORY = "/home/student/arm_description"

#: Start of an example that is the content of a robot.
_PIECE = re.compile(r"\s*<(link|joint|material|gazebo|transmission|ros2_control)\b")


def whole_robot(text: str) -> str:
    if _PIECE.match(text):
        return f'<robot name="example">\n{text}\n</robot>\n'
    return text


@contextmanager
def laid_out(rule: Rule, text: str) -> Iterator[Source]:
    """An example in a temporary directory, with the other files of its rule."""
    module = sys.modules[rule.module]
    files: Mapping[str, bytes] = getattr(module, "FILES", {})
    example = _file_name(rule)
    with tempfile.TemporaryDirectory() as directory:
        for name, data in files.items():
            path = os.path.join(directory, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(data)
        path = os.path.join(directory, example)
        os.makedirs(os.path.dirname(path), exist_ok=True)  # for names such as ../meshes/arm.stl
        robot = whole_robot(text).replace(DIRECTORY, directory)
        yield Source(path, robot.encode("utf-8", "surrogateescape"))


def targets_of(rule: Rule) -> tuple[str, ...]:
    """The targets that the examples of a rule are checked for; empty if detected from them."""
    names: tuple[str, ...] = getattr(sys.modules[rule.module], "TARGETS", ())
    return names


def context_of(rule: Rule, source: Source, simulate: Simulate | None = None) -> Context:
    names = targets_of(rule)
    targets = parse(names) if names else None
    return Context(source, Resolver(environment={}), targets=targets, simulate=simulate)


def diagnose_example(
    rule: Rule, text: str, *, simulate: Simulate | None = None
) -> list[Diagnostic]:
    """The findings of a rule in one of its examples.

    Args:
        simulate: `urdfkit.simulate`, for rules about simulations.
    """
    with laid_out(rule, text) as source:
        return diagnose(rule, list(rule.check(context_of(rule, source, simulate))))


def assert_examples(rule: Rule) -> None:
    """Fail unless BAD is reported, GOOD is not, and the fixes of BAD result in FIXED.

    Raises:
        AssertionError: with the actual and the expected result of an example.
    """
    bad, good = _example(rule, "BAD"), _example(rule, "GOOD")
    if not diagnose_example(rule, bad):
        raise AssertionError(f"{rule.code} finds nothing in BAD")
    if findings := diagnose_example(rule, good):
        raise AssertionError(f"{rule.code} finds in GOOD: {findings[0].message}")
    fixed = rule.example("FIXED")
    fixed_files: Mapping[str, bytes] = getattr(sys.modules[rule.module], "FIXED_FILES", {})
    if rule.fixable is (fixed is None and not fixed_files):
        raise AssertionError(f"{rule.code}: it takes FIXED and fixable=True, or neither of them")
    given = apply_fixes(rule, bad)
    expected = {"": whole_robot(fixed)} if fixed else {}
    expected |= {name: data.decode() for name, data in fixed_files.items()}
    if given != expected:
        raise AssertionError(f"{rule.code}: the fixes of BAD give\n{given}\nnot\n{expected}")
    if fixed and (findings := diagnose_example(rule, fixed)):
        raise AssertionError(f"{rule.code} finds in FIXED: {findings[0].message}")


def apply_fixes(rule: Rule, text: str) -> dict[str, str]:
    """The files that the fixes of an example change, by relative path; "" is the robot."""
    with laid_out(rule, text) as source:
        findings = diagnose(rule, list(rule.check(context_of(rule, source))))
        directory = source.path.removesuffix(_file_name(rule)).rstrip(os.sep)
        edits: dict[str, dict[Edit, None]] = {}
        for finding in findings:
            for edit in finding.fix.edits if finding.fix else ():
                path = edit.span.source.path
                name = "" if path == source.path else os.path.relpath(path, directory)
                edits.setdefault(name, {})[edit] = None
        return {
            name: _edited(parts).replace(directory, DIRECTORY)
            for name, parts in sorted(edits.items())
        }


def _file_name(rule: Rule) -> str:
    """The file name of an example, possibly with a directory."""
    name: str = getattr(sys.modules[rule.module], "NAME", "example.urdf")
    return name


def _edited(edits: Iterable[Edit]) -> str:
    """The text of a source after its edits."""
    edits = tuple(edits)
    return apply_edits(edits[0].span.source.data, edits).decode()


def _example(rule: Rule, which: str) -> str:
    text = rule.example(which)
    if not text:
        raise AssertionError(f"{rule.module} has no {which}")
    return text
