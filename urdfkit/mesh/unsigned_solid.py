"""The solid by which MuJoCo computes the inertia of a mesh, regardless of triangle orientation."""

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers, areas
from urdfkit.mesh.measures import Uniform


def unsigned_solid(vertices: Floats, faces: Integers) -> Uniform | None:
    """Sum of the tetrahedra between the centre of a surface and its triangles, all positive.

    The volume behind a dent counts more than once. Source: MuJoCo's mesh inertia ``legacy``, which
    its URDF reader uses: https://mujoco.readthedocs.io/en/stable/XMLreference.html#asset-mesh

    Args:
        vertices: (n, 3).
        faces: (m, 3), indices of vertices.

    Returns:
        None if the tetrahedra have no volume.
    """
    area = areas(vertices, faces)
    corners = vertices[faces]
    if not area.sum() > 0:
        return None
    middle = area @ corners.mean(axis=1) / area.sum()
    volumes = _volumes(corners - middle)
    if not volumes.sum() > 0:
        return None
    center = volumes @ (corners.mean(axis=1) * 0.75 + middle * 0.25) / volumes.sum()
    corners = corners - center
    volumes = _volumes(corners)
    sums = corners.sum(axis=1)
    second = np.einsum("i,ij,ik->jk", volumes, sums, sums)
    for corner in range(3):
        second += np.einsum("i,ij,ik->jk", volumes, corners[:, corner], corners[:, corner])
    xx, xy, xz, yy, yz, zz = map(float, second[np.triu_indices(3)] / 20)
    x, y, z = map(float, center)
    tensor = (yy + zz, -xy, -xz, xx + zz, -yz, xx + yy)
    return Uniform(float(volumes.sum()), (x, y, z), tensor)


def _volumes(corners: Floats) -> Floats:
    """(m,), volumes of the tetrahedra between the origin and triangles (m, 3, 3)."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    return np.asarray(np.abs(np.einsum("ij,ij->i", a, np.cross(b, c))) / 6)
