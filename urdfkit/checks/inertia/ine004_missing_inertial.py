"""A link that a joint moves has no mass.

RViz and MoveIt do not use masses. MuJoCo computes the mass of a link without `<inertial>` from its
collisions, at 1000 kg/m³, and rejects the robot if it has no collisions. PyBullet gives every link
without `<inertial>` 1 kg, a frame at the tip of an arm as well. Gazebo drops links:

- Gazebo drops a moving link with all its children if neither the link nor the links fixed to it
  have a mass, in older versions without an error; controllers then do not find their joints. Add an
  `<inertial>`. A frame with a fixed joint needs none: Gazebo merges it into its parent. A root
  without mass, such as `world`, is fine if a fixed joint connects it to the robot.
- sdformat up to 9.10.0 and 12.7.1 treats a mass of up to 1e-6 kg as none. Use a gram.
- In the same versions, a link without mass that is fixed to another link loses the children that
  moving joints connect to it: the wheel on a bracket, the arm on a mounting plate. Make the joint a
  child of the parent, with both origins combined, or give the link a mass of a gram.
- Of two links with a fixed joint whose `<inertial>` have a total mass of 0, Gazebo cannot compute
  a centre of mass, and rejects the robot. Remove the `<inertial>` of the frame.
- If no link has a mass, Gazebo rejects the robot. Many arms are published without masses, for RViz
  and MoveIt.
- One link has no `<inertial>` and its left or right counterpart has one, the only such pair: it was
  forgotten, also where a link that is fixed to it has a mass.

An error for Gazebo and MuJoCo, a warning for such a pair, for PyBullet, or if MuJoCo computes a
mass or only older Gazebo drops links, otherwise an info.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    MuJoCo, inertiafromgeom: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler-inertiafromgeom
    PyBullet, UrdfParser.cpp: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/UrdfParser.cpp
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
    gazebosim/gz-sim#2815: https://github.com/gazebosim/gz-sim/issues/2815
"""

from urdfkit.core.words import few, listed
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.link import Link
from urdfkit.robot.rigid_bodies import KEEPING_TAGS, NO_MASS, RigidBody
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.robot.symmetry import pairs
from urdfkit.ros.gazebo.conversion import OLD, SdfConversion
from urdfkit.ros.targets import GAZEBO, TargetFacts

BAD = robot_xml(
    link_xml("base", inertial_xml("2", "0.02 0.02 0.02")),
    link_xml("wheel", collision_xml('<sphere radius="0.1"/>')),
    joint_xml("continuous", name="axle", child="wheel"),
)
GOOD = BAD.replace("<collision>", f"{inertial_xml('0.5', '0.002 0.002 0.002')}<collision>")

#: Number of children that a message lists.
_MAX_NAMED = 4

#: Targets whose sdformat drops tiny masses.
_OLD_GAZEBO = ("classic-ros1", "classic-ros2", "gz-fortress")

#: Help for a link with an <inertial> whose mass is 0.
_HELP_OF_ZERO = "write its mass in kg, or give it a fixed joint if it is only a frame"


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="give it an <inertial>, or a fixed joint if it is only a frame",
    by_target=dict.fromkeys(GAZEBO, Severity.ERROR),
    reports_missing=True,
)
def check(context: Context) -> Findings:
    strict = [
        target
        for target in context.given_facts
        if target.rejects_massless or target.density or target.default_mass
    ]
    if strict and not context.is_part and not context.mujoco.least_mass:
        for target in strict:
            yield from _in_target(context, target)
    if not strict or len(strict) < len(context.given_targets):
        yield from _in_gazebo(context)
    yield from _unlike_counterpart(context)


def _unlike_counterpart(context: Context) -> Findings:
    """The only link without an inertial whose counterpart has one."""
    links = context.model.links_by_name
    unlike = []
    for names in pairs(links):
        one, other = sorted((links[name] for name in names), key=lambda link: link.mass)
        if one.inertial is None and one.bodies and other.mass > 0:
            unlike.append((one, other))
    if len(unlike) == 1:
        link, other = unlike[0]
        if not any(body.top is link and body.mass <= 0 for body in context.masses.bodies):
            yield Finding(
                link.at,
                f"link '{link.name}' has no <inertial>, and its counterpart '{other.name}' has "
                f"{other.mass:g} kg",
                "copy the <inertial>, with the signs of the mirror image",
                severity=Severity.WARNING,
                related=(Related((other.inertial or other).at.span, "counterpart"),),
            )


def _in_gazebo(context: Context) -> Findings:
    if context.masses.total == 0 and not any(map(_has_unread_mass, context.model.links)):
        yield from _without_any_mass(context)
    elif not context.is_part:  # the robot that includes a part may define the mass
        yield from _without_mass(context)
    yield from _of_tiny_mass(context)
    yield from _on_massless_frames(context)
    yield from _without_center(context)


def _in_target(context: Context, target: TargetFacts) -> Findings:
    """Moving links without mass, or with a mass that the target computes."""
    for body in context.masses.bodies:
        if body.joint is None:
            continue
        if target.default_mass:
            yield from _of_default_mass(body, target)
            continue
        moved = f"moved by the {body.joint.kind} joint '{body.joint.name}'"
        computed = [link for link, _ in body.links if link.inertial is None and link.collisions]
        inertial = body.top.inertial
        if computed and target.density:
            yield Finding(
                computed[0].at,
                f"link '{computed[0].name}' is {moved} and has no <inertial>: {target.title} "
                f"computes its mass from its collisions, at {target.density:g} kg/m³",
                severity=Severity.WARNING,
                group_key=f"computed by {target.name}",
            )
        elif (
            target.rejects_massless
            and body.mass <= 0
            and not (inertial and inertial.mass and context.masses.total > 0)
        ):
            yield Finding(
                body.top.at,
                f"link '{body.top.name}' is {moved} and has no mass: {target.title} rejects the "
                "robot",
                severity=Severity.ERROR,
                targets=(target.name,),
                group_key=f"rejected by {target.name}",
            )


