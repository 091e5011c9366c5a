"""The centre of mass is not above the wheels: the robot tips over where it stands.

All joints at zero, the lowest collisions touch the ground: their hull is what the robot stands on.
In a simulation it falls over in its first second. Move the heavy parts, the wheels or the caster,
or correct a mass or the place of one. Three kinds are not judged: a robot that stands on its base
alone, since bases are bolted down, one on two wheels, which balances, and one on legs, which does
not stand with all joints at zero; `urdfkit statics --pose` tells how it stands in any pose.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Related, Severity
from urdfkit.mechanics.extent import WITHOUT_MESHES
from urdfkit.mechanics.joints import BOUNDED
from urdfkit.mechanics.rigid import rigid_bodies
from urdfkit.mechanics.stability import Stability, stand
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING
from urdfkit.subject import Unavailable

if TYPE_CHECKING:
    from urdfkit.mechanics.tree import KinematicTree
    from urdfkit.model import RobotModel, Shape
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
    needs=(Need.MODEL, Need.MESHES),
    help="move wheels, casters or heavy parts until it stands (urdfkit statics)",
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.is_part or not subject.tree.is_sound:
        return
    standing = stand(subject, meshes=False)
    if not _falls(subject, standing):
        return
    meshes = list(_meshes(subject.model))
    if meshes:  # one of them may reach as low
        try:
            if any(subject.meshes.mesh(shape) is None for shape in meshes):
                return
            standing = stand(subject)
        except ImportError as error:
            raise Unavailable(WITHOUT_MESHES) from error
    if standing is None or not _falls(subject, standing):
        return
    links = subject.model.links_by_name
    heaviest = max(subject.model.links, key=lambda link: link.mass)
    yield Finding(
        heaviest.inertial.at if heaviest.inertial else heaviest.at,
        f"the robot falls {standing.way}: its centre of mass is {-standing.margin:.3g} m outside "
        f"of what it stands on, {', '.join(standing.links)}",
        related=tuple(Related(links[name].at.span, f"link '{name}'") for name in standing.links),
    )


def _falls(subject: Subject, standing: Stability | None) -> bool:
    """True if it falls, off several links of which a joint moves one; not what is bolted down."""
    if standing is None or standing.margin > -_TOLERANCE or len(standing.links) < 2:
        return False
    root = rigid_bodies(subject.tree)[0]
    fixed = {link.name for link, _ in root.links}
    return (
        not root.is_ground
        and not fixed.issuperset(standing.links)
        and not any(_is_leg(subject.tree, name) for name in standing.links)
    )


def _is_leg(tree: KinematicTree, link: str) -> bool:
    """True for the end of a leg; a wheel may be steered and sprung, and then turn."""
    bends = 0
    above = tree.parents[link]
    while above:
        bends += above[0].kind in BOUNDED
        assert above[0].parent is not None
        above = tree.parents[above[0].parent.value]
    return bends > 2


def _meshes(model: RobotModel) -> Iterator[Shape]:
    """The meshes that may touch the ground."""
    for link in model.links:
        for body in link.collisions or link.visuals:
            if body.shape and body.shape.filename:
                yield body.shape
