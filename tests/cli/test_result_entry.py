"""Entries of the cache of results: written, read, damaged and keyed."""

import os
from pathlib import Path

import pytest

from urdfkit.cli import result_cache, result_entry, result_recording
from urdfkit.cli.result_entry import ResultEntry, decode, encode
from urdfkit.core.cache_directory import VARIABLE


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def entry(cache: Path, tmp_path: Path) -> ResultEntry:
    """One that holds, of a command line that is never checked."""
    asked = result_cache.cache_key(["check", "a.urdf"])
    assert asked is not None
    out = (str(tmp_path / "out\n.txt"), b"a\0b\n")
    return ResultEntry(asked, 5, [("k", str(tmp_path / "none"), "-")], 1, [out])


def test_an_entry_is_replayed(entry: ResultEntry) -> None:
    assert result_cache.replay(["check", "a.urdf"]) is None
    result_recording.store(entry)
    assert decode(encode(entry)) == entry
    assert result_cache.replay(["check", "a.urdf"]) == 1
    assert Path(entry.outputs[0][0]).read_bytes() == b"a\0b\n"


def test_a_damaged_entry_is_ignored(entry: ResultEntry) -> None:
    data = encode(entry)
    path = Path(result_entry.path_of(entry.key))
    path.parent.mkdir(parents=True)
    broken = [data[:size] for size in range(len(data))]
    broken += [data[:at] + b"\xff" + data[at + 1 :] for at in range(len(data))]
    for one in broken:
        path.write_bytes(one)
        assert result_cache.replay(["check", "a.urdf"]) is None


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_a_pipe_instead_of_an_entry_is_ignored(entry: ResultEntry) -> None:
    path = result_entry.path_of(entry.key)
    os.makedirs(os.path.dirname(path))
    os.mkfifo(path)
    assert result_cache.replay(["check", "a.urdf"]) is None
    result_recording.store(entry)


def test_an_entry_is_for_one_key(entry: ResultEntry) -> None:
    other = entry._replace(key=entry.key + b"x")
    path = Path(result_entry.path_of(entry.key))
    path.parent.mkdir(parents=True)
    path.write_bytes(encode(other))  # of the same name, as two checksums may be
    assert result_cache.replay(["check", "a.urdf"]) is None


def test_another_version_has_another_key(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    installed = tmp_path / "site-packages"
    installed.mkdir()
    monkeypatch.syspath_prepend(installed)
    asked = [result_cache.cache_key(["check", "a"])]
    os.utime(installed, (1, 1))
    asked.append(result_cache.cache_key(["check", "a"]))
    (installed / "numpy").mkdir()
    asked.append(result_cache.cache_key(["check", "a"]))
    monkeypatch.setattr(result_cache, "__version__", "9")
    asked.append(result_cache.cache_key(["check", "a"]))
    assert len(set(asked)) == 4


def test_an_installed_extra_changes_the_key(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(tmp_path)
    asked = result_cache.cache_key(["check", "a"])
    (tmp_path / "robot.png").touch()
    assert result_cache.cache_key(["check", "a"]) == asked
    (tmp_path / "manifold3d.cpython-311-x86_64-linux-gnu.so").touch()
    again = result_cache.cache_key(["check", "a"])
    assert again != asked
    (tmp_path / "manifold3d-3.0.1.dist-info").mkdir()
    assert result_cache.cache_key(["check", "a"]) not in (asked, again)


@pytest.mark.parametrize("place", ["/dev/full", "/dev/null/cache"])
def test_an_unwritable_cache_is_ignored(
    entry: ResultEntry, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    monkeypatch.setattr(result_entry, "path_of", lambda _: f"{place}/entry")
    result_recording.store(entry)


def test_a_full_disk_leaves_no_file(
    entry: ResultEntry, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    result_recording.store(entry)
    assert list((cache / "results").iterdir()) == []
