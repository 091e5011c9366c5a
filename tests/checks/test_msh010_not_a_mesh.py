from __future__ import annotations

from pathlib import Path

import pytest

from tests.meshes import made
from tests.told import told
from tests.workspaces import add_file, mesh_link
from urdfkit.diagnostic import Severity

CODE = "MSH010"


def reasons(tmp_path: Path, name: str, data: bytes) -> list[tuple[str, str]]:
    """What is said of a mesh file, and the help."""
    add_file(tmp_path / name, data)
    found = told(CODE, mesh_link(name), str(tmp_path / "arm.urdf"))
    assert all(diagnostic.severity is Severity.ERROR for diagnostic in found)
    start = f"link 'arm': the visual mesh '{name}' "
    return [(diagnostic.message.removeprefix(start), diagnostic.help) for diagnostic in found]


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
    assert reasons(tmp_path, name, data) == [(reason, help_)]


@pytest.mark.parametrize("data", [made.binary_stl(), made.binary_stl()[:-1], b""])
def test_other_files(tmp_path: Path, data: bytes) -> None:
    assert reasons(tmp_path, "a.stl", data) == []
