"""Collision bodies for coal, with bounds that numpy tests for many poses."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf
from typing import Any

import coal
import numpy as np

from urdfkit.mesh.geometry import Floats, Integers, scaled_normals
from urdfkit.physics.collision.bodies import TOUCH, bounding_radius, half_edges
from urdfkit.physics.collision.bounds import distance_bounds
from urdfkit.physics.collision.geometry_arrays import CollisionArrays

#: Security margin in m, without which coal misses collisions of meshes (measured on a UR5).
MARGIN = 1e-6
#: Contacts of two meshes from which the deepest is selected.
_CONTACTS = 200
#: Depth of the overlap of hulls, in m, below which it is that of the bodies.
_SHALLOW = 1e-4
#: Ratio of thickness to length below which a mesh is flat and has no hull.
_FLAT = 1e-6
#: Relative difference of volumes up to which a mesh is its own hull.
_CONVEX = 1e-6

#: Ratio of the spread of normals at a vertex below which its faces are parallel.
_PARALLEL = 0.01

#: Corners of a cube, and one triangle, because coal only builds hulls of surfaces.
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

    arrays: CollisionArrays  # the source of the body
    hull: Any  # coal's convex hull; the triangles of a flat mesh
    is_convex: bool  # True if the body fills its hull
    center: Floats  # (3,), of the bounding box, in the body's frame, in m
    half: Floats  # (3,), half sides of the bounding box
    radius: float  # of the bounding sphere about the center, in m
    same: "CollisionGeometry | None" = None  # another body with this mesh

    @property
    def outermost(self) -> Floats:
        """(n, 3), the vertices of the hull, with others if the hull is flat or a box."""
        # A box may stand for a hull that coal rejects; flat meshes have no hull.
        points = getattr(self.hull, "num_points", len(_CORNERS))
        return self.arrays.vertices if points == len(_CORNERS) else self.hull.points()

    @cached_property
    def exact(self) -> Any:
        """The hull, or the triangles of a mesh that is not convex.

        Building coal's tree of triangles is slow, and a check needs it for few links.
        """
        if self.same is not None:
            return self.same.exact
        return self.hull if self.is_convex else _surface(self.arrays.vertices, self.arrays.faces)


def build_geometries(bodies: Iterable[CollisionArrays]) -> Iterator[CollisionGeometry]:
    """Build coal's bodies one after another; bodies of one mesh share its hull and its triangles.

    The legs of a hexapod of 49 meshes in 6 files took 1.3 GB.
    """
    known: dict[int, CollisionGeometry] = {}
    for arrays in bodies:
        if first := known.get(id(arrays.vertices)):
            yield replace(first, arrays=arrays, same=first)
            continue
        geometry = build_geometry(arrays)
        if arrays.kind == "mesh":
            known[id(arrays.vertices)] = geometry
        yield geometry


def build_geometry(arrays: CollisionArrays) -> CollisionGeometry:
    """Build coal's bodies; `geometry_arrays` has omitted those that crash coal."""
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
    model.endModel()  # builds the tree of bounding volumes
    return model


def _hull(vertices: Floats, faces: Integers) -> Any:
    """The convex hull of a surface; None if 256 edges meet at a vertex, which coal rejects."""
    model = _triangles(vertices, faces)
    try:
        model.buildConvexHull(True, "Qt")
    except RuntimeError:
        return None
    return model.convex


def _triangles(vertices: Floats, faces: Integers) -> Any:
    """A mesh without a tree of bounding volumes, which a hull does not need."""
    model = coal.BVHModelOBBRSS()
    model.beginModel(len(faces), len(vertices))
    model.addVertices(vertices)
    model.addTriangles(faces.astype(np.uint32))
    return model


def _is_flat(vertices: Floats) -> bool:
    """True for points in a plane, whose hull crashes coal."""
    spread = np.linalg.svd(vertices - vertices.mean(axis=0), compute_uv=False)
    return len(vertices) < 4 or bool(spread[2] <= _FLAT * spread[0])


