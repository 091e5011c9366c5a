from __future__ import annotations

import pytest

from tests.gazebos import BASE, block
from tests.told import messages, told


@pytest.mark.parametrize(
    ("tag", "message"),
    [
        (
            "<mu1>high</mu1>",
            "<mu1> is 'high', which is no number: Gazebo's converter ends with an exception",
        ),
        ("<kp/>", "<kp> is empty, which is no number: Gazebo's converter ends with an exception"),
        ("<mu1>0,5</mu1>", "<mu1> is '0,5': Gazebo reads 0, for a comma ends the number"),
        ('<mu1 value="0,5"/>', "<mu1> is '0,5': Gazebo reads 0, for a comma ends the number"),
        ("<selfCollide>on</selfCollide>", "<selfCollide> is 'on', which Gazebo takes for false"),
        (
            "<turnGravityOff>off</turnGravityOff>",
            "<turnGravityOff> is 'off', which Gazebo takes for true",
        ),
        (
            "<gravity>yes</gravity>",
            "<gravity> is 'yes': SDF wants true, false, 1 or 0, and refuses the model",
        ),
    ],
)
def test_what_gazebo_makes_of_it(tag: str, message: str) -> None:
    assert messages("GAZ004", BASE + block(tag)) == [message]


@pytest.mark.parametrize(
    "tag",
    [
        "<mu1>0.5</mu1>",
        "<mu1> .5 </mu1>",
        '<mu1 value="0.5"/>',
        "<kp>1e6</kp>",
        "<kp>+1000000.0</kp>",
        "<maxContacts>5.5</maxContacts>",
        "<selfCollide>True</selfCollide>",
        "<selfCollide>yes</selfCollide>",
        "<selfCollide>0</selfCollide>",
        "<turnGravityOff>no</turnGravityOff>",
        "<gravity>1</gravity>",
        "<material>Gazebo/Red</material>",
        "<unknown>word</unknown>",
    ],
)
def test_good_values(tag: str) -> None:
    assert told("GAZ004", BASE + block(tag)) == []


def test_a_switch_on_the_wrong_kind_is_told_by_gaz005() -> None:
    robot = BASE + block("<implicitSpringDamper>3</implicitSpringDamper>")
    assert messages("GAZ004", robot) == []
    assert len(messages("GAZ005", robot)) == 1
