"""A plugin looks for a link or joint that Gazebo leaves out.

A link without mass that no fixed joint merges into another one is not simulated, and neither is
anything that hangs on it. A plugin that looks for such a link, or for a joint above or below it,
does not find it. Give the link an `<inertial>`.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.gazebo.plugins import conversion_result
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="wheel"/>
<joint name="wheel_joint" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
  <axis xyz="0 1 0"/>
</joint>
<gazebo>
  <plugin name="states" filename="libgazebo_ros_joint_state_publisher.so">
    <jointName>wheel_joint</jointName>
  </plugin>
</gazebo>"""
GOOD = BAD.replace(
    '<link name="wheel"/>',
    """\
<link name="wheel">
  <inertial>
    <mass value="0.2"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial>
</link>""",
)


@rule("GAZ023", "names-dropped-link", Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Iterator[Finding]:
    conversion, model = subject.gazebo, subject.model
    for use in subject.plugins:
        for reference in use.references():
            if conversion_result(conversion, reference.kind, reference.name) != "dropped":
                continue
            if subject.is_part:
                return
            link = reference.name
            if reference.kind == "joint":
                child = model.joints_by_name[reference.name].child
                link = child.value if child else link
            yield Finding(
                reference.item.at,
                f"{use.title} looks for {reference.kind} '{reference.name}', which Gazebo leaves "
                f"out (link '{link}': {conversion.dropped[link]}){use.outcome}",
                f"give link '{link}' an <inertial> with its mass",
                alike=conversion.dropped[link],
            )
