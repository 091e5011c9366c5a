"""Collision bodies as coal wants them, each with bounds that numpy can test for many poses."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any

import coal
import numpy as np

from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.physics.collision.bodies import TOUCH, bounding_radius, half_edges
from urdfkit.physics.collision.bounds import apart
from urdfkit.physics.collision.geometry_arrays import CollisionArrays

#: coal's requests: without it coal misses hits of meshes (measured on a UR5).
MARGIN = 1e-6
#: Contacts of two meshes that are looked at for the deepest.
_CONTACTS = 200
#: A mesh is flat, and has no hull, below this ratio of its thickness and its length.
_FLAT = 1e-6
#: A mesh is its own hull if their volumes differ by no more than this, relatively.
_CONVEX = 1e-6

#: Faces at a vertex count as parallel below this ratio of the spread of their normals.
_PARALLEL = 0.01

#: Of a cube, with a triangle, as coal makes hulls of surfaces only.
_CORNERS = np.array(list(np.ndindex(2, 2, 2))) * 2.0 - 1
_BOX = np.array([[0, 1, 2]])

_IDENTITY = coal.Transform3s()

_PRIMITIVES: dict[str, Callable[..., Any]] = {
    "box": coal.Box,
    "sphere": coal.Sphere,
    "cylinder": coal.Cylinder,
    "capsule": coal.Capsule,
}


@dataclass(frozen=True)
class CollisionGeometry:
    """One collision body in coal."""

    arrays: CollisionArrays  # that it was built from
    hull: Any  # coal's convex body around it; the triangles of a flat mesh
    is_convex: bool  # its hull is no larger than itself
    center: Floats  # (3,), of its bounding box, in its own frame, in m
    half: Floats  # (3,), half the sides of that box
    radius: float  # of a sphere about the center that holds it, in m

    @cached_property
    def exact(self) -> Any:
        """The hull, or the triangles of a mesh that is not convex.

        coal's tree of these takes longer than all else, and most links never need it in a check.
        """
        return self.hull if self.is_convex else _surface(self.arrays.vertices, self.arrays.faces)


def build_geometry(arrays: CollisionArrays) -> CollisionGeometry:
    """Build coal's bodies; coal crashes on those that `geometry_arrays` leaves out."""
    if arrays.kind == "mesh":
        return _mesh(arrays)
    exact = _PRIMITIVES[arrays.kind](*arrays.size)
    half = half_edges(arrays.kind, arrays.size)
    radius = bounding_radius(arrays.kind, half)
    return CollisionGeometry(arrays, exact, True, np.zeros(3), np.array(half), radius)


def _mesh(arrays: CollisionArrays) -> CollisionGeometry:
    vertices, faces = arrays.vertices, arrays.faces
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    center, half = (low + high) / 2, (high - low) / 2
    radius = float(np.linalg.norm(vertices - center, axis=1).max())
    if _is_flat(vertices):
        return CollisionGeometry(arrays, _surface(vertices, faces), True, center, half, radius)
    hull = _hull(vertices, faces) or _hull(center + _CORNERS * half, _BOX)
    inside = abs(volume(vertices - center, faces))
    is_convex = abs(inside - hull.computeVolume()) <= _CONVEX * inside
    return CollisionGeometry(arrays, hull, is_convex, center, half, radius)


def _surface(vertices: Floats, faces: Integers) -> Any:
    model = _triangles(vertices, faces)
    model.endModel()  # makes the tree of bounding volumes
    return model


def _hull(vertices: Floats, faces: Integers) -> Any:
    """The convex hull of a surface; None where 256 edges meet, which coal cannot count."""
    model = _triangles(vertices, faces)
    try:
        model.buildConvexHull(True, "Qt")
    except RuntimeError:
        return None
    return model.convex


def _triangles(vertices: Floats, faces: Integers) -> Any:
    """A mesh without its tree of bounding volumes, of which a hull needs none."""
    model = coal.BVHModelOBBRSS()
    model.beginModel(len(faces), len(vertices))
    model.addVertices(vertices)
    model.addTriangles(faces.astype(np.uint32))
    return model


def _is_flat(vertices: Floats) -> bool:
    """True for points in a plane, of which coal's hull would end the process."""
    spread = np.linalg.svd(vertices - vertices.mean(axis=0), compute_uv=False)
    return len(vertices) < 4 or bool(spread[2] <= _FLAT * spread[0])


