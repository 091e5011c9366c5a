from __future__ import annotations

from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import reasons

CODE = "MSH026"


NAN = float("nan")


@pytest.mark.parametrize(
    ("name", "data", "reason"),
    [
        (
            "a.stl",
            made.binary_stl([*made.TETRAHEDRON, ((0, 0, 0), (0, NAN, 0), (1, 0, 0))]),
            "corner 2 of triangle 5 is (0, nan, 0)",
        ),
        (
            "a.stl",
            made.ascii_stl().replace(b"vertex 0 1 0", b"vertex 0 inf 0", 1),
            "the vertex in line 5 is (0, inf, 0)",
        ),
        ("a.dae", made.collada("0 0 0 nan 0 0 0 1 0"), "a coordinate in line 9 is nan"),
        ("a.ply", made.ascii_ply("nan 0 0"), "a vertex is (nan, 0, 0)"),
    ],
)
def test_vertices_that_are_not_finite(tmp_path: Path, name: str, data: bytes, reason: str) -> None:
    help_ = "export the mesh again, or remove the triangle in a mesh editor"
    assert reasons(tmp_path, CODE, name, data) == [(f"is not finite: {reason}", help_)]


@pytest.mark.parametrize(("form", "suffix"), made.SOUND)
def test_sound_files(tmp_path: Path, form: str, suffix: str) -> None:
    assert reasons(tmp_path, CODE, f"a{suffix}", made.SOUND[form, suffix]) == []
