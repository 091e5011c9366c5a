from __future__ import annotations

from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import reasons
from tests.reported import reported
from tests.workspaces import mesh_link

CODE = "MSH008"


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
    assert reasons(tmp_path, CODE, name, data) == [(reason, help_)]


@pytest.mark.parametrize("data", [made.binary_stl(), made.binary_stl()[:-1], b"<html>"])
def test_other_files(tmp_path: Path, data: bytes) -> None:
    assert reasons(tmp_path, CODE, "a.stl", data) == []


def test_a_missing_file_is_not_empty(tmp_path: Path) -> None:
    assert reported(CODE, mesh_link("none.stl"), str(tmp_path / "arm.urdf")) == []
