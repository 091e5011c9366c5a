"""A mesh ever coarser: within tolerances that grow, or with fewer triangles."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from urdfkit.mesh.edges import three_cornered
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshPart
from urdfkit.mesh.health import examine
from urdfkit.mesh.manifolds import solid
from urdfkit.mesh.repair.soup import TriangleSoup, soup_of

#: From one tolerance to the next.
_GROWTH = 1.5
#: Cells, as a part of the diagonal: to one that holds all.
_FIRST_CELL, _LAST_CELL = 1e-3, 1.0
#: fast-simplification looks for edges to remove within errors that are numbers, the first of them
#: of 1e-3: so the diagonal of what it gets is made so long that this is next to nothing.
_LENGTH = 1000.0

#: Of a part: its number, points and faces.
_Piece = tuple[int, Floats, Integers]
#: From a tolerance, larger than that of the last call, to simpler pieces.
_Coarser = Callable[[float], list[_Piece]]


def within_tolerances(mesh: Mesh, first: float, last: float) -> Iterator[Mesh]:
    """A mesh within ever larger tolerances, each made from the one before, which is quick.

    Solids go through manifold3d, which keeps them solids but lets thin walls vanish; of what is no
    solid, near vertices become one.

    Args:
        first: tolerance, in the unit of the mesh.
    """
    soup = soup_of(mesh)
    parts = _by_part(soup)
    apart = len(parts) > 1 and all(map(_is_solid, parts))
    pieces = [soup] if not apart and _is_solid(soup) else parts
    return _coarser(mesh, list(map(_coarser_solid, pieces)), first, last)


def in_cells(mesh: Mesh) -> Iterator[Mesh]:
    """Ever simpler meshes: vertices in one cell of a growing grid are merged. Rough, but small."""
    soup = soup_of(mesh)
    makers = list(map(_coarser_cells, _by_part(soup)))
    return _coarser(mesh, makers, _FIRST_CELL * soup.size, _LAST_CELL * soup.size)


def with_fewer(mesh: Mesh, triangles: int) -> Mesh:
    """A mesh of about so many triangles, each part by quadric error metrics for itself.

    Without any promise: where many triangles are slivers, far more are left.
    """
    from fast_simplification import simplify

    soup = soup_of(mesh)
    scale, share = _LENGTH / soup.size, triangles / len(soup.faces)
    found: list[_Piece] = []
    for piece in _by_part(soup):
        number, points, faces = _compact(piece)
        target = max(4, int(len(faces) * share))
        if target < len(faces):
            points, faces = simplify(points * scale, faces, target_count=target)[:2]
            points = np.asarray(points, dtype=np.float64) / scale
        found.append((number, points, np.asarray(faces, dtype=np.int64)))
    return _mesh_of(mesh, found)


def _coarser(mesh: Mesh, makers: list[_Coarser], first: float, last: float) -> Iterator[Mesh]:
    tolerance = first
    while tolerance < last:
        yield _mesh_of(mesh, [piece for maker in makers for piece in maker(tolerance)])
        tolerance *= _GROWTH


def _mesh_of(mesh: Mesh, pieces: list[_Piece]) -> Mesh:
    parts = (
        MeshPart(points, faces, mesh.parts[number].material)
        for number, points, faces in pieces
        if len(faces)
    )
    return mesh._replace(parts=tuple(parts))


def _by_part(soup: TriangleSoup) -> list[TriangleSoup]:
    return [soup.kept(soup.parts == number) for number in np.unique(soup.parts)]


def _is_solid(soup: TriangleSoup) -> bool:
    return examine(soup.points, soup.faces).is_solid


def _coarser_solid(soup: TriangleSoup) -> _Coarser:
    """Simplify with manifold3d, which keeps the parts of a solid as runs of triangles."""
    from manifold3d import Manifold

    order = np.argsort(soup.parts, kind="stable")
    numbers, starts = np.unique(soup.parts[order], return_index=True)
    first = Manifold.reserve_ids(len(numbers))
    bounds = np.append(3 * starts, 3 * len(order)).astype(np.uint64)
    ids = np.arange(first, first + len(numbers), dtype=np.uint32)
    body = solid(soup.points, soup.faces[order], runs=(bounds, ids))
    if body.is_empty():  # no solid, or bodies that touch along an edge
        return _coarser_cells(soup)

    def coarser(tolerance: float) -> list[_Piece]:
        nonlocal body
        body = body.simplify(tolerance)
        runs = _runs(body.to_mesh64())
        return [(int(numbers[run - first]), points, faces) for run, points, faces in runs]

    return coarser


def _runs(mesh: Any) -> list[_Piece]:
    """The runs of a manifold mesh: their ids, points and faces."""
    points = np.asarray(mesh.vert_properties[:, :3], dtype=np.float64)
    corners = np.asarray(mesh.tri_verts, dtype=np.int64)
    bounds = np.asarray(mesh.run_index, dtype=np.int64) // 3
    found: dict[int, list[Integers]] = {}
    for run, start, end in zip(mesh.run_original_id, bounds[:-1], bounds[1:], strict=True):
        found.setdefault(int(run), []).append(corners[start:end])
    return [(run, points, np.concatenate(faces)) for run, faces in found.items()]


def _coarser_cells(soup: TriangleSoup) -> _Coarser:
    """Simplify on a grid: all points in one cell become their mean."""
    number, points, corners = _compact(soup)

    def coarser(tolerance: float) -> list[_Piece]:
        _, places = np.unique(np.floor(points / tolerance), axis=0, return_inverse=True)
        places = places.reshape(-1)
        sums = np.zeros((int(places.max()) + 1, 3))
        np.add.at(sums, places, points)
        means = sums / np.bincount(places)[:, None]
        faces = places[corners]
        faces = faces[three_cornered(faces)]
        _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
        return [(number, means, faces[np.sort(first)].astype(np.int64))]

    return coarser


def _compact(soup: TriangleSoup) -> _Piece:
    """The number of a part, the points that it uses, and its faces."""
    used, faces = np.unique(soup.faces, return_inverse=True)
    points = np.ascontiguousarray(soup.points[used])
    return int(soup.parts[0]), points, np.ascontiguousarray(faces.reshape(-1, 3).astype(np.int64))
