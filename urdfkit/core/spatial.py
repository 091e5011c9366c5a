"""Vectors, rotations and frames on tuples: importing numpy takes longer than a check.

Lengths in metres, angles in radians. A rotation is a tuple of three rows; ``rotation @ vector``
transforms a vector from the child frame to the parent frame.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import atan2, cos, hypot, sin, sqrt

from urdfkit.core.record import Record

Vector = tuple[float, float, float]
Rotation = tuple[Vector, Vector, Vector]

IDENTITY: Rotation = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ORIGIN: Vector = (0.0, 0.0, 0.0)
#: The unit vectors of a frame.
AXES = X_AXIS, Y_AXIS, Z_AXIS = IDENTITY


class Transform(Record):
    """Pose of a frame in its parent frame: its axes and its origin."""

    rotation: Rotation = IDENTITY
    position: Vector = ORIGIN

    def __matmul__(self, inner: Transform) -> Transform:
        """The frame ``inner`` of this frame, in the parent of this frame."""
        return Transform(multiply(self.rotation, inner.rotation), self.apply(inner.position))

    def apply(self, point: Vector) -> Vector:
        """Transform a point from this frame to the parent frame."""
        x, y, z = rotate(self.rotation, point)
        return (x + self.position[0], y + self.position[1], z + self.position[2])

    @property
    def inverse(self) -> Transform:
        """The parent frame in this frame."""
        back = transposed(self.rotation)
        x, y, z = rotate(back, self.position)
        return Transform(back, (-x, -y, -z))


def from_rpy(roll: float, pitch: float, yaw: float) -> Rotation:
    """Rotation about the fixed axes x, y, z, in this order, like ``rpy`` in URDF."""
    if roll == pitch == yaw == 0:
        return IDENTITY  # most frames
    cr, sr, cp, sp, cy, sy = cos(roll), sin(roll), cos(pitch), sin(pitch), cos(yaw), sin(yaw)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def from_quaternion(x: float, y: float, z: float, w: float) -> Rotation:
    """Rotation of a quaternion of any length, as urdfdom reads one; none if its length is 0."""
    size = sqrt(x * x + y * y + z * z + w * w)
    if not size:
        return IDENTITY
    x, y, z, w = x / size, y / size, z / size, w / size
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )


def rotation_about(axis: Vector, angle: float) -> Rotation:
    """Rotation about a unit vector (Rodrigues' formula)."""
    x, y, z = axis
    c, s = cos(angle), sin(angle)
    t = 1 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )


def to_rpy(rotation: Rotation) -> Vector:
    """Roll, pitch and yaw of a rotation, like ``rpy`` in URDF.

    If the pitch is a right angle, roll and yaw are about the same axis; the yaw is then 0.
    """
    (xx, xy, _), (yx, yy, _), (zx, zy, zz) = rotation
    flat = hypot(xx, yx)
    pitch = atan2(-zx, flat)
    if flat < 1e-9:
        return (atan2(xy if zx < 0 else -xy, yy), pitch, 0.0)
    return (atan2(zy, zz), pitch, atan2(yx, xx))


def rotate(rotation: Rotation, vector: Vector) -> Vector:
    """``rotation @ vector``."""
    if rotation is IDENTITY:
        return vector
    x, y, z = vector
    a, b, c = rotation
    return (
        a[0] * x + a[1] * y + a[2] * z,
        b[0] * x + b[1] * y + b[2] * z,
        c[0] * x + c[1] * y + c[2] * z,
    )


def multiply(left: Rotation, right: Rotation) -> Rotation:
    """``left @ right``."""
    if left is IDENTITY:
        return right
    if right is IDENTITY:
        return left
    columns = [rotate(left, column) for column in zip(*right, strict=True)]
    a, b, c = zip(*columns, strict=True)
    return (a, b, c)


def transposed(rotation: Rotation) -> Rotation:
    """The inverse of a rotation."""
    if rotation is IDENTITY:
        return rotation
    a, b, c = rotation
    return ((a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2]))


def vector(values: Iterable[float]) -> Vector:
    """Convert three numbers, for example a numpy array, to a vector."""
    x, y, z = map(float, values)
    return (x, y, z)


def rotation(rows: Iterable[Iterable[float]]) -> Rotation:
    """Three rows of numbers as a rotation."""
    x, y, z = map(vector, rows)
    return (x, y, z)


def length(vector: Vector) -> float:
    """The Euclidean norm."""
    return hypot(*vector)  # does not overflow


def unit(vector: Vector) -> Vector:
    """The direction of a vector.

    Raises:
        ZeroDivisionError: the vector is zero.
    """
    norm = hypot(*vector)
    return (vector[0] / norm, vector[1] / norm, vector[2] / norm)


def basis(z: Vector) -> Rotation:
    """Right-handed orthonormal basis with a given third vector."""
    least = min(range(3), key=lambda i: abs(z[i]))  # well-conditioned cross product
    y = unit(cross(z, AXES[least]))
    return (cross(y, z), y, z)


def dot(a: Vector, b: Vector) -> float:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def plus(a: Vector, b: Vector) -> Vector:
    """The sum of two vectors."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def times(vector: Vector, factor: float) -> Vector:
    """A vector stretched by a factor."""
    return (vector[0] * factor, vector[1] * factor, vector[2] * factor)


def minus(a: Vector, b: Vector) -> Vector:
    """The difference: from ``b`` to ``a``."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
