"""An element of the SRDF is misspelt, incomplete or invalid, or the file is not well-formed.

- move_group stops at a file that is not well-formed XML; the other rules for the SRDF cannot run.
  It reads one with hyphens in a comment, which xacro rejects (a warning in ROS 1).
- srdfdom ignores unknown elements and attributes (warning): a group loses its chain, a pair of
  links is checked for collisions again. Only typos of known names are reported, since other
  programs may add their own elements.
- An element without a required attribute, or with text instead of a number, is logged and ignored:
  the group has no chain, the state does not set the joint. A state without a group is a warning:
  Pinocchio, which sets all joints of the robot, reads it; so is a robot without a name, whose
  elements srdfdom reads.
- A virtual joint connects the root of the robot to a frame of the world, and is `fixed`, `planar`
  or `floating`. If its type or link is invalid or missing, MoveIt prints a warning and treats the
  root as fixed: planning works, but the robot cannot be placed or driven (warning).
- The links of an end effector's group must not be in its parent group, and its parent link must be.
  MoveIt loads the robot, but handles the hand as a part of the arm, or attaches it to another group
  with the parent link, or to none (warning). Not for a group without a moving joint, which only
  names the tip of the arm.

Sources:
    SRDF: https://wiki.ros.org/srdf
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    Pinocchio, SRDF: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/srdf.hxx
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Location, Need, Severity, rule
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_grammar import missing_attributes, misspelt_names
from urdfkit.ros.moveit.srdf_reader import unreadable
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import rename_attribute, rename_element

BAD = named_xml("bad", arm_xml("fixed"))
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(
    '<disable_collision link1="base" link2="arm" reason="Adjacent"/>',
    '<disable_collisions link1="base" link2="arm" reason="Adjacent"/>',
)
FIXED_FILES = {"bad.srdf": FILES["good.srdf"].replace(b"good", b"bad", 1)}

_VIRTUAL_TYPES = ("fixed", "planar", "floating")


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), help="fix the XML of the SRDF")
def check(context: Context) -> Findings:
    if not context.is_part:
        for problem in unreadable(context.source.path, context.model.name, context.resolver):
            at = Location(problem.span, problem.frame)
            yield Finding(
                at,
                problem.message,
                problem.help,
                related=problem.related,
                severity=problem.severity,
            )
    if context.srdf is not None:
        yield from _misspelt(context.srdf)
        yield from _incomplete(context.srdf)
        yield from _positions(context.srdf)
        yield from _virtual_joints(context, context.srdf)
        yield from _end_effectors(context.srdf)


def _misspelt(srdf: Srdf) -> Findings:
    for mistake in misspelt_names(srdf.root):
        if isinstance(mistake.at, Element):
            part, edits = f"element <{mistake.name}>", rename_element(mistake.at, mistake.suggested)
        else:
            part = f"attribute '{mistake.name}'"
            edits = rename_attribute(mistake.at, mistake.suggested)
        yield Finding(
            edits[0].span if edits else mistake.at,
            f"unknown {part} in <{mistake.parent.tag}> (ignored); "
            f"did you mean '{mistake.suggested}'?",
            "fix the name",
            Fix.of(f"rename it to {mistake.suggested}", edits),
            severity=Severity.WARNING,
        )


def _incomplete(srdf: Srdf) -> Findings:
    for element, name in missing_attributes(srdf.root):
        if element.tag == "robot":
            reader, severity = "MoveIt logs an error, and reads the rest", Severity.WARNING
        elif element.tag == "virtual_joint":
            reader, severity = "ignored", Severity.WARNING
        elif element.tag == "group_state" and name == "group":
            reader, severity = "MoveIt ignores it", Severity.WARNING
        else:
            reader, severity = "ignored", Severity.ERROR
        message = f"<{element.tag}> has no {name} ({reader})"
        yield Finding(element, message, f"add {name}", severity=severity)


def _positions(srdf: Srdf) -> Findings:
    for state in srdf.states:
        for joint in state.all("joint"):
            value = joint.attributes.get("value")
            if value and any(number(part) is None for part in value.value.split()):
                message = f"state '{state.get('name')}': value '{value.value}' is not a number"
                yield Finding(value, message, "write a number, in rad or m")


def _virtual_joints(context: Context, srdf: Srdf) -> Findings:
    roots = {link.name: link for link in context.tree.roots}
    world = roots.get("world")
    # Robots for Gazebo have this empty root; MoveIt creates the joint nevertheless.
    has_world = world is not None and not world.visuals and not world.collisions
    help = "attach it to the root link, with type fixed, planar or floating"
    for joint in srdf.virtual_joints:
        name, child, kind = (joint.get(key) for key in ("name", "child_link", "type"))
        is_wrong = child in context.model.links_by_name and child not in roots
        if kind is not None and kind not in _VIRTUAL_TYPES:
            reason = f"has type '{kind}', which is not one of {', '.join(_VIRTUAL_TYPES)}"
            yield _warning(joint, f"virtual joint '{name}' {reason}", help)
        elif is_wrong and not (has_world and kind == "fixed"):
            reason = f"is attached to '{child}', which is not the root link"
            yield _warning(joint, f"virtual joint '{name}' {reason}", help)


def _end_effectors(srdf: Srdf) -> Findings:
    help = "use groups without common links, and a parent link in the parent group"
    moving = [joint for joint in srdf.tree.model.joints if joint.kind != "fixed"]
    for effector in srdf.end_effectors:
        name, parent = effector.get("name"), effector.get("parent_group")
        hand = srdf.links_of(effector.get("group") or "")
        if not any(joint.child_name in hand for joint in moving):
            continue  # the group names only the tip of the arm, as moveit_visual_tools needs it
        arm = srdf.links_of(parent) if parent else set()
        shared = sorted(hand & arm)
        if shared:
            links = ", ".join(f"'{link}'" for link in shared)
            message = f"end effector '{name}' and group '{parent}' share {links}"
            yield _warning(effector, message, help)
        link = effector.get("parent_link")
        if link in hand and link not in shared:
            message = f"end effector '{name}' is attached to '{link}', its own link"
            yield _warning(effector, message, help)
        elif arm and link in srdf.known("link") - arm - hand:
            message = f"end effector '{name}' is attached to '{link}', which is not in its parent "
            yield _warning(effector, f"{message}group '{parent}'", help)


def _warning(at: Element, message: str, help: str) -> Finding:
    return Finding(at, message, help, severity=Severity.WARNING)
