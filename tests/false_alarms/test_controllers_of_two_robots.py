"""RCT001: two robots share a parameter file, and each starts the controller with its joints."""

from pathlib import Path

import pytest

from tests.jointed import joint, limit, robot
from tests.launched import MANIFEST, launch
from tests.workspaces import add_files
from urdfkit import check

_CONTROLLER = """\
{0}:
  ros__parameters:
    type: joint_trajectory_controller/JointTrajectoryController
    joints: [{1}]
"""
_MANAGER = """\
<node pkg="controller_manager" exec="ros2_control_node">
  <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/{0}.urdf')"/>
  <param from="$(find-pkg-share arm)/config/controllers.yaml"/>
</node>
<node pkg="controller_manager" exec="spawner" args="{1}"/>
"""


def _robot(name: str, *joints: str) -> str:
    moving = (joint(one, "revolute", limit("-1", "1", "1", "1")) for one in joints)
    return f'<robot name="{name}">{robot(*moving)}</robot>'


@pytest.mark.parametrize(
    ("started", "count"), [("motor_controller", 0), ("arm_controller", 1), ("", 1)]
)
def test_the_joints_of_the_other_robot(tmp_path: Path, started: str, count: int) -> None:
    """A test of one motor with the joint `joint1` next to an arm with `Joint1` and `Joint2`."""
    files = {
        "package.xml": MANIFEST,
        "arm.urdf": _robot("arm", "Joint1", "Joint2"),
        "motor.urdf": _robot("motor", "joint1"),
        "config/controllers.yaml": _CONTROLLER.format("arm_controller", "Joint1, Joint2")
        + _CONTROLLER.format("motor_controller", "joint1"),
        "launch/arm.launch.xml": launch(_MANAGER.format("arm", "arm_controller")),
    }
    if started:
        files["launch/motor.launch.xml"] = launch(_MANAGER.format("motor", started))
    add_files(tmp_path / "arm", files)
    found = check(tmp_path / "arm", select=["RCT001"]).diagnostics
    assert len(found) == count
