"""All triangles of a scene in one list, in the camera frame, clipped at the near plane."""

from collections.abc import Iterable
from itertools import accumulate, pairwise
from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Bools, Floats, Integers, bounds, cross, rotated, unit
from urdfkit.render.camera import Camera
from urdfkit.render.scene import Scene


class CameraTriangles(NamedTuple):
    """All triangles of a scene in the camera frame."""

    points: Floats  # (n, 3), vertices
    normals: Floats  # (n, 3), unit vectors; 0 if faces are flat
    uv: Floats | None  # (n, 2), 0 if missing; None if no item has a texture
    colors: Floats | None  # (n, 4), 1 if missing; None if no item has vertex colours
    faces: Integers  # (m, 3), indices of the vertices
    item: Integers  # (m,), index of the item in the scene
    flat: Floats  # (m, 3), normals of the faces
    pieces: tuple[slice, ...]  # ranges of the vertices of the items


def soup(scene: Scene, camera: Camera) -> CameraTriangles:
    """The triangles of a scene as a camera sees them."""
    faces = [item.faces for item in scene.items]
    ends = list(accumulate((len(item.vertices) for item in scene.items), initial=0))
    total = ends[-1]
    colored = any(item.colors is not None for item in scene.items)
    # On meshes without texture coordinates, as Interbotix' STL files, one texel is used.
    textured = any(item.uv is not None or item.material.texture for item in scene.items)
    points, normals = (np.zeros((total, 3), dtype=np.float32) for _ in range(2))
    uv = np.zeros((total, 2), dtype=np.float32) if textured else None
    colors = np.ones((total, 4), dtype=np.float32) if colored else None
    pieces = tuple(slice(*edges) for edges in pairwise(ends))
    for item, here in zip(scene.items, pieces, strict=True):
        frame = scene.frames[item.link]
        rotation, position = camera.to_view(np.asarray(frame.rotation), np.asarray(frame.position))
        points[here] = rotated(item.vertices, rotation) + position
        if item.normals is not None:
            normals[here] = rotated(item.normals, rotation)
        if item.uv is not None and uv is not None:
            uv[here] = item.uv
        if item.colors is not None and colors is not None:
            colors[here] = item.colors
    moved = [own + np.int32(start) for own, start in zip(faces, ends, strict=False)]
    every = np.concatenate([np.zeros((0, 3), dtype=np.int32), *moved])
    of_item = np.repeat(np.arange(len(faces), dtype=np.int32), [len(own) for own in faces])
    a, b, c = (points[every[:, corner]] for corner in range(3))
    flat = unit(cross(b - a, c - a))
    return CameraTriangles(points, normals, uv, colors, every, of_item, flat, pieces)


def rows(values: Integers, chosen: Bools) -> Integers:
    """The chosen rows; the array itself, not a copy, if all are chosen."""
    return values if chosen.all() else values[chosen]


def extent(points: Floats, pieces: Iterable[slice]) -> tuple[Floats, Floats]:
    """The least and the greatest coordinates of pieces of a list of points."""
    ends = [end for piece in pieces if len(points[piece]) for end in bounds(points[piece])]
    return bounds(np.array(ends, dtype=np.float32).reshape(-1, 3))


def cut(whole: CameraTriangles, camera: Camera) -> CameraTriangles:
    """Clip triangles at the near plane of a camera.

    A triangle with one corner in front of the plane becomes two triangles, one with two corners in
    front becomes a smaller triangle.
    """
    plane = np.float32(-camera.near)
    before = whole.points[:, 2] > plane
    if camera.is_orthographic or not before.any():
        return whole
    corners = before[whole.faces]
    count = corners.sum(axis=1)
    clipped = chosen_triangles(whole, count == 0)
    for number in (1, 2):
        mask = count == number
        if mask.any():
            clipped = _add(clipped, chosen_triangles(whole, mask), corners[mask], plane)
    return clipped


def chosen_triangles(whole: CameraTriangles, chosen: Bools | Integers) -> CameraTriangles:
    return whole._replace(
        faces=whole.faces[chosen], item=whole.item[chosen], flat=whole.flat[chosen]
    )


def _add(
    kept: CameraTriangles, cut: CameraTriangles, before: Bools, plane: np.float32
) -> CameraTriangles:
    """Add the clipped parts of triangles with one corner alone on its side of the plane."""
    faces = cut.faces
    single = before.sum(axis=1)[0] == 1
    lone = np.argmax(before if single else ~before, axis=1)
    rows = np.arange(len(faces))
    a, b, c = (faces[rows, (lone + turn) % 3] for turn in range(3))
    start, count = len(kept.points), len(faces)
    kept, ab = _between(kept, a, b, plane), (start + np.arange(count)).astype(np.int32)
    kept, ac = _between(kept, a, c, plane), ab + np.int32(count)
    new = [(ab, b, c), (ab, c, ac)] if single else [(a, ab, ac)]
    return kept._replace(
        faces=np.concatenate((kept.faces, *(np.stack(corners, 1) for corners in new))),
        item=np.concatenate((kept.item, *(cut.item for _ in new))),
        flat=np.concatenate((kept.flat, *(cut.flat for _ in new))),
    )


def _between(
    kept: CameraTriangles, start: Integers, end: Integers, plane: np.float32
) -> CameraTriangles:
    """Add the intersections of edges with the plane."""
    z0, z1 = kept.points[start, 2], kept.points[end, 2]
    part = ((plane - z0) / (z1 - z0))[:, None]

    def added(values: Floats) -> Floats:
        middle = values[start] + part * (values[end] - values[start])
        return np.concatenate((values, middle.astype(np.float32)))

    return kept._replace(
        points=added(kept.points),
        normals=added(kept.normals),
        uv=None if kept.uv is None else added(kept.uv),
        colors=None if kept.colors is None else added(kept.colors),
    )
