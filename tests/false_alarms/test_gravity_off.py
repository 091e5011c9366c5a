"""Gravity asks nothing of a joint that moves links without gravity, as the PR2's arms."""

import pytest

from tests.massive import link
from tests.reported import messages
from tests.robot.test_joint_loads import pendulum

pytest.importorskip("pinocchio")

OFF = '<gazebo reference="{}"><{}>{}</{}></gazebo>'


@pytest.mark.parametrize(
    ("tag", "value", "count"),
    [
        ("turnGravityOff", "true", 0),
        ("turnGravityOff", "false", 1),
        ("gravity", "false", 0),
        ("gravity", "0", 0),
        ("gravity", "true", 1),
    ],
)
def test_a_link_without_gravity(tag: str, value: str, count: int) -> None:
    text = pendulum("13.7") + OFF.format("bob", tag, value, tag)
    assert len(messages("DYN003", text)) == count


def test_what_still_has_weight_counts() -> None:
    """The flag of the base takes no weight from the bob."""
    text = pendulum("13.7") + OFF.format("base", "turnGravityOff", "true", "turnGravityOff")
    assert len(messages("DYN003", text)) == 1


def test_the_flag_of_a_merged_link_holds_for_the_body() -> None:
    label = link("label") + (
        '<joint name="glue" type="fixed"><parent link="bob"/><child link="label"/></joint>'
    )
    text = pendulum("13.7") + label + OFF.format("label", "gravity", "false", "gravity")
    assert messages("DYN003", text) == []


@pytest.mark.parametrize(
    ("name", "count"), [("rotor{}", 0), ("motor_rotor_{}_joint", 0), ("w{}", 1)]
)
def test_no_root_of_a_robot_that_flies_is_held(name: str, count: int) -> None:
    """jsk_aerial_robot's Dragon: its rotors carry the links, not its joints."""
    rotors = "".join(
        link(f"blade{n}") + f'<joint name="{name.format(n)}" type="continuous">'
        f'<parent link="bob"/><child link="blade{n}"/></joint>'
        for n in (1, 2)
    )
    assert len(messages("DYN003", pendulum("13.7") + rotors)) == count
