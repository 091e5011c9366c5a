"""A link has no collision, no visual, or neither.

- A visual without collision: in Gazebo it passes through the floor and other objects, and a lidar
  simulated on the CPU does not detect it; MoveIt plans through it. This is right for a label, a
  marker or the glass of a lens. Otherwise add a `<collision>` with a simple shape. A warning for
  MoveIt, and for a caster or wheel without which a wheeled robot does not stand.
- A collision without visual: RViz and Gazebo show nothing where the robot collides. This is right
  for a bumper zone or a sphere that replaces a caster. Otherwise copy the shape to a `<visual>`.
- A link with mass, but without visual and collision, at the end of a moving chain, while other
  links have collisions: forces act on it, and nothing can touch it.
- A robot without any shape: RViz shows frames only. This is right for a purely kinematic model;
  otherwise the shapes were lost, for example in an include that an argument disabled.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import RigidBody, rigid_bodies
from urdfkit.robot.rotors import is_carried_by_rotors
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml, robot_xml, visual_xml
from urdfkit.robot.stability import Stability, collision_meshes, is_freestanding, stand

_BOX = '<box size="0.4 0.3 0.1"/>'
BAD = robot_xml(
    link_xml("base", visual_xml(_BOX), collision_xml(_BOX)),
    link_xml("arm", visual_xml('<cylinder radius="0.02" length="0.5"/>')),
    joint_xml("fixed"),
)
GOOD = link_xml("base", visual_xml(_BOX), collision_xml(_BOX))

#: In kg: a smaller mass is a placeholder that a simulator requires.
_MIN_MASS = 1e-3
#: Pattern of the file names of plugins that give the whole robot a velocity.
_SLIDE = ("planar_move", "velocity-control")


@rule(
    Severity.INFO,
    help="add a <collision> with a simple shape if the link can collide",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    links = context.model.links
    if any(link.visuals or link.collisions for link in links):
        yield from _without_collision(context)
        yield from _without_visual(context)
        yield from _without_both(context)
    elif not context.is_part:
        message = "the link has neither visual nor collision"
        if len(links) > 1:
            message = f"none of the {len(links)} links has a visual or a collision"
        help = "give the links visuals and collisions"
        yield Finding(context.model.root, message, help, severity=Severity.INFO)


def _without_collision(context: Context) -> Findings:
    links = [link for link in context.model.links if link.visuals]
    if len(links) > 1 and not any(link.collisions for link in context.model.links):
        message = f"none of the {len(links)} links with a visual has a collision"
        yield Finding(context.model.root, message)
        return
    bare = [link for link in links if not link.collisions]
    needed = _needed(context) if bare else ()
    for link in bare:
        supports = link.name in needed
        yield Finding(
            link.visuals[0].at,
            f"link '{link.name}' has a visual and no collision"
            + ("; without it the robot does not stand" if supports else ""),
            help="add a <collision> with the shape that touches the ground" if supports else "",
            severity=Severity.WARNING if supports else None,
        )


def _without_visual(context: Context) -> Findings:
    for link in context.model.links:
        if link.collisions and not link.visuals:
            message = f"link '{link.name}' has a collision and no visual"
            help = "add a <visual> if the link should be visible"
            yield Finding(link.collisions[0].at, message, help, severity=Severity.INFO)


def _without_both(context: Context) -> Findings:
    if not any(link.collisions for link in context.model.links) or context.is_part:
        return
    for body in rigid_bodies(context.tree):
        if body.joint and body.mass > _MIN_MASS and _is_bare_end(body, context):
            yield Finding(
                body.top.at,
                f"link '{body.top.name}' of {body.mass:g} kg moves and has neither visual nor "
                "collision",
                "add <visual> and <collision>, if the part exists",
                severity=Severity.INFO,
            )


def _is_bare_end(body: RigidBody, context: Context) -> bool:
    links = [link for link, _ in body.links]
    children = sum(len(context.tree.children[link.name]) for link in links)
    return children == len(links) - 1 and not any(link.visuals or link.collisions for link in links)


def _needed(context: Context) -> tuple[str, ...]:
    """Links on whose visuals a wheeled robot stands, if it falls over on its collisions.

    Empty if its meshes cannot be read.
    """
    wheeled = any(joint.kind == "continuous" for joint in context.model.joints)
    if not wheeled or context.is_part or not context.tree.is_sound:
        return ()
    if is_carried_by_rotors(context.model) or _slides(context.model):
        return ()
    links = context.model.links_by_name
    try:
        on_visuals = stand(context, visuals=True)
        if (
            on_visuals is None
            or on_visuals.tips
            or any(name.endswith("base_footprint") for name in on_visuals.links)  # a mark
            or not is_freestanding(context.tree, on_visuals.links)
        ):
            return ()
        touching = [name for name in on_visuals.links if links[name].collisions]
        on_collisions = stand(context, contacts=touching)
        if _is_stable(on_collisions):
            return ()
        # A collision mesh that cannot be read may reach the ground.
        meshes = map(context.meshes.mesh, collision_meshes(context.model))
        return () if any(mesh is None for mesh in meshes) else on_visuals.links
    except ImportError:
        return ()


def _slides(model: RobotModel) -> bool:
    """True if a plugin moves the whole robot over the ground, without turning wheels."""
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    names = (plugin.get("filename") or "" for plugin in plugins)
    return any(word in name for name in names for word in _SLIDE)


def _is_stable(stability: Stability | None) -> bool:
    return stability is not None and not stability.tips
