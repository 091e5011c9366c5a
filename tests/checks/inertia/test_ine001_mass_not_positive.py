import pytest

from tests.massive import inertial, joint, link
from tests.naming import naming
from tests.reported import messages, places

TENSOR = (0.1, 0.1, 0.1)
BASE = link("base", inertial(2, TENSOR))
MOVED = naming("arm", "0 kg", "continuous", "arm_joint")


@pytest.mark.parametrize(
    ("mass", "kind", "expected"),
    [
        (0, "continuous", [MOVED]),
        (0, "fixed", []),
        (1e-12, "continuous", []),
        (-0.5, "fixed", [naming("arm", "-0.5 kg")]),
        (-0.5, "continuous", [naming("arm", "-0.5 kg")]),
    ],
)
def test_masses_of_moving_and_fixed_links(mass: float, kind: str, expected: list[str]) -> None:
    robot = BASE + link("arm", inertial(mass, TENSOR)) + joint("base", "arm", kind)
    assert messages("INE001", robot) == expected


def test_what_is_fixed_to_it_may_have_the_mass() -> None:
    robot = BASE + link("arm", inertial(0, TENSOR)) + joint("base", "arm", "continuous")
    assert messages("INE001", robot) == [MOVED]
    assert (
        messages("INE001", robot + link("hand", inertial(1, TENSOR)) + joint("arm", "hand")) == []
    )
    assert messages("INE001", robot + link("hand") + joint("arm", "hand")) == [MOVED]


def test_a_robot_that_weighs_nothing_is_another_rule_s() -> None:
    robot = link("base") + link("arm", inertial(0, TENSOR)) + joint("base", "arm", "continuous")
    assert messages("INE001", robot) == []


def test_a_root_of_no_mass_is_nailed_to_the_world_in_pybullet() -> None:
    robot = link("base", inertial(0, TENSOR)) + link("arm", inertial(1, TENSOR))
    assert messages("INE001", robot + joint("base", "arm", "continuous")) == []


def test_the_place_is_the_number() -> None:
    robot = BASE + link("arm", inertial(-0.5, TENSOR)) + joint("base", "arm")
    assert places("INE001", robot) == [(4, "-0.5")]


def test_between_the_axes_of_a_ball_joint_nothing_weighs() -> None:
    """Such chains let a base float, or a wrist turn about three axes: no ROS node minds them."""
    nothing = (0, 0, 0)
    roll = link("roll", inertial(0, nothing)) + joint("base", "roll", "continuous")
    pitch = link("pitch", inertial(0, nothing)) + joint("roll", "pitch", "continuous")
    hand = link("hand", inertial(1, TENSOR)) + joint("pitch", "hand", "continuous")
    assert messages("INE001", BASE + roll + pitch + hand) == []
    assert len(messages("INE001", BASE + roll + pitch)) == 1, "at the end nothing is carried"
    simulated = "<gazebo><plugin name='p' filename='libgazebo_ros_p3d.so'/></gazebo>"
    assert len(messages("INE001", BASE + roll + pitch + hand + simulated)) == 2
