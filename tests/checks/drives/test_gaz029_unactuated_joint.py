import pytest

from tests.gazebos import BASE, WHEELS, child, plugin
from tests.naming import naming
from tests.reported import places, reported

MOVE = plugin("libgazebo_ros_planar_move.so")


def test_one_finding_names_all() -> None:
    (found,) = reported("GAZ029", WHEELS + MOVE)
    assert found.message == naming("left_joint", "right_joint", "Gazebo", "ros2_control")
    assert [text for _, text in places("GAZ029", WHEELS + MOVE)] == [
        '<joint name="left_joint" type="continuous">'
    ]
    assert len(found.related) == 1


def test_many_are_counted() -> None:
    (found,) = reported("GAZ029", BASE + "".join(child(f"w{n}") for n in range(6)) + MOVE)
    assert "'w3_joint' and 2 more" in found.message
    (found,) = reported("GAZ029", BASE + "".join(child(f"w{n}") for n in range(4)) + MOVE)
    assert "'w2_joint', 'w3_joint' are" in found.message


@pytest.mark.parametrize(
    "text",
    [
        WHEELS,  # not made for Gazebo
        WHEELS + MOVE + '<transmission name="t"/>',
        WHEELS + MOVE + '<ros2_control name="c" type="system"/>',
        WHEELS + MOVE + plugin("libvendor.so"),
        WHEELS + MOVE + plugin("gz-sim-joint-trajectory-controller-system"),
        WHEELS + plugin("libgazebo_ros_diff_drive.so", "<leftJoint>left_joint</leftJoint>"),
        WHEELS.replace("continuous", "fixed") + MOVE,
    ],
)
def test_no_finding(text: str) -> None:
    assert reported("GAZ029", text) == []
