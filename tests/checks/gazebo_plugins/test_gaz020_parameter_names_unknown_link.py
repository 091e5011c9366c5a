from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import messages, places, reported

P3D = "libgazebo_ros_p3d.so"


def pose(body: str, frame: str = "world") -> str:
    tags = f"<topicName>t</topicName><bodyName>{body}</bodyName><frameName>{frame}</frameName>"
    return BASE + plugin(P3D, tags)


def test_a_link_that_is_not_there() -> None:
    (message,) = messages("GAZ020", pose("baase"))
    assert message == (
        f"plugin 'p' ({P3D}) looks for link 'baase', which does not exist: it writes a "
        "fatal message and stays idle"
    )
    assert places("GAZ020", pose("baase")) == [(4, "<bodyName>")]
    assert [one.help for one in reported("GAZ020", pose("baase"))] == ["did you mean 'base'?"]


@pytest.mark.parametrize("frame", ["world", "/world", "map", "/map", "base", "robot::base"])
def test_frames_that_need_no_link(frame: str) -> None:
    assert reported("GAZ020", pose("base", frame)) == []


def test_a_frame_that_is_only_stamped_need_not_be_a_link() -> None:
    text = BASE + plugin("libgazebo_ros_planar_move.so", "<robotBaseFrame>any</robotBaseFrame>")
    assert reported("GAZ020", text) == []


def test_an_attribute() -> None:
    mistake = '<wheel link_name="whel"><wheel_normal_force>1</wheel_normal_force></wheel>'
    assert places("GAZ020", BASE + plugin("libWheelSlipPlugin.so", mistake)) == [(4, "whel")]


def test_links_that_sdf_adds_and_plugins_that_nobody_knows() -> None:
    added = BASE + '<gazebo><link name="extra"/></gazebo>'
    tags = "<topicName>t</topicName><bodyName>extra</bodyName>"
    assert reported("GAZ020", added + plugin(P3D, tags)) == []
    assert reported("GAZ020", BASE + plugin("libvendor.so", tags)) == []
