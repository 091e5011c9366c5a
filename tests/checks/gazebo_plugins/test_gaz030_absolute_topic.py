import pytest

from tests.gazebos import BASE, plugin
from tests.naming import naming
from tests.reported import places, reported

MOVE = "libgazebo_ros_planar_move.so"


def test_topics_that_begin_with_a_slash() -> None:
    tags = "<commandTopic>/cmd</commandTopic><odometryTopic>odom</odometryTopic>"
    text = BASE + plugin(MOVE, tags)
    (found,) = reported("GAZ030", text)
    assert found.message == naming("p", MOVE, "/cmd")
    assert found.help == naming("cmd", "namespace")
    assert places("GAZ030", text) == [(4, "<commandTopic>")]


@pytest.mark.parametrize(
    ("remapping", "count"), [("cmd_vel:=/cmd", 1), ("cmd_vel:=cmd", 0), ("/cmd_vel:=cmd", 0)]
)
def test_a_remapping_of_ros2(remapping: str, count: int) -> None:
    tags = f"<ros><remapping>{remapping}</remapping></ros>"
    assert len(reported("GAZ030", BASE + plugin(MOVE, tags))) == count


@pytest.mark.parametrize(
    "text",
    [
        plugin(MOVE, "<odometryFrame>/odom</odometryFrame>"),  # no topic
        plugin(MOVE, "<commandTopic>/</commandTopic>"),
        plugin("gz-sim-diff-drive-system", "<topic>/cmd</topic>"),  # all are absolute there
        plugin("libvendor.so", "<commandTopic>/cmd</commandTopic>"),
    ],
)
def test_no_finding(text: str) -> None:
    assert reported("GAZ030", BASE + text) == []
