"""Directories for a while, and what a kill leaves of them."""

import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from urdfkit.core import temporary

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows locks no directories")

#: Uses a directory until it is killed.
USER = """
import sys, time
from urdfkit.core.temporary import scratch, workshop
with {} as directory:
    open(directory + "/file", "w").close()
    print(directory, flush=True)
    time.sleep(1000)
"""


def user(call: str) -> tuple[subprocess.Popen[str], Path]:
    process = subprocess.Popen(
        [sys.executable, "-c", USER.format(call)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    return process, Path(process.stdout.readline().strip())


def kill(process: subprocess.Popen[str]) -> None:
    process.send_signal(signal.SIGKILL)
    process.communicate()


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr(tempfile, "tempdir", None)
    return tmp_path


def test_a_scratch_directory_that_a_kill_leaves_is_removed_by_the_next(home: Path) -> None:
    process, directory = user("scratch()")
    try:
        with temporary.scratch() as other:
            assert Path(other).parent == home
            assert directory.exists(), "it is in use"
    finally:
        kill(process)
    assert directory.exists()
    with temporary.scratch():
        assert not directory.exists()
    assert list(home.iterdir()) == []


def test_what_others_have_there_stays(home: Path) -> None:
    (home / "urdfkit-mine").mkdir()
    (home / "outside").mkdir()
    (home / "urdfkit-abcdefgh.tmp").symlink_to(home / "outside")
    with temporary.scratch():
        pass
    assert {path.name for path in home.iterdir()} == {
        "urdfkit-mine",
        "outside",
        "urdfkit-abcdefgh.tmp",
    }


def test_a_workshop_has_one_user_and_keeps_what_a_kill_leaves(tmp_path: Path) -> None:
    out = str(tmp_path / "out")
    process, directory = user(f"workshop({out!r})")
    try:
        with pytest.raises(BlockingIOError), temporary.workshop(out):
            pass
    finally:
        kill(process)
    with temporary.workshop(out) as mine:
        assert Path(mine) == directory
        assert os.listdir(mine) == ["file"]
    assert list(tmp_path.iterdir()) == []


def test_a_workshop_is_no_link(tmp_path: Path) -> None:
    with temporary.workshop(str(tmp_path / "out")) as directory:
        pass
    (tmp_path / "outside").mkdir()
    os.symlink(tmp_path / "outside", directory)
    with pytest.raises(OSError, match="irectory"), temporary.workshop(str(tmp_path / "out")):
        pass
    assert (tmp_path / "outside").exists()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such locks")
def test_a_directory_that_another_process_takes_for_abandoned_is_left_to_it(
    home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = tempfile.mkdtemp
    locked: list[int] = []

    def locked_by_another(*words: str) -> str:
        path = made(*words)
        if not locked:
            locked.append(temporary._lock(path) or -1)
        return path

    monkeypatch.setattr(tempfile, "mkdtemp", locked_by_another)
    with temporary.scratch() as path:
        assert os.path.isdir(path)
    os.close(locked[0])
    assert len(list(home.iterdir())) == 1
