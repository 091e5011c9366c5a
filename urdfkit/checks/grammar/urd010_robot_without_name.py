"""The robot has no name.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), Drake and PyBullet refuse it. Only a xacro file that
others include can do without one.

Sources:
    URDF, robot: https://wiki.ros.org/urdf/XML/robot
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = '<robot>\n  <link name="base"/>\n</robot>\n'
GOOD = BAD.replace("<robot>", '<robot name="cart">')
FIXED = BAD.replace("<robot>", '<robot name="example">')


@rule("URD010", "robot-without-name", Severity.ERROR, help='write <robot name="...">', fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    for element, *_ in subject.deviations.get("URD010", ()):
        if subject.is_part:
            return
        yield Finding(element, "<robot> has no name", fix=_fix(element))


def _fix(element: Element) -> Fix | None:
    """The name of the file without its suffixes, if a name can be that."""
    source, _, end = element.tag_at.name_span
    name = os.path.basename(source.path).partition(".")[0]
    if not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        return None
    return Fix(f'write name="{name}"', (Edit(Span(source, end, end), f' name="{name}"'),))
