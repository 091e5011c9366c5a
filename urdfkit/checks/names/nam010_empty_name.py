"""A link or a joint has an empty name.

urdfdom reads it, the next program does not: TF ignores a frame without a name, Drake rejects such a
link and PyBullet crashes. In a xacro the name is mostly a prefix with nothing behind it.

Sources:
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<link name=""/>'
GOOD = '<link name="base"/>'


@rule("NAM010", "empty-name", Severity.ERROR, help="give it a name")
def check(subject: Subject) -> Iterator[Finding]:
    for name in subject.model.names:
        if not name.value.strip():
            yield Finding(name, f"a {name.element.tag} has an empty name")
