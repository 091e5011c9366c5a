from math import cos, pi, radians, sin

import pytest

from tests.massive import BOX, WHEEL, inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import fixed, messages, reported
from urdfkit.lint.rule_examples import whole_robot

ACROSS, ALONG = 0.5 * (3 * 0.06**2 + 0.05**2) / 12, 0.5 * 0.06**2 / 2
LYING = shape("collision", WHEEL, rpy=f"{pi / 2!r} 0 0")


def test_a_wheel_that_lies_along_y() -> None:
    robot = link("wheel", LYING, inertial(0.5, (ACROSS, ACROSS, ALONG)))
    (found,) = reported("INE006", robot)
    assert found.message == naming(
        "wheel",
        "0.000554, 0.000554, 0.0009 kg·m²",
        "0.06 m",
        "0.05 m",
        "0.000554, 0.0009, 0.000554 kg·m²",
    )
    assert found.help == (
        'write iyy="0.0009" izz="0.0005541666666666667", or rotate the <inertial>'
    )
    assert messages("INE006", fixed("INE006", robot)) == []


def test_the_sign_of_one_product_is_all_that_is_edited() -> None:
    turned = shape("collision", BOX, rpy="0 0 0.4")
    robot = link("wrist", turned, inertial(12, (0.0923, -0.0178, 0, 0.0576, 0, 0.1303)))
    (found,) = reported("INE006", robot)
    assert found.message == naming("wrist", "-0.0178 kg·m²", "0.2 x 0.3 x 0.1 m", "0.0179")
    assert found.help == 'write ixy="0.0178", or rotate the <inertial>'
    assert fixed("INE006", robot) == whole_robot(robot.replace("-0.0178", "0.0178"))


def test_turned_with_the_shape_it_is_right() -> None:
    turned = inertial(0.5, (ACROSS, ACROSS, ALONG), rpy=f"{pi / 2!r} 0 0")
    assert messages("INE006", link("wheel", LYING, turned)) == []


def test_moments_that_are_not_those_of_the_shape_are_not_edited() -> None:
    (found,) = reported(
        "INE006", link("wheel", LYING, inertial(0.5, (ACROSS, ACROSS, ALONG * 1.1)))
    )
    assert found.fix is None


def test_swapped_values_of_twice_the_size_need_more_than_a_swap() -> None:
    """The macro of arm_base_link is called with twice the length of each edge."""
    (found,) = reported(
        "INE006", link("wheel", LYING, inertial(0.5, (ACROSS * 4, ACROSS * 4, ALONG * 4)))
    )
    assert "swap" not in found.help


def test_a_small_part_of_a_large_body_does_not_matter() -> None:
    imu = link("imu", LYING, inertial(0.5, (ACROSS, ACROSS, ALONG)))
    robot = part("base", 60, (0.5, 0.25, 0.65), BOX) + imu + joint("base", "imu")
    assert messages("INE006", robot) == []


def turned(degrees: float) -> tuple[float, ...]:
    """The six entries of a rod along x of 1 kg, 0.6 x 0.1 x 0.1 m, that is turned about z."""
    across, along, angle = (0.6**2 + 0.1**2) / 12, 2 * 0.1**2 / 12, radians(degrees)
    c, s = cos(angle), sin(angle)
    ixx, iyy = along * c * c + across * s * s, along * s * s + across * c * c
    return (ixx, (along - across) * s * c, 0, iyy, 0, across)


@pytest.mark.parametrize(
    ("shape_at", "tensor_at", "found"),
    [
        (30, 30, 0),
        (30, -30, 1),  # the sign of ixy
        (45, -45, 1),
        (0, 60, 1),
        (0, 10, 0),  # a part that is not quite straight
        (90, 90, 0),
    ],
)
def test_a_tensor_with_products(shape_at: float, tensor_at: float, found: int) -> None:
    rod = shape("collision", '<box size="0.6 0.1 0.1"/>', rpy=f"0 0 {radians(shape_at)!r}")
    robot = link("rod", rod, inertial(1, turned(tensor_at)))
    assert len(messages("INE006", robot)) == found
    assert messages("INE006", fixed("INE006", robot)) == []


