"""Limits that are written for form's sake."""

from __future__ import annotations

import pytest

from tests.gazebos import WHEELS, plugin
from tests.jointed import joint, limit, robot
from tests.reported import messages, reported

TAGS = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"


@pytest.mark.parametrize(("end", "count"), [("1e16", 0), ("3", 2)])
def test_a_wheel_on_a_revolute_joint_without_an_end(end: str, count: int) -> None:
    """Neobotix's MP-500: revolute wheels with limits of 1e16 rad."""
    limits = limit(f"-{end}", end)
    wheels = WHEELS.replace('type="continuous">', f'type="revolute">{limits}')
    text = f'<robot name="r">{wheels}{plugin("libgazebo_ros_diff_drive.so", TAGS)}</robot>'
    assert len(messages("GAZ024", text)) == count


@pytest.mark.parametrize(
    ("zeros", "severity"), [(("0", "0", "0", "0"), "info"), (("0", "0", "9", "1"), "warning")]
)
def test_a_joint_that_keeps_gazebo_from_merging_a_link(
    zeros: tuple[str, str, str, str], severity: str
) -> None:
    """RotorS mounts its sensors with revolute joints all of whose limits are 0."""
    (found,) = reported("JNT003", robot(joint("imu", "revolute", limit(*zeros))))
    assert found.severity.value == severity
