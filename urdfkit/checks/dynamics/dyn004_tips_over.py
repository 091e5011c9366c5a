"""The centre of mass is not above the wheels: the robot tips over where it stands.

With all joints at zero, the lowest collisions touch the ground: their hull is the support polygon.
In a simulation the robot falls over in the first second. Move the heavy parts, the wheels or the
caster, or correct a mass or its position. Four kinds of robots are not checked: a robot that stands
on its base alone, as bases are bolted down; a robot on two wheels, which balances; a robot on legs,
which does not stand with all joints at zero; and a robot that several rotors or thrusters carry.
`urdfkit statics --pose` computes the stability in any pose.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from urdfkit.errors import Unavailable
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.rotors import is_carried_by_rotors
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.robot.stability import Stability, collision_meshes, is_freestanding, stand
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.samples import solid_xml


def _wheel(name: str, kind: str, place: str) -> str:
    """A wheel or caster of the base."""
    return robot_xml(
        solid_xml(
            name,
            collision_xml('<sphere radius="0.05"/>'),
            mass="0.2",
            moments="0.0002 0.0002 0.0002",
        ),
        joint_xml(
            kind,
            f'<origin xyz="{place} 0"/>',
            '<axis xyz="0 1 0"/>',
            name=f"{name}_joint",
            child=name,
        ),
    )


BAD = robot_xml(
    link_xml("base", inertial_xml("3", "0.02 0.02 0.03", '<origin xyz="0.1 0 0"/>')),
    _wheel("left_wheel", "continuous", "0 0.1"),
    _wheel("right_wheel", "continuous", "0 -0.1"),
    _wheel("caster", "fixed", "-0.15 0"),
)
GOOD = BAD.replace('xyz="0.1 0 0"', 'xyz="-0.05 0 0"')

#: In m: a smaller distance is rounding, or a robot on the edge of its feet.
_TOLERANCE = 1e-3


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="move wheels, casters or heavy parts until it stands (urdfkit statics)",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    if context.is_part or not context.tree.is_sound or _is_serial(context.tree):
        return
    if is_carried_by_rotors(context.model):
        return
    stability = context.stability_on_primitives
    if not _falls(context, stability):
        return
    meshes = collision_meshes(context.model)
    if meshes:  # a mesh may extend as low
        try:
            if any(context.meshes.mesh(shape) is None for shape in meshes):
                return
            stability = stand(context)
        except ImportError as error:
            from urdfkit.robot.bounding_box import without_meshes

            raise Unavailable(without_meshes()) from error
    if stability is None or not _falls(context, stability):
        return
    links = context.model.links_by_name
    heaviest = max(context.model.links, key=lambda link: link.mass)
    yield Finding(
        heaviest.inertial.at if heaviest.inertial else heaviest.at,
        f"the robot falls {stability.tip_direction}: its centre of mass is "
        f"{-stability.margin:.3g} m outside of what it stands on, {', '.join(stability.links)}",
        related=tuple(Related(links[name].at.span, f"link '{name}'") for name in stability.links),
    )


def _is_serial(tree: KinematicTree) -> bool:
    """True for a chain of links, which is bolted down."""
    return all(len(joints) < 2 for joints in tree.children.values())


def _falls(context: Context, stability: Stability | None) -> bool:
    """True if the robot stands on several links, at least one moved by a joint, and falls."""
    return (
        stability is not None
        and stability.margin <= -_TOLERANCE
        and len(stability.links) > 1
        and is_freestanding(context.tree, stability.links)
    )