@pytest.mark.parametrize(
    ("moments", "found"),
    [
        ((0.02, 0.02, 0.002), 1),  # a rod along z, of another density in its middle
        ((0.02, 0.002, 0.02), 1),
        ((0.002, 0.02, 0.02), 0),
        ((0.02, 0.02, 0.006), 0),  # not elongated: motors beside the rod
        ((0.01, 0.02, 0.014), 0),
    ],
)
def test_a_long_part_that_points_another_way(moments: tuple[float, ...], found: int) -> None:
    """Doosan's arms: the second links of two series point along x and along z."""
    rod = shape("collision", '<box size="0.6 0.1 0.1"/>')
    reports = reported("INE006", link("rod", rod, inertial(1, moments)))
    assert [(one.severity.name, one.fix) for one in reports] == [("WARNING", None)] * found


@pytest.mark.parametrize(
    ("moments", "found"),
    [
        ((0.0247, 0.0247, 0.0441), 1),
        ((0.0247, 0.0441, 0.0247), 0),
        ((0.0247, 0.0247, 0.03), 0),  # nearly round
    ],
)
def test_a_wheel_that_turns_about_another_axis(moments: tuple[float, ...], found: int) -> None:
    """Husky's wheels: measured for a wheel about z, they turn about y."""
    wheel = shape("collision", '<cylinder radius="0.165" length="0.114"/>', rpy=f"{pi / 2!r} 0 0")
    reports = reported("INE006", link("wheel", wheel, inertial(2.637, moments)))
    assert [(one.severity.name, one.fix) for one in reports] == [("WARNING", None)] * found


def test_products_with_the_wrong_sign_of_a_part_of_other_density() -> None:
    """The moments about x, y and z are like those of the shape: the axes are the difference."""
    rod = shape("collision", '<box size="0.6 0.1 0.1"/>', rpy=f"0 0 {radians(45)!r}")
    moments = tuple(0.8 * value for value in turned(-45))
    (found,) = reported("INE006", link("rod", rod, inertial(1, moments)))
    assert "0.71 -0.71 0, but" in found.message
    assert found.message.endswith("0.71 0.71 0")
    assert found.fix is None


def test_moments_in_the_wrong_order_of_a_part_with_products() -> None:
    rod = shape("collision", '<box size="0.1 0.1 0.6"/>', rpy="0 0.1 0")
    moments = (0.0247, 0.0022, 0, 0.003, 0, 0.0247)
    (found,) = reported("INE006", link("rod", rod, inertial(1, moments)))
    assert found.help == naming("iyy", "izz")


def rod(moments: tuple[float, ...], center: float = 0.3) -> str:
    """A rod along z whose link begins at one end; 1 kg, 0.05 x 0.05 x 0.6 m."""
    body = shape("collision", '<box size="0.05 0.05 0.6"/>', f"0 0 {center}")
    return link("rod", body, inertial(1, moments, f"0 0 {center}"))


SIDE, OWN = (0.05**2 + 0.6**2) / 12, 2 * 0.05**2 / 12


def test_a_tensor_about_the_joint() -> None:
    about_joint = SIDE + 0.3**2
    (found,) = reported("INE006", rod((about_joint, about_joint, OWN)))
    assert found.message == naming(
        "rod",
        "0.12, 0.12, 0.000417 kg·m²",
        "0.05 x 0.05 x 0.6 m",
        "0.0302, 0.0302, 0.000417 kg·m²",
    )
    assert found.help == naming('ixx="0.0302083"', 'iyy="0.0302083"')
    assert messages("INE006", fixed("INE006", rod((about_joint, about_joint, OWN)))) == []


@pytest.mark.parametrize(
    ("moments", "center"),
    [
        ((SIDE, SIDE, OWN), 0.3),
        ((SIDE + 0.09, SIDE + 0.09, 4 * OWN), 0.3),  # nor about the joint
        ((SIDE + 0.01, SIDE + 0.01, OWN), 0.1),  # hardly different
    ],
)
def test_other_tensors_of_a_rod(moments: tuple[float, ...], center: float) -> None:
    assert messages("INE006", rod(moments, center)) == []


@pytest.mark.parametrize(
    ("moments", "center", "count"),
    [
        ((SIDE + 0.09, SIDE + 0.09, OWN), "0 0 0.3", 1),
        ((SIDE + 0.0925, SIDE + 0.09, OWN + 0.0025), "0 0.05 0.3", 0),  # of a motor on one side
        ((0.1, 0.1, 0.0005), "0 0 0.3", 0),  # a guess
    ],
)
def test_what_a_tensor_about_the_joint_needs(
    moments: tuple[float, ...], center: str, count: int
) -> None:
    body = shape("collision", '<box size="0.05 0.05 0.6"/>', "0 0 0.3")
    robot = link("rod", body, inertial(1, moments, center))
    found = [one for one in messages("INE006", robot) if "about the origin" in one]
    assert len(found) == count
