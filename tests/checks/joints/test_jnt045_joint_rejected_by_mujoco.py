"""JNT045: what MuJoCo rejects is tested with MuJoCo in ``tests/consumers/test_mujoco.py``."""

from pathlib import Path

import pytest

from tests.jointed import joint, robot
from urdfkit import check
from urdfkit.checks.joints import jnt045_joint_rejected_by_mujoco as rule
from urdfkit.lint.rule_examples import whole_robot


@pytest.mark.parametrize(("targets", "count"), [(["mujoco"], 1), (["ros2"], 0), ([], 0)])
def test_only_for_mujoco(targets: list[str], count: int, tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(whole_robot(rule.BAD))
    assert len(check(path, targets=targets, select=["JNT045"]).diagnostics) == count


def test_autolimits_is_reported_once_with_its_joints(tmp_path: Path) -> None:
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    joints = joint("j", "revolute", limit), joint("k", "prismatic", limit)
    text = f'<mujoco><compiler autolimits="false"/></mujoco>{robot(*joints)}'
    path = tmp_path / "robot.urdf"
    path.write_text(f'<robot name="r">{text}</robot>')
    (found,) = check(path, targets=["mujoco"], select=["JNT045"]).diagnostics
    assert found.span.text == "false"
    assert "'j'" in found.message
    assert "'k'" in found.message
