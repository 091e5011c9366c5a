"""Something follows the end of the robot.

An XML document has one root element. What stands behind `</robot>` is a second robot or the rest
of an edit, and no reader gets that far: most refuse the whole file.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule, told

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = '<robot name="r"><link name="a"/></robot>\n<link name="b"/>\n'
GOOD = '<robot name="r"><link name="a"/><link name="b"/></robot>\n'


@rule(
    "XML006",
    "trailing-content",
    Severity.ERROR,
    needs=(),
    help="move it into the robot, or delete it",
)
def check(subject: Subject) -> Iterator[Finding]:
    return told(subject, "XML006")
