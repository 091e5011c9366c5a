"""The ground: invisible except for the shadows and the metric grid on it."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import FAR, Floats, Integers, rotated
from urdfkit.render.camera import Camera
from urdfkit.render.light import TEXELS, ShadowMap
from urdfkit.render.raster import nearness_map
from urdfkit.render.scale import grid_step
from urdfkit.render.soup import extent
from urdfkit.render.thread_pool import Workers

#: Cells along the edge of the floor's map.
CELLS = 320
#: Margin of the map around the robot, as a part of the robot's size.
MARGIN = 0.75
#: Darkness of the sun's shadow and of contact shadows.
SUN_SHADE, CONTACT_SHADE = 0.34, 0.5
#: Texels of the shadow map that are averaged along each axis: soft shadows need no more.
COARSE = 4
#: Contact shadows: height up to which surfaces darken the floor and radius of the blur, as parts of
#: the robot's size, and weight.
CONTACT_SHADOWS = ((0.05, 0.012, 0.5), (0.22, 0.045, 0.45), (0.8, 0.13, 0.35))
#: Darkness of grid lines, and their width in pixels.
LINE_SHADE, LINE_WIDTH = 0.13, 1.3
#: Size of grid squares in pixels, at which the grid is invisible and fully visible.
DENSE, SPARSE = 3, 9
#: Least size of a robot in m; all vertices may coincide.
MIN_SIZE = 1e-9


class Ground(NamedTuple):
    """A level floor."""

    height: float  # in the world, in m
    origin: tuple[float, float]  # x and y of the map's corner in the world
    cell: float  # edge of a cell in m
    shade: Floats  # (c, c), from 0 (bright) to 1 (black)
    step: float  # edge of a grid square in m; 0 without a grid

    def render_band(self, camera: Camera, first: int, last: int) -> tuple[Floats, Floats]:
        """The floor in a band of an image: depth in m and darkness, (rows, w) each.

        The depth is `FAR` where the floor is not visible.
        """
        # One more row, for the width of grid lines.
        (x, y, z), (ahead_x, ahead_y, ahead_z) = _rays(camera, first, last + 1)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            distance = (np.float32(self.height) - z) / ahead_z
        shape = (last + 1 - first, camera.size[0])
        far = np.where((ahead_z < -1e-4) & (distance > 0) & (distance < FAR), distance, FAR)
        far = np.broadcast_to(far, shape).astype(np.float32)
        depth, dark = far[:-1], np.zeros((last - first, camera.size[0]), dtype=np.float32)
        if not (depth < FAR).any():
            return depth, dark
        x, y = x + far * ahead_x, y + far * ahead_y
        column = (x[:-1] - np.float32(self.origin[0])) / np.float32(self.cell)
        row = (y[:-1] - np.float32(self.origin[1])) / np.float32(self.cell)
        near = (column > 0) & (column < CELLS) & (row > 0) & (row < CELLS)
        half = np.float32(0.5)
        dark[near] = _bilinear(self.shade, column[near] - half, row[near] - half)
        if self.step:
            lines = np.maximum(_lines(x, self.step), _lines(y, self.step))
            faded = lines[near] * _fade(column[near], row[near]) * np.float32(LINE_SHADE)
            dark[near] += (1 - dark[near]) * faded
        return depth, dark


def _lines(coordinate: Floats, step: float) -> Floats:
    """The part of each pixel that lines at multiples of a step cover.

    Args:
        coordinate: (rows + 1, w), x or y on the ground, in m.
        step: in m.

    Returns:
        (rows, w), from 0 to 1.
    """
    down, across = np.diff(coordinate, axis=0), np.gradient(coordinate, axis=1)[:-1]
    pixel = np.abs(down) + np.abs(across) + np.float32(1e-9)
    place = coordinate[:-1] / np.float32(step)
    distance = np.abs(place - np.rint(place)) * np.float32(step) / pixel
    covered = np.clip(np.float32(LINE_WIDTH / 2 + 0.5) - distance, 0, 1)
    sparse = (np.float32(step) / pixel - DENSE) / np.float32(SPARSE - DENSE)
    return np.asarray(covered * np.clip(sparse, 0, 1))


def _rays(camera: Camera, first: int, last: int) -> tuple[list[Floats], list[Floats]]:
    """Origins and directions of the rays through the pixels of a band, in the world, by axis.

    The shapes broadcast to (rows, width); the directions have a depth of 1.
    """
    width, height = camera.size
    half, scale = np.float32(0.5), np.float32(camera.scale)
    across = (np.arange(width, dtype=np.float32) + half - np.float32(width / 2)) / scale
    upwards = (np.float32(height / 2) - half - np.arange(first, last, dtype=np.float32)) / scale
    right, up, back = np.asarray(camera.axes, dtype=np.float32)
    eye = np.asarray(camera.eye, dtype=np.float32)
    plane = [across * right[axis] + (upwards * up[axis])[:, None] for axis in range(3)]
    if camera.is_orthographic:
        return [eye[axis] + plane[axis] for axis in range(3)], [-part for part in back[:, None]]
    return list(eye[:, None]), [plane[axis] - back[axis] for axis in range(3)]


def ground(
    points: Floats,
    faces: Integers,
    pieces: Iterable[slice],
    shadow_map: ShadowMap,
    camera: Camera,
    level: float | None,
    workers: Workers,
) -> Ground:
    """The floor under a robot.

    Args:
        points: (n, 3), vertices in the world.
        faces: (m, 3), faces that cast shadows.
        camera: defines the frame of the shadow map.
        level: height of the floor; None for the robot's lowest point.
    """
    lowest, highest = extent(points, pieces)
    bare = without_shadows(lowest, highest, camera, level)
    height, origin, cell, *_ = bare
    size = _size(lowest, highest)
    cells = np.arange(CELLS, dtype=np.float32) + np.float32(0.5)
    x, y = np.meshgrid(*(start + cells * np.float32(cell) for start in origin))
    floor = np.stack((x, y, np.full_like(x, height)), axis=-1).reshape(-1, 3)
    contact = _contact(points, faces, origin, cell, height, size, workers)
    shade = 1 - (1 - CONTACT_SHADE * contact) * (
        1 - SUN_SHADE * _sun(floor, shadow_map, camera, size).reshape(CELLS, CELLS)
    )
    faded = shade * _fade(cells, cells[:, None])
    return bare._replace(shade=faded.astype(np.float32))


def without_shadows(
    lowest: Floats, highest: Floats, camera: Camera, level: float | None = None
) -> Ground:
    """The floor under a box, from two of its corners in the world."""
    height = float(lowest[2]) if level is None else level
    edge = float((highest - lowest)[:2].max()) + 2 * MARGIN * _size(lowest, highest)
    x, y = (float(middle - edge / 2) for middle in (lowest + highest)[:2] / 2)
    shade = np.zeros((CELLS, CELLS), dtype=np.float32)
    return Ground(height, (x, y), edge / CELLS, shade, grid_step(camera, height))


def _size(lowest: Floats, highest: Floats) -> float:
    return max(float((highest - lowest).max()), MIN_SIZE)


def _contact(
    points: Floats,
    faces: Integers,
    origin: tuple[float, float],
    cell: float,
    height: float,
    size: float,
    workers: Workers,
) -> Floats:
    """Approximate contact shadows of the floor: blurred heights."""
    x, y = ((points[:, i] - np.float32(origin[i])) / np.float32(cell) for i in range(2))
    top = height + 2 * size
    near = nearness_map(x, y, np.float32(top) - points[:, 2], faces, CELLS, workers)
    above = np.where(near > 0, np.float32(top - height) - near, np.float32(np.inf))
    hidden = np.zeros((CELLS, CELLS), dtype=np.float32)
    for reach, blur, weight in CONTACT_SHADOWS:
        shade = np.clip(1 - above / np.float32(reach * size), 0, 1)
        hidden = hidden + np.float32(weight) * blurred(shade, blur * size / cell)
    return np.minimum(hidden, 1)


def _sun(floor: Floats, shadow_map: ShadowMap, camera: Camera, size: float) -> Floats:
    """The sun's shadow on points of the floor, with a blur that grows with distance."""
    rotation, position = camera.to_view(np.eye(3), np.zeros(3))
    column, row, level = shadow_map.coordinates(rotated(floor, rotation) + position)
    covered = _coarse((shadow_map.nearness > 0).astype(np.float32))
    texels = size * shadow_map.scale / COARSE
    sharp, soft = blurred(covered, 0.006 * texels), blurred(covered, 0.035 * texels)
    heights, parts = (
        blurred(_coarse(shadow_map.nearness), 0.012 * texels),
        blurred(covered, 0.012 * texels),
    )
    high = heights / np.maximum(parts, np.float32(1e-3))
    inside = (column > 0) & (column < TEXELS) & (row > 0) & (row < TEXELS)
    x, y = column / COARSE - np.float32(0.5), row / COARSE - np.float32(0.5)
    softness = np.clip((_bilinear(high, x, y) - level) / np.float32(size), 0, 1)
    mixed = _bilinear(sharp, x, y) * (1 - softness) + _bilinear(soft, x, y) * softness
    return np.where(inside, mixed, 0)


