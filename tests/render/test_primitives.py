"""The triangles of shapes against closed forms; normals that are found for meshes without."""

from math import pi

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np

from urdfkit.render import primitives
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
