"""A disk that is full at the n-th write: one error, the old files, and nothing left over."""

import errno
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import MODELS
from urdfkit.cli import main
from urdfkit.core import atomic

#: Commands that write, in a copy of ``models/``.
COMMANDS = [
    "fix gazebo_pkg --unsafe-fixes",
    "format gazebo_pkg --width 60",
    "report good/gripper.urdf --quick -o made.html",
    "expand good/gripper.urdf -o made.urdf",
    "check good --format json:made.json",
    "check gazebo_pkg --baseline made.json --write-baseline",
    "scan good -o out",
    "init good",
]


@pytest.fixture
def directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("good", "gazebo_pkg"):
        shutil.copytree(MODELS / name, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def files(directory: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in directory.rglob("*") if path.is_file()}


@pytest.mark.parametrize("failing", ["fsync", "replace", "open"])
@pytest.mark.parametrize("line", COMMANDS)
def test_it_is_one_error(
    line: str,
    failing: str,
    directory: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    before = files(directory)

    def full(*_: object, **__: object) -> Any:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patch:
        if failing == "open":
            patch.setattr(atomic, "_claimed", full)
        else:
            patch.setattr(os, failing, full)
        assert main(line.split()) == 2
    err = capsys.readouterr().err
    assert err.count("error: ") == 1
    assert "No space left on device" in err
    assert files(directory) == before
    assert main(line.split()) in (0, 1)


@pytest.fixture
def small() -> Iterator[Path]:
    """A file system of 64 kB."""
    if os.geteuid() != 0 or shutil.which("mount") is None:
        pytest.skip("only root may mount")
    place = Path("/tmp") / f"urdfkit-small-{os.getpid()}"
    place.mkdir()
    mounting = ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(place)]
    if subprocess.run(mounting, capture_output=True, check=False).returncode:
        place.rmdir()
        pytest.skip("this machine mounts nothing")
    try:
        yield place
    finally:
        subprocess.run(["umount", str(place)], check=True)
        place.rmdir()


def test_a_small_disk(small: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = small / "r.urdf"
    links = "".join(f'<link   name="a{number}" ></link>\n' for number in range(2000))
    robot.write_text(f'<robot name="r">\n{links}</robot>')
    before = robot.read_bytes()
    for words in (["format", str(robot)], ["report", str(robot), "--quick", "-o", f"{small}/a.md"]):
        assert main(words) == 2
        err = capsys.readouterr().err
        assert err.count("error: ") == 1
        assert "No space left on device" in err
    assert robot.read_bytes() == before
    assert os.listdir(small) == ["r.urdf"]
