from __future__ import annotations

from tests.controls import NEXT, ROBOT, control, driven, plugin, transmission
from tests.reported import messages, places, reported

TWO = ROBOT + transmission("swing") + transmission("slide").replace('"t"', '"u"')


def test_one_finding_for_all() -> None:
    text = TWO + control(driven("swing"))
    assert messages("RCT015", text) == ["transmission 't' and 1 more: nothing in ROS 2 reads it"]
    assert places("RCT015", text) == [(NEXT, '<transmission name="t">')]
    (found,) = reported("RCT015", text)
    assert [one.message for one in found.related] == ["transmission 'u'"]


def test_who_reads_it() -> None:
    assert reported("RCT015", TWO) == [], "nothing says that it is for ROS 2"
    assert reported("RCT015", TWO + plugin("libgazebo_ros_control.so")) == []
    assert reported("RCT015", TWO, targets=("ros1", "ros2")) == []
    assert len(reported("RCT015", TWO, targets=("gz-jetty",))) == 1
    inner = '<transmission name="t"><plugin>p/C</plugin></transmission>'
    assert reported("RCT015", ROBOT + control(driven("swing"), inner)) == []
