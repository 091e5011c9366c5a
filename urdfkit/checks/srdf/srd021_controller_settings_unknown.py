"""MoveIt's controllers name a joint that the robot does not have, or one another wrongly.

MoveIt finds no controller for the joints that it has planned: "Unable to identify any set of
controllers that can actuate the specified joints". Read are `moveit_controllers.yaml`, its
forerunners of ROS 1, and `initial_positions.yaml`.

Sources:
    MoveIt, controllers: https://moveit.picknik.ai/main/doc/examples/controller_configuration/controller_configuration_tutorial.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.moveit.config import joint_entries, names_without_settings
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
    "moveit_controllers.yaml": b"""\
moveit_simple_controller_manager:
  controller_names:
    - arm_controller
  arm_controller:
    type: FollowJointTrajectory
    joints:
      - elbow
""",
}


@rule(
    "SRD021",
    "controller-settings-unknown",
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="correct the name",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    known = srdf.known("joint")
    named = list(joint_entries(srdf, subject.resolver))
    strange = [(who, joint) for who, joint in named if joint.text not in known]
    if 2 * len(strange) > len(named) > 2:
        strange = []  # of another robot, or of another variant of this one
    for who, joint in strange:
        message = f"{who} names joint '{joint.text}', which is not in the model"
        yield Finding(Location(joint.span), f"{message}{did_you_mean(joint.text, known)}")
    for name, others in names_without_settings(srdf, subject.resolver):
        message = f"controller '{name.text}' has no settings{did_you_mean(name.text, others)}"
        yield Finding(Location(name.span), message)
