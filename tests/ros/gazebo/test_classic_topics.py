"""Topics of plugins of Gazebo Classic, and remappings of others."""

import pytest

from tests.gazebos import BASE, plugin, sensor
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.gazebo.classic_topics import classic_topics, lost_remappings
from urdfkit.ros.targets import parse
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

CAMERA = '<plugin name="p" filename="libgazebo_ros_camera.so">{}</plugin>'
DRIVE = "libgazebo_ros_diff_drive.so"


def context(text: str) -> Context:
    source = Source("robot.urdf", whole_robot(BASE + text).encode())
    return Context(source, Resolver(environment={}), targets=parse(["classic-ros2"]))


def names(text: str) -> set[str] | None:
    found = classic_topics(context(text).plugins)
    return None if found is None else {f"{topic.message} {topic.name}" for topic in found}


def test_of_a_camera() -> None:
    text = CAMERA.format("<camera_name>front</camera_name>")
    assert names(sensor("camera", text)) == {
        "Image /front/image_raw",
        "CameraInfo /front/camera_info",
    }
    assert "PointCloud2 /s/points" in (names(sensor("depth", CAMERA.format(""))) or ())
    assert names(sensor("multicamera", CAMERA.format(""))) is None


def test_of_a_drive() -> None:
    assert names(plugin(DRIVE, "<publish_odom>false</publish_odom>")) == set()
    assert names(plugin("libgazebo_ros_planar_move.so", "<publish_rate>1</publish_rate>")) == {
        "Odometry /odom"
    }
    assert names(plugin("libown.so")) is None


@pytest.mark.parametrize(
    ("rule", "topic"),
    [
        ("image_raw:=image", "s/image_raw"),
        ("s/image_raw:=image", ""),
        ("image_raw:=s/image_raw", ""),
        ("image_raw:=image_raw", ""),  # asks for nothing
        ("image_raw:=$(arg topic)", ""),
        ("/tf:=tf", ""),
        ("~/depth/camera_info:=info", "s/camera_info"),
    ],
)
def test_lost_remappings(rule: str, topic: str) -> None:
    text = CAMERA.format(f"<ros><remapping>{rule}</remapping></ros>")
    (use,) = context(sensor("camera", text)).plugins
    assert [lost.topic for lost in lost_remappings(use)] == [topic] * bool(topic)


@pytest.mark.parametrize(("encoding", "count"), [("compressed", 0), ("zipped", 1)])
def test_an_image_in_another_encoding(encoding: str, count: int) -> None:
    """Reachy: image_transport publishes it as a topic of its own, which is remapped by itself."""
    rule = f"<ros><remapping>s/image_raw/{encoding}:=image/{encoding}</remapping></ros>"
    (use,) = context(sensor("camera", CAMERA.format(rule))).plugins
    assert len(list(lost_remappings(use))) == count


@pytest.mark.parametrize(
    ("old", "topic"),
    [
        ("image_raw", "front_depth/image_raw"),
        ("image_depth", "front_depth/depth/image_raw"),
        ("camera_info_depth", "front_depth/depth/camera_info"),
        ("points", "front_depth/points"),
    ],
)
def test_lost_remappings_of_a_depth_camera(old: str, topic: str) -> None:
    rule = f"<ros><remapping>custom/{old}:=custom/a</remapping></ros>"
    text = CAMERA.format(f"{rule}<camera_name>front_depth</camera_name>")
    (use,) = context(sensor("depth", text)).plugins
    assert [lost.topic for lost in lost_remappings(use)] == [topic]


def test_a_lost_remapping_of_a_topic_of_another_plugin() -> None:
    """simulation_agrobot_ws: ~/depth/disparity is not s/image_raw."""
    text = CAMERA.format("<ros><remapping>~/depth/disparity:=disparity</remapping></ros>")
    (use,) = context(sensor("camera", text)).plugins
    assert [lost.topic for lost in lost_remappings(use)] == [""]


def test_an_image_is_not_proposed_for_a_depth_image() -> None:
    """tianracer: a camera without depth, whose remapping of `image_depth` has no effect."""
    text = CAMERA.format("<ros><remapping>image_depth:=depth</remapping></ros>")
    (use,) = context(sensor("camera", text)).plugins
    assert [lost.topic for lost in lost_remappings(use)] == [""]
