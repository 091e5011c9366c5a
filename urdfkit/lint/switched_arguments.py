"""Values of arguments that add a part to a robot, and with which no launch file starts it.

What is in an ``<xacro:if>`` of ``$(arg use_gazebo)`` or ``${sensor == 'lidar'}`` is checked, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.plan import Job

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.text.diagnostic import Diagnostic, Problem

#: Most further values of arguments with which a robot is checked, one at a time, by the most
#: elements that the robot may have; a check of a larger one takes too long.
MAX_SWITCHED = ((1_000, 8), (5_000, 4))
#: Most sets of arguments with which a robot is started in which another value is tried.
_MAX_STARTED = 3
_BOOLEANS = ("true", "false")
# Compiled when needed: most robots have no arguments.
_CONDITION = rb"<xacro:(?:if|unless)\b[^<>]*?\bvalue\s*=\s*(?:\"([^\"]*)|'([^']*))"
#: ``sensor == 'lidar'``, ``'$(arg sensor)' == 'lidar'``
_COMPARED = r"\b(\w+)\)?[\"']?\s*==\s*[\"']([\w.-]+)[\"']"
#: A property or parameter with the value of an argument.
_PASSED = rb"(?:\bname\s*=\s*[\"'](\w+)[\"']\s+value|\b(\w+))\s*=\s*[\"']\$\(arg\s+(\w+)\)[\"']"


def switched(job: Job, started: list[tuple[Job, Context]]) -> Iterator[Job]:
    """A robot with each other value of an argument that a condition asks for.

    Args:
        job: the robot; its arguments are those of the user.
        started: the same with the sets of arguments with which it is started.
    """
    first, context = started[0]
    document, defaults = context.reading.known, context.reading.defaults
    if document is None or not defaults:
        return
    sets = [{**defaults, **variant.arguments} for variant, _ in started]
    conditions = _conditions(context)
    names = [name for name in defaults if name in conditions and name not in job.arguments]
    others = [
        (first.arguments, name, value)
        for name in names
        for value in _others({arguments[name] for arguments in sets}, conditions[name])
    ]
    # A part may need two arguments, such as the simulation and the camera.
    others += [
        (arguments, name, value)
        for arguments in sets[1:_MAX_STARTED]
        for name in names
        for value in _others({arguments[name]}, conditions[name])
        if {**arguments, name: value} not in sets
    ]
    elements = sum(1 for _ in document.root.walk()) if others else 0
    count = next((count for most, count in MAX_SWITCHED if elements <= most), 0)
    for base, name, value in others[:count]:
        arguments = {**base, name: value}
        yield first._replace(arguments=arguments, may_fail=True, switched=f"{name}={value}")


def is_wrong_call(problem: Problem | Diagnostic) -> bool:
    """True for a call of a macro with other parameters than it has, with whatever values."""
    if problem.code != "XAC001":
        return False
    from urdfkit.xacro.errors import CALLED_WITHOUT, NO_PARAMETER

    wrong_call = rf"macro '[^']*' (?:{NO_PARAMETER}|{CALLED_WITHOUT}) "
    return re.match(wrong_call, problem.message) is not None


def switched_launches(job: Job) -> Iterator[Job]:
    """A launch file with each other value of an argument that it offers, or compares with."""
    if job.source is None or job.arguments or job.codes:
        return
    from urdfkit.ros.launch.alternatives import alternatives

    for name, value in alternatives(job.source):
        yield job._replace(arguments={name: value}, switched=f"{name}={value}")


def _others(known: set[str], compared: Iterable[str]) -> list[str]:
    """The values that are not known: the other boolean, or those of comparisons."""
    booleans = {value.lower() for value in known}
    if booleans.issubset(_BOOLEANS):
        return [value for value in _BOOLEANS if value not in booleans]
    return [value for value in compared if value not in known]


def _conditions(context: Context) -> dict[str, list[str]]:
    """The values with which conditions compare a name, by each name in them.

    The name of an argument is in those of properties and parameters that have its value.
    """
    assert context.reading.xacro is not None, "only a xacro has arguments"
    values: dict[str, list[str]] = {}
    passed: list[tuple[str, str]] = []
    for source in context.reading.xacro.sources:
        for match in re.findall(_CONDITION, source.data):
            text = b"".join(match).decode("utf-8", "replace")
            for name in re.findall(r"\w+", text):
                values.setdefault(name, [])
            for name, value in re.findall(_COMPARED, text):
                values[name].append(value)
        for one, other, argument in re.findall(_PASSED, source.data):
            passed.append((argument.decode(), (one or other).decode()))
    for argument, name in passed:
        if name in values and name != argument:
            values.setdefault(argument, []).extend(values[name])
    return {name: list(dict.fromkeys(compared)) for name, compared in values.items()}
