"""A drive plugin names one joint for two wheels.

The other wheel is not driven: the robot drags it, turns when it should go straight, and its
odometry is that of another robot. Usually a line was copied and not changed.

Sources:
    gazebo_plugins, skid steer: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_skid_steer_drive.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.gazebo.drives import drive_of, driven
from urdfkit.ros.gazebo.plugins import Reference
from urdfkit.ros.gazebo.samples import WHEELED
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = (
    WHEELED
    + """\
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
    <leftJoint>left_joint</leftJoint>
    <rightJoint>left_joint</rightJoint>
    <wheelSeparation>0.3</wheelSeparation>
    <wheelDiameter>0.2</wheelDiameter>
  </plugin>
</gazebo>"""
)
GOOD = BAD.replace("<rightJoint>left", "<rightJoint>right")


@rule(
    "GAZ064",
    "wheel-driven-twice",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="name the joint of the other wheel",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        if drive_of(use) is None:
            continue
        first: dict[str, Reference] = {}
        for reference in driven(use):
            other = first.setdefault(reference.name, reference)
            if other is not reference and other.parameter.name != reference.parameter.name:
                yield Finding(
                    reference.item.at,
                    f"{use.title}: <{reference.parameter.name}> is '{reference.name}', as "
                    f"<{other.parameter.name}> is",
                    related=(Related(other.item.at.span, "and here"),),
                )
