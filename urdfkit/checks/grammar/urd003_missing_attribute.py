"""An element lacks a required attribute, or a link or joint has an empty name.

If an attribute is missing in a joint or in `<robot>`, urdfdom (RViz, MoveIt, Gazebo, Pinocchio)
rejects the robot. In a link, urdfdom logs one line and drops every visual and collision of that
link. A `<dynamics>` needs at least one of its two attributes. Values in elements or as text,
`<box><size>1 1 1</size></box>` or `<parent>base</parent>`, are SDF: in URDF they are attributes.
The name of the robot is optional only in a xacro file that others include (a warning if a file
of another package may include it: it is not called `.urdf.xacro`, and no launch file names it).

urdfdom reads an empty name, but TF ignores such a frame, Drake rejects the link and PyBullet
crashes. In a xacro an empty name is usually a prefix with nothing after it.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

import os
import re

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.samples import link_xml, visual_xml
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import first_attribute, rename_attribute
from urdfkit.text.grammar import owner

BAD = link_xml("wheel", visual_xml('<cylinder radus="0.1" length="0.05"/>'))
FIXED = GOOD = BAD.replace("radus", "radius")


@rule(Severity.ERROR, help="add the attribute")
def check(context: Context) -> Findings:
    for element, attribute, missing, suggested in context.deviations.get("URD003", ()):
        message = f"{owner(element)}: <{element.tag}> has no '{missing}'"
        if attribute is None and element.parent is None:
            if not context.is_part:
                yield _nameless(context, element)
            continue
        if attribute is not None and not suggested:
            yield Finding(attribute, f"a {element.tag} has an empty name", "give it a name")
            continue
        if attribute is None:
            is_material = element.tag == "material"
            is_unneeded = is_material and context.targets.all_are("reads_unnamed_materials")
            severity = Severity.WARNING if is_unneeded else None
            key = f"{missing} of {element.tag}"
            help = _as_attribute(element, missing)
            yield Finding(element, message, help, group_key=key, severity=severity)
            continue
        edits = rename_attribute(attribute, suggested)
        yield Finding(
            attribute,
            f"{message}, but an unknown attribute '{attribute.name}'",
            f"rename {attribute.name} to {suggested}",
            Fix.of(f"rename {attribute.name} to {suggested}", edits),
            is_about_name=True,
        )


def _nameless(context: Context, robot: Element) -> Finding:
    message, help, severity = "<robot> has no name", 'write <robot name="...">', None
    if _may_be_part(context):
        message += ", which is right only if a file of another package includes this one"
        severity = Severity.WARNING
    return Finding(robot, message, help, _named_for_file(robot), severity=severity)


def _may_be_part(context: Context) -> bool:
    """True for a xacro that is not named like a robot, and that no launch file names."""
    from urdfkit.workspace.launch_files import launch_files

    name = os.path.basename(context.source.path)
    if not name.endswith(".xacro") or name.endswith(".urdf.xacro"):
        return False
    workspace = context.resolver.packages.workspace(context.source.path)
    return not any(launch_files(workspace, name, context.resolver))


def _as_attribute(element: Element, missing: str) -> str:
    """Help for a value in the element, as in SDF; empty if there is none."""
    child = element.child(missing)
    value = (child.text if child is not None else element.text).strip()
    if missing == "rgba" and len(value.split()) == 3:
        value += " 1"  # SDF has colours without alpha
    return f'write <{element.tag} {missing}="{value[:40]}"/>, an attribute' if value else ""


def _named_for_file(element: Element) -> Fix | None:
    """The name of the file without its suffixes, if that is a valid name."""
    name = os.path.basename(element.tag_at.source.path).partition(".")[0]
    if not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        return None
    return Fix(f'write name="{name}"', first_attribute(element, "name", name))
