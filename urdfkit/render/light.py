"""The lamps of the studio, and the shadows of the sun."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Floats, Integers, dot, rotated
from urdfkit.render.camera import Camera
from urdfkit.render.raster import nearness_map
from urdfkit.render.soup import CameraTriangles, extent
from urdfkit.render.thread_pool import Workers

#: Texels along the edge of the shadow map.
TEXELS = 1024
#: Blur radius of shadow edges, as a part of the map.
SOFTNESS = 0.009
#: Least sine of the angle between surfaces and the sun's rays.
LEAST_TILT = 0.15
#: Edge in pixels of squares in which each pixel has another sampling pattern.
LATTICE = 4


class Rig(NamedTuple):
    """Directions to the lamps, unit vectors in the camera frame.

    The sun is above and to the left of the camera, a weak lamp to its right. The lamps move with
    the camera, so that all views have the same light.
    """

    sun: Floats
    fill: Floats
    up: Floats


def rig(camera: Camera) -> Rig:
    """Place the lamps for a camera."""
    up = np.asarray(camera.axes)[:, 2]
    above = up if up[2] > -0.2 else np.array((0.0, 1.0, 0.0))  # views from below are lit, too
    sun = 1.0 * above + np.array((-0.55, 0.12, 0.62))
    fill = 0.25 * above + np.array((0.9, 0.0, 0.45))
    return Rig(*((v / np.linalg.norm(v)).astype(np.float32) for v in (sun, fill, up)))


class ShadowMap(NamedTuple):
    """Depths from the direction of the sun, which determine shadows."""

    axes: Floats  # rows are the directions across, along and to the sun, in the camera frame
    origin: Floats  # (3,), of the map, in these axes
    scale: float  # texels per m
    nearness: Floats  # (t, t), height in m of the nearest surface; 0 without a surface

    def coordinates(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Column and row in texels, and height in m, of points (n, 3) in the camera frame."""
        return self.placed(rotated(points, self.axes))

    def placed(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """The same for points in the axes of the map."""
        x, y, z = (points[:, axis] - np.float32(self.origin[axis]) for axis in range(3))
        factor = np.float32(self.scale)
        x *= factor
        y *= factor
        return x, y, z


def shadow_map(
    triangles: CameraTriangles, faces: Integers, pieces: Iterable[slice], rig: Rig, workers: Workers
) -> ShadowMap:
    """The shadow map of triangles.

    Args:
        faces: (m, 3), faces that cast shadows.
    """
    axes = _axes(rig)
    points = rotated(triangles.points, axes)
    lowest, highest = extent(points, pieces)
    edge = max(float((highest - lowest)[:2].max()), 1e-6) * (1 + 4 * SOFTNESS)
    middle = (lowest + highest) / 2
    origin = np.array((middle[0] - edge / 2, middle[1] - edge / 2, lowest[2]))
    origin[2] -= max(float(highest[2] - lowest[2]), 1e-6) * 0.01  # so that heights are above 0
    result = ShadowMap(axes, origin.astype(np.float32), TEXELS / edge, np.zeros(0))
    nearness = nearness_map(*result.placed(points), faces, TEXELS, workers)
    return result._replace(nearness=nearness)


def _axes(rig: Rig) -> Floats:
    across = np.cross(rig.up, rig.sun)
    norm = float(np.linalg.norm(across))
    across = across / norm if norm > 1e-6 else np.array((1.0, 0.0, 0.0))
    return np.stack((across, np.cross(rig.sun, across), rig.sun)).astype(np.float32)


def sunlight(
    map_: ShadowMap, points: Floats, normals: Floats, pixel: Integers, width: int, taps: int
) -> Floats:
    """(k,), visible part of the sun, from 0 to 1, with grain in a lattice of pixels.

    Args:
        points: (k, 3), in the camera frame.
        normals: (k, 3).
        pixel: (k,), row times width plus column.
        taps: number of samples for each point.
    """
    texel = np.float32(1 / map_.scale)
    column, row, height = map_.coordinates(points + normals * (2 * texel))
    # Samples are compared with the plane of the surface, so that tilted surfaces do not shade
    # themselves.
    across, along, towards = (dot(normals, axis) for axis in map_.axes)
    towards = np.maximum(towards, np.float32(LEAST_TILT)) * np.float32(-map_.scale)
    across /= towards
    along /= towards
    offsets = spiral(taps) * np.float32(SOFTNESS * TEXELS)
    place = lattice(pixel, width)
    lit = np.zeros(len(points), dtype=np.float32)
    limit = np.float32(TEXELS - 1)
    flat = map_.nearness.reshape(-1)
    for tap in range(taps):
        right, up = offsets[place, tap].T
        x = np.clip(column + right, 0, limit).astype(np.int32)
        y = np.clip(row + up, 0, limit).astype(np.int32)
        plane = height + right * across + up * along
        lit += flat[y * np.int32(TEXELS) + x] <= plane
    return np.asarray(lit / np.float32(taps))


def lattice(pixel: Integers, width: int) -> Integers:
    """Index of pixels in their squares, from 0 to 15."""
    row, column = np.divmod(pixel, width)
    return np.asarray(row % LATTICE * LATTICE + column % LATTICE)


def spiral(taps: int, power: float = 0.5) -> Floats:
    """Sample points in the unit disc for each index of the lattice.

    The points of all indices together form a sunflower spiral, so that a square of pixels samples
    the whole disc with few samples for each pixel.

    Args:
        taps: number of points for each index.
        power: 0.5 for a uniform distribution, 1 for more points in the middle.

    Returns:
        (16, taps, 2)
    """
    places = LATTICE**2
    number = np.arange(taps) * places + (np.arange(places) * 7 % places)[:, None]
    radius = ((number + 0.5) / (taps * places)) ** power
    angle = number * np.pi * (3 - np.sqrt(5))  # the golden angle
    return np.stack((radius * np.cos(angle), radius * np.sin(angle)), axis=-1).astype(np.float32)
