from __future__ import annotations

import pytest

from tests.gazebos import BASE, block
from tests.reported import messages, reported


@pytest.mark.parametrize(
    ("tag", "message"),
    [
        (
            "<mu1>high</mu1>",
            "<mu1> is 'high', which is not a number: Gazebo's converter ends with an exception",
        ),
        (
            "<kp/>",
            "<kp> is empty, which is not a number: Gazebo's converter ends with an exception",
        ),
        ("<mu1>0,5</mu1>", "<mu1> is '0,5': Gazebo reads 0, for a comma ends the number"),
        ('<mu1 value="0,5"/>', "<mu1> is '0,5': Gazebo reads 0, for a comma ends the number"),
        ("<kp>1.2.3</kp>", "<kp> is '1.2.3': Gazebo reads 1.2 and ignores '.3'"),
        ("<minDepth>1 mm</minDepth>", "<minDepth> is '1 mm': Gazebo reads 1 and ignores 'mm'"),
        ("<kd>nan</kd>", "<kd> is 'nan': the simulation spreads it to all links"),
        ("<fdir1>a b c</fdir1>", "<fdir1> is 'a b c', and must be 3 numbers"),
        ("<selfCollide>on</selfCollide>", "<selfCollide> is 'on', which Gazebo takes for false"),
        (
            "<turnGravityOff>off</turnGravityOff>",
            "<turnGravityOff> is 'off', which Gazebo takes for true",
        ),
        (
            "<gravity>yes</gravity>",
            "<gravity> is 'yes': SDF wants true, false, 1 or 0, and rejects the model",
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
        '<mu1 value=" 0.5 "/>',
        "<mu1>inf</mu1>",
        "<kp>1e6 N/m</kp>",
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
    assert reported("GAZ004", BASE + block(tag)) == []


def test_a_switch_on_the_wrong_kind_is_told_by_gaz005() -> None:
    robot = BASE + block("<implicitSpringDamper>3</implicitSpringDamper>")
    assert messages("GAZ004", robot) == []
    assert len(messages("GAZ005", robot)) == 1
