"""MoveIt plans with wider limits than the robot has.

What joint_limits.yaml says wins over the URDF. MoveIt then plans motions that the robot cannot
follow: controllers abort with a path tolerance, or the hardware stops. The limits of the URDF were
lowered and the file was forgotten, or the other way round.

Sources:
    MoveIt, robot_model_loader.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/robot_model_loader/src/robot_model_loader.cpp
    MoveIt, time parameterization: https://github.com/moveit/moveit2/blob/main/moveit_core/trajectory_processing/src/time_optimal_trajectory_generation.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.robot.joints import bounds, unit
from urdfkit.ros.moveit.joint_limits import PlannedLimit, planned_limits
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

#: Relative; people round to three digits.
TOLERANCE = 0.01

BAD = """\
<link name="column"/>
<link name="carriage"/>
<joint name="lift" type="prismatic">
  <parent link="column"/>
  <child link="carriage"/>
  <limit lower="0.1" upper="0.9" effort="500" velocity="0.1"/>
</joint>"""
GOOD = BAD.replace('velocity="0.1"', 'velocity="0.2"')
FILES = {
    "example.srdf": b'<robot name="example"/>',
    "joint_limits.yaml": b"""\
joint_limits:
  lift:
    has_velocity_limits: true
    max_velocity: 0.2
""",
}


@rule(
    "SRD015",
    "joint-limits-wider-than-robot",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="make the narrower of the two the limit in both files",
)
def check(subject: Subject) -> Iterator[Finding]:
    for planned in planned_limits(subject):
        joint = subject.model.joints_by_name.get(planned.joint)
        for name, said, allowed, measure in _compared(planned, joint) if joint else ():
            if _is_wider(name, said, allowed):
                assert joint is not None
                limit = joint.limit
                yield Finding(
                    Location(planned.values[name].span),
                    f"joint '{joint.name}': MoveIt plans with {name} {said:g} {measure}, the "
                    f"robot allows {allowed:g} {measure}",
                    related=(Related(limit.at.span, "the robot's limit"),) if limit else (),
                )


def _compared(planned: PlannedLimit, joint: Joint) -> Iterator[tuple[str, float, float, str]]:
    """Name, value there, value in the URDF, and unit of each bound that both have."""
    velocity = planned.bound("max_velocity", "has_velocity_limits")
    limit = joint.limit
    if velocity is not None and limit and limit.velocity and limit.velocity.value > 0:
        yield "max_velocity", velocity, limit.velocity.value, f"{unit(joint)}/s"
    for name, allowed in zip(("min_position", "max_position"), bounds(joint) or (), strict=False):
        position = planned.bound(name, "has_position_limits")
        if position is not None:
            yield name, position, allowed, unit(joint)


def _is_wider(name: str, said: float, allowed: float) -> bool:
    beyond = allowed - said if name.startswith("min") else said - allowed
    return beyond > TOLERANCE * max(abs(allowed), 0.01)
