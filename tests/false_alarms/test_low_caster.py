"""TRE008: to lift the robot onto a caster that reaches too low takes the wheels off the ground."""

import pytest

from tests.massive import joint, link, shape
from tests.naming import naming
from tests.reported import reported


def on_wheels(caster: float, footprint: float = 0.05) -> str:
    """Wheels of 0.05 m radius, and a caster at a height over their axles."""
    wheel = shape("collision", '<cylinder radius="0.05" length="0.02"/>', rpy="1.5707963 0 0")
    text = link("base_footprint") + link("base_link")
    text += joint("base_footprint", "base_link", xyz=f"0 0 {footprint}")
    for name, y in (("left", 0.1), ("right", -0.1)):
        turning = joint("base_link", name, "continuous", f"0 {y} 0")
        text += link(name, wheel) + turning.replace("</joint>", '<axis xyz="0 1 0"/></joint>')
    ball = link("caster", shape("collision", '<sphere radius="0.02"/>'))
    return text + ball + joint("base_link", "caster", xyz=f"-0.1 0 {caster}")


def test_a_caster_that_reaches_lower_than_the_wheels() -> None:
    (found,) = reported("TRE008", on_wheels(-0.05))
    assert found.message == naming(
        "collision", "caster", "0.02 m", "below", "base_footprint", "left", "right", "0.02 m"
    )
    assert found.help == naming("caster", "touch")
    assert found.fix is None


@pytest.mark.parametrize("footprint", [0.0, 0.1])
def test_a_robot_that_stands_on_all_of_them_is_lifted(footprint: float) -> None:
    (found,) = reported("TRE008", on_wheels(-0.03, footprint))
    assert "hang" not in found.message
    assert found.fix is not None


def test_a_caster_that_ends_above_the_ground() -> None:
    assert reported("TRE008", on_wheels(0.0)) == []


def test_a_footprint_below_the_base() -> None:
    """What is a child of the base moves itself, not the robot."""
    robot = (
        link("base", shape("collision", '<box size="1 1 0.2"/>'))
        + link("base_footprint")
        + joint("base", "base_footprint", xyz="0 0 0.05")
    )
    (found,) = reported("TRE008", robot)
    assert found.help == naming("lower", "base_footprint", "0.15 m")
