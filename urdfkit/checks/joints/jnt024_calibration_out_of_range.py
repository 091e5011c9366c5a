"""The calibration mark of a joint lies outside of its limits.

`rising` and `falling` are the positions at which a sensor switches while the joint searches for
its zero. A joint never gets to a position beyond its limits, so the search runs into the stop, or
every position is off afterwards. Correct the mark or the limits.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds, unit
from urdfkit.robot.model import number
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <limit lower="-1.5" upper="1.5" effort="30" velocity="1"/>
  <calibration rising="1.8"/>
</joint>"""
GOOD = BAD.replace("1.8", "1.4")

#: Part of the range that is rounding.
_TOLERANCE = 1e-3


@rule(
    "JNT024",
    "calibration-out-of-range",
    Severity.WARNING,
    help="correct the position of the mark, or the limits",
)
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        calibration, ends = joint.at.child("calibration"), bounds(joint)
        if calibration is None or ends is None or ends[0] >= ends[1]:
            continue
        lower, upper = ends
        allowed = _TOLERANCE * (upper - lower)
        for edge in ("rising", "falling"):
            value = number(calibration.get(edge))
            if value is not None and not lower - allowed <= value <= upper + allowed:
                yield Finding(
                    calibration.attributes[edge],
                    f"joint '{joint.name}': the {edge} edge at {value:g} {unit(joint)} is not "
                    f"within its limits {lower:g} to {upper:g} {unit(joint)}",
                )
