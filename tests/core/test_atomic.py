import os
import stat
import subprocess
import sys
from collections.abc import Iterator
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


def test_what_cannot_be_written_is_said_with_the_fix(tmp_path: Path) -> None:
    with pytest.raises(UnwritableFile, match="is a directory; pass a file in it"):
        atomic.write(tmp_path, b"")
    with pytest.raises(UnwritableFile, match=r"no such directory '.*missing'; create it first"):
        atomic.write(tmp_path / "missing" / "a", b"")
    with pytest.raises(UnwritableFile, match="null"):
        atomic.write("a\0b", b"")


def temporary(path: Path) -> Path:
    return Path(atomic.temporary_name(str(path), ".tmp"))


@UNIX
def test_what_a_kill_has_left_is_used_again(tmp_path: Path) -> None:
    file = tmp_path / ("x" * 255)  # as long as a name can be
    temporary(file).write_bytes(b"half of something long")
    atomic.write(file, b"new")
    assert file.read_bytes() == b"new"
    assert os.listdir(tmp_path) == [file.name]


@UNIX
@pytest.mark.parametrize("kind", ["link", "hard link", "pipe"])
def test_what_somebody_has_put_in_its_way_is_not_written_to(kind: str, tmp_path: Path) -> None:
    file, other = tmp_path / "file", tmp_path / "other"
    other.write_bytes(b"other")
    if kind == "link":
        temporary(file).symlink_to(other)
    elif kind == "hard link":
        os.link(other, temporary(file))
    else:
        os.mkfifo(temporary(file))
    with pytest.raises(UnwritableFile, match="file: cannot be written"):
        atomic.write(file, b"new")
    assert other.read_bytes() == b"other"
    assert not file.exists()


@UNIX
def test_two_processes_write_one_after_the_other(tmp_path: Path) -> None:
    file = tmp_path / "file"
    inside: list[bytes] = []

    def parts() -> Iterator[bytes]:
        with pytest.raises(UnwritableFile, match="another process is writing it"):
            atomic.write(file, b"other")
        inside.append(temporary(file).read_bytes())
        yield b"first"

    atomic.MAX_WAIT, before = 0.05, atomic.MAX_WAIT
    try:
        atomic.write(file, parts())
    finally:
        atomic.MAX_WAIT = before
    assert inside == [b""]
    assert file.read_bytes() == b"first"


def test_what_another_process_has_written_stays(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_bytes(b"a")
    atomic.write(file, b"b", before=b"a")
    with pytest.raises(UnwritableFile, match="the file changed meanwhile"):
        atomic.write(file, b"c", before=b"a")
    assert file.read_bytes() == b"b"
    assert os.listdir(tmp_path) == ["file"]


@UNIX
def test_many_processes_lose_nothing(tmp_path: Path) -> None:
    """Each adds its own lines to one file, again whenever another one was faster."""
    file = tmp_path / "file"
    file.touch()
    adding = """
import sys
from urdfkit.core import atomic
from urdfkit.errors import UnwritableFile
for number in range(20):
    while True:
        with open(sys.argv[1], "rb") as file:
            before = file.read()
        try:
            atomic.write(sys.argv[1], before + f"{sys.argv[2]} {number}\\n".encode(),
                         before=before, durable=False)
            break
        except UnwritableFile as error:
            assert "changed meanwhile" in str(error), error
"""
    processes = [
        subprocess.Popen([sys.executable, "-c", adding, str(file), name]) for name in "abcd"
    ]
    assert [process.wait() for process in processes] == [0] * 4
    lines = file.read_text().splitlines()
    assert sorted(lines) == sorted(f"{name} {number}" for name in "abcd" for number in range(20))
    assert os.listdir(tmp_path) == ["file"]


@UNIX
def test_a_pipe_is_written_to_if_somebody_reads_it(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(UnwritableFile, match="without a reader"):
        atomic.write(pipe, b"data")
    reading = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        atomic.write(pipe, b"data")
        assert os.read(reading, 10) == b"data"
    finally:
        os.close(reading)
