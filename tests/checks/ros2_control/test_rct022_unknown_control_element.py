"""RCT022: see the rule."""

import pytest

from tests.controls import NEXT, ROBOT, control
from tests.reported import messages, places


@pytest.mark.parametrize(
    ("part", "message"),
    [
        (
            '<joint name="swing"><comand_interface name="position"/></joint>',
            (
                "joint 'swing' in <ros2_control>: unknown element <comand_interface>; did you mean "
                "'command_interface'?"
            ),
        ),
        (
            (
                '<joint name="swing"><state_interface name="position"><parm name="min">0</parm>'
                "</state_interface></joint>"
            ),
            (
                "state_interface 'position' in <ros2_control>: unknown element <parm>; "
                "did you mean 'param'?"
            ),
        ),
        (
            '<sensor name="imu"><command_interface name="x"/></sensor>',
            (
                "sensor 'imu' in <ros2_control>: unknown element <command_interface>; did you mean "
                "'state_interface'?"
            ),
        ),
    ],
)
def test_what_nothing_reads(part: str, message: str) -> None:
    assert messages("RCT022", ROBOT + control(part)) == [message]
    ((line, _),) = places("RCT022", ROBOT + control(part))
    assert line == NEXT + 2


def test_what_is_read_is_calm() -> None:
    part = (
        '<joint name="swing"><command_interface name="position"><param name="min">0</param>'
        '<limits enable="false"/></command_interface><param name="gain">1</param></joint>'
    )
    transmission = (
        '<transmission name="t"><plugin>t/T</plugin><joint name="swing" role="r">'
        "<mechanical_reduction>2</mechanical_reduction></joint></transmission>"
    )
    assert messages("RCT022", ROBOT + control(part, transmission)) == []
