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

from urdfkit.diagnostic import Edit, Fix, Severity
from urdfkit.rules import Finding, rule
from urdfkit.source import Span
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.document import Element
    from urdfkit.subject import Subject

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
