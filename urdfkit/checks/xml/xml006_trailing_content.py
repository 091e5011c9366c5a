"""Something follows the end of the robot.

An XML document has one root element. What stands behind `</robot>` is a second robot or the rest of
an edit. Most readers refuse the whole file; urdfdom passes over the rest without a word, so that
the links in it are missing.

Sources:
    XML 1.0: https://www.w3.org/TR/REC-xml/
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<robot name="r"><link name="a"/></robot>\n<material name="red"/>\n'
GOOD = '<robot name="r"><link name="a"/><material name="red"/></robot>\n'


@rule(
    "XML006",
    "trailing-content",
    Severity.ERROR,
    needs=(),
    help="move it into the robot, or delete it",
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XML006")
