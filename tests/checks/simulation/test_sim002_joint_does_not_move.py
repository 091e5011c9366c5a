"""Joints that do not move."""

import pytest

pytest.importorskip("mujoco")

from tests.naming import naming
from tests.simulated import codes, simulated
from urdfkit.checks.simulation.sim002_joint_does_not_move import BAD, GOOD
from urdfkit.robot.samples import arm_xml, inertial_xml, robot_xml

_DISC = inertial_xml("1", "0.01 0.01 0.01")


def turning(inside: str = "", effort: str = "5", moments: str = "0.01") -> str:
    limit = f'<limit lower="-3" upper="3" effort="{effort}" velocity="1"/>'
    text = arm_xml("revolute", '<axis xyz="0 0 1"/>', limit, inside)
    body = _DISC.replace("0.01", moments)
    return text.replace('<link name="arm"/>', f'<link name="arm">{body}</link>')


def test_a_joint_between_walls() -> None:
    (found,) = simulated(BAD)
    assert found.code == "SIM002"
    assert found.message == naming("slide", "-0.02 m", "back", "cart", "10 mm")
    assert simulated(GOOD) == []


def test_a_joint_whose_inertia_is_too_large() -> None:
    (found,) = simulated(turning(moments="6000", effort="100"))
    assert found.code == "SIM002"
    assert found.span.text.startswith("<limit")
    assert codes(turning(moments="600", effort="100")) == []


@pytest.mark.parametrize(
    ("text", "other"),
    [
        (turning('<dynamics friction="6"/>'), "JNT041"),
        (turning('<dynamics damping="500"/>'), "JNT041"),
        (turning(effort="0"), "JNT008"),
    ],
)
def test_what_other_rules_find_without_a_simulation(text: str, other: str) -> None:
    assert codes(text, "SIM", other) == [other]


def test_a_mimic_joint_that_ends_before_its_leader_is_left_to_the_rule_about_it() -> None:
    limit = '<limit lower="0" upper="{}" effort="10" velocity="1"/>'
    joints = [
        f'<joint name="{name}" type="revolute"><parent link="base"/><child link="{name}"/>'
        f'<axis xyz="0 0 1"/>{limit.format(upper)}{mimic}</joint>'
        for name, upper, mimic in (("a", 1, ""), ("b", 0.5, '<mimic joint="a"/>'))
    ]
    links = [f'<link name="{name}">{_DISC}</link>' for name in ("a", "b")]
    assert codes(robot_xml('<link name="base"/>', *links, *joints), "SIM", "JNT016") == ["JNT016"]
