from __future__ import annotations

from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import reasons

CODE = "MSH010"


FETCH = "fetch the file itself: from the raw link of the page, or with git lfs pull"


@pytest.mark.parametrize(
    ("name", "data", "reason", "help_"),
    [
        (
            "hokuyo.dae",
            b"<!DOCTYPE html><html><title>hokuyo.dae at main</title></html>",
            "is a web page: 'hokuyo.dae at main'",
            FETCH,
        ),
        (
            "a.stl",
            b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 684\n",
            "is a Git LFS pointer: the mesh of 684 bytes itself has not been fetched",
            "run git lfs pull",
        ),
        ("a.stl", b"404: Not Found", "is text of no mesh format: '404: Not Found'", FETCH),
    ],
)
def test_something_else(tmp_path: Path, name: str, data: bytes, reason: str, help_: str) -> None:
    assert reasons(tmp_path, CODE, name, data) == [(reason, help_)]


@pytest.mark.parametrize("data", [made.binary_stl(), made.binary_stl()[:-1], b""])
def test_other_files(tmp_path: Path, data: bytes) -> None:
    assert reasons(tmp_path, CODE, "a.stl", data) == []
