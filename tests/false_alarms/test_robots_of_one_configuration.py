"""SRD026: two robots of one package share the YAML files of MoveIt, which are for both."""

from pathlib import Path

import pytest

from tests.jointed import joint, limit
from tests.jointed import robot as joined
from tests.workspaces import add_file
from urdfkit import check

LIMITS = "joint_limits:\n  a: {has_acceleration_limits: false}\n  NAME: {max_velocity: 1}\n"
POSITIONS = "initial_positions:\n  a: 0\n  NAME: 0\n"
SOLVERS = "GROUP: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}\n"


def _write(directory: Path, name: str, *joints: str, group: str) -> Path:
    """A robot with some joints, and its SRDF."""
    moving = (joint(one, "revolute", limit("-1", "1", "1", "1")) for one in joints)
    text = f'<robot name="{name}">{joined(*moving)}</robot>'
    named = "".join(f'<joint name="{one}"/>' for one in joints[:1])
    srdf = f'<robot name="{name}"><group name="{group}">{named}</group></robot>'
    add_file(directory / f"{name}.srdf", srdf.encode())
    return add_file(directory / f"{name}.urdf", text.encode())


@pytest.mark.parametrize(
    ("name", "group", "count"), [("finger", "hand", 0), ("fingr", "hand", 2), ("finger", "had", 1)]
)
def test_names_of_the_other_robot(tmp_path: Path, name: str, group: str, count: int) -> None:
    """fairino5_v6_moveit2_config: an arm, and the arm with a gripper that its files are for."""
    add_file(tmp_path / "package.xml", b"<package><name>p</name></package>")
    arm = _write(tmp_path / "config", "arm", "a", group="arm")
    texts = {
        "joint_limits.yaml": LIMITS.replace("NAME", name),
        "initial_positions.yaml": POSITIONS.replace("NAME", name),
        "kinematics.yaml": "".join(SOLVERS.replace("GROUP", one) for one in ("arm", group)),
    }
    for file, text in texts.items():
        add_file(tmp_path / "config" / file, text.encode())
    assert len(check(arm, select=["SRD026"]).diagnostics) == 3, "there is no other robot"
    _write(tmp_path / "config", "arm_hand", "a", "finger", group="hand")
    assert len(check(arm, select=["SRD026"]).diagnostics) == count
