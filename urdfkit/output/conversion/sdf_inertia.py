"""The inertia of links with the links merged into them, as sdformat computes it.

Source: ``ReduceInertialToParent`` in its parser_urdf.cc. It rotates by the angles of urdfdom, which
rounds a pitch near 90 degrees to 90 degrees: this changes a tensor by a few thousandths.
"""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree.ElementTree import Element as Tag
from xml.etree.ElementTree import SubElement

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY, Rotation, Transform, from_rpy, to_rpy, transposed
from urdfkit.output.conversion.sdf_extensions import set_value
from urdfkit.output.conversion.sdf_values import number_text, pose_text, snapped_rpy
from urdfkit.robot.inertia import ZERO, MassProperties, combined, rotated
from urdfkit.robot.link import Link
from urdfkit.text.document import Element


class _Inertia(Record):
    """The inertia of a link together with the links merged into it so far."""

    properties: MassProperties  # its tensor along the axes
    axes: Rotation  # of the link's own inertial
    at: Element


class Inertias:
    """Inertias of all links; updated as links are merged."""

    def __init__(self, links: Iterable[Link]) -> None:
        self._by_link: dict[str, _Inertia] = {}
        for link in links:
            if link.inertial is not None:
                origin = link.inertial.origin
                tensor = link.inertial.tensor.value if link.inertial.tensor else ZERO
                own = MassProperties(link.mass, origin.position, tensor)
                self._by_link[link.name] = _Inertia(own, origin.rotation, link.inertial.at)

    def merge(self, link: str, into: str, frame: Transform) -> None:
        """Add the inertia of a link to the link that it is merged into.

        Args:
            frame: of the link, in the frame of ``into``.
        """
        inertia = self._by_link.get(link)
        if inertia is None:
            return
        massless = _Inertia(MassProperties(0.0, (0.0, 0.0, 0.0), ZERO), IDENTITY, inertia.at)
        own = self._by_link.get(into, massless)
        moved = _along_link(inertia).moved(Transform(_snapped(frame.rotation), frame.position))
        total = combined((_along_link(own), moved))
        tensor = rotated(total.tensor, transposed(_snapped(own.axes)))
        properties = MassProperties(total.mass, total.center, tensor)
        self._by_link[into] = _Inertia(properties, own.axes, own.at)

    def tag(self, link: str) -> Tag:
        """The ``<inertial>`` of a link."""
        properties, axes, _ = self._by_link[link]
        tag = Tag("inertial")
        set_value(tag, "pose", pose_text(properties.center, to_rpy(axes)))
        set_value(tag, "mass", number_text(properties.mass))
        inertia = SubElement(tag, "inertia")
        for name, moment in zip(properties.tensor._fields, properties.tensor, strict=True):
            set_value(inertia, name, number_text(moment))
        return tag


def _along_link(inertia: _Inertia) -> MassProperties:
    """Mass properties with the tensor along the axes of the link."""
    mass, center, tensor = inertia.properties
    return MassProperties(mass, center, rotated(tensor, _snapped(inertia.axes)))


def _snapped(rotation: Rotation) -> Rotation:
    return from_rpy(*snapped_rpy(rotation))
