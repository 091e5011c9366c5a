"""Signed distances of boxes, spheres, cylinders and capsules in closed form, without any library.

A signed distance is positive between bodies that are apart, and negative by the penetration depth
where they overlap: the shortest way that one must move until they only touch. Lengths in m.
"""

from math import hypot, sqrt

from urdfkit.core.spatial import Transform, Vector, dot

#: Axes are parallel if the cosine between them is so near to 1: within a millionth of a radian.
_PARALLEL = 1 - 5e-13

#: Edges whose directions have a shorter cross product are parallel, and give no axis of their own.
_CROSSING = 1e-6


def signed_distance(
    kind: str,
    size: tuple[float, ...],
    other_kind: str,
    other_size: tuple[float, ...],
    at: Transform,
) -> float | None:
    """The signed distance of two bodies; None for a pair without a closed form, such as a mesh.

    Exact where they overlap; of two boxes apart a lower bound, more than 0.

    Args:
        kind: ``box``, ``sphere``, ``cylinder`` or ``capsule``, about its origin, its axis along z,
            or ``mesh``.
        size: the sides of a box; the radius, and the length of what has one.
        at: the frame of the other one in that of the first.
    """
    if "mesh" in (kind, other_kind):
        return None
    if other_kind == "sphere":
        return point_distance(kind, size, at.position) - other_size[0]
    if kind == "sphere" or (kind == "cylinder" and other_kind == "box"):
        return signed_distance(other_kind, other_size, kind, size, at.inverse)
    if kind == other_kind == "box":
        return box_distance(_half(size), _half(other_size), at)
    if kind == "box" and other_kind == "cylinder":
        return _box_and_cylinder(_half(size), other_size, at)
    if kind == other_kind == "cylinder" and abs(at.rotation[2][2]) > _PARALLEL:
        x, y, z = at.position
        across = hypot(x, y) - size[0] - other_size[0]
        return _of_product(across, abs(z) - (size[1] + other_size[1]) / 2)
    return None


def point_distance(kind: str, size: tuple[float, ...], point: Vector) -> float:
    """The signed distance of a point from the surface of a primitive, in its frame."""
    x, y, z = map(abs, point)
    if kind == "box":
        return _of_product(x - size[0] / 2, y - size[1] / 2, z - size[2] / 2)
    if kind == "cylinder":
        return _of_product(hypot(x, y) - size[0], z - size[1] / 2)
    above = z - size[1] / 2 if kind == "capsule" else z
    return hypot(x, y, max(above, 0.0)) - size[0]


def box_distance(a: Vector, b: Vector, at: Transform) -> float:
    """How far two boxes are apart along the best of 15 axes: their normals, and across edges.

    Exact where they overlap, since the Minkowski difference of two boxes has no other faces; else a
    lower bound, more than 0.

    Args:
        a: half the sides of the first.
        b: half the sides of the second.
        at: the frame of the second about its centre, in that of the first about its own.

    Source: S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, SIGGRAPH 1996.
    """
    rotation, (x, y, z) = at.rotation, at.position
    size = [(abs(p), abs(q), abs(r)) for p, q, r in rotation]
    columns = list(zip(*rotation, strict=True))
    best = max(
        abs(offset) - half - dot(row, b)
        for offset, half, row in zip(at.position, a, size, strict=True)
    )
    for half, column in zip(b, columns, strict=True):
        p, q, r = column
        gap = abs(x * p + y * q + z * r) - half - a[0] * abs(p) - a[1] * abs(q) - a[2] * abs(r)
        best = max(best, gap)
    for i, (j, k) in _OTHERS:
        for m, (n, o) in _OTHERS:
            across = sqrt(max(1 - size[i][m] * size[i][m], 0.0))
            if across > _CROSSING:
                gap = abs(at.position[k] * rotation[j][m] - at.position[j] * rotation[k][m])
                gap -= a[j] * size[k][m] + a[k] * size[j][m]
                gap -= b[n] * size[i][o] + b[o] * size[i][n]
                best = max(best, gap / across)
    return best


#: Each axis with the two others.
_OTHERS = ((0, (1, 2)), (1, (2, 0)), (2, (0, 1)))


def _box_and_cylinder(half: Vector, size: tuple[float, ...], at: Transform) -> float | None:
    """Where the axis of the cylinder is parallel to an edge: a product of a plane and a line."""
    for axis, (j, k) in _OTHERS:
        if abs(at.rotation[axis][2]) > _PARALLEL:
            x, y, z = (abs(at.position[i]) - half[i] for i in (j, k, axis))
            return _of_product(_of_product(x, y) - size[0], z - size[1] / 2)
    return None


def _of_product(*gaps: float) -> float:
    """The signed distance from a product of sets, by the signed distances in its factors."""
    deepest = max(gaps)
    return deepest if deepest <= 0 else hypot(*(max(gap, 0.0) for gap in gaps))


def _half(size: tuple[float, ...]) -> Vector:
    return (size[0] / 2, size[1] / 2, size[2] / 2)
