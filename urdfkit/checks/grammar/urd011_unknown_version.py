"""The robot asks for a version of URDF that does not exist.

`version` is that of the format, not that of your robot, and has the form `1.0`. urdfdom (RViz,
MoveIt, Gazebo, Pinocchio) refuses the robot with any other text. Without the attribute it is 1.0.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.schema import VERSIONS

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<robot name="cart" version="2.3">\n  <link name="base"/>\n</robot>\n'
GOOD = BAD.replace(' version="2.3"', "")
FIXED = BAD.replace("2.3", "1.0")


@rule(
    "URD011",
    "unknown-version",
    Severity.ERROR,
    help='leave it out, or write version="1.0"',
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for _, attribute, *_ in subject.deviations.get("URD011", ()):
        assert attribute is not None
        known = ", ".join(VERSIONS)
        edits = replace_value(attribute, VERSIONS[0])
        yield Finding(
            attribute,
            f"version '{attribute.value}' of URDF does not exist; {known} do",
            fix=Fix.of(f'write version="{VERSIONS[0]}"', edits),
        )
