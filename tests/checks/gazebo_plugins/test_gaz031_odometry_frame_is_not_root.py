from __future__ import annotations

import pytest

from tests.gazebos import BASE, WHEELS, child, plugin
from tests.reported import messages, places, reported

MOVE, DRIVE = "libgazebo_ros_planar_move.so", "libgazebo_ros_diff_drive.so"
ROBOT = BASE + child("body", "fixed") + child("mast", "fixed", parent="body")


def test_two_parents() -> None:
    text = ROBOT + plugin(MOVE, "<robotBaseFrame>mast</robotBaseFrame>")
    assert messages("GAZ031", text) == [
        (
            f"plugin 'p' ({MOVE}) sends the transform odom -> mast, and robot_state_publisher body "
            "-> mast: a frame has one parent"
        )
    ]
    assert [one.help for one in reported("GAZ031", text)] == [
        "name the root link 'base', or remove the links above 'mast'"
    ]
    assert [text for _, text in places("GAZ031", text)] == ["<robotBaseFrame>"]


def test_the_default_frame_counts() -> None:
    robot = BASE + child("base_footprint", "fixed")
    text = robot + plugin(MOVE, "<odometryRate>9</odometryRate>")
    assert [one.span.text for one in reported("GAZ031", text)] == [
        f'<plugin name="p" filename="{MOVE}">'
    ]


@pytest.mark.parametrize("frame", ["base", "/base", "nothing", "base_link"])
def test_the_root_and_frames_of_others(frame: str) -> None:
    text = ROBOT + plugin(MOVE, f"<robotBaseFrame>{frame}</robotBaseFrame>")
    assert reported("GAZ031", text) == []


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
def test_a_transform_that_is_not_sent(switch: str, count: int) -> None:
    frame = "<robotBaseFrame>left</robotBaseFrame><leftJoint>left_joint</leftJoint>"
    assert len(reported("GAZ031", WHEELS + plugin(DRIVE, frame + switch))) == count


def test_in_ros2_the_drive_must_be_told_to_send_it() -> None:
    tags = "<robot_base_frame>left</robot_base_frame><left_joint>left_joint</left_joint>"
    assert reported("GAZ031", WHEELS + plugin(DRIVE, tags)) == []
    on = tags + "<publish_odom_tf>true</publish_odom_tf>"
    assert len(reported("GAZ031", WHEELS + plugin(DRIVE, on))) == 1


def test_a_model_whose_root_is_the_odometry_frame() -> None:
    robot = '<link name="odom"/>' + child("body", "floating", parent="odom")
    text = robot + plugin(MOVE, "<robotBaseFrame>body</robotBaseFrame>")
    assert reported("GAZ031", text) == [], "both name the same parent"
