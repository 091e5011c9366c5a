"""The centre of mass is not above the wheels: the robot tips over where it stands.

All joints at zero, the lowest collisions touch the ground: their hull is what the robot stands on.
In a simulation it falls over in its first second. Move the heavy parts, the wheels or the caster,
or correct a mass or the place of one. Three kinds are not judged: a robot that stands on its base
alone, since bases are bolted down, one on two wheels, which balances, and one on legs, which does
not stand with all joints at zero; `urdfkit statics --pose` computes its stability in any pose.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.lint.context import Unavailable
from urdfkit.lint.rules import Finding, Findings, Need, Related, Severity, Subject, rule
from urdfkit.robot.bounding_box import WITHOUT_MESHES
from urdfkit.robot.model import RobotModel, Shape
from urdfkit.robot.stability import Stability, is_freestanding, stand
from urdfkit.robot.tree import KinematicTree

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
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="move wheels, casters or heavy parts until it stands (urdfkit statics)",
)
def check(subject: Subject) -> Findings:
    if subject.is_part or not subject.tree.is_sound or _is_serial(subject.tree):
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


def _is_serial(tree: KinematicTree) -> bool:
    """True for a chain of links, which is bolted down."""
    return all(len(joints) < 2 for joints in tree.children.values())


def _falls(subject: Subject, standing: Stability | None) -> bool:
    """True if it falls, off several links of which a joint moves one; not what is bolted down."""
    return (
        standing is not None
        and standing.margin <= -_TOLERANCE
        and len(standing.links) > 1
        and is_freestanding(subject.tree, standing.links)
    )


def _meshes(model: RobotModel) -> Iterator[Shape]:
    """The meshes that may touch the ground; a visual does not."""
    for link in model.links:
        for body in link.collisions:
            if body.shape and body.shape.filename:
                yield body.shape
