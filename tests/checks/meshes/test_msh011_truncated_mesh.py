from __future__ import annotations

from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import reasons

CODE = "MSH011"


@pytest.mark.parametrize(
    ("name", "data", "reason"),
    [
        ("a.stl", made.binary_stl()[:-1], "declares 4 triangles and holds 3"),
        (
            "a.stl",
            made.binary_stl() + b"\n",
            "holds 1 byte beyond the 4 triangles it declares",
        ),
        ("a.stl", made.ascii_stl()[:-20], "ends after 3 triangles, without 'endsolid'"),
        (
            "bot.dae",
            made.collada()[: made.collada().index(b"<library_geometries>")],
            "ends inside <COLLADA>, before any triangle",
        ),
        ("a.ply", made.ascii_ply()[:-9], "declares 1 face and holds 0"),
        ("a.glb", made.glb()[:8], "ends after 8 bytes, inside its header"),
    ],
)
def test_cut_off_files(tmp_path: Path, name: str, data: bytes, reason: str) -> None:
    assert reasons(tmp_path, CODE, name, data) == [(reason, "fetch or export the mesh again")]


@pytest.mark.parametrize("data", [made.binary_stl(), b"<html>", b""])
def test_other_files(tmp_path: Path, data: bytes) -> None:
    assert reasons(tmp_path, CODE, "a.stl", data) == []
