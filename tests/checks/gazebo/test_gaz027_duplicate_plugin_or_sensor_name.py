from __future__ import annotations

from tests.gazebos import BASE, BODY, child, plugin, sensor
from tests.reported import messages, places, reported

MOVE, P3D = "libgazebo_ros_planar_move.so", "libgazebo_ros_p3d.so"
POSE = "<body_name>base</body_name>"


def pair(first: str = "<publish_rate>1</publish_rate>", second: str = "") -> str:
    return BASE + plugin(MOVE, first) + plugin(P3D, POSE + second)


def test_two_nodes_of_one_name() -> None:
    assert messages("GAZ027", pair()) == [
        f"plugin 'p' ({P3D}) and plugin 'p' ({MOVE}) are ROS nodes of the same name"
    ]
    assert places("GAZ027", pair()) == [(7, "p")]


def test_namespaces_keep_them_apart() -> None:
    space = "<ros><namespace>{}</namespace></ros>"
    assert reported("GAZ027", pair(space.format("/a"), space.format("/b"))) == []
    assert len(reported("GAZ027", pair(space.format("/a"), space.format("a")))) == 1


def test_other_names_and_other_generations() -> None:
    assert reported("GAZ027", BASE + plugin(MOVE, name="a") + plugin(P3D, POSE, name="b")) == []
    assert reported("GAZ027", pair(), targets=("classic-ros1",)) == []
    assert reported("GAZ027", BASE + 2 * plugin("libvendor.so")) == []


FIXED = BASE + child("tip", "fixed", inside=BODY)


def test_two_on_one_link() -> None:
    assert messages("GAZ027", BASE + sensor("imu", "") + sensor("camera", "")) == [
        "two sensors 's' on 'base': gz-sim rejects the model"
    ]


def test_two_on_links_that_gazebo_merges() -> None:
    assert messages("GAZ027", FIXED + sensor("imu", "") + sensor("imu", "", "tip")) == [
        "two sensors 's' on 'tip' (merged into 'base'): gz-sim rejects the model"
    ]


def test_other_names_and_other_links_are_not_reported() -> None:
    other = sensor("imu", "").replace('"s"', '"t"')
    assert messages("GAZ027", BASE + sensor("imu", "") + other) == []
    apart = BASE + child("tip", inside=BODY) + sensor("imu", "") + sensor("imu", "", "tip")
    assert messages("GAZ027", apart) == []
