"""All collision geometry of a moving link is inside that of another link.

Nothing can make contact with the inner link from outside: a wheel inside the chassis does not reach
the floor, a bumper or a finger detects nothing. With self-collision enabled, a simulator pushes the
two apart in every step. Make the outer geometry smaller, or move the inner geometry to the position
of the part. A link that contains several others is reported once. Three kinds of links are not
reported: a link with fixed children that extend outside, such as the rotor of a motor; a link
inside an envelope, which is a link without visual, or with a transparent one, that is fixed to a
link with a visual, such as the capsules for self-collision of Franka's arms and safety boxes around
tools; and a link with a shape of a few micrometres, which is a placeholder.

Sources:
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from __future__ import annotations

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.link import Material
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml, robot_xml

if TYPE_CHECKING:
    from urdfkit.physics.collision.bodies import CollisionBody
    from urdfkit.physics.collision.contacts import Contact
    from urdfkit.text.document import Element

BAD = robot_xml(
    link_xml("base", collision_xml('<box size="0.2 0.2 0.2"/>')),
    link_xml("arm", collision_xml('<sphere radius="0.02"/>')),
    joint_xml(
        "prismatic",
        '<origin xyz="0 0 0.05"/>',
        '<limit lower="0" upper="0.03" effort="20" velocity="0.1"/>',
    ),
)
GOOD = BAD.replace("0 0 0.05", "0 0 0.12")

#: In m: a smaller shape is a placeholder.
_MIN_SIZE = 1e-5
#: Number of contained links that a finding lists.
_MAX_NAMED = 5


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.COLLISIONS),
    help="make the outer geometry smaller, or move the inner one to where the part is",
)
def check(context: Context) -> Findings:
    contained: dict[str, list[Contact]] = {}
    for pair in context.collisions.contacts.pairs:
        if not pair.is_rigid and pair.is_enclosed and pair.is_permanent:
            assert pair.contact is not None
            if _is_point(context.model, pair.contact.small):
                continue  # a placeholder: GEO001
            contained.setdefault(pair.contact.large.link, []).append(pair.contact)
    for name, contacts in contained.items():
        if _is_envelope(context, name):
            continue
        if len(contacts) > 1:
            yield _several(context.model, contacts)
        else:
            yield _single(context.model, contacts[0])


def _is_envelope(context: Context, name: str) -> bool:
    """True for a link without an opaque visual that is fixed to a link with a visual."""
    colours = Colours(context.model)
    if not all(
        _is_transparent(colours.of(body)) for body in context.model.links_by_name[name].visuals
    ):
        return False
    return any(
        name in body.names and any(link.visuals for link, _ in body.links if link.name != name)
        for body in rigid_bodies(context.tree)
    )


def _is_point(model: RobotModel, body: CollisionBody) -> bool:
    shape = model.links_by_name[body.link].collisions[body.number].shape
    extents = shape and shape.half_extents
    return extents is not None and max(extents) < _MIN_SIZE


def _is_transparent(material: Material | None) -> bool:
    rgba = material.rgba.value if material and material.rgba else ()
    return len(rgba) == 4 and rgba[3] < 1


def _single(model: RobotModel, contact: Contact) -> Finding:
    return Finding(
        _element(model, contact.small),
        f"link '{contact.small.link}' is inside the collision geometry of '{contact.large.link}' "
        "and cannot make contact",
        related=(Related(_element(model, contact.large).span, f"link '{contact.large.link}'"),),
    )


def _several(model: RobotModel, contacts: list[Contact]) -> Finding:
    """A link that contains several links: more likely the outer link is wrong than all others."""
    names = [contact.small.link for contact in contacts]
    large = contacts[0].large
    return Finding(
        _element(model, large),
        f"the collision geometry of link '{large.link}' contains {len(names)} other links, which "
        f"cannot make contact: {few(names, _MAX_NAMED)}",
        related=tuple(
            Related(_element(model, contact.small).span, f"link '{contact.small.link}'")
            for contact in contacts[:_MAX_NAMED]
        ),
        weight=len(names),
    )


def _element(model: RobotModel, body: CollisionBody) -> Element:
    return model.collision(body.link, body.number)
