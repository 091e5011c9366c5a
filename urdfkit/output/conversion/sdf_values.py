"""Numbers and poses as sdformat writes them."""

from collections.abc import Iterable
from math import asin, atan2, copysign, pi

from urdfkit.core.spatial import Rotation, Vector

#: urdfdom rounds a pitch whose sine is larger to 90 degrees: within 4.5 mrad.
SNAP = 0.99999


def number_text(value: float) -> str:
    """A number with 16 digits; -0 is written as 0."""
    return f"{value:.16g}" if value else "0"


def numbers_text(values: Iterable[float]) -> str:
    return " ".join(map(number_text, values))


def pose_text(position: Vector, rpy: Vector) -> str:
    """A pose in the format of SDF, in m and rad."""
    return numbers_text((*position, *rpy))


def snapped_rpy(rotation: Rotation) -> Vector:
    """Roll, pitch and yaw as urdfdom computes them, with a rounded pitch near 90 degrees.

    Source: ``Rotation::getRPY`` in urdfdom_headers' pose.h.
    """
    (xx, xy, _), (yx, yy, _), (zx, zy, zz) = rotation
    if abs(zx) >= SNAP:
        # Four times x * x, x * y and y * y of the quaternion: x and y up to a factor.
        squares = (1 + xx - yy - zz, xy + yx, 1 - xx + yy - zz)
        x, y = squares[:2] if squares[0] > squares[2] else squares[1:]
        return (0.0, copysign(pi / 2, -zx), 2 * atan2(x, -y))
    return (atan2(zy, zz), asin(-zx), atan2(yx, xx))