def _drawn_in(vertices: Floats, faces: Integers, depth: float) -> tuple[Floats, Integers]:
    """A closed surface whose faces are moved inwards.

    A vertex goes where all its faces want it, by least squares: where faces meet that are almost
    parallel, nothing but their common direction counts.

    Args:
        vertices: (n, 3).
        faces: (m, 3).
        depth: in the unit of the vertices.

    Returns:
        Vertices, each once, and faces.
    """
    points, number = np.unique(np.round(vertices, 7), axis=0, return_inverse=True)
    corners = number.reshape(-1)[faces]
    a, b, c = (points[corners[:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    normals /= np.where(size > 0, size, 1) * (1 if volume(points, corners) > 0 else -1)
    products, sums = np.zeros((len(points), 3, 3)), np.zeros((len(points), 3))
    for corner in range(3):
        np.add.at(products, corners[:, corner], normals[:, :, None] * normals[:, None, :])
        np.add.at(sums, corners[:, corner], normals)
    inverse = np.linalg.pinv(products, rcond=_PARALLEL, hermitian=True)
    return points - depth * (inverse @ sums[:, :, None])[:, :, 0], corners


def volume(vertices: Floats, faces: Integers) -> float:
    """Volume of a closed surface in m^3; negative if it is inside out (divergence theorem)."""
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


class DistanceQuery:
    """Measures the distance of two bodies, thousands of times.

    Args:
        first: stays where it is.
        second: is moved.

    Attributes:
        first, second: see there.
        is_exact: both are convex, so that the distance is that of their hulls.
    """

    def __init__(self, first: CollisionGeometry, second: CollisionGeometry) -> None:
        self.first, self.second = first, second
        self.is_exact = first.is_convex and second.is_convex
        self._place = coal.Transform3s()
        self._ask = coal.DistanceRequest()
        self._distance = coal.DistanceResult()
        self._one, self._many = coal.CollisionRequest(), coal.CollisionRequest()
        for request, contacts in ((self._one, 1), (self._many, _CONTACTS)):
            request.security_margin = MARGIN
            request.enable_contact = True
            request.num_max_contacts = contacts
        self._hits = coal.CollisionResult()

    def distance(self, rotation: Floats, translation: Floats, limit: float) -> float:
        """The signed distance of the two, in m: negative by how deep they overlap.

        Meshes that are no convex bodies are surfaces: one within the other does not overlap.

        Args:
            rotation: (3, 3), of the second in the frame of the first.
            translation: (3,), in the same frame.
            limit: of a distance from here on only a lower bound is needed.
        """
        apart = self.hulls(rotation, translation)
        if self.is_exact or apart >= max(limit, TOUCH):
            return apart
        if apart <= TOUCH:
            depth = self._depth(self._one)
            if 0 < depth <= TOUCH:  # another pair of triangles may lie deeper
                depth = self._depth(self._many)
            if depth > TOUCH:
                return -depth
            if limit <= 0:
                return 0.0
        return max(0.0, self._measure(self.first.exact, self.second.exact, limit))

    def is_deeper(self, rotation: Floats, translation: Floats, depth: float) -> bool:
        """True if the two overlap by more than a depth.

        coal's depth of triangles is no measure: where two meshes only touch, an edge in the plane
        of another triangle is as "deep" as it is far from that triangle's border. So the faces of
        one mesh are drawn in, and what only touched no longer does.

        Args:
            rotation: (3, 3), of the second in the frame of the first.
            translation: (3,), in the same frame.
            depth: in m.
        """
        if self.distance(rotation, translation, 0.0) >= -TOUCH:
            return False
        if self.is_exact:
            return self.hulls(rotation, translation) < -depth
        bodies = [self.first.exact, self.second.exact]
        moved = 0 if self.first.arrays.kind == "mesh" else 1
        mesh = (self.first, self.second)[moved].arrays
        bodies[moved] = _surface(*_drawn_in(mesh.vertices, mesh.faces, depth))
        self._hits.clear()
        first, second = bodies
        return bool(coal.collide(first, _IDENTITY, second, self._place, self._one, self._hits))

    def hulls(self, rotation: Floats, translation: Floats) -> float:
        """The signed distance of the hulls of the two, in m; a lower bound of theirs."""
        self._place.setRotation(rotation)
        self._place.setTranslation(translation)
        return self._measure(self.first.hull, self.second.hull, inf)

    def bounds(self, rotation: Floats, translation: Floats, limit: float) -> Floats:
        """(n,): they are no nearer than that, in m, by the boxes and spheres around them.

        Args:
            rotation: (n, 3, 3), as for `distance`.
            translation: (n, 3).
            limit: bounds from here on, in m, are good enough.
        """
        a, b = self.first, self.second
        offset = translation + rotation @ b.center - a.center
        return apart(a.half, b.half, a.radius + b.radius, rotation, offset, limit)

    @property
    def line(self) -> tuple[Floats, Floats, Floats]:
        """Where the two were nearest when their distance was measured last, in the first's frame.

        Returns:
            A point of the first, one of the second, and coal's unit vector from the first to the
            second, (3,) each. The last is no number to rely on if both are triangles.
        """
        found = self._distance
        return found.getNearestPoint1(), found.getNearestPoint2(), found.normal

    def _measure(self, first: Any, second: Any, limit: float) -> float:
        """The distance of two of coal's bodies; the limit, if it is no less than that."""
        found = self._distance
        found.clear()
        if limit < inf:
            found.min_distance = limit  # coal looks no farther
        coal.distance(first, _IDENTITY, second, self._place, self._ask, found)
        return float(found.min_distance)

    def _depth(self, request: Any) -> float:
        """How deep the exact bodies overlap, at the deepest of some contacts; 0 without any."""
        hits = self._hits
        hits.clear()
        if not coal.collide(
            self.first.exact, _IDENTITY, self.second.exact, self._place, request, hits
        ):
            return 0.0
        return max(-float(contact.penetration_depth) for contact in hits.getContacts())
