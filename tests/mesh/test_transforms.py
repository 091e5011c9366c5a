"""Meshes moved and stretched, against trimesh."""

import pytest

pytest.importorskip("numpy")
trimesh = pytest.importorskip("trimesh")

import numpy as np

from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.transforms import scaled

BALL = trimesh.creation.icosphere(subdivisions=1)
MESH = Mesh((MeshPart(BALL.vertices.view(np.ndarray), BALL.faces, normals=BALL.vertex_normals),))


@pytest.mark.parametrize("factors", [(1, 2, 3), (-1, 2, 3), (-1, -2, -3), (1e-3, 1e-3, 1e-3)])
def test_normals_stay_upright(factors: tuple[float, float, float]):
    (part,) = scaled(MESH, factors).parts
    stretched = BALL.copy()
    stretched.apply_scale(factors)
    assert part.vertices == pytest.approx(stretched.vertices)
    normals = BALL.vertex_normals / factors
    assert part.normals == pytest.approx(normals / np.linalg.norm(normals, axis=1)[:, None])
    again = trimesh.Trimesh(part.vertices, part.faces, process=False)
    assert again.volume == pytest.approx(abs(np.prod(factors)) * BALL.volume)


@pytest.mark.parametrize("factor", [1e-300, 1e300, 1e308])
def test_no_factor_is_too_large_for_normals(factor: float):
    (part,) = scaled(scaled(MESH, (2.0, 2.0, 2.0)), (factor,) * 3).parts
    assert part.normals == pytest.approx(BALL.vertex_normals)