def _coarse(image: Floats) -> Floats:
    """The means of squares of pixels."""
    cells = len(image) // COARSE
    rows = image.reshape(cells, COARSE, -1).mean(axis=1)
    return np.asarray(rows.reshape(cells, cells, COARSE).mean(axis=2))


def _fade(column: Floats, row: Floats) -> Floats:
    """1 in the middle of the map, 0 at its edge."""
    distance = np.hypot(column / CELLS * 2 - 1, row / CELLS * 2 - 1)
    ramp = np.clip((1 - distance) / np.float32(0.35), 0, 1)
    return np.asarray(ramp * ramp * (3 - 2 * ramp))


def blurred(values: Floats, radius: float) -> Floats:
    """A blurred image: three moving means along each axis approximate a Gaussian."""
    half = max(1, round(radius))
    for axis in (0, 1, 0, 1, 0, 1):
        values = _mean(values, half, axis)
    return values


def _mean(values: Floats, half: int, axis: int) -> Floats:
    padding = [(0, 0), (0, 0)]
    padding[axis] = (half + 1, half)
    sums = np.cumsum(np.pad(values, padding), axis=axis)
    window = 2 * half + 1
    if axis == 0:
        mean = (sums[window:] - sums[:-window]) / window
    else:
        mean = (sums[:, window:] - sums[:, :-window]) / window
    return mean.astype(np.float32)


def _bilinear(image: Floats, column: Floats, row: Floats) -> Floats:
    """Bilinear interpolation of an image; 0 outside."""
    height, width = image.shape
    inside = (column > -1) & (column < width) & (row > -1) & (row < height)
    x = np.clip(column, 0, width - 1.001)
    y = np.clip(row, 0, height - 1.001)
    left, low = x.astype(np.int32), y.astype(np.int32)
    across, along = x - left, y - low
    flat = image.reshape(-1)
    start = low * np.int32(width) + left
    lower = flat[start] * (1 - across) + flat[start + 1] * across
    upper = flat[start + width] * (1 - across) + flat[start + width + 1] * across
    return np.where(inside, lower * (1 - along) + upper * along, 0)
