"""GAZ064: see the rule."""

from tests.gazebos import WHEELS, plugin
from tests.reported import messages, places

DRIVE = "libgazebo_ros_diff_drive.so"
TAGS = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"


def test_one_joint_for_both_sides() -> None:
    text = WHEELS + plugin(DRIVE, TAGS.replace("right_joint", "left_joint"))
    assert messages("GAZ064", text) == [
        f"plugin 'p' ({DRIVE}): <rightJoint> is 'left_joint', as <leftJoint> is"
    ]
    assert [at for _, at in places("GAZ064", text)] == ["<rightJoint>"]


def test_a_joint_for_each_is_calm() -> None:
    assert messages("GAZ064", WHEELS + plugin(DRIVE, TAGS)) == []
