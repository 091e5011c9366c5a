"""Input that ends or stops a native library, and what urdfkit makes of the same input.

A version of a library that takes its killer is skipped; urdfkit must do without its crash anyway.
"""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from urdfkit.mesh.geometry import Mesh, MeshPart

pytestmark = pytest.mark.skipif(os.name == "nt", reason="processes end by no signal there")

pytest.importorskip("manifold3d")

#: A box whose faces are not those of a box: 9 triangles, whose edges cannot be pairs.
NO_PAIRS = (
    (6, 7, 2), (2, 1, 4), (4, 6, 2), (7, 5, 1), (3, 7, 6), (3, 5, 7), (1, 5, 4), (0, 6, 4),
    (0, 3, 6),
)  # fmt: skip
BOX = (
    (1, 1, -1), (-1, 1, 1), (-1, -1, -1), (1, -1, 1), (-1, 1, -1), (1, 1, 1), (1, -1, -1),
    (-1, -1, 1),
)  # fmt: skip
#: A tetrahedron.
PEAK, SIDES = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), (
    (0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3),
)  # fmt: skip
WITH_NAN = (*PEAK[:3], (0, 0, float("nan")))
BEYOND = (*SIDES[:3], (1, 2, 2**31 - 2))


def mesh(points: object, faces: object) -> Mesh:
    return Mesh((MeshPart(np.array(points, dtype=float), np.array(faces, dtype=np.int64)),))


def require_death(code: str) -> None:
    """Skip unless a process that runs some code is killed: by itself, or after 5 s of computing."""
    bound = "import resource; resource.setrlimit(resource.RLIMIT_CORE, (0, 0))\n"
    bound += "resource.setrlimit(resource.RLIMIT_CPU, (5, 5))\n"
    bound += "import numpy as np; from math import nan\n"
    done = subprocess.run([sys.executable, "-c", bound + code], capture_output=True, check=False)
    if done.returncode >= 0:
        pytest.skip("this version of the library takes its killer")


def test_manifold3d_and_a_surface_whose_edges_are_no_pairs() -> None:
    from urdfkit.mesh.manifolds import solid

    assert solid(np.array(BOX, dtype=float), np.array(NO_PAIRS)).is_empty()
    require_death(
        "from manifold3d import Manifold, Mesh64\n"
        f"Manifold(Mesh64(np.array({BOX}, float), np.array({NO_PAIRS}, np.uint64)))"
    )


def test_simplification_of_a_surface_whose_edges_are_no_pairs() -> None:
    from urdfkit.mesh.simplify import to_budget

    assert 0 < len(to_budget(mesh(BOX, NO_PAIRS), 8).mesh.faces) <= 8


def test_fast_simplification_and_an_index_beyond_the_vertices(tmp_path: Path) -> None:
    pytest.importorskip("fast_simplification")
    from urdfkit.mesh.io.load import salvage
    from urdfkit.mesh.simplify import to_budget

    lines = [f"v {x} {y} {z}" for x, y, z in PEAK]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in [*SIDES, *BEYOND]]
    path = tmp_path / "damaged.obj"
    path.write_text("\n".join(lines))
    found = salvage(path)
    assert found.losses == ("1 triangle with a vertex that is not in the file",)
    assert len(to_budget(found, 4).mesh.faces) <= 4
    require_death(
        "from fast_simplification import simplify\n"
        f"simplify(np.array({PEAK}, float), np.array({BEYOND}), target_count=2)"
    )


def test_vhacdx_and_a_vertex_that_is_no_number() -> None:
    pytest.importorskip("vhacdx")
    from urdfkit.mesh.convex_decomposition import cut
    from urdfkit.mesh.convex_hull import NoHull

    with pytest.raises(NoHull):  # the triangles that are left lie in a plane
        cut(mesh(WITH_NAN, SIDES))
    points = (*PEAK, (float("nan"), 0, 0))
    assert np.isfinite(cut(mesh(points, (*SIDES, (0, 1, 4)))).vertices).all()
    require_death(
        "from vhacdx import compute_vhacd\n"
        f"faces = np.column_stack([[3] * 4, {SIDES}]).astype(np.uint32)\n"
        f"compute_vhacd(np.array({WITH_NAN}), faces, resolution=50000, asyncACD=False)"
    )


def test_coacd_and_a_vertex_that_is_no_number() -> None:
    pytest.importorskip("coacd")
    from urdfkit.mesh.convex_decomposition import cut

    points = (*PEAK, (float("nan"), 0, 0))
    faces = (*SIDES, (0, 1, 4))
    assert np.isfinite(cut(mesh(points, faces), engine="coacd").vertices).all()
    require_death(
        "import coacd\n"
        f"coacd.run_coacd(coacd.Mesh(np.array({points}), np.array({faces})), decimate=True)"
    )


def test_coal_and_the_hull_of_a_plane() -> None:
    pytest.importorskip("coal")
    from urdfkit.physics.collision.collision_geometry import build_geometry
    from urdfkit.physics.collision.geometry_arrays import CollisionArrays

    plane = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0))
    faces = ((0, 1, 2), (1, 3, 2))
    found = build_geometry(
        CollisionArrays("a", 0, np.eye(4), "mesh", (), np.array(plane, float), np.array(faces))
    )
    assert found.is_convex
    require_death(
        "import coal\nmodel = coal.BVHModelOBBRSS()\nmodel.beginModel(2, 4)\n"
        f"model.addVertices(np.array({plane}, float))\n"
        f"model.addTriangles(np.array({faces}, np.uint32))\n"
        "model.endModel()\nmodel.buildConvexHull(True, 'Qt')"
    )
