"""Vertex normals for meshes without: smooth on smooth surfaces, split at sharp edges."""

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers, MeshPart
from urdfkit.mesh.grouping import components, distinct
from urdfkit.mesh.welding import weld

#: Angle in degrees between two faces above which their edge is sharp.
CREASE = 35.0


def shaded(part: MeshPart, crease: float = CREASE) -> MeshPart:
    """The part with normals: one vertex at each position and side of a sharp edge.

    Vertices with colours or texture coordinates are not merged.

    Args:
        part: returned unchanged if it has normals.
        crease: angle in degrees between two faces above which their edge is sharp.
    """
    if part.normals is not None or not len(part.faces):
        return part
    places, faces = weld(part.vertices, part.faces)
    corners = part.faces.reshape(-1)
    if part.uv is None and part.colors is None:  # merge vertices at the same position
        first = np.zeros(len(places), dtype=np.int64)
        first[faces.reshape(-1)[::-1]] = corners[::-1]
        corners = first[faces.reshape(-1)]
    edges = _edge_directions(part.vertices, part.faces)
    normals = _normals(edges)
    groups = _corner_groups(faces, normals, crease)
    # One new vertex for each pair of an old vertex and a smooth patch.
    pairs = np.column_stack([corners, groups])
    first, new, _ = distinct(pairs)
    old, patch = pairs[first].T
    weighted = (_corner_angles(edges)[:, :, None] * normals[:, None, :]).reshape(-1, 3)
    sums: Floats = np.stack([np.bincount(groups, column) for column in weighted.T], axis=1)
    return part._replace(
        vertices=part.vertices[old],
        faces=new.reshape(-1, 3),
        normals=_directed(sums)[patch],
        uv=None if part.uv is None else part.uv[old],
        colors=None if part.colors is None else part.colors[old],
    )


def _directed(sums: Floats) -> Floats:
    """Unit vectors; upwards where all adjacent faces have no area."""
    normals = _unit(sums)
    normals[np.linalg.norm(normals, axis=1) < 0.5] = (0.0, 0.0, 1.0)
    return normals


def _edge_directions(vertices: Floats, faces: Integers) -> list[Floats]:
    """Three arrays (m, 3), unit vectors from each corner of a face to the next corner."""
    corners = [vertices[faces[:, corner]] for corner in range(3)]
    return [_unit(corners[(corner + 1) % 3] - corners[corner]) for corner in range(3)]


def _normals(edges: list[Floats]) -> Floats:
    """(m, 3), unit normals of faces with these edge directions; 0 without area."""
    return _unit(np.cross(edges[0], -edges[2]))


def _unit(vectors: Floats) -> Floats:
    # Normalised to about 1 first, so that squares neither overflow nor vanish.
    largest = np.abs(vectors).max(axis=1, keepdims=True, initial=0)
    vectors = vectors / np.where(largest > 0, largest, 1.0)
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0, lengths, 1.0)


def _corner_angles(edges: list[Floats]) -> Floats:
    """(m, 3), angles in rad at the corners of faces with these edge directions."""
    cosines = [-(edges[corner] * edges[corner - 1]).sum(axis=1) for corner in range(3)]
    return np.asarray(np.arccos(np.clip(np.stack(cosines, axis=1), -1.0, 1.0)))


def _corner_groups(faces: Integers, normals: Floats, crease: float) -> Integers:
    """(3 m,), the smooth patch around its vertex that each corner of a face belongs to.

    Two corners at one vertex are in the same patch if their faces share an edge that is not sharp.
    """
    number = len(faces)
    following = np.array([1, 2, 0])
    starts, ends = faces.reshape(-1), faces[:, following].reshape(-1)
    corner_at_start = np.arange(3 * number)
    corner_at_end = (3 * np.arange(number)[:, None] + following).reshape(-1)
    flip = starts > ends
    low, high = np.where(flip, ends, starts), np.where(flip, starts, ends)
    at_low = np.where(flip, corner_at_end, corner_at_start)
    at_high = np.where(flip, corner_at_start, corner_at_end)
    edge = low * (int(high.max()) + 1) + high
    order = np.argsort(edge, kind="stable")
    first, second = order[:-1], order[1:]
    same = edge[first] == edge[second]
    flat = (normals[first // 3] * normals[second // 3]).sum(axis=1) >= np.cos(np.radians(crease))
    first, second = first[same & flat], second[same & flat]
    links = [np.concatenate([at_low[side], at_high[side]]) for side in (first, second)]
    return components(3 * number, np.column_stack(links))
