from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control, driven
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

BAD = ROBOT + control(driven("swing"), driven("follow", "velocity"))


def test_a_follower_with_a_command() -> None:
    assert messages("RCT008", BAD) == [
        "joint 'follow' mimics 'swing' and has command interface 'velocity'"
    ]
    assert places("RCT008", BAD) == [(NEXT + 3, '<command_interface name="velocity"/>')]


@pytest.mark.parametrize(
    ("targets", "severity"),
    [
        (("ros2",), Severity.ERROR),
        (("gz-harmonic",), Severity.ERROR),
        (("gz-jetty", "ros2"), Severity.ERROR),
        (("gz-fortress",), Severity.WARNING),
        (("classic-ros2", "ros2"), Severity.WARNING),
    ],
)
def test_humble_lets_it_pass(targets: tuple[str, ...], severity: Severity) -> None:
    (found,) = reported("RCT008", BAD, targets=targets)
    assert found.severity is severity


def test_a_follower_without_command() -> None:
    state = '<joint name="follow"><state_interface name="position"/></joint>'
    assert reported("RCT008", ROBOT + control(driven("swing"), state)) == []


def test_a_follower_with_a_motor_of_its_own() -> None:
    own = driven("follow").replace("<joint ", '<joint mimic="False" ')
    assert reported("RCT008", ROBOT + control(driven("swing"), own)) == []
    same = driven("follow").replace("<joint ", '<joint mimic="true" ')
    assert len(reported("RCT008", ROBOT + control(driven("swing"), same))) == 1


def test_the_form_of_humble() -> None:
    old = driven("follow", more='<param name="mimic">swing</param>')
    assert reported("RCT008", ROBOT + control(driven("swing"), old)) == []
