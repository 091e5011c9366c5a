"""Inertia tensors: principal moments, uniform primitives, and composite bodies.

Tensors in kg·m² about the centre of mass unless stated otherwise, masses in kg, lengths in m. The
module does without numpy, whose import alone takes longer than checking a robot.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import acos, cos, hypot, pi, sqrt

from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    IDENTITY,
    Rotation,
    Transform,
    Vector,
    basis,
    cross,
    dot,
    rotate,
    unit,
)
from urdfkit.robot.link import Tensor

#: Sweeps of Jacobi rotations: convergence is quadratic, and five reach machine precision.
_SWEEPS = 8

ZERO = Tensor(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class MassProperties(Record):
    """Mass properties of a rigid body."""

    mass: float  # in kg
    center: Vector  # of mass, in m
    tensor: Tensor  # about the centre of mass, along the axes of the same frame, in kg·m²

    def moved(self, frame: Transform) -> MassProperties:
        """The mass properties transformed from a frame to its parent frame."""
        tensor = rotated(self.tensor, frame.rotation)
        return MassProperties(self.mass, frame.apply(self.center), tensor)


def principal_moments(tensor: Tensor) -> Vector:
    """The three eigenvalues of a symmetric tensor, smallest first, in its unit.

    The error is a few units in the last place of the largest moment, even if two moments are nearly
    equal. Source: D. Eberly, "A Robust Eigensolver for 3x3 Symmetric Matrices" (2014),
    non-iterative: the trigonometric roots of the characteristic cubic are accurate for the most
    distant eigenvalue; the other two are computed in the plane orthogonal to its eigenvector.
    """
    scale = max(map(abs, tensor))
    if scale == 0.0:
        return (0.0, 0.0, 0.0)
    xx, xy, xz, yy, yz, zz = (value / scale for value in tensor)
    mean = (xx + yy + zz) / 3
    dx, dy, dz = xx - mean, yy - mean, zz - mean
    off = xy * xy + xz * xz + yz * yz
    if off < 1e-30:  # smaller than the rounding error of the eigenvalues
        low, middle, high = sorted((tensor.ixx, tensor.iyy, tensor.izz))
        return (low, middle, high)
    spread = sqrt((dx * dx + dy * dy + dz * dz + 2 * off) / 6)
    minor = dx * (dy * dz - yz * yz) - xy * (xy * dz - yz * xz) + xz * (xy * yz - dy * xz)
    half = max(-1.0, min(1.0, minor / (2 * spread**3)))
    # The distant root is the largest if half > 0, the smallest if half < 0.
    distant = mean + 2 * spread * cos(acos(half) / 3 + (0.0 if half >= 0 else 2 * pi / 3))
    u, v, w = _eigenbasis(xx - distant, xy, xz, yy - distant, yz, zz - distant)
    rows = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    au, av = rotate(rows, u), rotate(rows, v)
    uu, uv, vv = dot(u, au), dot(v, au), dot(v, av)
    middle, radius = (uu + vv) / 2, hypot((uu - vv) / 2, uv)
    low, middle, high = sorted((dot(w, rotate(rows, w)), middle - radius, middle + radius))
    return (low * scale, middle * scale, high * scale)


def principal_axes(tensor: Tensor) -> tuple[Vector, Rotation]:
    """The principal moments, smallest first, and a rotation whose columns are their axes.

    The largest component of each axis is positive, except for the last axis, which completes a
    right-handed set. For equal moments any axes are correct; the basis vectors are preferred.
    Source: C. G. J. Jacobi's rotations (1846), each of which eliminates one product of inertia.
    """
    scale = max(map(abs, tensor)) or 1.0
    xx, xy, xz, yy, yz, zz = (value / scale for value in tensor)
    rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    for _ in range(_SWEEPS):
        for i, j in ((0, 1), (0, 2), (1, 2)):
            _clear(rows, axes, i, j)
    moments = principal_moments(tensor)
    order = sorted(range(3), key=lambda index: rows[index][index])
    x, y = (_positive([axes[row][index] for row in range(3)]) for index in order[:2])
    z = cross(x, y)
    return moments, ((x[0], y[0], z[0]), (x[1], y[1], z[1]), (x[2], y[2], z[2]))


def uniform_solid(tensor: Tensor, mass: float) -> tuple[Vector, Rotation]:
    """The edges of the equivalent box of uniform density, and a rotation with its axes as columns.

    The second moment of mass along an axis is half the sum of the moments minus its own moment; an
    edge is the root of 12 times the second moment by the mass (> 0), or 0 for impossible tensors.
    """
    moments, axes = principal_axes(tensor)
    half = sum(moments) / 2
    x, y, z = (sqrt(max(0.0, 12 * (half - moment) / mass)) for moment in moments)
    return (x, y, z), axes


def _clear(rows: list[list[float]], axes: list[list[float]], i: int, j: int) -> None:
    """Rotate in the plane of two axes so that their product of inertia becomes zero."""
    if abs(rows[i][j]) < 1e-18:
        return
    half = (rows[j][j] - rows[i][i]) / (2 * rows[i][j])
    t = (1 if half >= 0 else -1) / (abs(half) + hypot(half, 1.0))
    c = 1 / hypot(t, 1.0)
    s = t * c
    for row in (*rows, *axes):
        row[i], row[j] = c * row[i] - s * row[j], s * row[i] + c * row[j]
    rows[i], rows[j] = (
        [c * a - s * b for a, b in zip(rows[i], rows[j], strict=True)],
        [s * a + c * b for a, b in zip(rows[i], rows[j], strict=True)],
    )


def _positive(axis: list[float]) -> Vector:
    sign = 1.0 if max(axis, key=abs) >= 0 else -1.0
    return (sign * axis[0] + 0.0, sign * axis[1] + 0.0, sign * axis[2] + 0.0)


def _eigenbasis(
    a: float, b: float, c: float, d: float, e: float, f: float
) -> tuple[Vector, Vector, Vector]:
    """Two unit vectors orthogonal to the kernel of a singular symmetric matrix, and the kernel."""
    rows = ((a, b, c), (b, d, e), (c, e, f))
    normals = [cross(rows[i], rows[j]) for i, j in ((0, 1), (0, 2), (1, 2))]
    return basis(unit(max(normals, key=lambda normal: dot(normal, normal))))


def box(mass: float, size: Vector) -> Tensor:
    """A solid box with edges ``size`` along x, y, z."""
    xx, yy, zz = (edge * edge * mass / 12 for edge in size)
    return Tensor(yy + zz, 0.0, 0.0, xx + zz, 0.0, xx + yy)


def cylinder(mass: float, radius: float, length: float) -> Tensor:
    across = mass * (3 * radius * radius + length * length) / 12
    return Tensor(across, 0.0, 0.0, across, 0.0, mass * radius * radius / 2)


def sphere(mass: float, radius: float) -> Tensor:
    moment = 2 * mass * radius * radius / 5
    return Tensor(moment, 0.0, 0.0, moment, 0.0, moment)


def capsule(mass: float, radius: float, length: float) -> Tensor:
    """A solid cylinder along z of ``length`` with a hemisphere at each end.

    The centre of mass of a hemisphere is 3/8 of the radius beyond the end of the cylinder; the
    parallel axis theorem gives the term with ``radius * length``.
    """
    ends = mass * 4 * radius / (3 * length + 4 * radius)
    middle = cylinder(mass - ends, radius, length)
    ball = 2 * radius * radius / 5
    across = middle.ixx + ends * (ball + length * length / 4 + 3 * length * radius / 8)
    return Tensor(across, 0.0, 0.0, across, 0.0, middle.izz + ends * ball)


def shifted(tensor: Tensor, mass: float, offset: Vector) -> Tensor:
    """The tensor about a point ``offset`` away from the centre of mass (parallel axis theorem).

    A negative mass inverts the shift, from that point to the centre of mass.
    """
    x, y, z = offset
    return Tensor(
        tensor.ixx + mass * (y * y + z * z),
        tensor.ixy - mass * x * y,
        tensor.ixz - mass * x * z,
        tensor.iyy + mass * (x * x + z * z),
        tensor.iyz - mass * y * z,
        tensor.izz + mass * (x * x + y * y),
    )


def rotated(tensor: Tensor, rotation: Rotation) -> Tensor:
    """A tensor transformed from the axes of a child frame to those of the parent."""
    if rotation is IDENTITY:
        return tensor
    x, y, z = rotation
    rows = tensor.rows
    tx, ty, tz = rotate(rows, x), rotate(rows, y), rotate(rows, z)
    return Tensor(dot(x, tx), dot(x, ty), dot(x, tz), dot(y, ty), dot(y, tz), dot(z, tz))


def scaled(tensor: Tensor, factor: float) -> Tensor:
    return Tensor(*(factor * value for value in tensor))


def added(left: Tensor, right: Tensor) -> Tensor:
    """The sum of two tensors about the same point."""
    return Tensor(*(a + b for a, b in zip(left, right, strict=True)))


def agree(tensor: Tensor, other: Tensor, factor: float) -> bool:
    """True if the moments about x, y and z are positive and differ by a factor at most."""
    rows = zip((tensor.ixx, tensor.iyy, tensor.izz), (other.ixx, other.iyy, other.izz), strict=True)
    return all(b > 0 and b / factor <= a <= b * factor for a, b in rows)


def combined(bodies: Iterable[MassProperties]) -> MassProperties:
    """Composite of bodies in one frame; zero at the origin if they have no mass.

    The tensor of bodies without mass counts about the common centre of mass.
    """
    bodies = list(bodies)
    mass = sum(body.mass for body in bodies)
    if mass == 0.0:
        return MassProperties(0.0, (0.0, 0.0, 0.0), ZERO)
    if len(bodies) == 1:
        return bodies[0]
    x, y, z = (sum(b.mass * b.center[i] for b in bodies) / mass for i in range(3))
    total = ZERO
    for body in bodies:
        offset = (body.center[0] - x, body.center[1] - y, body.center[2] - z)
        total = added(total, shifted(body.tensor, body.mass, offset))
    return MassProperties(mass, (x, y, z), total)
