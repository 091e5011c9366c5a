"""Ambient occlusion: the part of the sky that the surroundings of a point hide.

McGuire, Mara, Luebke: Scalable Ambient Obscurance, 2012, equation 1 of section 3, with exact
positions instead of a pyramid of them, and the authors' falloff.
"""

import numpy as np

from urdfkit.render.arrays import Floats, Integers
from urdfkit.render.camera import Camera
from urdfkit.render.light import lattice, spiral

#: Largest radius, as a part of the image's height.
MAX_RADIUS = 0.2
#: Least distance of occluders, as a part of the radius, so that surfaces do not occlude themselves.
BIAS = 0.02
STRENGTH = 1.3
#: Least radius in m; the sixth power of a smaller one is 0 in single precision.
LEAST_RADIUS = 1e-5


def openness(
    depth: Floats,
    camera: Camera,
    points: Floats,
    normals: Floats,
    pixel: Integers,
    radius: float,
    taps: int,
) -> Floats:
    """(k,), visible part of the sky, from 0 to 1, with grain in a lattice of pixels.

    Args:
        depth: (h, w), in m, at the centre of each pixel; huge without a surface.
        points: (k, 3), in the camera frame.
        normals: (k, 3).
        pixel: (k,), indices of their pixels.
        radius: in m; farther surfaces do not occlude.
        taps: number of samples for each point.
    """
    if radius < LEAST_RADIUS:
        return np.ones(len(points), dtype=np.float32)
    height, width = depth.shape
    flat = depth.reshape(-1)
    row, column = np.divmod(pixel.astype(np.int32), np.int32(width))
    reach = _reach(camera, radius, flat[pixel])
    offsets = spiral(taps, 1.0)
    place = lattice(pixel, width)
    px, py, pz = np.ascontiguousarray(points.T)
    nx, ny, nz = np.ascontiguousarray(normals.T)
    square = np.float32(radius * radius)
    bias = np.float32(BIAS * radius)
    hidden = np.zeros(len(points), dtype=np.float32)
    for tap in range(taps):
        x = np.clip(column + (offsets[place, tap, 0] * reach).astype(np.int32), 0, width - 1)
        y = np.clip(row + (offsets[place, tap, 1] * reach).astype(np.int32), 0, height - 1)
        qx, qy, qz = camera.places(x, y, flat[y * np.int32(width) + x])
        qx -= px
        qy -= py
        qz -= pz
        distance = qx * qx + qy * qy + qz * qz
        rise = np.maximum(qx * nx + qy * ny + qz * nz - bias, 0)
        falloff = np.maximum(square - distance, 0)
        hidden += falloff * falloff * falloff * rise / (distance + np.float32(0.02) * square)
    factor = np.float32(5 * STRENGTH * radius / (taps * radius**6))
    return np.asarray(np.exp(-hidden * factor))


def _reach(camera: Camera, radius: float, depth: Floats) -> Floats:
    """(k,), a length in m at depths (k,), in pixels."""
    reach = np.full(len(depth), radius * camera.scale, dtype=np.float32)
    if not camera.is_orthographic:
        reach /= depth
    np.minimum(reach, np.float32(MAX_RADIUS * camera.size[1]), out=reach)
    return reach
