from __future__ import annotations

from math import pi

from tests.massive import BOX, WHEEL, inertial, joint, link, part, shape
from tests.told import fixed, messages, told

ACROSS, ALONG = 0.5 * (3 * 0.06**2 + 0.05**2) / 12, 0.5 * 0.06**2 / 2
LYING = shape("collision", WHEEL, rpy=f"{pi / 2!r} 0 0")


def test_a_wheel_that_lies_along_y() -> None:
    robot = link("wheel", LYING, inertial(0.5, (ACROSS, ACROSS, ALONG)))
    (found,) = told("INE015", robot)
    assert found.message == (
        "link 'wheel' has moments of inertia of 0.000554, 0.000554, 0.0009 kg m^2 about x, y and "
        "z; a solid cylinder of radius 0.06 m and length 0.05 m has 0.000554, 0.0009, 0.000554 "
        "kg m^2 as it lies"
    )
    assert found.help == (
        'write ixx="0.000554167" iyy="0.0009" izz="0.000554167", or turn the <inertial>'
    )
    assert messages("INE015", fixed("INE015", robot)) == []


def test_turned_with_the_shape_it_is_right() -> None:
    turned = inertial(0.5, (ACROSS, ACROSS, ALONG), rpy=f"{pi / 2!r} 0 0")
    assert messages("INE015", link("wheel", LYING, turned)) == []


def test_other_values_are_another_rule_s() -> None:
    robot = link("wheel", LYING, inertial(0.5, (ACROSS, ACROSS, ALONG * 1.1)))
    assert messages("INE015", robot) == []


def test_a_small_part_of_a_large_body_does_not_matter() -> None:
    imu = link("imu", LYING, inertial(0.5, (ACROSS, ACROSS, ALONG)))
    robot = part("base", 60, (0.5, 0.25, 0.65), BOX) + imu + joint("base", "imu")
    assert messages("INE015", robot) == []
