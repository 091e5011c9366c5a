"""GAZ063: see the rule."""

import pytest

from tests.gazebos import BASE, WHEELS, plugin
from tests.naming import naming
from tests.reported import messages

CONTROL = plugin("libgazebo_ros_control.so")


@pytest.mark.parametrize("text", ["true", " True ", "1", "yes"])
def test_a_robot_that_shall_move(text: str) -> None:
    static = f"<gazebo><static>{text}</static></gazebo>"
    assert messages("GAZ063", WHEELS + CONTROL + static) == [naming("Gazebo", "2")]


def test_what_does_not_move_is_calm() -> None:
    static = "<gazebo><static>true</static></gazebo>"
    assert messages("GAZ063", BASE + CONTROL + static) == []
    assert messages("GAZ063", WHEELS + static) == []
    assert messages("GAZ063", WHEELS + CONTROL + static.replace("true", "false")) == []