def _of_default_mass(body: RigidBody, target: TargetFacts) -> Findings:
    """Links that add a mass of the target to a moving body."""
    for link, _ in body.links:
        if link.inertial is None:
            yield Finding(
                link.at,
                f"link '{link.name}' has no <inertial>: {target.title} gives it "
                f"{target.default_mass:g} kg",
                "give it an <inertial>; a gram is enough for a frame",
                severity=Severity.WARNING,
                targets=(target.name,),
                group_key=f"default mass of {target.name}",
            )


def _without_any_mass(context: Context) -> Findings:
    links = context.model.links
    if links and not context.is_part:
        count = f"none of the {len(links)} links has a mass"
        gazebo = context.targets.among(GAZEBO)
        yield Finding(
            context.model.root,
            "the link has no mass" if len(links) == 1 else count,
            "for a simulation, give every moving link an <inertial>",
            severity=Severity.ERROR if gazebo else Severity.INFO,
            targets=gazebo,
        )


def _without_mass(context: Context) -> Findings:
    if context.masses.total < 0:
        return
    for body in context.gazebo.massless:
        if any(_has_unread_mass(link) for link, _ in body.links):
            continue  # URD003, URD005
        zero = body.top.inertial is not None and body.top.inertial.mass is not None
        reported = body.joint is not None and zero  # INE001
        if not reported and (body.joint or context.targets.any_of(GAZEBO)):
            finding = _finding(body, context)
            if finding and body.joint and body.joint.kind == "fixed":
                yield finding._replace(help=_help_of_fixed(context, body.joint.name))
            elif finding:
                yield finding._replace(help=_HELP_OF_ZERO) if zero else finding


def _has_unread_mass(link: Link) -> bool:
    """True for a mass that is not a number, such as ``1.1*0.3`` in a URDF, or not an attribute."""
    if link.inertial is None or link.inertial.mass is not None:
        return False
    mass = link.inertial.at.child("mass")
    return mass is not None and bool((mass.get("value") or mass.text).strip())


def _help_of_fixed(context: Context, joint: str) -> str:
    """Help for a link whose joint is fixed already; a tag may keep Gazebo from merging it."""
    blocks = [block for block in context.model.gazebo if block.get("reference") == joint]
    kept = [tag for tag in KEEPING_TAGS for block in blocks if block.child(tag)]
    return "give it an <inertial>" + (f", or remove <{kept[0]}> of the joint" if kept else "")


def _finding(body: RigidBody, context: Context) -> Finding | None:
    """The finding; None if only frames without shape and mass are dropped."""
    name, links = body.top.name, context.model.links_by_name
    dropped = context.tree.below(name)
    if not any(links[n].visuals or links[n].collisions or links[n].mass for n in dropped):
        return None
    children = [f"'{n}'" for n in dropped if n not in body.names]
    others = ""
    if children:
        named = few(children, _MAX_NAMED - 1) if len(children) > _MAX_NAMED else listed(children)
        others = f" and its children {named}"
    by = "the root"
    if body.joint:  # a fixed joint connects it to the world
        verb = "held" if body.joint.kind == "fixed" else "moved"
        by = f"{verb} by the {body.joint.kind} joint '{body.joint.name}'"
    message = f"link '{name}' is {by} and has no mass: Gazebo drops it{others}"
    return Finding(body.top.at, message)


def _of_tiny_mass(context: Context) -> Findings:
    old = context.targets.among(_OLD_GAZEBO)
    for body in context.masses.bodies:
        if body.joint is None or not 0 < body.mass <= NO_MASS:
            continue
        link = body.top
        mass = link.inertial.mass if link.inertial else None
        yield Finding(
            mass or link.at,
            f"link '{link.name}' of {body.mass:.3g} kg is moved by the {body.joint.kind} joint "
            f"'{body.joint.name}': older Gazebo drops links of up to {NO_MASS:g} kg",
            "give it a gram, or make its joint fixed",
            severity=Severity.WARNING if old else Severity.INFO,
            targets=old,
        )


def _on_massless_frames(context: Context) -> Findings:
    old = context.targets.among(_OLD_GAZEBO)
    for body in SdfConversion(context.tree, OLD).stranded:
        joint = body.joint
        assert joint is not None
        yield Finding(
            joint.at,
            f"joint '{joint.name}' is a child of link '{joint.parent_name}', which has no mass "
            f"and is fixed to another link: older Gazebo drops '{body.top.name}' and its children",
            "make the joint a child of the parent, or give the link a mass of a gram",
            severity=Severity.WARNING if old else Severity.INFO,
            targets=old,
        )


def _without_center(context: Context) -> Findings:
    for joint in context.gazebo.undefined_centers():
        link = context.model.links_by_name[joint.child_name]
        yield Finding(
            (link.inertial or link).at,
            f"links '{link.name}' and '{joint.parent_name}' with the fixed joint '{joint.name}' "
            "have a total mass of 0: Gazebo rejects the robot",
            "remove <inertial>, or add a mass",
            group_key="total mass of 0",
        )
