import pytest

from tests.gazebos import WHEELS, plugin
from tests.naming import naming
from tests.reported import places, reported

DRIVE = "libgazebo_ros_diff_drive.so"
TAGS = "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>"
ROBOT = WHEELS + plugin(DRIVE, TAGS)


def tags(text: str) -> list[str]:
    return [tag for _, tag in places("GAZ024", text)]


@pytest.mark.parametrize("kind", ["revolute", "prismatic", "floating", "planar"])
def test_a_joint_that_is_not_a_wheel(kind: str) -> None:
    text = ROBOT.replace('"left_joint" type="continuous"', f'"left_joint" type="{kind}"')
    (found,) = reported("GAZ024", text)
    assert found.message == naming("p", DRIVE, "left_joint", kind)
    assert tags(text) == ["<leftJoint>"]


def test_wheels() -> None:
    assert reported("GAZ024", ROBOT) == []


def test_a_steering_joint_has_limits() -> None:
    steered = "".join(
        f"<{side}_steering_joint>{side}_joint</{side}_steering_joint>" for side in ("left", "right")
    )
    text = WHEELS + plugin("gz-sim-ackermann-steering-system", steered)
    assert tags(text.replace("continuous", "revolute")) == []


def test_other_plugins_may_move_any_joint() -> None:
    text = WHEELS.replace("continuous", "revolute")
    text += plugin("gz-sim-joint-position-controller-system", "<joint_name>left_joint</joint_name>")
    assert reported("GAZ024", text) == []
    assert reported("GAZ024", text + plugin("gz-sim-diff-drive-system")) == []  # it names no joint
    driven = plugin("gz-sim-diff-drive-system", "<left_joint>left_joint</left_joint>")
    assert len(reported("GAZ024", text + driven)) == 1


def test_one_joint_for_both_sides() -> None:
    text = WHEELS + plugin(DRIVE, TAGS.replace("right_joint", "left_joint"))
    (found,) = reported("GAZ024", text)
    assert found.help == naming("wheel")
    assert [note.span.text for note in found.related] == ["<leftJoint>"]
    assert tags(text) == ["<rightJoint>"]
