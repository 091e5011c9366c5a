"""A wheel turns about another axis than that of its cylinder.

It tumbles like a coin instead of rolling: the robot jumps, or does not move. Either the axis of the
joint is wrong, or the shape is not turned as it: a cylinder of URDF stands on its z axis, and a
wheel whose axle is y wants rpy="1.5707963 0 0".

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Confidence, Related, Severity
from urdfkit.mechanics.kinematics import direction
from urdfkit.rules import Finding, rule
from urdfkit.spatial import dot, rotate
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.model import Body, Joint, Link
    from urdfkit.subject import Subject

BAD = """\
<link name="base"/>
<link name="wheel">
  <collision>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
</link>
<joint name="wheel_joint" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
  <axis xyz="0 1 0"/>
</joint>"""
GOOD = BAD.replace("<geometry>", '<origin rpy="1.5707963 0 0"/>\n    <geometry>', 1)

#: Names of links whose cylinder need not roll.
_OTHERS = ("caster", "castor", "swivel", "steer", "mount", "support", "bracket", "hub", "fork")


@rule("JNT033", "wheel-axis-across", Severity.WARNING)
def check(subject: Subject) -> Iterator[Finding]:
    links = subject.model.links_by_name
    for joint in subject.model.joints:
        link = links.get(joint.child.value) if joint.child else None
        if link is None or joint.kind != "continuous":
            continue
        body = _tyre(joint, link)
        if body is None:
            continue
        x, y, z = (round(part, 3) + 0.0 for part in direction(joint))
        a, b, c = (round(part, 3) + 0.0 for part in rotate(body.origin.rotation, (0.0, 0.0, 1.0)))
        if abs(dot((x, y, z), (a, b, c))) < 0.5:
            yield Finding(
                joint.at.child("axis") or joint.at,
                f"joint '{joint.name}' turns wheel '{link.name}' about {x:g} {y:g} {z:g}, and the "
                f"axis of its cylinder is {a:g} {b:g} {c:g}",
                "write the axis of the cylinder, or turn the shapes with their <origin>",
                related=(Related(body.at.span, "the cylinder"),),
                confidence=Confidence.INFERRED,
            )


def _tyre(joint: Joint, link: Link) -> Body | None:
    """The flat cylinder of a wheel, about its joint; None if it is none."""
    names = f"{joint.name} {link.name}".lower()
    if "wheel" not in names or any(word in names for word in _OTHERS):
        return None
    for bodies in (link.collisions, link.visuals):
        shape = bodies[0].shape if len(bodies) == 1 else None
        if shape and shape.kind == "cylinder" and shape.radius and shape.length:
            is_flat = shape.length < 1.5 * shape.radius
            is_centred = max(map(abs, bodies[0].origin.position)) < shape.radius
            return bodies[0] if is_flat and is_centred else None
    return None
