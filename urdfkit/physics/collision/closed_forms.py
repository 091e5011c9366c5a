"""Signed distances of boxes, spheres, cylinders and capsules in closed form, without any library.

A signed distance is positive between separate bodies. For overlapping bodies it is the negative
penetration depth: the shortest translation until they only touch. Lengths in m.
"""

from math import hypot, sqrt

from urdfkit.core.spatial import Transform, Vector, dot

#: Cosine above which axes are parallel: within a millionth of a radian.
_PARALLEL = 1 - 5e-13

#: Length of the cross product of two edge directions below which they are parallel.
_CROSSING = 1e-6


def signed_distance(
    kind: str,
    size: tuple[float, ...],
    other_kind: str,
    other_size: tuple[float, ...],
    at: Transform,
) -> float | None:
    """The signed distance of two bodies; None for a pair without a closed form, such as a mesh.

    Exact if they overlap; for two separate boxes a lower bound above 0.

    Args:
        kind: ``box``, ``sphere``, ``cylinder`` or ``capsule``, centred at its origin, with its axis
            along z, or ``mesh``.
        size: sides of a box; otherwise the radius, and the length if there is one.
        at: frame of the second body in the first.
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
    """The signed distance of a point from the surface of a primitive, in the primitive's frame."""
    x, y, z = map(abs, point)
    if kind == "box":
        return _of_product(x - size[0] / 2, y - size[1] / 2, z - size[2] / 2)
    if kind == "cylinder":
        return _of_product(hypot(x, y) - size[0], z - size[1] / 2)
    above = z - size[1] / 2 if kind == "capsule" else z
    return hypot(x, y, max(above, 0.0)) - size[0]


def box_distance(a: Vector, b: Vector, at: Transform) -> float:
    """The separation of two boxes along the best of 15 axes: normals and cross products of edges.

    Exact if they overlap, because the Minkowski difference of two boxes has no other faces;
    otherwise a lower bound above 0.

    Args:
        a: half sides of the first box.
        b: half sides of the second box.
        at: frame of the centre of the second box in the frame of the centre of the first.

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
    """The signed distance if the axis is parallel to an edge: a product of a plane and a line."""
    for axis, (j, k) in _OTHERS:
        if abs(at.rotation[axis][2]) > _PARALLEL:
            x, y, z = (abs(at.position[i]) - half[i] for i in (j, k, axis))
            return _of_product(_of_product(x, y) - size[0], z - size[1] / 2)
    return None


def _of_product(*gaps: float) -> float:
    """The signed distance from a product of sets, from the signed distances in its factors."""
    deepest = max(gaps)
    return deepest if deepest <= 0 else hypot(*(max(gap, 0.0) for gap in gaps))


def _half(size: tuple[float, ...]) -> Vector:
    return (size[0] / 2, size[1] / 2, size[2] / 2)
