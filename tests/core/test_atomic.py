from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from urdfkit.core import atomic
from urdfkit.errors import UnwritableFile

UNIX = pytest.mark.skipif(os.name == "nt", reason="no such thing on Windows")


def test_a_new_file_and_one_that_exists(tmp_path: Path) -> None:
    file = tmp_path / "report.json"
    for data in (b"first", b"second, longer", b""):
        atomic.write(file, data)
        assert file.read_bytes() == data
        assert os.listdir(tmp_path) == ["report.json"], "nothing is left over"


def test_line_ends_stay_as_they_are(tmp_path: Path) -> None:
    atomic.write(tmp_path / "a", b"\n\r\n")
    assert (tmp_path / "a").read_bytes() == b"\n\r\n"


@UNIX
def test_permissions(tmp_path: Path) -> None:
    old = os.umask(0o022)
    try:
        atomic.write(tmp_path / "new", b"")
        (tmp_path / "old").write_bytes(b"")
        (tmp_path / "old").chmod(0o640)
        atomic.write(tmp_path / "old", b"x")
    finally:
        os.umask(old)
    modes = {name: stat.S_IMODE((tmp_path / name).stat().st_mode) for name in ("new", "old")}
    assert modes == {"new": 0o644, "old": 0o640}


@UNIX
def test_a_link_stays_a_link(tmp_path: Path) -> None:
    target = tmp_path / "directory" / "target"
    target.parent.mkdir()
    target.write_bytes(b"old")
    (tmp_path / "link").symlink_to(target)
    atomic.write(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert target.read_bytes() == b"new"


@UNIX
def test_what_is_no_regular_file_is_written_to() -> None:
    atomic.write("/dev/null", b"data")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


@pytest.mark.parametrize("failing", ["replace", "fsync"])
def test_a_failure_leaves_the_old_file_and_nothing_else(
    failing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "report.json"
    file.write_bytes(b"old")

    def fail(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, failing, fail)
    with pytest.raises(UnwritableFile, match=r"report\.json: .*No space left on device"):
        atomic.write(file, b"new")
    assert file.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["report.json"]


def test_what_cannot_be_written_is_said_with_the_remedy(tmp_path: Path) -> None:
    with pytest.raises(UnwritableFile, match="is a directory; pass a file in it"):
        atomic.write(tmp_path, b"")
    with pytest.raises(UnwritableFile, match=r"no such directory '.*missing'; create it first"):
        atomic.write(tmp_path / "missing" / "a", b"")
    with pytest.raises(UnwritableFile, match="null"):
        atomic.write("a\0b", b"")
