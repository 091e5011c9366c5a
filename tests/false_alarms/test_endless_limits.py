"""Limits that are written for form's sake."""

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
    ("zeros", "severity"),
    [
        (("0", "0", "0", "0"), "info"),
        (("0", "0", "1", "0"), "info"),
        (("0", "0", "9", "1"), "warning"),
    ],
)
def test_a_joint_that_keeps_gazebo_from_merging_a_link(
    zeros: tuple[str, str, str, str], severity: str
) -> None:
    """RotorS mounts its sensors with revolute joints all of whose limits are 0."""
    (found,) = reported("JNT003", robot(joint("imu", "revolute", limit(*zeros))))
    assert found.severity.value == severity


@pytest.mark.parametrize(
    ("lower", "upper", "severity"),
    [
        ("-1e16", "1e16", "info"),
        ("-3.14", "3.14", "info"),
        ("0", "0", "info"),
        ("1", "20", "info"),
        ("-1.5", "1.5", "warning"),
    ],
)
def test_limits_of_a_continuous_joint_that_nobody_counts_on(
    lower: str, upper: str, severity: str
) -> None:
    """rm_description's wheels, exports of SolidWorks, and jsk_aerial_robot's rotors."""
    text = robot(joint("wheel", "continuous", limit(lower, upper)))
    (found,) = reported("JNT020", text)
    assert found.severity.value == severity
    (found,) = reported("JNT020", text, targets=("drake",))
    assert found.severity.value == "warning"


@pytest.mark.parametrize(("soft", "count"), [("1.50003", 0), ("1.6", 1)])
def test_soft_limits_that_are_rounded(soft: str, count: int) -> None:
    """FAIRINO: 3.05433 in limits of 3.0543."""
    controller = f'<safety_controller soft_lower_limit="-1.5" soft_upper_limit="{soft}"/>'
    text = robot(joint("arm", "revolute", limit("-1.5", "1.5") + controller))
    assert len(reported("JNT019", text)) == count
