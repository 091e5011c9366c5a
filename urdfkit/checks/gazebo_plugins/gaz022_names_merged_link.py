"""A plugin looks for a link or joint that Gazebo has merged away.

Gazebo makes one link of all links that fixed joints connect, and only the topmost keeps its name. A
plugin that looks for one of the others, or for the fixed joint, does not find it. Name the link
that is left, or ask for the joint to be kept with `<preserveFixedJoint>true</preserveFixedJoint>`
in a `<gazebo>` block that refers to it; the link then needs a mass of its own.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    ros-simulation/gazebo_ros_pkgs#843: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/843
    gazebosim/gazebo-classic#2732: https://github.com/gazebosim/gazebo-classic/issues/2732
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.catalog.extensions import rewritten
from urdfkit.ros.gazebo.plugins import PluginUse, Reference, conversion_result
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import from_macro, insert_before

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="tool">
  <inertial>
    <mass value="0.1"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial>
</link>
<joint name="tool_joint" type="fixed">
  <parent link="base"/>
  <child link="tool"/>
</joint>
<gazebo>
  <plugin name="hand" filename="libgazebo_ros_hand_of_god.so">
    <linkName>tool</linkName>
  </plugin>
</gazebo>"""
FIXED = BAD.replace(
    "<gazebo>",
    '<gazebo reference="tool_joint">\n  <preserveFixedJoint>true</preserveFixedJoint>\n</gazebo>\n'
    "<gazebo>",
)
GOOD = FIXED

#: Passes over a joint that is not there, and robot_state_publisher needs no state of a fixed one.
_STATES = "gazebo_ros_joint_state_publisher@classic-ros2"


@rule(
    "GAZ022",
    "names-merged-link",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    conversion = subject.gazebo
    for use in subject.plugins:
        for reference in use.references():
            if conversion_result(conversion, reference.kind, reference.name) != "merged":
                continue
            if use.place == "model" and reference.parameter.name in rewritten():
                continue  # the converter writes the survivor there
            if use.plugin and use.plugin.id == _STATES:
                continue
            yield _finding(subject, use, reference)


def _finding(subject: Subject, use: PluginUse, reference: Reference) -> Finding:
    joint = _fixed_joint(subject, reference)
    child = joint.child.value if joint and joint.child else reference.name
    survivor = subject.gazebo.survivor.get(child, "")
    mass = subject.model.links_by_name[child].mass
    help = f"name '{survivor}'" if reference.kind == "link" else "make it a joint that moves"
    if joint is not None and mass > 0:
        help += f", or keep joint '{joint.name}' with <preserveFixedJoint>"
    return Finding(
        reference.item.at,
        f"{use.title} looks for {reference.kind} '{reference.name}', which Gazebo merges into "
        f"link '{survivor}'{use.outcome}",
        help,
        _fix(use, joint) if joint is not None and mass > 0 else None,
        alike=use.filename,
    )


def _fixed_joint(subject: Subject, reference: Reference) -> Joint | None:
    if reference.kind == "joint":
        return subject.model.joints_by_name[reference.name]
    above = subject.tree.parents[reference.name]
    return above[0] if len(above) == 1 else None


def _fix(use: PluginUse, joint: Joint) -> Fix | None:
    if from_macro(use.block):  # the name would be that of one call
        return None
    lines = (
        f'<gazebo reference="{joint.name}">',
        "  <preserveFixedJoint>true</preserveFixedJoint>",
        "</gazebo>",
    )
    return Fix(f"keep joint '{joint.name}' in Gazebo", insert_before(use.block, lines))
