"""What hides the sky and the sun, by rays: for pictures of high quality, where embreex is there.

Depth maps know only what the camera and the sun see; rays know all of the robot. Embree has
wheels for few platforms, so nothing else may depend on it.
"""

from __future__ import annotations

import numpy as np

from urdfkit.render.arrays import Floats, Integers, cross, unit
from urdfkit.render.light import lattice, spiral

#: Half the angle of the sun's disc, as a slope: larger than the true one, for soft shadows.
SUN_RADIUS = 0.035
#: Rays that are cast at a time.
_RAYS = 1 << 18


class RayTracer:
    """Triangles that hide one another.

    Args:
        points: (n, 3), in the camera's frame.
        faces: (m, 3), of what hides anything.
        size: of the robot, in m.

    Raises:
        ImportError: embreex is not installed.
    """

    def __init__(self, points: Floats, faces: Integers, size: float) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self._scene = EmbreeScene()
        self._mesh = TriangleMesh(
            self._scene, points.astype(np.float32), np.ascontiguousarray(faces, dtype=np.int32)
        )
        self._size = size

    def sky(
        self, points: Floats, normals: Floats, pixel: Integers, width: int, reach: float, rays: int
    ) -> Floats:
        """How much of the sky above their surfaces points see, (k,), from 0 to 1.

        Args:
            points: (k, 3).
            normals: (k, 3).
            pixel: (k,), where they are in the picture.
            width: of the picture.
            reach: in m; what is farther away hides nothing.
            rays: for each of them; their mean is weighted by the cosine.
        """
        across, along = _tangents(normals)
        offsets = spiral(rays)[lattice(pixel, width)]
        seen = np.zeros(len(points), dtype=np.float32)
        for number in range(rays):
            x, y = offsets[:, number, 0, None], offsets[:, number, 1, None]
            upwards = np.sqrt(np.maximum(1 - x * x - y * y, 0))
            seen += self._free(points, normals, x * across + y * along + upwards * normals, reach)
        part: Floats = seen / np.float32(rays)
        return part

    def sun(
        self, points: Floats, normals: Floats, pixel: Integers, width: int, sun: Floats, rays: int
    ) -> Floats:
        """How much of the sun's disc points see, (k,), from 0 to 1.

        Args:
            points: (k, 3).
            normals: (k, 3).
            pixel: (k,), where they are in the picture.
            width: of the picture.
            sun: unit vector to it.
            rays: for each of them.
        """
        across, along = _tangents(sun[None])
        offsets = spiral(rays)[lattice(pixel, width)] * np.float32(SUN_RADIUS)
        seen = np.zeros(len(points), dtype=np.float32)
        for number in range(rays):
            aside = offsets[:, number, 0, None] * across + offsets[:, number, 1, None] * along
            seen += self._free(points, normals, unit(sun + aside), 10 * self._size)
        part: Floats = seen / np.float32(rays)
        return part

    def _free(self, points: Floats, normals: Floats, ahead: Floats, reach: float) -> Floats:
        """1 for each ray that meets nothing within reach, else 0."""
        start = points + normals * np.float32(2e-4 * self._size)
        free = np.ones(len(points), dtype=np.float32)
        for first in range(0, len(points), _RAYS):
            some = slice(first, first + _RAYS)
            far = np.full(len(start[some]), reach, dtype=np.float32)
            met = self._scene.run(
                np.ascontiguousarray(start[some], dtype=np.float32),
                np.ascontiguousarray(ahead[some], dtype=np.float32),
                dists=far,
                query="OCCLUDED",
            )
            free[some] = met < 0
        return free


def _tangents(normals: Floats) -> tuple[Floats, Floats]:
    """Two directions (k, 3) across each of some unit vectors."""
    aside = np.where(
        np.abs(normals[:, :1]) < 0.7,
        np.array((1, 0, 0), dtype=np.float32),
        np.array((0, 1, 0), dtype=np.float32),
    )
    across = unit(cross(aside, normals))
    return across, cross(normals, across)
