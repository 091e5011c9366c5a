"""The centre of mass is not above the wheels or feet: the robot tips over where it stands.

All joints at zero, the lowest collisions touch the ground: their hull is what the robot stands on.
In a simulation it falls over in its first second. Move the heavy parts, the wheels or the caster,
or correct a mass or the place of one. A robot that stands on its base alone is not judged, since
bases are bolted down, nor one on two wheels, which balances.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Related, Severity
from urdfkit.rigid import rigid_bodies
from urdfkit.rules import Finding, rule
from urdfkit.stability import Stability, stand

if TYPE_CHECKING:
    from urdfkit.subject import Subject

_WHEEL = """
<link name="{0}">
  <collision>
    <geometry><sphere radius="0.05"/></geometry>
  </collision>
  <inertial>
    <mass value="0.2"/>
    <inertia ixx="0.0002" ixy="0" ixz="0" iyy="0.0002" iyz="0" izz="0.0002"/>
  </inertial>
</link>
<joint name="{0}_joint" type="{1}">
  <origin xyz="{2} 0"/>
  <parent link="base"/>
  <child link="{0}"/>
  <axis xyz="0 1 0"/>
</joint>"""
BAD = """\
<link name="base">
  <inertial>
    <origin xyz="0.1 0 0"/>
    <mass value="3"/>
    <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.03"/>
  </inertial>
</link>""" + "".join(
    _WHEEL.format(*words)
    for words in (
        ("left_wheel", "continuous", "0 0.1"),
        ("right_wheel", "continuous", "0 -0.1"),
        ("caster", "fixed", "-0.15 0"),
    )
)
GOOD = BAD.replace('xyz="0.1 0 0"', 'xyz="-0.05 0 0"')

#: In m; less is rounding, and a robot on the edge of its feet.
_TOLERANCE = 1e-3


@rule(
    "DYN004",
    "tips-over",
    Severity.WARNING,
    help="move wheels, casters or heavy parts until it stands (urdfkit statics)",
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.is_part or not subject.tree.is_sound:
        return
    standing = stand(subject, meshes=False)
    if standing is None or standing.margin > -_TOLERANCE or not _is_on_wheels(subject, standing):
        return
    links = subject.model.links_by_name
    heaviest = max(subject.model.links, key=lambda link: link.mass)
    yield Finding(
        heaviest.inertial.at if heaviest.inertial else heaviest.at,
        f"the robot falls {standing.way}: its centre of mass is {-standing.margin:.3g} m outside "
        f"of what it stands on, {', '.join(standing.links)}",
        related=tuple(Related(links[name].at.span, f"link '{name}'") for name in standing.links),
    )


def _is_on_wheels(subject: Subject, standing: Stability) -> bool:
    """True if it stands on several links and a joint moves one of them; not on what is bolted.

    Meshes are not measured here: with one that may reach as low there is nothing to say.
    """
    root = rigid_bodies(subject.tree)[0]
    if root.is_ground or len(standing.links) < 2:
        return False
    fixed = {link.name for link, _ in root.links}
    touching = subject.model.links_by_name
    return not fixed.issuperset(standing.links) and not any(
        body.shape and body.shape.filename
        for link in touching.values()
        for body in link.collisions or link.visuals
    )
