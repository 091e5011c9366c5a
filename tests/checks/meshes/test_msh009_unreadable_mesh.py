from __future__ import annotations

from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import reasons

CODE = "MSH009"


@pytest.mark.parametrize(
    ("name", "data", "reason"),
    [
        (
            "a.stl",
            made.ascii_stl().replace(b"vertex 0 1 0", b"vertex 0,0 1,0 0,0"),
            "has 'vertex 0,0 1,0 0,0' in line 5, not three numbers",
        ),
        ("a.obj", made.obj() + b"f 1 2 9\n", "names vertex 9 in line 9 and holds 4 vertices"),
        (
            "a.dae",
            made.collada().replace(b"</asset>", b"</assets>"),
            "is not well-formed XML: mismatched tag in line 4",
        ),
        ("a.dae", b"\x01\0", "is of no known mesh format (it begins with 01 00)"),
    ],
)
def test_unreadable_files(tmp_path: Path, name: str, data: bytes, reason: str) -> None:
    help_ = "export the mesh again, or copy it from where the robot comes from"
    assert reasons(tmp_path, CODE, name, data) == [(reason, help_)]


@pytest.mark.parametrize("data", [made.binary_stl(), made.binary_stl()[:-1], b"<html>", b""])
def test_other_files(tmp_path: Path, data: bytes) -> None:
    assert reasons(tmp_path, CODE, "a.stl", data) == []
