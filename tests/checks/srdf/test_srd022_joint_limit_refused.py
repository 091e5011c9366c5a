"""SRD022: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

TEXT = "joint_limits:\n  shoulder:\n    has_velocity_limits: true\n    max_velocity: {}\n"
AMENT = (
    "<package format='3'><name>a</name><export><build_type>ament_cmake</build_type></export>"
    "</package>"
)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("2,5", "max_velocity is '2,5', and must be a number"),
        ("'2.5'", "max_velocity is '2.5', and must be a number"),
        ("-2.5", "max_velocity is -2.5, and must be above 0"),
        ("0.0", "max_velocity is 0.0, and must be above 0"),
        ("2", "max_velocity is 2, a whole number, and MoveIt 2 wants a point in it"),
    ],
)
def test_values_that_moveit_cannot_use(tmp_path: Path, value: str, message: str) -> None:
    (tmp_path / "package.xml").write_text(AMENT)
    (tmp_path / "joint_limits.yaml").write_text(TEXT.format(value))
    (found,) = findings(tmp_path, "", "SRD022")
    assert found.message == f"joint 'shoulder': {message}"
    assert (found.span.line, found.span.text) == (4, value)


@pytest.mark.parametrize("value", ["2.5", "2", "$(var v)"])
def test_what_moveit_1_takes_is_calm(tmp_path: Path, value: str) -> None:
    (tmp_path / "joint_limits.yaml").write_text(TEXT.format(value))
    assert findings(tmp_path, "", "SRD022") == []


def test_a_limit_that_is_off_is_calm(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(AMENT)
    (tmp_path / "joint_limits.yaml").write_text(TEXT.replace("true", "false").format(0))
    assert findings(tmp_path, "", "SRD022") == []
