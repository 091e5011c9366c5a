"""A name holds a character that a program along the way does not take.

White space: Gazebo's topics, command lines and parameter names break at it, and a space at the end
is a name that nobody finds. `::` separates scopes in SDF, and Gazebo refuses it in a name. `/` in
the name of a joint that moves: ROS 1 parameters and MoveIt read it as a path. Keep to letters,
digits and `_`.

Sources:
    ROS 1, names: http://wiki.ros.org/Names
    ROS 2, names: https://design.ros2.org/articles/topic_and_service_names.html
    sdformat, Utils.cc: https://github.com/gazebosim/sdformat/blob/main/src/Utils.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<link name="base link"/>'
GOOD = '<link name="base_link"/>'


@rule(
    "NAM004",
    "illegal-character",
    Severity.WARNING,
    help="keep to letters, digits and _",
)
def check(subject: Subject) -> Iterator[Finding]:
    for name in subject.model.names:
        if name.value.isidentifier() or not name.value or is_expression(name.value):
            continue
        is_joint, is_fixed = name.element.tag == "joint", name.element.get("type") == "fixed"
        if reason := _reason(name.value, moves=is_joint and not is_fixed):
            yield Finding(
                name,
                f"{name.element.tag} '{name.value}': {reason}",
                alike=reason,
                # Nobody asks for such a joint by its name.
                severity=Severity.INFO if is_joint and is_fixed else None,
            )


def _reason(name: str, *, moves: bool) -> str | None:
    if name != name.strip():
        return "white space at an end of the name"
    if any(character.isspace() for character in name):
        return "white space in the name, at which Gazebo topics and command lines break"
    if "::" in name:
        return "'::' in the name, which Gazebo's SDF keeps for scopes"
    if moves and "/" in name:
        return "'/' in the name of a joint, which ROS parameters read as a path"
    return None
