from __future__ import annotations

from pathlib import Path

import pytest

from tests.srdfs import findings
from urdfkit import Diagnostic


def reported(folder: Path, **values: str) -> list[Diagnostic]:
    lines = "".join(f"    {name}: {value}\n" for name, value in values.items())
    (folder / "joint_limits.yaml").write_text(f"joint_limits:\n  shoulder:\n{lines}")
    return findings(folder, "", "SRD015")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (
            {"has_velocity_limits": "true", "max_velocity": "1.5"},
            "joint 'shoulder': MoveIt plans with max_velocity 1.5 rad/s, the robot allows 1 rad/s",
        ),
        (
            {"has_position_limits": "true", "min_position": "-2", "max_position": "0.5"},
            "joint 'shoulder': MoveIt plans with min_position -2 rad, the robot allows -1 rad",
        ),
        (
            {"has_velocity_limits": "true", "max_velocity": "!degrees 90"},
            (
                "joint 'shoulder': MoveIt plans with max_velocity 1.5708 rad/s, the robot allows "
                "1 rad/s"
            ),
        ),
        (
            {"has_position_limits": "True", "max_position": "1.2"},
            "joint 'shoulder': MoveIt plans with max_position 1.2 rad, the robot allows 1 rad",
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
        {"has_velocity_limits": "true", "max_velocity": "fast"},
        {"has_position_limits": "true", "min_position": "-1", "max_position": "0.9"},
        {"has_acceleration_limits": "true", "max_acceleration": "99"},
    ],
)
def test_narrower_or_off(tmp_path: Path, values: dict[str, str]) -> None:
    assert reported(tmp_path, **values) == []
