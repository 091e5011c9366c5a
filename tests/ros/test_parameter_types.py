"""What ROS 2 takes the values of a file of parameters for."""

import pytest

from urdfkit.ros.parameter_types import is_not_positive, type_of
from urdfkit.text.located_yaml import Node, Value, load
from urdfkit.text.source import Source


def value(text: str) -> Value | list[Node]:
    root = load(Source("c.yaml", f"a: {text}\n".encode()))
    assert isinstance(root, dict)
    found = root["a"]
    assert isinstance(found, (Value, list))
    return found


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("50", "int"),
        ("-0x1F", "int"),
        ("010", "int"),
        ("50.0", "double"),
        ("5.", "double"),
        (".5", "double"),
        ("1e-3", "double"),
        ("-.inf", "double"),
        (".NaN", "double"),
        ("yes", "bool"),
        ("False", "bool"),
        ("0,033", "string"),
        ("10 Hz", "string"),
        ("'50.0'", "string"),
        ('"true"', "string"),
        ("1_000", "string"),
        ("[1, 2]", "int_array"),
        ("[a, 'b']", "string_array"),
        ("[1.0, 2]", None),
        ("[]", None),
        ("", None),
        ("$(var rate)", None),
        ("<robot>/odom", None),
        ("KEEPOUT_ZONE_ENABLED", None),
        ("UNKNOWN", "string"),
        ("!!float 5", None),
    ],
)
def test_the_type_of_a_value(text: str, kind: str | None) -> None:
    assert type_of(value(text)) == kind


@pytest.mark.parametrize(
    ("text", "is_so"),
    [("0", True), ("-1.5", True), ("-.inf", True), ("0.1", False), (".nan", False), ("a", False)],
)
def test_what_is_zero_or_less(text: str, is_so: bool) -> None:
    found = value(text)
    assert isinstance(found, Value)
    assert is_not_positive(found) is is_so
