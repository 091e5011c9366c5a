"""SRD004, SRD015: MoveIt's files are for the revision of the robot that launch files start."""

from pathlib import Path

import pytest

from tests.jointed import joint, limit, robot
from tests.launched import reported
from tests.workspaces import add_file, add_package
from urdfkit import check

SRDF = """<robot name="hand"><group name="g"><joint name="finger"/></group>
<group_state name="open" group="g"><joint name="finger" value="-1.5"/></group_state></robot>"""
LIMITS = "joint_limits:\n  finger: {has_position_limits: true, min_position: -1.57}\n"
PARAM = '<param name="robot_description" textfile="$(find arm)/rev2/hand.urdf"/>'


@pytest.mark.parametrize(
    ("name", "lower", "count"), [("hand", "-1.57", 0), ("hand", "-1", 2), ("arm", "-1.57", 2)]
)
def test_the_started_revision_has_the_limit(
    tmp_path: Path, name: str, lower: str, count: int
) -> None:
    """robotis_hand: both revisions of the hand have the robot's name; rev2 is started."""

    def revision(robot_name: str, lower: str) -> bytes:
        moving = joint("finger", "revolute", limit(lower, "1.57", "1", "1"))
        return f'<robot name="{robot_name}">{robot(moving)}</robot>'.encode()

    package = tmp_path / "hand"
    add_file(package / "rev1" / "hand.urdf", revision("hand", "0"))
    add_file(package / "rev2" / "hand.urdf", revision(name, lower))
    files = {"config/hand.srdf": SRDF, "config/joint_limits.yaml": LIMITS}
    reported(package, "SRD004", "a.launch", PARAM, files)
    report = check(package / "rev1" / "hand.urdf", select=["SRD004", "SRD015"])
    assert len(report.diagnostics) == count


@pytest.mark.parametrize(("named", "count"), [("leg", 0), ("arm", 1)])
def test_the_robot_of_a_package_that_is_absent(tmp_path: Path, named: str, count: int) -> None:
    """z1_ros: the assistant and the launch files name a robot of another repository."""
    (tmp_path / "LICENSE").touch()
    add_file(
        add_package(tmp_path / "arm", "arm") / "urdf" / "r.urdf",
        f'<robot name="r">{robot(joint("a", "fixed"), joint("b", "fixed"))}</robot>',
    )
    moveit = add_package(tmp_path / "arm_moveit_config", "arm_moveit_config")
    setup = "moveit_setup_assistant_config:\n  URDF:\n    package: leg\n    relative_path: r.urdf\n"
    launch = f'<launch><param name="r" command="xacro $(find {named})/r.urdf"/></launch>'
    group = '<group name="g"><link name="gripper"/><joint name="a"/><joint name="b"/></group>'
    disabled = '<disable_collisions link1="gripper" link2="base" reason="Never"/>'
    add_file(moveit / ".setup_assistant", setup)
    add_file(moveit / "launch" / "planning_context.launch", launch)
    add_file(moveit / "config" / "r.srdf", f'<robot name="r">{group}{disabled}</robot>')
    codes = {one.code for one in check(tmp_path, select=["SRD001"]).diagnostics}
    assert len(codes) == count
