import subprocess
import sys
from pathlib import Path

import pytest

from tests.meshed import SOUND, link, mesh
from urdfkit.core import cache_directory
from urdfkit.core.libraries import why_unmeasured
from urdfkit.lint.rule_examples import whole_robot


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    if reason := why_unmeasured():
        pytest.skip(reason)
    (tmp_path / "a.stl").write_bytes(SOUND)
    path = tmp_path / "robot.urdf"
    path.write_text(whole_robot(link(mesh("a.stl"))), encoding="utf-8")
    return path


def entries(
    robot: Path, monkeypatch: pytest.MonkeyPatch, *words: str, command: str = "check"
) -> int:
    """How many measures a command has kept."""
    directory = robot.parent / "cache"
    monkeypatch.setenv(cache_directory.VARIABLE, str(directory))
    line = [sys.executable, "-m", "urdfkit", command, str(robot), "--select", "MSH", *words]
    subprocess.run(line, check=True, capture_output=True)
    return sum(path.is_file() for path in (directory / "meshes").rglob("*"))


def test_measures_are_cached(robot: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert entries(robot, monkeypatch) == 1
    assert entries(robot, monkeypatch) == 1


@pytest.mark.parametrize("command", ["check", "fix"])
def test_no_cache(robot: Path, monkeypatch: pytest.MonkeyPatch, command: str) -> None:
    assert entries(robot, monkeypatch, "--no-cache", command=command) == 0


def test_other_rules_measure_nothing(robot: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert entries(robot, monkeypatch, "--ignore", "MSH", "--select", "NAM") == 0
