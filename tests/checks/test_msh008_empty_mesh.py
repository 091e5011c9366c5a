from __future__ import annotations

from pathlib import Path

import pytest

from tests.meshes import made
from tests.told import told
from tests.workspaces import add_file, mesh_link
from urdfkit.diagnostic import Severity

CODE = "MSH008"


def reasons(tmp_path: Path, name: str, data: bytes) -> list[tuple[str, str]]:
    """What is said of a mesh file, and the help."""
    add_file(tmp_path / name, data)
    found = told(CODE, mesh_link(name), str(tmp_path / "arm.urdf"))
    assert all(diagnostic.severity is Severity.ERROR for diagnostic in found)
    start = f"link 'arm': the visual mesh '{name}' "
    return [(diagnostic.message.removeprefix(start), diagnostic.help) for diagnostic in found]


@pytest.mark.parametrize(
    ("name", "data", "reason"),
    [
        ("hokuyo.dae", b"", "is empty"),
        ("a.stl", made.binary_stl([]), "holds no triangles"),
        ("a.obj", b"v 0 0 0\n", "holds no faces (number of vertices: 1)"),
        ("a.dae", made.collada(faces=0), "holds no triangles"),
    ],
)
def test_empty_files(tmp_path: Path, name: str, data: bytes, reason: str) -> None:
    help_ = "export the mesh again, or copy it from where the robot comes from"
    assert reasons(tmp_path, name, data) == [(reason, help_)]


@pytest.mark.parametrize("data", [made.binary_stl(), made.binary_stl()[:-1], b"<html>"])
def test_other_files(tmp_path: Path, data: bytes) -> None:
    assert reasons(tmp_path, "a.stl", data) == []


def test_a_missing_file_is_not_empty(tmp_path: Path) -> None:
    assert told(CODE, mesh_link("none.stl"), str(tmp_path / "arm.urdf")) == []
