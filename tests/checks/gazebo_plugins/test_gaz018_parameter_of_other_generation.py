from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import reported
from urdfkit.text.editing.apply import apply_edits

MOVE = "libgazebo_ros_planar_move.so"


def heard(tags: str, target: str = "classic-ros2") -> list[tuple[str, str]]:
    found = reported("GAZ018", BASE + plugin(MOVE, tags), targets=(target,))
    return [(one.message, one.help) for one in found]


@pytest.mark.parametrize(
    ("old", "help"),
    [
        ("odometryFrame", "write <odometry_frame>"),
        ("odometryRate", "write <publish_rate>"),
        ("robotBaseFrame", "write <robot_base_frame>"),
        ("robotNamespace", "write <ros><namespace>...</namespace></ros>"),
        ("commandTopic", "write <ros><remapping>FROM:=TO</remapping></ros>"),
        ("cmdTimeout", "remove it, or see what the plugin reads there"),
    ],
)
def test_names_of_ros1(old: str, help: str) -> None:
    message = f"plugin 'p' ({MOVE}) reads <{old}> in ROS 1, and nothing of that name in ROS 2"
    assert heard(f"<{old}>x</{old}>") == [(message, help)]
    assert heard(f"<{old}>x</{old}>", "classic-ros1") == []


def test_names_of_ros2() -> None:
    ((message, help),) = heard("<odometry_frame>x</odometry_frame>", "classic-ros1")
    assert message.endswith("reads <odometry_frame> in ROS 2, and nothing of that name in ROS 1")
    assert help == "write <odometryFrame>"
    assert len(heard("<ros><namespace>x</namespace></ros>", "classic-ros1")) == 1


def test_only_a_pure_rename_is_mended() -> None:
    text = BASE + plugin(MOVE, "<odometryRate>9</odometryRate><commandTopic>c</commandTopic>")
    rename, remap = reported("GAZ018", text, targets=("classic-ros2",))
    assert rename.fix is not None
    assert remap.fix is None
    source = rename.span.source.data
    assert b"<publish_rate>9</publish_rate>" in apply_edits(source, rename.fix.edits)


def test_no_second_tag_of_one_name() -> None:
    both = "<odometryRate>9</odometryRate><publish_rate>9</publish_rate>"
    (found,) = reported("GAZ018", BASE + plugin(MOVE, both), targets=("classic-ros2",))
    assert found.fix is None


def test_without_targets_the_tags_tell_the_generation() -> None:
    assert reported("GAZ018", BASE + plugin(MOVE, "<odometryRate>9</odometryRate>")) == []
    assert reported("GAZ018", BASE + plugin(MOVE, "<publish_rate>9</publish_rate>")) == []
