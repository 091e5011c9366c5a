"""The triangles of shapes against closed forms; normals that are found for meshes without."""

from __future__ import annotations

from math import pi

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np

from urdfkit.render import primitives
from urdfkit.render.normals import smooth
from urdfkit.render.primitives import Triangles

SHAPES = {
    "box": (primitives.box(0.2, 0.4, 0.6), 0.048, 0.88, 1e-5),
    "cylinder": (primitives.cylinder(0.1, 0.5), pi * 0.005, 2 * pi * 0.1 * 0.6, 2e-3),
    "sphere": (primitives.sphere(0.3), 4 / 3 * pi * 0.027, 4 * pi * 0.09, 3e-3),
    "capsule": (
        primitives.capsule(0.1, 0.5),
        pi * 0.005 + 4 / 3 * pi * 0.001,
        2 * pi * 0.1 * 0.5 + 4 * pi * 0.01,
        3e-3,
    ),
}


def corners(shape: Triangles) -> np.ndarray:
    return shape.vertices[shape.faces].astype(float)


@pytest.mark.parametrize("name", SHAPES)
def test_volume_and_surface_are_those_of_the_shape(name: str) -> None:
    shape, volume, surface, tolerance = SHAPES[name]
    a, b, c = np.moveaxis(corners(shape), 1, 0)
    product = np.cross(b - a, c - a)
    assert np.einsum("ij,ij->", a, product) / 6 == pytest.approx(volume, rel=tolerance)
    assert np.linalg.norm(product, axis=1).sum() / 2 == pytest.approx(surface, rel=tolerance)


@pytest.mark.parametrize("name", SHAPES)
def test_normals_point_outwards(name: str) -> None:
    shape = SHAPES[name][0]
    if shape.normals is None:
        return
    assert np.linalg.norm(shape.normals, axis=1) == pytest.approx(1, abs=1e-5)
    a, b, c = np.moveaxis(corners(shape), 1, 0)
    product = np.cross(b - a, c - a)
    whole = np.linalg.norm(product, axis=1) > 1e-9
    mean = shape.normals[shape.faces].mean(axis=1)
    assert (np.einsum("ij,ij->i", product, mean)[whole] > 0).all()


def test_the_normals_of_a_sphere_are_its_radii() -> None:
    shape = primitives.sphere(0.3)
    assert shape.normals is not None
    assert shape.normals == pytest.approx(shape.vertices / 0.3, abs=1e-5)


def test_smoothing_finds_the_surface_of_a_cylinder_and_keeps_its_rims() -> None:
    shape = primitives.cylinder(0.1, 0.5)
    loose = shape.vertices[shape.faces].reshape(-1, 3)  # as an STL file has it
    faces = np.arange(len(loose), dtype=np.int32).reshape(-1, 3)
    found = smooth(loose, faces)
    assert found is not None
    found, loose = (rows[np.linalg.norm(found, axis=1) > 0.5] for rows in (found, loose))
    upright = np.abs(found[:, 2]) < 0.5
    radial = loose[upright] * (1, 1, 0) / 0.1
    assert np.einsum("ij,ij->i", found[upright], radial) == pytest.approx(1, abs=1e-3)
    assert np.abs(found[~upright][:, 2]) == pytest.approx(1, abs=1e-4)


def test_a_box_stays_flat() -> None:
    shape = primitives.box(1, 1, 1)
    assert smooth(shape.vertices, shape.faces) is None


def test_corners_without_end_at_one_point_stay_flat_and_quick() -> None:
    """A fan of 60 000 triangles: pairs of its corners would be 3.6 thousand million."""
    rim = np.linspace(0, 2 * pi, 60_001)
    points = np.stack((np.cos(rim), np.sin(rim), np.cos(9 * rim)), axis=1).astype(np.float32)
    vertices = np.concatenate((np.zeros((1, 3), dtype=np.float32), points))
    index = np.arange(1, 60_001, dtype=np.int32)
    smooth(vertices, np.stack((np.zeros_like(index), index, index + 1), axis=1))
