"""Values of tags as Gazebo reads them."""

import math

import pytest

from urdfkit.ros.gazebo.values import leading, value


@pytest.mark.parametrize(
    ("text", "read", "rest"),
    [
        ("1e3", "1e3", ""),
        (" -.5 ", "-.5", ""),
        ("5.", "5.", ""),
        ("0x10", "0x10", ""),
        ("inf", "inf", ""),
        ("1,5", "1", ",5"),
        ("1.2.3", "1.2", ".3"),
        ("30 Hz", "30", ""),
        ("3 deg", "3", "deg"),
        ("1e", "1", "e"),
        ("", "", ""),
        ("${x}", "", ""),
    ],
)
def test_the_leading_number_of_a_text(text: str, read: str, rest: str) -> None:
    assert leading(text) == (read, rest)


def test_an_integer_ends_at_a_decimal_point() -> None:
    assert leading("3.7", whole=True) == ("3", ".7")
    assert leading("3.0", whole=True) == ("3", "")


def test_values() -> None:
    assert [value(text) for text in ("0x1F", "-.5", "+2e1")] == [31, -0.5, 20]
    assert math.isnan(value("nan"))
