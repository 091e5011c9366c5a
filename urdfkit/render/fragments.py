"""Fragments: pieces of one triangle in one pixel, which are shaded once."""

from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Floats, Integers, Keys, dot, unit
from urdfkit.render.camera import Camera
from urdfkit.render.raster import Grid, Projected, split
from urdfkit.render.soup import CameraTriangles

#: Barycentric weights beyond which a point is far outside of a triangle.
_MAX_WEIGHT = np.float32(4)


class Fragments(NamedTuple):
    """Pieces of triangles, in the order of the pixels."""

    pixel: Integers  # (k,), row times width plus column
    number: Integers  # (k,), of the triangle
    weight: Floats  # (k,), covered part of the pixel
    #: x and y: (k,), position of shading in the image.
    x: Floats
    y: Floats
    nearness: Floats  # (k,), of one of the samples


class FragmentSurface(NamedTuple):
    """The surfaces of fragments, in the camera frame."""

    position: Floats  # (k, 3)
    normal: Floats  # (k, 3), unit vectors, facing the viewer
    flat: Floats  # (k, 3), normals of the faces
    uv: Floats | None  # (k, 2); None if no vertex has texture coordinates
    color: Floats | None  # (k, 4); None if no vertex has a colour


def fragments_of(keys: Keys, grid: Grid) -> Fragments:
    """The fragments of a band: consecutive samples of a pixel with the same triangle."""
    samples, rows = len(grid.offsets), grid.last - grid.first
    by_pixel = keys.reshape(rows, samples, grid.width).swapaxes(1, 2).reshape(-1, samples)
    numbers, nearness = split(by_pixel)
    starts = np.ones(numbers.shape, dtype=bool)
    starts[:, 1:] = numbers[:, 1:] != numbers[:, :-1]
    begin = np.flatnonzero(starts)
    length = np.diff(begin, append=numbers.size)
    seen = numbers.reshape(-1)[begin] >= 0
    begin, length = begin[seen], length[seen]
    middle = begin + length // 2
    pixel, sample = np.divmod(middle, samples)
    row, column = np.divmod(pixel, grid.width)
    is_whole, half = length == samples, np.float32(0.5)
    across = np.where(is_whole, half, grid.offsets[sample])
    down = np.where(is_whole, half, (sample.astype(np.float32) + half) / np.float32(samples))
    return Fragments(
        pixel + grid.first * grid.width,
        numbers.reshape(-1)[middle],
        length.astype(np.float32) / np.float32(samples),
        column.astype(np.float32) + across,
        (row + grid.first).astype(np.float32) + down,
        nearness.reshape(-1)[middle],
    )


def surface_of(
    fragments: Fragments, triangles: CameraTriangles, screen: Projected, camera: Camera
) -> FragmentSurface:
    """Positions, normals and attributes of fragments, with perspective correction."""
    corners = [triangles.faces[fragments.number, corner] for corner in range(3)]
    weights, nearness = _weights(fragments, corners, screen, camera)

    def blend(values: Floats) -> Floats:
        return np.asarray(sum(w * values[i] for w, i in zip(weights, corners, strict=True)))

    position = camera.positions(fragments.x, fragments.y, nearness)
    towards = _towards(position, camera)
    flat = triangles.flat[fragments.number]
    flat = np.where(dot(flat, towards)[:, None] < 0, -flat, flat)
    normal = blend(triangles.normals)
    normal = np.where(dot(normal, flat)[:, None] < 0, -normal, normal)
    normal = unit(np.where(np.abs(normal).max(axis=1, keepdims=True) < 0.1, flat, normal))
    return FragmentSurface(
        position,
        normal,
        flat,
        None if triangles.uv is None else blend(triangles.uv),
        None if triangles.colors is None else blend(triangles.colors),
    )


def _weights(
    fragments: Fragments, corners: list[Integers], screen: Projected, camera: Camera
) -> tuple[list[Floats], Floats]:
    """The barycentric weights in space, (k, 1) each, and the nearness, (k,)."""
    x = [screen.x[index] for index in corners]
    y = [screen.y[index] for index in corners]
    parts = []
    for i, j in ((1, 2), (2, 0), (0, 1)):
        parts.append(
            (x[i] - fragments.x) * (y[j] - fragments.y)
            - (x[j] - fragments.x) * (y[i] - fragments.y)
        )
    area = parts[0] + parts[1] + parts[2]
    area = np.where(area == 0, np.float32(1), area)
    # A fragment may be shaded slightly outside of its triangle, but on its plane. If it is far
    # outside, as for slivers, the nearness of the sample is more reliable than the plane.
    weights = [part / area for part in parts]
    is_far = np.maximum.reduce(np.abs(weights)) > _MAX_WEIGHT
    weights = [np.clip(weight, -_MAX_WEIGHT, _MAX_WEIGHT) for weight in weights]
    total = weights[0] + weights[1] + weights[2]
    total = np.where(np.abs(total) < 0.5, np.float32(1), total)
    near = [screen.nearness[index] for index in corners]
    nearness = sum(w * n for w, n in zip(weights, near, strict=True)) / total
    nearness = np.where(is_far, fragments.nearness, nearness)
    nearness = np.clip(nearness, np.minimum.reduce(near), np.maximum.reduce(near))
    weights = [np.clip(w, 0, 1) for w in weights]
    total = np.maximum(weights[0] + weights[1] + weights[2], np.float32(1e-12))
    if not camera.is_orthographic:
        weights = [w * n for w, n in zip(weights, near, strict=True)]
        total = np.maximum(weights[0] + weights[1] + weights[2], np.float32(1e-30))
    return [(w / total)[:, None] for w in weights], nearness


def _towards(position: Floats, camera: Camera) -> Floats:
    """Unit vectors to the viewer."""
    if camera.is_orthographic:
        return np.broadcast_to(np.array((0, 0, 1), dtype=np.float32), position.shape)
    return unit(-position)
