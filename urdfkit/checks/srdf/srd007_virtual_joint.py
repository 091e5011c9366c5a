"""A virtual joint does not fit the robot.

A virtual joint connects the root of the robot to a frame of the world, and is `fixed`, `planar` or
`floating`. If its type or link is invalid, MoveIt prints a warning and treats the root as fixed:
planning works, but the robot cannot be placed or driven.

Sources:
    SRDF: https://wiki.ros.org/srdf
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.model import Link
from urdfkit.robot.samples import arm_xml
from urdfkit.ros.moveit.samples import named_xml, srdf_files

BAD = named_xml("bad", arm_xml("continuous"))
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(
    '<virtual_joint name="v" type="fixed" parent_frame="world" child_link="arm"/>',
    '<virtual_joint name="v" type="fixed" parent_frame="world" child_link="base"/>',
)


_TYPES = ("fixed", "planar", "floating")


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="attach it to the root link, with type fixed, planar or floating",
)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    roots = {link.name: link for link in context.tree.roots}
    for joint in srdf.virtual_joints:
        name, child, kind = (joint.get(key) for key in ("name", "child_link", "type"))
        if kind is not None and kind not in _TYPES:
            types = ", ".join(_TYPES)
            yield Finding(
                joint, f"virtual joint '{name}' has type '{kind}', which is not one of {types}"
            )
        elif kind == "fixed" and _is_empty(roots.get("world")):
            continue  # robots for Gazebo have this root; MoveIt creates the joint nevertheless
        elif child in context.model.links_by_name and child not in roots:
            message = f"virtual joint '{name}' is attached to '{child}', which is not the root link"
            yield Finding(joint, message)


def _is_empty(link: Link | None) -> bool:
    return link is not None and not link.visuals and not link.collisions
