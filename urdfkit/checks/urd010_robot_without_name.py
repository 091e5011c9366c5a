"""The robot has no name.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), Drake and PyBullet refuse it. Only a xacro file that
others include can do without one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = '<robot>\n  <link name="base"/>\n</robot>\n'
GOOD = BAD.replace("<robot>", '<robot name="cart">')


@rule("URD010", "robot-without-name", Severity.ERROR, help='write <robot name="...">')
def check(subject: Subject) -> Iterator[Finding]:
    for element, *_ in subject.deviations.get("URD010", ()):
        if subject.is_part:
            return
        yield Finding(element, "<robot> has no name")
