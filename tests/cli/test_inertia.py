"""The inertia command: a table, proposals, files, JSON."""

import json
from pathlib import Path

import pytest

from tests.conftest import MISSION
from urdfkit.cli import main


def test_declared_against_computed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", str(MISSION)]) == 0
    lines = capsys.readouterr().out.splitlines()
    at = next(number for number, line in enumerate(lines) if line.startswith("wheel_1"))
    assert lines[at].split() == ["wheel_1", "declared", "0.5", "0.1", "0.1", "0.1"]
    assert lines[at + 1].split()[-2:] == ["differs", "x180"]
    assert any("wheel_1 (differs), wheel_2 (differs)" in line for line in lines)


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", str(MISSION), "--format", "json", "--link", "imu_link"]) == 0
    (link,) = json.loads(capsys.readouterr().out)["links"]
    assert link["verdict"] == "differs"
    assert link["computed"]["inertia"]["ixx"] == pytest.approx(4.1667e-6, rel=1e-4)
    assert link["volume"] == pytest.approx(0.05**3)


def test_write_and_diff(gazebo_pkg: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = gazebo_pkg / "urdf" / MISSION.name
    before = file.read_bytes()
    assert main(["inertia", str(file), "--diff", "--link", "imu_link"]) == 0
    assert '+      <inertia ixx="4.16667e-06"' in capsys.readouterr().out
    assert file.read_bytes() == before
    assert main(["inertia", str(file), "--write"]) == 1
    text = capsys.readouterr().out
    assert f"wrote {file}" in text
    assert "link 'wheel_1' is unchanged: a macro creates it" in text
    assert file.read_bytes() != before
    assert main(["inertia", str(file), "--write", "--link", "imu_link"]) == 0
    assert capsys.readouterr().out == "nothing to write\n"


def test_a_material(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["inertia", str(MISSION), "--material", "pla", "--link", "imu_link"]
    assert main([*words, "--format", "json"]) == 0
    (link,) = json.loads(capsys.readouterr().out)["links"]
    assert link["computed"]["mass"] == pytest.approx(1240 * 0.05**3)


@pytest.mark.parametrize(
    "words",
    [
        ["--mass", "1", "--material", "pla"],
        ["--density", "0"],
        ["--link", "nobody"],
        ["--material", "butter"],
    ],
)
def test_usage_errors(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", str(MISSION), *words]) == 2
    assert capsys.readouterr().err.startswith("error: ")
