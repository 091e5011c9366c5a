"""A value in MoveIt's joint_limits.yaml is none that MoveIt can use.

ROS 2 types parameters, and the limits are declared as `double`: a whole number stops move_group
("parameter ... has invalid type: expected [double] got [integer]"). A greatest velocity or
acceleration that is not above zero leaves nothing to plan with; a decimal comma makes a text.

Sources:
    MoveIt, joint limits: https://moveit.picknik.ai/main/doc/examples/time_parameterization/time_parameterization_tutorial.html
    moveit2, robot_model_loader.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/robot_model_loader/src/robot_model_loader.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.moveit.joint_limits import planned_limits
from urdfkit.ros.parameter_types import is_not_positive, type_of
from urdfkit.text.diagnostic import Severity
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.manifest import manifest_of

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
  shoulder:
    has_velocity_limits: true
    max_velocity: 2,5
""",
}

#: Limits, each with the switch that turns it on.
_LIMITS = {
    "min_position": "has_position_limits",
    "max_position": "has_position_limits",
    "max_velocity": "has_velocity_limits",
    "max_acceleration": "has_acceleration_limits",
    "max_jerk": "has_jerk_limits",
}
_POSITIVE = ("max_velocity", "max_acceleration", "max_jerk")


@rule("SRD022", "joint-limit-refused", Severity.ERROR, needs=(Need.MODEL, Need.SRDF))
def check(subject: Subject) -> Iterator[Finding]:
    known = subject.model.joints_by_name
    for limit in planned_limits(subject):
        for name, switch in _LIMITS.items() if limit.joint in known else ():
            value = limit.values.get(name) if limit.is_on(switch) else None
            if value is not None and (reported := _wrong(name, value, _ros(subject))):
                message, help = reported
                yield Finding(Location(value.span), f"joint '{limit.joint}': {message}", help)


def _ros(subject: Subject) -> int | None:
    """The ROS of the SRDF's package, else of the robot's."""
    places = (subject.srdf.path if subject.srdf else "", subject.source.path)
    manifests = (manifest_of(subject.resolver, place) for place in places if place)
    return next((manifest.ros for manifest in manifests if manifest), None)


def _wrong(name: str, value: Value, ros: int | None) -> tuple[str, str] | None:
    kind = type_of(value)
    if kind in ("string", "bool"):
        return f"{name} is '{value.text}', and must be a number", "write a number"
    if kind == "int" and ros == 2:
        message = f"{name} is {value.text}, a whole number, and MoveIt 2 wants a point in it"
        return message, f"write {value.text}.0"
    if name in _POSITIVE and is_not_positive(value):
        return f"{name} is {value.text}, and must be above 0", ""
    return None
