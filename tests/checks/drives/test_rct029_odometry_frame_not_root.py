"""RCT029: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported
from tests.gazebos import BASE, WHEELS, child, plugin
from tests.naming import naming
from tests.reported import messages, places
from tests.reported import reported as reported_of


def test_frame_that_is_not_a_link(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT029", DRIVE.replace("_id: base", "_id: base_link"))
    assert found.message == naming("drive", "base_link", "base_link", "base")
    assert place(found) == ("c.yaml", 11, "base_link")


def test_a_frame_that_is_a_child_of_another(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT029", DRIVE.replace("_id: base", "_id: left"))
    assert found.message == naming("drive", "left", "left", "base")
    assert found.help == naming("base", "enable_odom_tf")


@pytest.mark.parametrize(
    "more",
    ["", "    enable_odom_tf: false\n", "    tf_frame_prefix: robot\n"],
)
def test_root_or_no_transform_is_accepted(tmp_path: Path, more: str) -> None:
    text = DRIVE.replace("_id: base", "_id: left") if more else DRIVE
    assert reported(tmp_path, "RCT029", text + more) == []


# --- drive plugins of Gazebo

MOVE, DIFF = "libgazebo_ros_planar_move.so", "libgazebo_ros_diff_drive.so"
ROBOT = BASE + child("body", "fixed") + child("mast", "fixed", parent="body")


def test_two_parents() -> None:
    text = ROBOT + plugin(MOVE, "<robotBaseFrame>mast</robotBaseFrame>")
    assert messages("RCT029", text) == [
        naming("p", MOVE, "odom -> mast", "robot_state_publisher", "body -> mast")
    ]
    assert [one.help for one in reported_of("RCT029", text)] == [naming("base", "above", "mast")]
    assert [text for _, text in places("RCT029", text)] == ["<robotBaseFrame>"]


def test_default_frame_is_compared() -> None:
    robot = BASE + child("base_footprint", "fixed")
    text = robot + plugin(MOVE, "<odometryRate>9</odometryRate>")
    assert [one.span.text for one in reported_of("RCT029", text)] == [
        f'<plugin name="p" filename="{MOVE}">'
    ]


@pytest.mark.parametrize("frame", ["base", "/base", "nothing", "base_link"])
def test_root_and_other_frames(frame: str) -> None:
    text = ROBOT + plugin(MOVE, f"<robotBaseFrame>{frame}</robotBaseFrame>")
    assert reported_of("RCT029", text) == []


@pytest.mark.parametrize(
    ("switch", "count"),
    [
        ("", 1),
        ("<publishOdomTF>false</publishOdomTF>", 0),
        ("<publishOdomTF>0</publishOdomTF>", 0),
        ("<publishTf>false</publishTf>", 0),
        ("<publishOdomTF>true</publishOdomTF>", 1),
    ],
)
def test_transform_that_is_not_published(switch: str, count: int) -> None:
    frame = "<robotBaseFrame>left</robotBaseFrame><leftJoint>left_joint</leftJoint>"
    assert len(reported_of("RCT029", WHEELS + plugin(DIFF, frame + switch))) == count


def test_transform_must_be_enabled_in_ros2() -> None:
    tags = "<robot_base_frame>left</robot_base_frame><left_joint>left_joint</left_joint>"
    assert reported_of("RCT029", WHEELS + plugin(DIFF, tags)) == []
    on = tags + "<publish_odom_tf>true</publish_odom_tf>"
    assert len(reported_of("RCT029", WHEELS + plugin(DIFF, on))) == 1


def test_model_with_the_odometry_frame_as_root() -> None:
    robot = '<link name="odom"/>' + child("body", "floating", parent="odom")
    text = robot + plugin(MOVE, "<robotBaseFrame>body</robotBaseFrame>")
    assert reported_of("RCT029", text) == [], "both name the same parent"
