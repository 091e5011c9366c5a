"""Inertia tensors: principal moments, primitives of uniform density, and what bodies make together.

Tensors in kg·m² about the centre of mass unless said otherwise, masses in kg, lengths in m.
Nothing here needs numpy, which alone costs more than checking a robot.
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
from urdfkit.robot.model import Tensor

#: Sweeps of Jacobi's rotations: they converge quadratically, and five reach rounding.
_SWEEPS = 8

ZERO = Tensor(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class MassProperties(Record):
    """A rigid body as dynamics sees it."""

    mass: float  # in kg
    center: Vector  # of mass, in m
    tensor: Tensor  # about the centre of mass, along the axes of the same frame, in kg·m²

    def moved(self, frame: Transform) -> MassProperties:
        """The same, given in a frame, in the parent of that frame."""
        tensor = rotated(self.tensor, frame.rotation)
        return MassProperties(self.mass, frame.apply(self.center), tensor)


def principal_moments(tensor: Tensor) -> Vector:
    """The three eigenvalues of a symmetric tensor, smallest first, in its unit.

    The error is a few units in the last place of the largest one, whatever the magnitude and
    however close two of them are. Source: D. Eberly, "A Robust Eigensolver for 3x3 Symmetric
    Matrices" (2014), non-iterative: the trigonometric roots of the characteristic cubic are good
    for the eigenvalue that lies apart; the other two come from the plane at right angles to its
    eigenvector.
    """
    scale = max(map(abs, tensor))
    if scale == 0.0:
        return (0.0, 0.0, 0.0)
    xx, xy, xz, yy, yz, zz = (value / scale for value in tensor)
    mean = (xx + yy + zz) / 3
    dx, dy, dz = xx - mean, yy - mean, zz - mean
    off = xy * xy + xz * xz + yz * yz
    if off < 1e-30:  # these move no eigenvalue by more than rounding does
        low, middle, high = sorted((tensor.ixx, tensor.iyy, tensor.izz))
        return (low, middle, high)
    spread = sqrt((dx * dx + dy * dy + dz * dz + 2 * off) / 6)
    minor = dx * (dy * dz - yz * yz) - xy * (xy * dz - yz * xz) + xz * (xy * yz - dy * xz)
    half = max(-1.0, min(1.0, minor / (2 * spread**3)))
    # The largest root lies apart from the two others if half > 0, the smallest if half < 0.
    apart = mean + 2 * spread * cos(acos(half) / 3 + (0.0 if half >= 0 else 2 * pi / 3))
    u, v, w = _eigenbasis(xx - apart, xy, xz, yy - apart, yz, zz - apart)
    rows = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    au, av = rotate(rows, u), rotate(rows, v)
    uu, uv, vv = dot(u, au), dot(v, au), dot(v, av)
    middle, radius = (uu + vv) / 2, hypot((uu - vv) / 2, uv)
    low, middle, high = sorted((dot(w, rotate(rows, w)), middle - radius, middle + radius))
    return (low * scale, middle * scale, high * scale)


def principal_axes(tensor: Tensor) -> tuple[Vector, Rotation]:
    """The principal moments, smallest first, and a rotation whose columns are their axes.

    Of each axis the largest part is positive, but for the last one, where a right-handed set needs
    it. Equal moments have no axes of their own: any set of them is one, the basis vectors first.
    Source: C. G. J. Jacobi's rotations (1846), each of which clears one product of inertia.
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
    x, y = (_upright([axes[row][index] for row in range(3)]) for index in order[:2])
    z = cross(x, y)
    return moments, ((x[0], y[0], z[0]), (x[1], y[1], z[1]), (x[2], y[2], z[2]))


def uniform_solid(tensor: Tensor, mass: float) -> tuple[Vector, Rotation]:
    """The edges of a box of uniform density, and a rotation whose columns are their axes.

    A second moment of mass along an axis is half of all three moments less its own; an edge is the
    root of 12 times it over the mass, which is above 0; 0 where a tensor belongs to no real body.
    """
    moments, axes = principal_axes(tensor)
    half = sum(moments) / 2
    x, y, z = (sqrt(max(0.0, 12 * (half - moment) / mass)) for moment in moments)
    return (x, y, z), axes


def _clear(rows: list[list[float]], axes: list[list[float]], i: int, j: int) -> None:
    """Turn in the plane of two axes until their product of inertia is zero."""
    if abs(rows[i][j]) < 1e-18:
        return
    half = (rows[j][j] - rows[i][i]) / (2 * rows[i][j])
    t = (1 if half >= 0 else -1) / (abs(half) + hypot(half, 1.0))
    c = 1 / hypot(t, 1.0)
    s = t * c
    for row in rows:
        row[i], row[j] = c * row[i] - s * row[j], s * row[i] + c * row[j]
    rows[i], rows[j] = (
        [c * a - s * b for a, b in zip(rows[i], rows[j], strict=True)],
        [s * a + c * b for a, b in zip(rows[i], rows[j], strict=True)],
    )
    for row in axes:
        row[i], row[j] = c * row[i] - s * row[j], s * row[i] + c * row[j]


def _upright(axis: list[float]) -> Vector:
    sign = 1.0 if max(axis, key=abs) >= 0 else -1.0
    return (sign * axis[0] + 0.0, sign * axis[1] + 0.0, sign * axis[2] + 0.0)


def _eigenbasis(
    a: float, b: float, c: float, d: float, e: float, f: float
) -> tuple[Vector, Vector, Vector]:
    """Two unit vectors at right angles to the kernel of a singular symmetric matrix, and it."""
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
    """A solid cylinder along z of ``length`` with a half ball at each end.

    The half balls have their centre of mass 3/8 of the radius beyond the cylinder's end; the
    parallel-axis rule there gives the term with ``radius * length``.
    """
    ends = mass * 4 * radius / (3 * length + 4 * radius)
    middle = cylinder(mass - ends, radius, length)
    ball = 2 * radius * radius / 5
    across = middle.ixx + ends * (ball + length * length / 4 + 3 * length * radius / 8)
    return Tensor(across, 0.0, 0.0, across, 0.0, middle.izz + ends * ball)


def shifted(tensor: Tensor, mass: float, offset: Vector) -> Tensor:
    """The tensor about a point ``offset`` away from the centre of mass (Huygens, Steiner).

    With a negative mass, it leads back from that point to the centre of mass.
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
    """A tensor given along the axes of a child frame, along those of the parent."""
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
    """True if the moments about x, y and z, all positive, differ by no more than a factor."""
    rows = zip((tensor.ixx, tensor.iyy, tensor.izz), (other.ixx, other.iyy, other.izz), strict=True)
    return all(b > 0 and b / factor <= a <= b * factor for a, b in rows)


def combined(bodies: Iterable[MassProperties]) -> MassProperties:
    """Several bodies in one frame as one rigid body; zero at the origin if they have no mass.

    Bodies without mass count with their tensor where the others balance.
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
