"""Distances between surfaces."""

from collections.abc import Callable

import numpy as np

from urdfkit.mesh.geometry import Flags, Floats, Integers, scaled_normals

#: Points of a surface whose distances are measured: vertices, samples of the whole surface, and
#: points that seem farthest from the other surface.
MAX_VERTICES, SAMPLES, FARTHEST = 1500, 1500, 3000
#: Points from which these are selected: a dent may cover a thousandth of a surface.
_MANY_VERTICES, _MANY_SAMPLES = 100_000, 20_000
#: Points of the other surface that lead to near triangles, and how many triangles are measured;
#: more of them for points of slivers, after the first points were measured to all triangles.
_GUIDES, _NEAREST, _MORE_NEAREST = 20_000, 8, 128
#: Points that are measured to all triangles that may be nearer, before and after.
_FIRST_MEASURED, _MAX_MEASURED = 20, 1000
_SEED = 7
#: Rounding error on surfaces of size 1.
_ROUNDING = 1e-12


def distance(
    vertices: Floats, faces: Integers, other_vertices: Floats, other_faces: Integers
) -> float:
    """The Hausdorff distance of two surfaces, in their unit.

    It is computed over the vertices (of a large mesh, some of them) and points spread over the
    faces with a fixed seed: never more than the true distance, and rarely much less.

    Args:
        vertices: (n, 3).
        faces: (m, 3), indices of vertices.
    """
    return max(
        directed_distance(vertices, faces, other_vertices, other_faces),
        directed_distance(other_vertices, other_faces, vertices, faces),
    )


def directed_distance(
    vertices: Floats,
    faces: Integers,
    other_vertices: Floats,
    other_faces: Integers,
    counts: Callable[[Floats], Flags] | None = None,
) -> float:
    """The directed Hausdorff distance: greatest distance from the first surface to the second.

    Arguments as for `distance`, and ``counts``: selects which of points (n, 3) are measured.
    """
    many = _evenly(vertices, _MANY_VERTICES)
    spread, _ = sample_surface(vertices[faces], _MANY_SAMPLES)
    if counts:
        many, spread = many[counts(many)], spread[counts(spread)]
        if not len(many) + len(spread):
            return 0.0
    used, numbers = np.unique(other_faces, return_inverse=True)
    corners = other_vertices[used]
    # trimesh uses absolute tolerances, so the surfaces are scaled to size 1.
    all_points = np.concatenate([many, spread, corners])
    low, high = all_points.min(axis=0), all_points.max(axis=0)
    size = float((high - low).max()) or 1.0
    many, spread, corners = ((points - low) / size for points in (many, spread, corners))
    other = _Surface(corners[numbers.reshape(other_faces.shape)])
    far = other.farthest_from_guides(np.concatenate([many, spread]), corners, FARTHEST)
    points = [_evenly(many, MAX_VERTICES), spread[:SAMPLES], far]
    return size * other.farthest(np.concatenate(points))


def to_surface(points: Floats, vertices: Floats, faces: Integers) -> Floats:
    """(n,), distances of points (n, 3) from a surface, in their unit.

    Measured to triangles near samples of the surface: never less than the true distance, and rarely
    more.

    Args:
        vertices: (k, 3).
        faces: (m, 3), indices of vertices.
    """
    if not len(points):
        return np.zeros(0)
    triangles = vertices[faces]
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    size = float((high - low).max()) or 1.0
    return size * _Surface((triangles - low) / size).to_near_triangles((points - low) / size)


