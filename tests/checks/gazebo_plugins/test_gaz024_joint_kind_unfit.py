from __future__ import annotations

import pytest

from tests.gazebos import WHEELS, plugin
from tests.reported import messages, places, reported

DRIVE = "libgazebo_ros_diff_drive.so"
TAGS = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"
ROBOT = WHEELS + plugin(DRIVE, TAGS)


@pytest.mark.parametrize("kind", ["revolute", "prismatic", "floating", "planar"])
def test_no_wheel(kind: str) -> None:
    text = ROBOT.replace('"left_joint" type="continuous"', f'"left_joint" type="{kind}"')
    assert messages("GAZ024", text) == [
        f"plugin 'p' ({DRIVE}) turns joint 'left_joint' as a wheel, and it is {kind}"
    ]
    assert [text for _, text in places("GAZ024", text)] == ["<leftJoint>"]


def test_wheels() -> None:
    assert reported("GAZ024", ROBOT) == []


def test_a_steering_joint_has_limits() -> None:
    tags = "".join(
        f"<{side}_{kind}>{side}_joint</{side}_{kind}>"
        for side in ("left", "right")
        for kind in ("steering_joint", "joint")
    )
    text = WHEELS + plugin("gz-sim-ackermann-steering-system", tags)
    limited = text.replace('"left_joint" type="continuous"', '"left_joint" type="revolute"')
    heard = [text for _, text in places("GAZ024", limited)]
    assert heard == ["<left_joint>"], "as a wheel, but not as a steering joint"


def test_other_plugins_may_move_any_joint() -> None:
    tags = "<joint_name>left_joint</joint_name>"
    text = WHEELS.replace("continuous", "revolute")
    text += plugin("gz-sim-joint-position-controller-system", tags)
    assert reported("GAZ024", text) == []
    assert reported("GAZ024", text + plugin("gz-sim-diff-drive-system")) == []  # it names no joint
    turned = plugin("gz-sim-diff-drive-system", "<left_joint>left_joint</left_joint>")
    assert len(reported("GAZ024", text + turned)) == 1
