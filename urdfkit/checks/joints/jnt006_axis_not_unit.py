"""The axis of a joint is not one long.

URDF wants a unit vector. Gazebo, MuJoCo, Drake, MoveIt and KDL make it one and go on; viewers that
do not, move a prismatic joint too far by the same factor. More often it shows a slip: angles or a
position where a direction was meant, or a component too many.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    kdl_parser: https://github.com/ros/kdl_parser/blob/noetic-devel/kdl_parser/src/kdl_parser.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import MOVING
from urdfkit.robot.model import length
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.core.spatial import Vector
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Placed

BAD = """\
<link name="base"/>
<link name="drawer"/>
<joint name="slide" type="prismatic">
  <parent link="base"/>
  <child link="drawer"/>
  <axis xyz="0 3 4"/>
  <limit lower="0" upper="0.5" effort="100" velocity="1"/>
</joint>"""
GOOD = BAD.replace("0 3 4", "0 0.6 0.8")
FIXED = GOOD

#: A direction rounded to two decimals, such as 0.71 0.71 0, is nearer to 1 than this.
_TOLERANCE = 0.01

#: Shorter axes are JNT005's.
_TINY = 1e-6


@rule(
    "JNT006",
    "axis-not-unit",
    Severity.WARNING,
    help="write a vector of length 1 in the direction of the axis",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        if joint.axis is None or joint.kind not in (*MOVING, "planar"):
            continue
        norm = length(joint.axis.value)
        if norm >= _TINY and abs(norm - 1) > _TOLERANCE:
            text = " ".join(f"{value:g}" for value in joint.axis.value)
            yield Finding(
                joint.axis,
                f"joint '{joint.name}': the axis {text} has length {norm:.4g}, not 1",
                fix=_normalized(joint.axis, norm),
            )


def _normalized(axis: Placed[Vector], norm: float) -> Fix | None:
    assert isinstance(axis.at, Attribute)
    value = " ".join(f"{part / norm + 0.0:.10g}" for part in axis.value)  # + 0.0: no -0
    edits = replace_value(axis.at, value)
    return Fix.of(f'write xyz="{value}"', edits)
