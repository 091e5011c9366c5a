"""Compares visuals and collisions of a USD stage with the robot."""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np
from pxr import Usd, UsdGeom, UsdPhysics

from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
from urdfkit.robot.link import Body, Link, Shape

#: Prim types of URDF's primitives.
_TYPES = {"box": "Cube", "sphere": "Sphere", "cylinder": "Cylinder"}
#: Lengths in m below this are rounding errors.
_ZERO = 1e-9
_CORNERS = np.array(list(product((-1.0, 1.0), repeat=3)))


def converted_shapes(link: Link) -> list[Body]:
    """Visuals and collisions of a link that become prims, in the order of the prims."""
    return [
        body
        for body in link.bodies
        if body.shape and (body.shape.kind in _TYPES or body.shape.filename)
    ]


def gprims(prim: Any) -> list[Any]:
    """Prims with a shape at a prim or below it; empty for a mesh that is not converted."""
    return [part for part in Usd.PrimRange(prim) if part.IsA(UsdGeom.Gprim)]


def shape_difference(prim: Any, robot: Context, body: Body) -> float:
    """Difference of a prim from a visual or collision in pose and size, relative to the size.

    A mesh is compared by its bounding box in the frame of the visual or collision.
    """
    shape = body.shape
    assert shape is not None
    if not gprims(prim):
        return 0.0  # reported as a loss
    collides = any(gprim.HasAPI(UsdPhysics.CollisionAPI) for gprim in gprims(prim))
    if collides != (body.at.tag == "collision"):
        return 1.0
    to_body = homogeneous(*body.origin.inverse)
    extents = shape.half_extents
    if extents is None:
        return _mesh_difference(prim, robot, shape, to_body)
    theirs = _half_extents(prim)
    if prim.GetTypeName() != _TYPES[shape.kind] or theirs is None:
        return 1.0
    points = _transformed(_CORNERS * theirs, to_body @ _matrix(prim, prim.GetParent()))
    return float(np.abs(points - _CORNERS * extents).max() / max(*extents, _ZERO))


def _mesh_difference(prim: Any, robot: Context, shape: Shape, to_body: Floats) -> float:
    mesh = robot.meshes.mesh(shape) if shape.filename else None
    if mesh is None or not len(mesh.faces):
        return 0.0
    ours = mesh.vertices[np.unique(mesh.faces)] * np.multiply(shape.scale, mesh.unit)
    theirs = np.concatenate([_transformed(points, to_body @ at) for points, at in _vertices(prim)])
    low, high = theirs.min(axis=0) - ours.min(axis=0), theirs.max(axis=0) - ours.max(axis=0)
    return float(np.abs([low, high]).max() / max(np.abs(ours).max(), _ZERO))


def _half_extents(prim: Any) -> Floats | None:
    """Half the bounding box of a primitive in its own frame; None for another prim."""
    if prim.IsA(UsdGeom.Cube):
        return np.full(3, UsdGeom.Cube(prim).GetSizeAttr().Get() / 2)
    if prim.IsA(UsdGeom.Sphere):
        return np.full(3, UsdGeom.Sphere(prim).GetRadiusAttr().Get())
    if prim.IsA(UsdGeom.Cylinder):
        cylinder = UsdGeom.Cylinder(prim)
        radius = cylinder.GetRadiusAttr().Get()
        return np.array([radius, radius, cylinder.GetHeightAttr().Get() / 2])
    return None


def _vertices(prim: Any) -> Iterator[tuple[Floats, Floats]]:
    """Vertices (n, 3) of the meshes at a prim or below it, and their pose in its parent."""
    for mesh in gprims(prim):
        if mesh.IsA(UsdGeom.Mesh):
            points = np.array(UsdGeom.Mesh(mesh).GetPointsAttr().Get(), dtype=float)
            used = np.unique(UsdGeom.Mesh(mesh).GetFaceVertexIndicesAttr().Get())
            yield points[used], _matrix(mesh, prim.GetParent())


def _matrix(prim: Any, ancestor: Any) -> Floats:
    """Pose of a prim in an ancestor, (4, 4)."""
    transform, _ = UsdGeom.XformCache().ComputeRelativeTransform(prim, ancestor)
    return np.asarray(np.array(transform).T)


def _transformed(points: Floats, at: Floats) -> Floats:
    return np.asarray(points @ at[:3, :3].T + at[:3, 3])
