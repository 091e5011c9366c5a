"""MoveIt's joint_limits.yaml names a joint that the robot does not have.

MoveIt passes over the entry without a word, and plans for the real joint with the limits of the
URDF, without any bound on its acceleration. The joint was renamed, or has a prefix there.

Sources:
    MoveIt, robot_model_loader.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/robot_model_loader/src/robot_model_loader.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.moveit.joint_limits import planned_limits
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
</joint>"""
GOOD = BAD.replace("shoulder", "elbow")
FILES = {
    "example.srdf": b'<robot name="example"/>',
    "joint_limits.yaml": b"""\
joint_limits:
  elbow:
    has_velocity_limits: true
    max_velocity: 2.0
    has_acceleration_limits: false
""",
}


@rule(
    "SRD014",
    "joint-limits-of-unknown-joint",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="correct the name, or remove the entry",
)
def check(subject: Subject) -> Iterator[Finding]:
    known = subject.model.joints_by_name
    suggester = Suggester(known)
    planned = list(planned_limits(subject))
    strange = [limit for limit in planned if limit.joint not in known]
    if len(strange) == len(planned) > 1:
        strange = strange[:1]  # of another robot altogether
    for limit in strange:
        suggested = suggester.suggested(limit.joint)
        yield Finding(
            Location(limit.at.span),
            f"limits for joint '{limit.joint}', which is not in the model",
            f"did you mean '{suggested}'?" if suggested else "",
        )
