"""All triangles of a scene in one list, in the frame of a camera, cut at its near plane."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Bools, Floats, Integers, cross, unit
from urdfkit.render.camera import Camera
from urdfkit.render.scene import Item, Scene


class Soup(NamedTuple):
    """Triangles.

    Attributes:
        points: (n, 3), vertices in the frame of the camera.
        normals: (n, 3), unit vectors there; 0 where faces are flat.
        uv: (n, 2); 0 where there are none.
        colors: (n, 4), 1 where there are none; None if nothing has any.
        faces: (m, 3), indices of the vertices.
        item: (m,), the index of the item in the scene.
        flat: (m, 3), the normals of the faces.
    """

    points: Floats
    normals: Floats
    uv: Floats
    colors: Floats | None
    faces: Integers
    item: Integers
    flat: Floats


def soup(scene: Scene, camera: Camera) -> Soup:
    """The triangles of a scene as a camera sees them."""
    points, normals, uv, colors, faces, item = [], [], [], [], [], []
    start = 0
    colored = any(item.colors is not None for item in scene.items)
    for index, thing in enumerate(scene.items):
        frame = scene.frames[thing.link]
        rotation, position = camera.to_view(np.asarray(frame.rotation), np.asarray(frame.position))
        count = len(thing.vertices)
        points.append(thing.vertices @ rotation.T + position)
        normals.append(_or(thing.normals, count, 3, 0) @ rotation.T)
        uv.append(_or(thing.uv, count, 2, 0))
        if colored:
            colors.append(_or(thing.colors, count, 4, 1))
        faces.append(_valid(thing) + np.int32(start))
        item.append(np.full(len(faces[-1]), index, dtype=np.int32))
        start += count
    if not faces:
        none = np.zeros((0, 3), dtype=np.float32)
        return Soup(none, none, none[:, :2], None, none.astype(np.int32), _none(), none)
    whole = Soup(
        np.concatenate(points),
        np.concatenate(normals),
        np.concatenate(uv),
        np.concatenate(colors) if colored else None,
        np.concatenate(faces),
        np.concatenate(item),
        np.zeros((0, 3), dtype=np.float32),
    )
    return _with_flat(whole if camera.is_orthographic else _cut(whole, np.float32(-camera.near)))


def _none() -> Integers:
    return np.zeros(0, dtype=np.int32)


def _or(given: Floats | None, count: int, width: int, value: float) -> Floats:
    return np.full((count, width), value, dtype=np.float32) if given is None else given


def _valid(item: Item) -> Integers:
    """The faces whose corners are finite; a bad number in a file hides one triangle only."""
    if np.isfinite(item.vertices).all():
        return item.faces
    finite = np.isfinite(item.vertices[item.faces]).all(axis=(1, 2))
    return item.faces[finite]


def _with_flat(whole: Soup) -> Soup:
    a, b, c = (whole.points[whole.faces[:, corner]] for corner in range(3))
    return whole._replace(flat=unit(cross(b - a, c - a)))


def _cut(whole: Soup, plane: np.float32) -> Soup:
    """Only what lies beyond z = plane (z points to the viewer).

    A triangle with one corner before the plane becomes two, one with two becomes a smaller one.
    """
    before = whole.points[:, 2] > plane
    if not before.any():
        return whole
    corners = before[whole.faces]
    count = corners.sum(axis=1)
    kept = whole._replace(faces=whole.faces[count == 0], item=whole.item[count == 0])
    for number in (1, 2):
        some = count == number
        if some.any():
            kept = _cut_some(kept, whole.faces[some], whole.item[some], corners[some], plane)
    return kept


def _cut_some(
    kept: Soup, faces: Integers, item: Integers, before: Bools, plane: np.float32
) -> Soup:
    """Add what is left of triangles of which one corner lies alone on its side of the plane."""
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
        item=np.concatenate((kept.item, *(item for _ in new))),
    )


def _between(kept: Soup, start: Integers, end: Integers, plane: np.float32) -> Soup:
    """Add the points where edges cross the plane."""
    z0, z1 = kept.points[start, 2], kept.points[end, 2]
    part = ((plane - z0) / (z1 - z0))[:, None]

    def added(values: Floats) -> Floats:
        middle = values[start] + part * (values[end] - values[start])
        return np.concatenate((values, middle.astype(np.float32)))

    return kept._replace(
        points=added(kept.points),
        normals=added(kept.normals),
        uv=added(kept.uv),
        colors=None if kept.colors is None else added(kept.colors),
    )
