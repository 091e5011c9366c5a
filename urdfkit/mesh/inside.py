"""Point containment in closed surfaces."""

from collections.abc import Iterator

import numpy as np

from urdfkit.mesh.convex_hull import NoHull, hull
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh
from urdfkit.mesh.health import examine_mesh

#: Largest coordinate of a mesh in m.
_MAX_COORDINATE = 1e5
#: Points on each line.
_POINTS_PER_LINE = 10
#: A solid with fewer points inside is thin.
_MIN_INSIDE = 200
#: Lines that are processed together.
_GROUP = 32


def columns_inside(triangles: Floats, columns: Floats, heights: Floats) -> Flags:
    """(k, n), True for points on lines along z that are inside.

    A point is inside if its line has entered solids more often than left them. This is exact for
    lines that do not meet an edge, such as lines through random points.

    Args:
        triangles: (m, 3, 3), of closed surfaces, counter-clockwise from outside; they may overlap.
        columns: (k, 2), x and y of the lines.
        heights: (k, n), z of the points on each line.
    """
    corners = triangles[:, :, :2]
    turns = _cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    (low_x, low_y), (high_x, high_y) = corners.min(axis=1).T, corners.max(axis=1).T
    is_inside = np.zeros(heights.shape, dtype=bool)
    for group in _neighbours(columns):
        lines = columns[group]
        (left, front), (right, back) = lines.min(axis=0), lines.max(axis=0)
        near = (low_x <= right) & (high_x >= left) & (low_y <= back) & (high_y >= front)
        chosen = np.flatnonzero(near & (turns != 0))
        a, b, c = (corners[chosen, corner] - lines[:, None] for corner in range(3))
        weights = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)])
        met = (weights > 0).all(axis=0) | (weights < 0).all(axis=0)
        line, hit = np.nonzero(met)
        hit_weights, hit = weights[:, line, hit], chosen[hit]
        crossed = np.einsum("ji,ij->i", hit_weights, triangles[hit, :, 2]) / hit_weights.sum(axis=0)
        entered = np.zeros((len(group), heights.shape[1]))
        signs = np.sign(turns[hit])[:, None]
        np.add.at(entered, line, signs * (crossed[:, None] > heights[group[line]]))
        is_inside[group] = entered > 0.5
    return is_inside


def _neighbours(columns: Floats) -> Iterator[Integers]:
    """Groups of adjacent lines, by their indices; few triangles meet such a group."""
    count = int(np.ceil(np.sqrt(len(columns) / _GROUP)))
    for strip in np.array_split(np.argsort(columns[:, 0]), count) if count else ():
        yield from np.array_split(strip[np.argsort(columns[strip, 1])], count)


def are_inside(triangles: Floats, points: Floats) -> Flags:
    """(n,), True for points (n, 3) inside; triangles as for `columns_inside`."""
    return columns_inside(triangles, points[:, :2], points[:, 2:])[:, 0]


def points_inside(triangles: Floats, columns: int, seed: int) -> tuple[Floats, float]:
    """Points spread evenly over the inside, (n, 3), and its volume.

    Args:
        triangles: as for `columns_inside`.
        columns: number of lines through the bounding box that contain the points.
    """
    from scipy.stats import qmc

    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    places = low[:2] + qmc.Halton(2, seed=seed).random(columns) * (high - low)[:2]
    offsets = np.random.default_rng(seed).random((columns, _POINTS_PER_LINE))
    shares = (np.arange(_POINTS_PER_LINE) + offsets) / _POINTS_PER_LINE
    heights = low[2] + shares * (high - low)[2]
    inside = columns_inside(triangles, places, heights)
    points = np.column_stack([places[np.nonzero(inside)[0]], heights[inside]])
    return points, float(inside.mean() * np.prod(high - low))


def solid_points(triangles: Floats, columns: int, seed: int, surface: Floats) -> Floats:
    """Points that are to be covered: those inside; of a thin part, which has few, surface, too.

    Args:
        triangles: as for `columns_inside`.
        columns: as for `points_inside`.
        surface: (n, 3), points of the surface.
    """
    inside, _ = points_inside(triangles, columns, seed)
    return inside if len(inside) > _MIN_INSIDE else np.concatenate([inside, surface])


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def closed(mesh: Mesh) -> Mesh:
    """The mesh if its triangles enclose a volume and face outwards; else its convex hull.

    Raises:
        NoHull: all points lie in a plane, or the mesh is larger than any robot.
    """
    health = examine_mesh(mesh)
    if not np.abs(mesh.vertices).max(initial=0.0) < _MAX_COORDINATE:
        raise NoHull(f"it is larger than {_MAX_COORDINATE:g} m")
    defects = health.inconsistent_edges + health.inverted + health.doubled + health.non_finite
    return mesh if health.is_closed and health.volume > 0 and not defects else hull(mesh)
