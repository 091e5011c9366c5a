"""Which points lie inside of closed surfaces."""

from collections.abc import Iterator

import numpy as np

from urdfkit.mesh.convex_hull import NoHull, hull
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh
from urdfkit.mesh.health import examine_mesh

#: In m.
_LARGEST = 1e5
#: Points on each line.
_ON_EACH = 10
#: Lines that are looked at together.
_GROUP = 32


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
        found[group] = entered > 0.5
    return found


def _neighbours(columns: Floats) -> Iterator[Integers]:
    """The numbers of lines in groups that are near each other, which few triangles meet."""
    count = int(np.ceil(np.sqrt(len(columns) / _GROUP)))
    for strip in np.array_split(np.argsort(columns[:, 0]), count) if count else ():
        yield from np.array_split(strip[np.argsort(columns[strip, 1])], count)


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
    product: Floats = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
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
