"""Fewer triangles: to a budget, or as few as an error bound allows, with the deviation measured.

Solids go through manifold3d, which keeps them solids but lets walls thinner than its tolerance
vanish; what is no solid through fast-simplification (quadric error metrics), which promises
nothing. So what came out is measured in every case.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from urdfkit.errors import UrdfkitError
from urdfkit.meshes.distance import one_way
from urdfkit.meshes.geometry import Floats, Integers, Mesh, Part
from urdfkit.meshes.health import Health, examine, examine_mesh
from urdfkit.meshes.repair.soup import Soup, soup_of
from urdfkit.record import Record

#: Tolerances that are tried for solids, from nothing to a fifth of the diagonal.
_FINEST, _COARSEST = 1e-6, 0.2
#: The smallest part of the triangles that is tried for the rest.
_LEAST = 1e-3
_STEPS_TO_BUDGET, _STEPS_TO_ERROR = 14, 8


#: Of a part: its number, points and faces.
_Piece = tuple[int, Floats, Integers]
#: From a piece and the size of all to a function of the level.
_Way = Callable[[Soup, float], Callable[[float], list[_Piece]]]


class Unreachable(UrdfkitError):
    """No simplification meets the bound."""


class Simplified(Record):
    """What came of a simplification.

    Attributes:
        mesh: with fewer triangles; without normals, texture coordinates and colours of vertices.
        before, after: the state of the mesh.
        lost: how far the old surface lies from the new one at most, in the unit of the mesh.
        gained: how far the new surface lies from the old one at most.
        diagonal: of the bounding box, to compare these with.
    """

    mesh: Mesh
    before: Health
    after: Health
    lost: float
    gained: float
    diagonal: float

    @property
    def deviation(self) -> float:
        """The greater of the two distances."""
        return max(self.lost, self.gained)


def to_budget(mesh: Mesh, triangles: int) -> Simplified:
    """At most so many triangles, with as little change as that takes.

    Every way is tried, and that is taken which moves the surface least; a solid is kept a solid
    unless another way is twice as good.

    Raises:
        Unreachable: the shape cannot be kept with so few, or there is none.
    """
    _refuse_nothing(mesh)
    if len(mesh.faces) <= triangles:
        return _judged(mesh, mesh)
    tried = [_to_budget(mesh, triangles, way) for way in (_solid_shrinker, _quadric_shrinker)]
    found = [one for one in tried if one]
    if not found:
        clustered = _to_budget(mesh, triangles, _cluster_shrinker)
        if clustered is None:
            raise Unreachable(f"{triangles} triangles are too few for this shape")
        return clustered
    return min(found, key=lambda one: one.deviation / (2 if one.after.is_solid else 1))


def _to_budget(mesh: Mesh, triangles: int, way: _Way) -> Simplified | None:
    shrink = _shrinker(mesh, way)
    low, high, best = 0.0, 1.0, None
    for _ in range(_STEPS_TO_BUDGET):
        level = (low + high) / 2
        found = shrink(level)
        if 0 < len(found.faces) <= triangles:
            best, high = found, level
        else:
            low = level
    return None if best is None else _judged(mesh, best)


def to_error(
    mesh: Mesh, error: float, progress: Callable[[int, int], None] | None = None
) -> Simplified:
    """As few triangles as are possible while no surface moves farther than a bound.

    Args:
        mesh: any.
        error: in the unit of the mesh, measured both ways.
        progress: is told how many of how many steps are done.

    Raises:
        Unreachable: there is no shape.
    """
    _refuse_nothing(mesh)
    shrink = _shrinker(mesh, _solid_shrinker)
    low, high = 0.0, 1.0
    best = _judged(mesh, mesh)
    for step in range(_STEPS_TO_ERROR):
        level = (low + high) / 2
        found = shrink(level)
        judged = _judged(mesh, found) if len(found.faces) else None
        if judged and judged.deviation <= error:
            low = level
            if judged.after.faces < best.after.faces:
                best = judged
        else:
            high = level
        if progress:
            progress(step + 1, _STEPS_TO_ERROR)
    return best


def _refuse_nothing(mesh: Mesh) -> None:
    sound = soup_of(mesh)
    if not sound.size > 0:
        raise Unreachable("all triangles are in one place, or at no place at all")


def _judged(mesh: Mesh, found: Mesh) -> Simplified:
    before, sound = examine_mesh(mesh), soup_of(mesh)
    diagonal = sound.size
    if found is mesh:
        return Simplified(mesh, before, before, 0.0, 0.0, diagonal)
    old, new = (sound.points, sound.faces), (found.vertices, found.faces)
    lost, gained = one_way(*old, *new), one_way(*new, *old)
    return Simplified(found, before, examine_mesh(found), lost, gained, diagonal)


def _shrinker(mesh: Mesh, way: _Way) -> Callable[[float], Mesh]:
    """A function from a level between 0 and 1 to a simpler mesh; the higher, the simpler.

    Args:
        mesh: any.
        way: to simplify a piece; solids are simplified as a whole, all else part by part.
    """
    soup = soup_of(mesh)
    parts = [soup.kept(soup.parts == number) for number in range(len(mesh.parts))]
    parts = [part for part in parts if len(part.faces)]
    apart = len(parts) > 1 and all(map(_is_solid, parts))
    whole = way is _solid_shrinker and not apart and _is_solid(soup)
    makers = [way(piece, soup.size) for piece in ([soup] if whole else parts)]

    def shrink(level: float) -> Mesh:
        found = [part for maker in makers for part in maker(level)]
        return mesh._replace(
            parts=tuple(
                Part(points, faces, mesh.parts[number].material) for number, points, faces in found
            )
        )

    return shrink


def _is_solid(soup: Soup) -> bool:
    return examine(soup.points, soup.faces).is_solid


def _solid_shrinker(soup: Soup, size: float) -> Callable[[float], list[_Piece]]:
    """Within a tolerance, for a solid; another piece by quadrics."""
    if not _is_solid(soup):
        return _quadric_shrinker(soup, size)
    from manifold3d import Manifold, Mesh64

    order = np.argsort(soup.parts, kind="stable")
    numbers, starts = np.unique(soup.parts[order], return_index=True)
    first = Manifold.reserve_ids(len(numbers))
    whole = Manifold(
        Mesh64(
            vert_properties=soup.points,
            tri_verts=soup.faces[order].astype(np.uint64),
            run_index=np.append(3 * starts, 3 * len(order)).astype(np.uint64),
            run_original_id=np.arange(first, first + len(numbers), dtype=np.uint32),
        )
    )
    if whole.is_empty():  # bodies that touch along an edge are no manifold
        return _quadric_shrinker(soup, size)

    def shrink(level: float) -> list[_Piece]:
        tolerance = size * _FINEST * (_COARSEST / _FINEST) ** level
        return [
            (int(numbers[run - first]), points, faces)
            for run, points, faces in _runs(whole.simplify(tolerance).to_mesh64())
        ]

    return shrink


def _runs(mesh: Any) -> list[tuple[int, Floats, Integers]]:
    """The runs of a manifold mesh: their ids, points and faces."""
    points = np.asarray(mesh.vert_properties[:, :3], dtype=np.float64)
    corners = np.asarray(mesh.tri_verts, dtype=np.int64)
    bounds = np.asarray(mesh.run_index, dtype=np.int64) // 3
    found: dict[int, list[Integers]] = {}
    for run, start, end in zip(mesh.run_original_id, bounds[:-1], bounds[1:], strict=True):
        found.setdefault(int(run), []).append(corners[start:end])
    return [(run, points, np.concatenate(faces)) for run, faces in found.items() if len(faces[0])]


def _quadric_shrinker(soup: Soup, _: float) -> Callable[[float], list[_Piece]]:
    """By quadric error metrics, each part for itself."""
    from fast_simplification import simplify

    number, points, corners = _compact(soup)

    def shrink(level: float) -> list[_Piece]:
        target = max(4, int(len(corners) * _LEAST**level))
        if target >= len(corners):
            return [(number, points, corners)]
        fewer, faces = simplify(points, corners, target_count=target)[:2]
        return [(number, np.asarray(fewer, dtype=np.float64), np.asarray(faces, dtype=np.int64))]

    return shrink


def _cluster_shrinker(soup: Soup, size: float) -> Callable[[float], list[_Piece]]:
    """By cells of a grid, all points of which become their mean: coarse, and reaches any budget."""
    number, points, corners = _compact(soup)

    def shrink(level: float) -> list[_Piece]:
        cell = size * _FINEST * (1 / _FINEST) ** level
        _, places = np.unique(np.floor(points / cell), axis=0, return_inverse=True)
        places = places.reshape(-1)
        sums = np.zeros((int(places.max()) + 1, 3))
        np.add.at(sums, places, points)
        means = sums / np.bincount(places)[:, None]
        a, b, c = faces = places[corners].T
        sound = (a != b) & (b != c) & (c != a)
        faces = faces.T[sound]
        _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
        return [(number, means, faces[np.sort(first)].astype(np.int64))]

    return shrink


def _compact(soup: Soup) -> _Piece:
    """The number of a part, the points that it uses, and its faces."""
    used, faces = np.unique(soup.faces, return_inverse=True)
    points = np.ascontiguousarray(soup.points[used])
    return int(soup.parts[0]), points, np.ascontiguousarray(faces.reshape(-1, 3).astype(np.int64))
