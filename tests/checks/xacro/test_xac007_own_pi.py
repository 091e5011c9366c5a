import pytest

from tests.naming import naming
from tests.reported import fixed
from tests.xacros import reported, xacro


@pytest.mark.parametrize(
    ("name", "value", "off"),
    [
        ("PI", "3.1415926", "5.4e-08"),
        ("M_PI", "3.14159", "2.7e-06"),
        ("my_pi", "3.142", "4.1e-04"),
        ("half_turn", "3.14159", "2.7e-06"),
    ],
)
def test_fewer_digits(name: str, value: str, off: str) -> None:
    body = f'<xacro:property name="{name}" value="{value}"/><link name="l${{{name}}}"/>'
    (found,) = reported("XAC007", body)
    assert found.message == naming(name, f"{float(value)}, {off}")
    assert found.fix is not None
    (edit,) = found.fix.edits
    assert (edit.span.text, edit.text) == (value, "${pi}")
    assert not found.fix.safe


def test_one_that_is_called_pi_goes() -> None:
    mended = fixed(
        "XAC007", xacro('<xacro:property name="pi" value="3.14"/>\n<link name="a${pi}"/>')
    )
    assert "xacro:property" not in mended
    assert '<link name="a${pi}"/>' in mended


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("PI", "3.141592653589793"),
        ("PI", "3.1415926535897931"),
        ("PI", "${pi}"),
        ("width", "3.14"),
        ("pitch", "3.14"),
        ("spin", "3.15"),
        ("pi_2", "1.5708"),
        ("PI", "3.2"),
    ],
)
def test_exact_or_something_else(name: str, value: str) -> None:
    body = f'<xacro:property name="{name}" value="{value}"/><link name="l${{{name}}}"/>'
    assert reported("XAC007", body) == []


def test_fixing_it() -> None:
    robot = xacro('<xacro:property name="PI" value="3.1415926"/>\n<link name="l${PI}"/>')
    after = fixed("XAC007", robot, "robot.xacro")
    assert after == robot.replace("3.1415926", "${pi}")
    assert fixed("XAC007", after, "robot.xacro") == after
