"""SRD015: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings
from urdfkit import Diagnostic, check


def reported(directory: Path, **values: str) -> list[Diagnostic]:
    lines = "".join(f"    {name}: {value}\n" for name, value in values.items())
    (directory / "joint_limits.yaml").write_text(f"joint_limits:\n  shoulder:\n{lines}")
    return findings(directory, "", "SRD015")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (
            {"has_velocity_limits": "true", "max_velocity": "1.5"},
            naming("shoulder", "max_velocity", "1.5 rad/s", "1 rad/s"),
        ),
        (
            {"has_position_limits": "true", "min_position": "-2", "max_position": "0.5"},
            naming("shoulder", "min_position", "-2 rad", "-1 rad"),
        ),
        (
            {"has_velocity_limits": "true", "max_velocity": "!degrees 90"},
            naming("shoulder", "max_velocity", "1.5708 rad/s", "1 rad/s"),
        ),
        (
            {"has_position_limits": "True", "max_position": "1.2"},
            naming("shoulder", "max_position", "1.2 rad", "1 rad"),
        ),
    ],
)
def test_wider(tmp_path: Path, values: dict[str, str], message: str) -> None:
    (found,) = reported(tmp_path, **values)
    assert found.message == message
    assert found.span.source.path == str(tmp_path / "joint_limits.yaml")
    (related,) = found.related
    assert related.span.source.path == str(tmp_path / "r.urdf")


@pytest.mark.parametrize(
    "values",
    [
        {"has_velocity_limits": "true", "max_velocity": "1.005"},
        {"has_velocity_limits": "true", "max_velocity": "!degrees 57"},
        {"has_velocity_limits": "false", "max_velocity": "5"},
        {"max_velocity": "5"},
        {"has_position_limits": "true", "min_position": "-1", "max_position": "0.9"},
        {"has_acceleration_limits": "true", "max_acceleration": "99"},
    ],
)
def test_narrower_or_disabled(tmp_path: Path, values: dict[str, str]) -> None:
    assert reported(tmp_path, **values) == []


TEXT = "joint_limits:\n  shoulder:\n    has_velocity_limits: true\n    max_velocity: {}\n"
AMENT = (
    "<package format='3'><name>a</name><export><build_type>ament_cmake</build_type></export>"
    "</package>"
)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("2,5", ["2,5", "number"]),
        ("'2.5'", ["2.5", "number"]),
        ("-2.5", ["-2.5", "> 0"]),
        ("0.0", ["0.0", "> 0"]),
        ("2", ["2", "integer", "MoveIt", "2", "double"]),
    ],
)
def test_values_that_moveit_cannot_use(tmp_path: Path, value: str, message: list[str]) -> None:
    (tmp_path / "package.xml").write_text(AMENT)
    (tmp_path / "joint_limits.yaml").write_text(TEXT.format(value))
    (found,) = findings(tmp_path, "", "SRD015")
    assert found.message == naming("shoulder", "max_velocity", *message)
    assert (found.span.line, found.span.text) == (4, value)


@pytest.mark.parametrize("value", ["0.5", "1", "$(var v)"])
def test_integers_are_accepted_in_moveit_1(tmp_path: Path, value: str) -> None:
    (tmp_path / "joint_limits.yaml").write_text(TEXT.format(value))
    assert findings(tmp_path, "", "SRD015") == []


@pytest.mark.parametrize(
    ("name", "count"), [("has_velocity_limit", 1), ("max_velocty", 1), ("own", 0), ("max_jerk", 0)]
)
def test_misspelt(tmp_path: Path, name: str, count: int) -> None:
    found = reported(tmp_path, **{name: "0.5"})
    assert ["did you mean" in one.message for one in found] == [True] * count


def test_disabled_limit_is_accepted(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(AMENT)
    (tmp_path / "joint_limits.yaml").write_text(TEXT.replace("true", "false").format(0))
    assert findings(tmp_path, "", "SRD015") == []


@pytest.mark.parametrize(
    ("speeds", "values"),
    [
        (("143.0", "2.5", "2.0"), ["143 rad/s", "2.5 rad/s"]),
        (("143.0", "143.0", "143.0"), []),
        (("143.0", "20.0", "2.0"), []),
        (("12.0", "2.5", "2.0"), []),
    ],
)
def test_a_velocity_in_degrees(tmp_path: Path, speeds: tuple[str, ...], values: list[str]) -> None:
    """Next to joints in radians, and without a velocity in the URDF that tells it."""
    robot = '<robot name="r"><link name="base"/>'
    limits = "joint_limits:\n"
    for name, speed in zip("abc", speeds, strict=True):
        robot += f'<link name="{name}"/><joint name="{name}" type="continuous">'
        robot += f'<parent link="base"/><child link="{name}"/></joint>'
        limits += f"  {name}:\n    has_velocity_limits: true\n    max_velocity: {speed}\n"
    (tmp_path / "a.urdf").write_text(robot + "</robot>")
    (tmp_path / "a.srdf").write_text('<robot name="r"/>')
    (tmp_path / "joint_limits.yaml").write_text(limits)
    found = check(tmp_path / "a.urdf", select=["SRD015"]).diagnostics
    expected = [naming("a", "max_velocity", *values)] if values else []
    assert [one.message for one in found] == expected
    assert [one.span.text for one in found] == (["143.0"] if values else [])
