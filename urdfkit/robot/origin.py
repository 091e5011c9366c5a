"""The transform of an ``<origin>``."""

from urdfkit.core.spatial import IDENTITY, ORIGIN, Rotation, Transform, from_quaternion, from_rpy
from urdfkit.robot.values import numbers, vector
from urdfkit.text.document import Element
from urdfkit.text.schema import VERSIONS


def read_origin(element: Element) -> Transform:
    """The frame of an element in that of its parent; the identity without ``<origin>``."""
    origin = element.child("origin")
    if origin is None:
        return Transform()
    return Transform(_rotation(origin), vector(origin.get("xyz")) or ORIGIN)


def _rotation(origin: Element) -> Rotation:
    """The rotation of ``rpy``, or of ``quat_xyzw`` if the URDF version supports it."""
    rpy = vector(origin.get("rpy"))
    if rpy:
        return from_rpy(*rpy)
    quaternion = numbers(origin.get("quat_xyzw")) or ()
    if len(quaternion) == 4 and reads_quaternions(origin):
        return from_quaternion(*quaternion)
    return IDENTITY


def reads_quaternions(element: Element) -> bool:
    """True if urdfdom reads ``quat_xyzw`` in this robot: from URDF 1.1 on."""
    from urdfkit.text.grammar import version_of

    while element.parent is not None:
        element = element.parent
    return version_of(element) != VERSIONS[0]
