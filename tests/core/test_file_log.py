"""When a file is the one that was read."""

import os
import sys
import time
from pathlib import Path

import pytest

from urdfkit.core.file_log import FileLog, present_answer


def test_a_file_with_the_same_time_is_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise AssertionError("it was read")

    path, log = tmp_path / "a", FileLog()
    path.touch()
    state = path.stat()
    log.read(str(path), -1, b"", state)
    answer = log.answers["r", str(path)]
    monkeypatch.setattr("builtins.open", fail)
    changed = max(state.st_mtime_ns, state.st_ctime_ns)
    assert present_answer("r", str(path), answer, changed + 3_000_000_000) == answer
    with pytest.raises(AssertionError, match="it was read"):  # it was new: it may be another one
        present_answer("r", str(path), answer, changed + 1_000_000_000)


@pytest.mark.skipif(sys.platform == "win32", reason="has no time of the last change of a file")
def test_a_change_whose_time_is_set_back_is_seen(tmp_path: Path) -> None:
    path, log = tmp_path / "a", FileLog()
    path.write_bytes(b"old")
    state = path.stat()
    log.read(str(path), -1, b"old", state)
    time.sleep(0.05)  # a tick of the clock of the file system
    path.write_bytes(b"new")
    os.utime(path, ns=(state.st_atime_ns, state.st_mtime_ns))
    later = state.st_ctime_ns + 3_000_000_000
    assert present_answer("r", str(path), log.answers["r", str(path)], later) is None


def test_a_change_within_one_tick_of_the_clock_is_seen(tmp_path: Path) -> None:
    path, log = tmp_path / "a", FileLog()
    since = time.time_ns()
    path.write_bytes(b"old")
    state = path.stat()
    log.read(str(path), -1, b"old", state)
    path.write_bytes(b"new")
    os.utime(path, ns=(state.st_atime_ns, state.st_mtime_ns))
    assert present_answer("r", str(path), log.answers["r", str(path)], since) is None
