"""RCT023: see the rule."""

import pytest

from tests.controls import ROBOT, control
from tests.reported import fixed, messages


def with_parameter(name: str, value: str) -> str:
    parameter = f'<param name="{name}">{value}</param>'
    interface = f'<command_interface name="position">{parameter}</command_interface>'
    return ROBOT + control(f'<joint name="swing">{interface}</joint>')


@pytest.mark.parametrize("value", ["1,5", "", "3.14 rad", "nan?"])
@pytest.mark.parametrize("name", ["min", "max", "initial_value"])
def test_text_for_a_number(name: str, value: str) -> None:
    shown = f"'{value}'" if value else "empty"
    assert messages("RCT023", with_parameter(name, value)) == [
        f"joint 'swing', position: parameter '{name}' is {shown}, and no number"
    ]


def test_a_slip_is_mended() -> None:
    assert messages("RCT023", with_parameter("inital_value", "1")) == [
        "joint 'swing', position: parameter 'inital_value' is nearly 'initial_value'"
    ]
    assert 'name="initial_value"' in fixed("RCT023", with_parameter("inital_value", "1"))


@pytest.mark.parametrize(
    ("name", "value"), [("min", "-1.5"), ("max", "${pi}"), ("initial_value", " 1e-3 "), ("p", "x")]
)
def test_numbers_and_parameters_of_others_are_calm(name: str, value: str) -> None:
    assert messages("RCT023", with_parameter(name, value)) == []


def with_attributes(rw_rate: str, size: str) -> str:
    interface = f'<command_interface name="position" size="{size}"/>'
    text = ROBOT + control(f'<joint name="swing">{interface}</joint>')
    return text.replace("<ros2_control", f'<ros2_control rw_rate="{rw_rate}"')


@pytest.mark.parametrize("rate", ["-50", "50.5", "fast", ""])
def test_a_rate_that_is_refused(rate: str) -> None:
    (message,) = messages("RCT023", with_attributes(rate, "1"))
    assert message.endswith(f": rw_rate is '{rate}', and must be an integer of 0 or more")


@pytest.mark.parametrize("size", ["-4", "0", "1.5", "all"])
def test_a_size_that_is_refused(size: str) -> None:
    assert messages("RCT023", with_attributes("100", size)) == [
        f"joint 'swing', position: size is '{size}', and must be an integer of 1 or more"
    ]


def test_attributes_that_are_read() -> None:
    assert messages("RCT023", with_attributes("0", "3")) == []
