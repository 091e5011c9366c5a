"""Which points lie inside of closed surfaces."""

import numpy as np

from urdfkit.mesh.convex_hull import NoHull, hull
from urdfkit.mesh.geometry import Flags, Floats, Mesh
from urdfkit.mesh.health import examine_mesh

#: In m.
_LARGEST = 1e5
#: Points on each line.
_ON_EACH = 10


def columns_inside(triangles: Floats, columns: Floats, heights: Floats) -> Flags:
    """Which points of lines along z are inside, (k, n).

    A line enters and leaves a solid; where it has entered more often than left, it is inside. That
    holds for lines that meet no edge, as those through random points do.

    Args:
        triangles: (m, 3, 3), of closed surfaces, counter-clockwise from outside; they may overlap.
        columns: (k, 2), where the lines are in x and y.
        heights: (k, n), of the points on each.
    """
    corners = triangles[:, :, :2]
    turns = _cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    (low_x, low_y), (high_x, high_y) = corners.min(axis=1).T, corners.max(axis=1).T
    found = np.zeros(heights.shape, dtype=bool)
    for number, (x, y) in enumerate(columns):
        near = (low_x <= x) & (high_x >= x) & (low_y <= y) & (high_y >= y) & (turns != 0)
        chosen = np.flatnonzero(near)
        a, b, c = (corners[chosen] - (x, y)).swapaxes(0, 1)
        weights = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)], axis=1)
        met = (weights > 0).all(axis=1) | (weights < 0).all(axis=1)
        chosen, weights = chosen[met], weights[met]
        crossed = np.einsum("ij,ij->i", weights, triangles[chosen, :, 2]) / weights.sum(axis=1)
        entered = np.sign(turns[chosen]) @ (crossed[:, None] > heights[number])
        found[number] = entered > 0.5
    return found


def are_inside(triangles: Floats, points: Floats) -> Flags:
    """Which of some points, (n, 3), are inside; triangles as for `columns_inside`."""
    return columns_inside(triangles, points[:, :2], points[:, 2:])[:, 0]


def points_inside(triangles: Floats, columns: int, seed: int) -> tuple[Floats, float]:
    """Points spread evenly over the inside, (n, 3), and its volume.

    Args:
        triangles: as for `columns_inside`.
        columns: lines through the bounding box on which they lie.
    """
    from scipy.stats import qmc

    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    places = low[:2] + qmc.Halton(2, seed=seed).random(columns) * (high - low)[:2]
    shares = (
        np.arange(_ON_EACH) + np.random.default_rng(seed).random((columns, _ON_EACH))
    ) / _ON_EACH
    heights = low[2] + shares * (high - low)[2]
    inside = columns_inside(triangles, places, heights)
    points = np.column_stack([places[np.nonzero(inside)[0]], heights[inside]])
    return points, float(inside.mean() * np.prod(high - low))


def _cross(a: Floats, b: Floats) -> Floats:
    product: Floats = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return product


def closed(mesh: Mesh) -> Mesh:
    """The mesh if its triangles enclose a volume, and look outwards; else its convex hull.

    Raises:
        NoHull: all points lie in a plane, or are farther away than those of any robot.
    """
    health = examine_mesh(mesh)
    if not np.abs(mesh.vertices).max(initial=0.0) < _LARGEST:
        raise NoHull(f"it is larger than {_LARGEST:g} m")
    wrong = health.inconsistent_edges + health.inverted + health.doubled + health.non_finite
    return mesh if health.is_closed and health.volume > 0 and not wrong else hull(mesh)
