"""The lamps of the studio, and the shadows that the sun casts."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Floats, Integers, dot, turned
from urdfkit.render.camera import Camera
from urdfkit.render.raster import Grid, nearest, projected, split
from urdfkit.render.soup import CameraTriangles, extent
from urdfkit.render.thread_pool import Workers

#: Texels of the edge of the shadow map.
TEXELS = 1024
#: Radius of the blur of a shadow's edge, as a part of the map.
SOFTNESS = 0.009
#: Planes along the sun's rays are taken for less steep ones (the sine of the angle between).
LEAST_TILT = 0.15
#: Places of a pixel in a square of so many, each with a pattern of samples of its own.
LATTICE = 4


class Rig(NamedTuple):
    """Directions to the lamps, unit vectors in the frame of the camera.

    The sun stands above the camera's left shoulder, a weak lamp at its right; so every view is
    lit alike, and a robot that turns before the camera turns in the light.
    """

    sun: Floats
    fill: Floats
    up: Floats


def rig(camera: Camera) -> Rig:
    """Place the lamps for a camera."""
    up = np.asarray(camera.axes)[:, 2]
    above = up if up[2] > -0.2 else np.array((0.0, 1.0, 0.0))  # from below the robot is lit, too
    sun = 1.0 * above + np.array((-0.55, 0.12, 0.62))
    fill = 0.25 * above + np.array((0.9, 0.0, 0.45))
    return Rig(*((v / np.linalg.norm(v)).astype(np.float32) for v in (sun, fill, up)))


class ShadowMap(NamedTuple):
    """Depths as the sun sees them, which decide what lies in shadow."""

    axes: Floats  # rows are the directions across, along and to the sun, in the camera's frame
    origin: Floats  # (3,), of the map, in these axes
    scale: float  # texels per m
    nearness: Floats  # (t, t), height in m of the nearest surface; 0 where there is none

    def coordinates(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Points (n, 3) of the camera's frame: column and row in texels, and height in m."""
        return self.placed(turned(points, self.axes))

    def placed(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """The same of points in the axes of the map."""
        x, y, z = (points[:, axis] - np.float32(self.origin[axis]) for axis in range(3))
        factor = np.float32(self.scale)
        x *= factor
        y *= factor
        return x, y, z


def shadow_map(
    whole: CameraTriangles, faces: Integers, pieces: Iterable[slice], rig: Rig, workers: Workers
) -> ShadowMap:
    """The shadow map of some triangles.

    Args:
        faces: (m, 3), those that cast a shadow.
    """
    axes = _axes(rig)
    seen = turned(whole.points, axes)
    lowest, highest = extent(seen, pieces)
    edge = max(float((highest - lowest)[:2].max()), 1e-6) * (1 + 4 * SOFTNESS)
    middle = (lowest + highest) / 2
    origin = np.array((middle[0] - edge / 2, middle[1] - edge / 2, lowest[2]))
    origin[2] -= max(float(highest[2] - lowest[2]), 1e-6) * 0.01  # so that heights are above 0
    scale = TEXELS / edge
    result = ShadowMap(
        axes, origin.astype(np.float32), scale, np.zeros((TEXELS, TEXELS), dtype=np.float32)
    )
    x, y, z = result.placed(seen)
    screen, _ = projected(x, y, z, faces, TEXELS)
    everything = np.arange(len(screen.top))
    offsets = np.array((0.5,), dtype=np.float32)

    def band(first: int, last: int) -> None:
        keys = nearest(screen, everything, Grid(TEXELS, first, last, offsets))
        numbers, nearness = split(keys)
        result.nearness[first:last] = np.where(numbers >= 0, nearness, 0)

    workers.bands(TEXELS, 128, band)
    return result


def _axes(rig: Rig) -> Floats:
    across = np.cross(rig.up, rig.sun)
    norm = float(np.linalg.norm(across))
    across = across / norm if norm > 1e-6 else np.array((1.0, 0.0, 0.0))
    return np.stack((across, np.cross(rig.sun, across), rig.sun)).astype(np.float32)


def sunlight(
    map_: ShadowMap, points: Floats, normals: Floats, pixel: Integers, width: int, taps: int
) -> Floats:
    """How much of the sun surfaces see, (k,), from 0 to 1; grainy in a lattice of pixels.

    Args:
        points: (k, 3), in the camera's frame.
        normals: (k, 3).
        pixel: (k,), row times width plus column.
        taps: samples of each.
    """
    texel = np.float32(1 / map_.scale)
    column, row, height = map_.coordinates(points + normals * (2 * texel))
    # Around a point its own surface is as high as its plane: tilted ones do not shade themselves.
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
    part: Floats = lit / np.float32(taps)
    return part


def lattice(pixel: Integers, width: int) -> Integers:
    """The place of pixels in their squares, from 0 to 15."""
    row, column = np.divmod(pixel, width)
    result: Integers = row % LATTICE * LATTICE + column % LATTICE
    return result


def spiral(taps: int, power: float = 0.5) -> Floats:
    """Points of a disc of radius 1, some of them for each place of a lattice.

    Those of all places together are one sunflower, so a square of pixels sees every part of the
    disc, though each of them takes few samples.

    Args:
        taps: how many.
        power: 0.5 spreads them evenly, 1 puts more of them in the middle.

    Returns:
        (16, taps, 2)
    """
    places = LATTICE**2
    number = np.arange(taps) * places + (np.arange(places) * 7 % places)[:, None]
    radius = ((number + 0.5) / (taps * places)) ** power
    angle = number * np.pi * (3 - np.sqrt(5))  # the golden angle
    return np.stack((radius * np.cos(angle), radius * np.sin(angle)), axis=-1).astype(np.float32)
