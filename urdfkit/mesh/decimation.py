"""Coarser versions of a mesh: within growing tolerances, or with fewer triangles."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from urdfkit.core.grouping import by_key
from urdfkit.mesh.edges import have_distinct_corners
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshPart
from urdfkit.mesh.grouping import distinct
from urdfkit.mesh.health import examine
from urdfkit.mesh.manifolds import solid
from urdfkit.mesh.repair.soup import TriangleSoup, soup_of

#: Factor from one tolerance to the next.
_TOLERANCE_FACTOR = 1.5
#: Smallest and largest cell, as a part of the diagonal.
_FIRST_CELL, _LAST_CELL = 1e-3, 1.0
#: Diagonal of the meshes passed to fast-simplification. It removes edges within absolute errors, of
#: which the first is 1e-3; at this size that is negligible.
_DIAGONAL = 1000.0

#: Number, points and faces of a part.
_Piece = tuple[int, Floats, Integers]
#: Maps a tolerance, larger than in the last call, to simpler pieces.
_Coarser = Callable[[float], list[_Piece]]


def within_tolerances(mesh: Mesh, first: float, last: float) -> Iterator[Mesh]:
    """Coarser meshes within growing tolerances, each made from the previous one, which is fast.

    Solids are simplified by manifold3d: they stay solids, but thin walls vanish. In other meshes,
    near vertices are merged.

    Args:
        first, last: tolerances in the unit of the mesh.
    """
    soup = soup_of(mesh)
    parts = _by_part(soup)
    are_separate = len(parts) > 1 and all(map(_is_solid, parts))
    pieces = [soup] if not are_separate and _is_solid(soup) else parts
    return _coarser(mesh, list(map(_coarser_solid, pieces)), first, last)


def in_cells(mesh: Mesh) -> Iterator[Mesh]:
    """Coarser meshes: vertices in one cell of a growing grid are merged. Rough, but small."""
    soup = soup_of(mesh)
    makers = list(map(_coarser_cells, _by_part(soup)))
    return _coarser(mesh, makers, _FIRST_CELL * soup.size, _LAST_CELL * soup.size)


def with_fewer(mesh: Mesh, triangles: int) -> Mesh:
    """A mesh of about so many triangles; each part is simplified by quadric error metrics.

    The number is not guaranteed: if many triangles are slivers, far more remain.
    """
    from fast_simplification import simplify

    soup = soup_of(mesh)
    scale, share = _DIAGONAL / soup.size, triangles / len(soup.faces)
    pieces: list[_Piece] = []
    for piece in _by_part(soup):
        number, points, faces = _compact(piece)
        target = max(4, int(len(faces) * share))
        if target < len(faces):
            points, faces = simplify(points * scale, faces, target_count=target)[:2]
            points = np.asarray(points, dtype=np.float64) / scale
        pieces.append((number, points, np.asarray(faces, dtype=np.int64)))
    return _mesh_of(mesh, pieces)


def _coarser(mesh: Mesh, makers: list[_Coarser], first: float, last: float) -> Iterator[Mesh]:
    tolerance = first
    while tolerance < last:
        yield _mesh_of(mesh, [piece for maker in makers for piece in maker(tolerance)])
        tolerance *= _TOLERANCE_FACTOR


def _mesh_of(mesh: Mesh, pieces: list[_Piece]) -> Mesh:
    parts = (
        MeshPart(points, faces, mesh.parts[number].material)
        for number, points, faces in pieces
        if len(faces)
    )
    return mesh._replace(parts=tuple(parts))


def _by_part(soup: TriangleSoup) -> list[TriangleSoup]:
    return [soup.select(soup.parts == number) for number in np.unique(soup.parts)]


def _is_solid(soup: TriangleSoup) -> bool:
    return examine(soup.points, soup.faces).is_solid


def _coarser_solid(soup: TriangleSoup) -> _Coarser:
    """Simplifies with manifold3d, which preserves the parts of a solid as runs of triangles."""
    from manifold3d import Manifold

    order = np.argsort(soup.parts, kind="stable")
    numbers, starts = np.unique(soup.parts[order], return_index=True)
    first = Manifold.reserve_ids(len(numbers))
    bounds = np.append(3 * starts, 3 * len(order)).astype(np.uint64)
    ids = np.arange(first, first + len(numbers), dtype=np.uint32)
    body = solid(soup.points, soup.faces[order], runs=(bounds, ids))
    if body.is_empty():  # not a solid, or bodies that touch along an edge
        return _coarser_cells(soup)

    def coarser(tolerance: float) -> list[_Piece]:
        nonlocal body
        body = body.simplify(tolerance)
        runs = _runs(body.to_mesh64())
        return [(int(numbers[run - first]), points, faces) for run, points, faces in runs]

    return coarser


def _runs(mesh: Any) -> list[_Piece]:
    """Ids, points and faces of the runs of a manifold3d mesh."""
    points = np.asarray(mesh.vert_properties[:, :3], dtype=np.float64)
    corners = np.asarray(mesh.tri_verts, dtype=np.int64)
    bounds = np.asarray(mesh.run_index, dtype=np.int64) // 3
    starts = zip(mesh.run_original_id, bounds[:-1], bounds[1:], strict=True)
    runs = by_key((int(run), corners[start:end]) for run, start, end in starts)
    return [(run, points, np.concatenate(faces)) for run, faces in runs.items()]


def _coarser_cells(soup: TriangleSoup) -> _Coarser:
    """Simplifies on a grid: all points in one cell are replaced by their mean."""
    number, points, corners = _compact(soup)

    def coarser(tolerance: float) -> list[_Piece]:
        cells = np.floor(points / tolerance).T
        ranks = [np.unique(column, return_inverse=True)[1] for column in cells]  # small integers
        _, places, count = distinct(np.stack(ranks, axis=1))
        sums = [np.bincount(places, column) for column in points.T]
        means: Floats = np.stack(sums, axis=1) / count[:, None]
        faces = places[corners]
        faces = faces[have_distinct_corners(faces)]
        first, _, _ = distinct(np.sort(faces, axis=1))
        return [(number, means, faces[np.sort(first)].astype(np.int64))]

    return coarser


def _compact(soup: TriangleSoup) -> _Piece:
    """The number, used points and faces of a part."""
    used, faces = np.unique(soup.faces, return_inverse=True)
    points = np.ascontiguousarray(soup.points[used])
    return int(soup.parts[0]), points, np.ascontiguousarray(faces.reshape(-1, 3).astype(np.int64))
