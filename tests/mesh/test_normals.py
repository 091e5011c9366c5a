"""Normals of triangles that have none."""

from math import pi

import pytest

pytest.importorskip("numpy")

import numpy as np

from urdfkit.mesh.geometry import MeshPart
from urdfkit.mesh.normals import shaded
from urdfkit.render import primitives


def test_a_cylinder_is_smooth_around_and_sharp_at_its_rims() -> None:
    shape = primitives.cylinder(0.1, 0.5)
    loose = shape.vertices[shape.faces].reshape(-1, 3).astype(float)  # as an STL file has it
    found = shaded(MeshPart(loose, np.arange(len(loose)).reshape(-1, 3)))
    assert found.normals is not None
    used = np.unique(found.faces[np.ptp(found.vertices[found.faces], axis=1).min(axis=1) >= 0])
    normals, points = found.normals[used], found.vertices[used]
    upright = np.abs(normals[:, 2]) < 0.5
    radial = points[upright] * (1, 1, 0) / 0.1
    assert np.einsum("ij,ij->i", normals[upright], radial) == pytest.approx(1, abs=1e-3)
    assert np.abs(normals[~upright][:, 2]) == pytest.approx(1, abs=1e-4)
    shared = shaded(MeshPart(shape.vertices.astype(float), shape.faces.astype(np.int64)))
    assert len(found.vertices) == len(shared.vertices) < len(loose)


def test_corners_without_end_at_one_point_are_quick() -> None:
    """A fan of 60 000 triangles: pairs of its corners would be 3.6 thousand million."""
    rim = np.linspace(0, 2 * pi, 60_001)
    points = np.stack((np.cos(rim), np.sin(rim), np.cos(9 * rim)), axis=1)
    index = np.arange(1, 60_001)
    faces = np.stack((np.zeros_like(index), index, index + 1), axis=1)
    assert shaded(MeshPart(np.concatenate((np.zeros((1, 3)), points)), faces)).normals is not None