def _shrunk(vertices: Floats, faces: Integers, depth: float) -> tuple[Floats, Integers]:
    """A closed surface with all faces moved inwards.

    A vertex moves to the least-squares intersection of its moved faces; for almost parallel faces,
    along their common normal only.

    Args:
        vertices: (n, 3).
        faces: (m, 3).
        depth: in the unit of the vertices.

    Returns:
        Vertices, each once, and faces.
    """
    points, number = np.unique(np.round(vertices, 7), axis=0, return_inverse=True)
    corners = number.reshape(-1)[faces]
    normals = scaled_normals(points[corners])
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
    """Measures the distance of two bodies in many relative poses.

    Args:
        first: the fixed body.
        second: the moving body.

    Attributes:
        first, second: the bodies.
        is_exact: True if both are convex, so that the distance of their hulls is exact.
        triangles: their number.
    """

    def __init__(self, first: CollisionGeometry, second: CollisionGeometry) -> None:
        self.first, self.second = first, second
        self.is_exact = first.is_convex and second.is_convex
        self.triangles = sum(
            len(body.arrays.faces) for body in (first, second) if body.arrays.kind == "mesh"
        )
        self._place = coal.Transform3s()
        self._request = coal.DistanceRequest()
        self._distance = coal.DistanceResult()
        self._one, self._many = coal.CollisionRequest(), coal.CollisionRequest()
        for request, contacts in ((self._one, 1), (self._many, _CONTACTS)):
            request.security_margin = MARGIN
            request.enable_contact = True
            request.num_max_contacts = contacts
        self._hits = coal.CollisionResult()

    def distance(self, rotation: Floats, translation: Floats, limit: float) -> float:
        """The signed distance in m; the negative penetration depth if the bodies overlap.

        Meshes that are not convex are surfaces: a body inside such a mesh does not overlap it.
        Bodies whose hulls overlap by less than 0.1 mm are taken for their hulls.

        Args:
            rotation: (3, 3), of the second body in the frame of the first.
            translation: (3,), in the same frame.
            limit: for larger distances, a lower bound is sufficient.
        """
        bound = self.hulls(rotation, translation)
        # The triangles of two flanges that lie on one another take coal seconds in each pose.
        is_shallow = -_SHALLOW < bound < -TOUCH
        if self.is_exact or is_shallow or bound >= max(limit, TOUCH):
            return bound
        if bound > TOUCH:
            return max(0.0, self._measure(self.first.exact, self.second.exact, limit))
        # Few poses collide: coal needs less time for the distance than to exclude a collision.
        free = max(0.0, self._measure(self.first.exact, self.second.exact, max(limit, 2 * TOUCH)))
        if free <= TOUCH:
            depth = self._depth(self._one)
            if 0 < depth <= TOUCH:  # another pair of triangles may be deeper
                depth = self._depth(self._many)
            if depth > TOUCH:
                # coal's depth of triangles may be the length of one of them
                return max(-depth, bound) if bound < -TOUCH else -depth
        return min(free, max(limit, 0.0))

    def is_deeper(self, rotation: Floats, translation: Floats, depth: float) -> bool:
        """True if the bodies overlap by more than a depth.

        coal's depth of triangles is not usable: if two meshes only touch, the depth of an edge in
        the plane of a triangle is its distance from that triangle's border. Therefore one mesh is
        shrunk by the depth and tested for a collision.

        Args:
            rotation: (3, 3), of the second body in the frame of the first.
            translation: (3,), in the same frame.
            depth: in m.
        """
        if self.distance(rotation, translation, 0.0) >= -TOUCH:
            return False
        if self.is_exact:
            return self.hulls(rotation, translation) < -depth
        bodies = [self.first.exact, self.second.exact]
        shrunk = 0 if self.first.arrays.kind == "mesh" else 1
        mesh = (self.first, self.second)[shrunk].arrays
        bodies[shrunk] = _surface(*_shrunk(mesh.vertices, mesh.faces, depth))
        self._hits.clear()
        first, second = bodies
        return bool(coal.collide(first, _IDENTITY, second, self._place, self._one, self._hits))

    def hulls(self, rotation: Floats, translation: Floats) -> float:
        """The signed distance of the hulls, in m; a lower bound of the distance of the bodies."""
        self._place.setRotation(rotation)
        self._place.setTranslation(translation)
        return self._measure(self.first.hull, self.second.hull, inf)

    def bounds(self, rotation: Floats, translation: Floats, limit: float) -> Floats:
        """(n,), lower bounds of the distance in m, by bounding boxes and spheres.

        Args:
            rotation: (n, 3, 3), as for `distance`.
            translation: (n, 3).
            limit: bounds above this limit, in m, are sufficient.
        """
        a, b = self.first, self.second
        offset = translation + rotation @ b.center - a.center
        return distance_bounds(a.half, b.half, a.radius + b.radius, rotation, offset, limit)

    @property
    def line(self) -> tuple[Floats, Floats, Floats]:
        """The nearest points of the last measured distance, in the frame of the first body.

        Returns:
            A point of the first body, a point of the second, and coal's unit vector from the first
            to the second, (3,) each. The vector is unreliable if both bodies are triangles.
        """
        result = self._distance
        return result.getNearestPoint1(), result.getNearestPoint2(), result.normal

    def _measure(self, first: Any, second: Any, limit: float) -> float:
        """The distance of two coal bodies, or the limit if it is smaller."""
        result = self._distance
        result.clear()
        if limit < inf:
            result.min_distance = limit  # coal ignores larger distances
        coal.distance(first, _IDENTITY, second, self._place, self._request, result)
        return float(result.min_distance)

    def _depth(self, request: Any) -> float:
        """The depth of the deepest contact of the exact bodies; 0 without contacts."""
        hits = self._hits
        hits.clear()
        if not coal.collide(
            self.first.exact, _IDENTITY, self.second.exact, self._place, request, hits
        ):
            return 0.0
        return max(-float(contact.penetration_depth) for contact in hits.getContacts())
