from pathlib import Path

import pytest

from urdfkit.output.formats._paths import in_repository


@pytest.mark.parametrize("here", [".", "src", "src/arm", "src/arm/urdf", "src/hand"])
def test_paths_are_those_of_the_repository(
    here: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A job checks out repositories into ``src``, or runs urdfkit in a package."""
    for directory in ("src/arm/.git", "src/arm/urdf", "src/hand"):
        (tmp_path / directory).mkdir(parents=True)
    monkeypatch.chdir(tmp_path / here)
    assert in_repository(str(tmp_path / "src" / "arm" / "urdf" / "a.urdf")) == "urdf/a.urdf"


def test_a_submodule_is_a_part_of_the_repository(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for directory in (".git", "hand/.git"):
        (tmp_path / directory).mkdir(parents=True)
    monkeypatch.chdir(tmp_path)
    assert in_repository("hand/a.urdf") == "hand/a.urdf"


def test_paths_outside_of_repositories_are_those_that_are_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert in_repository(str(tmp_path / "urdf" / "a.urdf")) == "urdf/a.urdf"
    assert in_repository("/opt/a.urdf") == "/opt/a.urdf"
