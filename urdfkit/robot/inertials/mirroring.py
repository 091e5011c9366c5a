"""Mirror images of the inertials of left/right counterparts."""

from __future__ import annotations

from collections.abc import Mapping
from math import dist

from urdfkit.core.spatial import Transform, Vector, transposed, vector
from urdfkit.robot.inertia import MassProperties, rotated
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.link import Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.edits import replace_value

#: Tolerance of mirrored positions, in m.
_TOLERANCE = 1e-3
#: The products of inertia that change their sign with an axis: y, or else x.
_PLANES = ((1, ("ixy", "iyz")), (0, ("ixy", "ixz")))


def mirror_image(
    link: LinkInertia, other: LinkInertia, placed: Mapping[str, Transform]
) -> MassProperties | None:
    """The mirrored mass properties of a counterpart, in the frame of a link.

    None unless the origins of the two are mirror images in the plane y = 0 or x = 0 of the root.

    Args:
        placed: the frames of the links in that of the root.
    """
    own, its = placed.get(link.name), placed.get(other.name)
    if own is None or its is None:
        return None
    for axis, products in _PLANES:
        if dist(_flipped(its.position, axis), own.position) <= _TOLERANCE:
            properties = properties_of(other.link, its)
            signs = {key: -getattr(properties.tensor, key) for key in products}
            center, tensor = _flipped(properties.center, axis), properties.tensor._replace(**signs)
            return MassProperties(properties.mass, center, tensor).moved(own.inverse)
    return None


def _flipped(point: Vector, axis: int) -> Vector:
    return vector(-value if index == axis else value for index, value in enumerate(point))


def along_inertial(link: LinkInertia, tensor: Tensor) -> Tensor:
    """A tensor transformed from the axes of a link to those of its ``<inertial>``."""
    return rotated(tensor, transposed(link.inertial.origin.rotation))


def center_edits(link: LinkInertia, center: Vector) -> tuple[Edit, ...] | None:
    """Edits that change the centre of mass; empty if it is equal, None if they are impossible."""
    if dist(center, link.inertial.origin.position) <= _TOLERANCE:
        return ()
    origin = link.inertial.at.child("origin")
    xyz = origin.attributes.get("xyz") if origin else None
    return replace_value(xyz, " ".join(f"{value:.6g}" for value in center)) if xyz else None
