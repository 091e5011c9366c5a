"""A prismatic joint travels many times the length of the robot.

Its limits are metres. A gripper that opens by 30 m was meant to open by 30 mm: it flies apart in
the simulator, and MoveIt plans through the wall.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds
from urdfkit.text.diagnostic import Confidence, Fix, Severity
from urdfkit.text.editing.edits import scale_limits

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="palm">
  <visual>
    <geometry><box size="0.1 0.1 0.05"/></geometry>
  </visual>
</link>
<link name="finger"/>
<joint name="slide" type="prismatic">
  <parent link="palm"/>
  <child link="finger"/>
  <axis xyz="1 0 0"/>
  <limit lower="0" upper="30" effort="10" velocity="0.1"/>
</joint>"""
FIXED = GOOD = BAD.replace('"30"', '"0.03"')

#: Times the length of the longest part of the robot; and in m.
_TIMES = 20.0
_LEAST = 5.0


@rule(
    "JNT038",
    "travel-looks-like-millimetres",
    Severity.WARNING,
    help="divide by 1000: lengths are metres",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    model = subject.model
    suspects = [
        (joint, ends)
        for joint in model.joints
        if joint.kind == "prismatic"
        and (ends := bounds(joint))
        and _LEAST <= max(map(abs, ends)) <= 10_000
        and all(end == int(end) for end in ends)
    ]
    if not suspects or any(shape.filename for shape in model.shapes):
        return
    sizes = [2 * max(half) for shape in model.shapes if (half := shape.half_extents)]
    origins = [max(map(abs, joint.origin.position)) for joint in model.joints]
    longest = max((*sizes, *origins), default=0.0)
    for joint, (lower, upper) in suspects:
        if longest and max(abs(lower), abs(upper)) > _TIMES * longest and joint.limit:
            yield Finding(
                joint.limit.at,
                f"joint '{joint.name}' may slide from {lower:g} to {upper:g} m, and no part of the "
                f"robot is longer than {longest:.3g} m",
                fix=Fix.of("write the limits in metres", scale_limits(joint.limit.at, 1e-3)),
                confidence=Confidence.INFERRED,
            )