def _evenly(points: Floats, number: int) -> Floats:
    """About so many of the points, evenly chosen; all if they are fewer."""
    return points[:: max(1, len(points) // number)]


class _Surface:
    """A surface of size 1, to which distances are measured.

    Args:
        triangles: (m, 3, 3).
    """

    def __init__(self, triangles: Floats) -> None:
        from scipy.spatial import cKDTree

        self._triangles = triangles
        self._low, self._high = triangles.min(axis=1), triangles.max(axis=1)
        spread, of_spread = sample_surface(triangles, _GUIDES)
        corners = np.repeat(np.arange(len(triangles)), 3)
        self._owner = np.concatenate([corners, of_spread])
        self._guides = cKDTree(np.concatenate([triangles.reshape(-1, 3), spread]))
        self._spread = spread

    def farthest_from_guides(self, points: Floats, corners: Floats, number: int) -> Floats:
        """At most ``number`` of the points (n, 3), those that may be farthest away.

        Args:
            corners: (k, 3), of the triangles. Each is here once, and not once for each of its
                triangles, which takes half of the time.
        """
        from scipy.spatial import cKDTree

        far, _ = cKDTree(np.concatenate([corners, self._spread])).query(points)
        return points[np.argsort(far)[-number:]]

    def farthest(self, points: Floats) -> float:
        """The greatest distance of any of the points (n, 3).

        The distance to some near triangles is fast to compute and an upper bound of the true
        distance. In decreasing order of this bound, points are measured to all triangles that may
        be nearer, until no other point can be farther away: a few points, or hundreds if the
        triangles are slivers, of which near ones are hard to find.
        """
        farthest = 0.0
        for near, most in ((_NEAREST, _FIRST_MEASURED), (_MORE_NEAREST, _MAX_MEASURED)):
            bounds = self.to_near_triangles(points, near)
            order = np.argsort(-bounds)
            points, bounds = points[order], bounds[order]
            for point, bound in zip(points[:most], bounds, strict=False):
                if bound <= farthest + _ROUNDING:
                    break
                farthest = max(farthest, self._distance(point, bound))
            points = points[bounds > farthest + _ROUNDING]
        return farthest

    def _distance(self, point: Floats, bound: float) -> float:
        """The distance of a point (3,), which is at most ``bound``."""
        outside = np.maximum(self._low - point, 0) + np.maximum(point - self._high, 0)
        near = self._triangles[np.einsum("mj,mj->m", outside, outside) <= bound**2]
        distances = _to_triangles(np.broadcast_to(point, (len(near), 3)), near)
        return float(distances.min(initial=bound))

    def to_near_triangles(self, points: Floats, number: int = _NEAREST) -> Floats:
        """(n,), distance from each point to the nearest of a few near triangles."""
        number = min(number, len(self._owner))
        _, nearest = self._guides.query(points, k=number)
        near = self._owner[nearest.reshape(len(points), number)]
        repeated = np.repeat(points, near.shape[1], axis=0)
        distances = _to_triangles(repeated, self._triangles[near.reshape(-1)])
        return np.asarray(distances.reshape(near.shape).min(axis=1))


def _to_triangles(points: Floats, triangles: Floats) -> Floats:
    """(n,), distance from each point to its triangle; to a corner of a triangle without area."""
    from trimesh.triangles import closest_point

    with np.errstate(invalid="ignore", divide="ignore"):
        to_faces = np.linalg.norm(closest_point(triangles, points) - points, axis=1)
    to_corners = np.linalg.norm(triangles - points[:, None], axis=2).min(axis=1)
    return np.asarray(np.fmin(to_faces, to_corners))


def sample_surface(triangles: Floats, number: int) -> tuple[Floats, Integers]:
    """Points spread evenly over a surface, (n, 3), and their triangles; empty without area."""
    areas = np.linalg.norm(scaled_normals(triangles), axis=1)
    total = float(areas.sum())
    if not 0 < total < np.inf:
        return np.zeros((0, 3)), np.zeros(0, dtype=np.int64)
    random = np.random.default_rng(_SEED)
    chosen = np.searchsorted(np.cumsum(areas), random.random(number) * total)
    chosen = np.minimum(chosen, len(triangles) - 1)
    weights = random.dirichlet((1.0, 1.0, 1.0), number)
    return np.einsum("nk,nkj->nj", weights, triangles[chosen]), chosen
