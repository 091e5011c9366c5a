"""Entries of the cache."""

import os
from pathlib import Path
from random import Random

import pytest

from urdfkit.core import cache_entries
from urdfkit.core.cache_entries import LOOKS, store


def test_the_older_half_of_a_full_directory_is_removed(tmp_path: Path) -> None:
    for number in range(10):
        old = tmp_path / f"{number}"
        old.write_bytes(b"1" * LOOKS)
        os.utime(old, (number, number))
    store(str(tmp_path / "00000000"), b"new", 10 * LOOKS + 1)
    assert len(list(tmp_path.iterdir())) == 11
    store(str(tmp_path / "00000000"), b"new", 10 * LOOKS)
    assert {path.name for path in tmp_path.iterdir()} == {"6", "7", "8", "9", "00000000"}


def test_few_entries_list_the_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    looks: list[str] = []
    monkeypatch.setattr(cache_entries, "_make_room", lambda directory, _: looks.append(directory))
    random = Random(0)
    for _ in range(1000):
        store(str(tmp_path / f"{random.getrandbits(32):08x}"), b"12345", 50 * LOOKS)
    assert 50 < len(looks) < 200


def test_what_cannot_be_written_is_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    store(str(tmp_path / "00000000"), b"1", 1000)
    assert list(tmp_path.iterdir()) == []
