"""Distances of bodies by coal, for pairs without a closed form."""

from collections.abc import Callable
from functools import cache
from math import inf

import numpy as np

from urdfkit.core.spatial import Transform, Vector
from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.bodies import THINNEST, CollisionBody
from urdfkit.physics.collision.collision_geometry import (
    CollisionGeometry,
    DistanceQuery,
    build_geometry,
)
from urdfkit.physics.collision.geometry_arrays import (
    NO_FACES,
    NO_VERTICES,
    CollisionArrays,
    OmittedCollision,
    arrays,
)
from urdfkit.robot import Robot

_POINT = build_geometry(
    CollisionArrays("", 0, np.eye(4), "sphere", (THINNEST,), NO_VERTICES, NO_FACES)
)


def _arrays(at: Transform) -> tuple[Floats, Floats]:
    return np.array(at.rotation), np.array(at.position)


class ExactDistances:
    """Measures distances of the bodies of a robot; each body is loaded once.

    Args:
        unit: apply the unit of COLLADA files.
    """

    def __init__(self, robot: Robot, *, unit: bool) -> None:
        self._robot = robot
        self._unit = unit
        self._built: Callable[[str, int], CollisionGeometry | None] = cache(self._build)

    def distance(self, first: CollisionBody, second: CollisionBody, at: Transform) -> float:
        """The signed distance of two bodies, in m; infinite if a body cannot be used.

        Args:
            at: frame of the second body in the first.
        """
        query = self._query(first, second)
        return query.distance(*_arrays(at), 0.0) if query else inf

    def hull_distance(self, first: CollisionBody, second: CollisionBody, at: Transform) -> float:
        """The signed distance of the convex hulls of two bodies; arguments as for `distance`."""
        query = self._query(first, second)
        return query.hulls(*_arrays(at)) if query else inf

    def is_deeper(
        self, first: CollisionBody, second: CollisionBody, at: Transform, depth: float
    ) -> bool:
        """True if two bodies overlap by more than a depth.

        Args:
            at: frame of the second body in the first.
            depth: in m.
        """
        query = self._query(first, second)
        return query is not None and query.is_deeper(*_arrays(at), depth)

    def is_convex(self, body: CollisionBody) -> bool:
        """True for a body that fills its hull."""
        geometry = self._geometry(body)
        return geometry is not None and geometry.is_convex

    def is_inside(self, body: CollisionBody, large: CollisionBody, at: Transform) -> bool:
        """True if a mesh, or the bounding box of a primitive, is inside a convex body.

        Args:
            body: the inner body.
            large: the convex body.
            at: frame of the inner body in the convex body.
        """
        geometry = self._geometry(large)
        if geometry is None:
            return False
        query = DistanceQuery(geometry, _POINT)
        points = np.array(self.vertices(body)) @ np.array(at.rotation).T + at.position
        return all(query.distance(np.eye(3), point, inf) < -2 * THINNEST for point in points)

    def vertices(self, body: CollisionBody) -> tuple[Vector, ...]:
        """Vertices of the hull of a mesh, or corners of the bounding box of a primitive.

        In its frame; other vertices of the mesh may be among them.
        """
        geometry = self._geometry(body)
        if body.kind != "mesh" or geometry is None:
            return body.points
        return tuple((x, y, z) for x, y, z in geometry.outermost.tolist())

    def _query(self, first: CollisionBody, second: CollisionBody) -> DistanceQuery | None:
        a, b = self._geometry(first), self._geometry(second)
        return DistanceQuery(a, b) if a and b else None

    def _geometry(self, body: CollisionBody) -> CollisionGeometry | None:
        return self._built(body.link, body.number)

    def _build(self, name: str, number: int) -> CollisionGeometry | None:
        link = self._robot.model.links_by_name[name]
        made = arrays(link, number, self._robot.meshes, unit=self._unit)
        return None if isinstance(made, OmittedCollision) else build_geometry(made)
