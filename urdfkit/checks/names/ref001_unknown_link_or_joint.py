"""A joint refers to a link, or a `<mimic>` to a joint, that is not in the model.

Without the link the tree is incomplete: urdfdom (RViz, MoveIt, Gazebo, Pinocchio), MuJoCo, Drake
and PyBullet reject the robot. The name is misspelt, a prefix is missing, or the macro that creates
the link was not called. `world` requires a `<link name="world"/>` like every other link, except for
Drake, which adds that link itself. In a xacro that has no base of its own, such as a sensor for any
robot, a missing parent is a warning.

urdfdom does not check the joint of a `<mimic>`: Drake rejects the robot, MoveIt drops the coupling,
joint_state_publisher stops with an exception. MuJoCo, Pinocchio, Newton, PyBullet and yourdfpy load
the robot without the coupling: a warning if they are the only targets.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    joint_state_publisher.py: https://github.com/ros/joint_state_publisher/blob/ros2/joint_state_publisher/joint_state_publisher/joint_state_publisher.py
"""

from urdfkit.core.suggest import Suggester, hint_for
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.lint.switched_off import is_switched_off, uncalled_macro
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value, from_macro, insert_before
from urdfkit.text.grammar import is_expression

BAD = robot_xml(
    link_xml("base_link"),
    link_xml("lid"),
    joint_xml("fixed", name="hinge", parent="base_lnk", child="lid"),
)
FIXED = GOOD = BAD.replace("base_lnk", "base_link")

_INCLUDE = "add the link, or include the file in the robot that has it"

#: Least similarity of a joint that cannot lead, or follows another one.
_OF_OTHERS = 0.9


@rule(Severity.ERROR, reports_missing=True, depends_on_arguments=True)
def check(context: Context) -> Findings:
    yield from _links(context)
    yield from _leaders(context)


def _links(context: Context) -> Findings:
    known = context.model.links_by_name
    children = {joint.child_name for joint in context.model.joints}
    is_fragment = context.source.path.endswith(".xacro") and not context.tree.has_base
    # A child must not get a second parent.
    suggesters = {"parent": Suggester(known), "child": Suggester(known.keys() - children)}
    for joint in context.model.joints:
        for role in ("parent", "child"):
            element = joint.at.child(role)
            link = element.attributes.get("link") if element else None
            if link is None or link.value in known or is_expression(link.value):
                continue
            if link.value == "world" and context.targets.all_are("adds_world"):
                continue
            if context.is_part:  # the file that includes this part defines the link
                return
            is_awaited = role == "parent" and is_fragment
            suggested = suggesters[role].suggested(link.value)
            if suggested in _ends(joint):
                suggested = ""
            hint = hint_for(suggested)
            yield Finding(
                link,
                f"joint '{joint.name}': {role} link '{link.value}' is not in the model{hint}",
                _help(context, link.value, is_awaited),
                _corrected(context, link, known.get(suggested))
                or _added_world(joint, link, context),
                severity=Severity.WARNING if is_awaited else None,
            )


def _help(context: Context, name: str, is_awaited: bool) -> str:
    if not is_awaited:
        return "correct the name, or add the link"
    if macro := uncalled_macro(context, name):
        return f"call macro '{macro}', which defines the link"
    if is_switched_off(context, name):
        return "pass the argument that adds the link"
    return _INCLUDE


def _leaders(context: Context) -> Findings:
    known = context.model.joints_by_name
    # What another joint follows moves by itself.
    leading = (joint for joint in known.values() if joint.kind != "fixed" and joint.mimic is None)
    suggesters = Suggester([joint.name for joint in leading]), Suggester(known, _OF_OTHERS)
    is_ignored = context.targets.all_are("ignores_unknown_leaders")
    severity = Severity.WARNING if is_ignored else None
    for joint in context.model.joints:
        leader = joint.mimic.at.attributes.get("joint") if joint.mimic else None
        if leader is None or leader.value in known or is_expression(leader.value):
            continue
        found = (suggester.suggested(leader.value) for suggester in suggesters)
        suggested = next(filter(None, found), "")
        hint = hint_for(suggested)
        message = f"joint '{joint.name}' mimics '{leader.value}', which is not in the model{hint}"
        help = "correct the name, or add the joint"
        correction = _corrected(context, leader, known.get(suggested))
        yield Finding(leader, message, help, correction, severity=severity)


def _ends(joint: Joint) -> list[str]:
    """The names of the parent and child link of a joint."""
    return [end.value for end in (joint.parent, joint.child) if end]


def _corrected(context: Context, name: Attribute, suggested: Link | Joint | None) -> Fix | None:
    """Corrects a reference, or the suggested definition if that is misspelt."""
    if suggested is None:
        return None
    from urdfkit.lint.misspelt_names import corrected_definition  # for few robots

    return corrected_definition(context, suggested, name.value) or fix_value(name, suggested.name)


def _added_world(joint: Joint, link: Attribute, context: Context) -> Fix | None:
    """Adds the world, unless another link is the root already."""
    children = {joint.child_name for joint in context.model.joints}
    has_root = any(link.name not in children for link in context.model.links)
    if link.value != "world" or from_macro(joint.at) or has_root:
        return None
    return Fix('add <link name="world"/>', insert_before(joint.at, ('<link name="world"/>',)))
