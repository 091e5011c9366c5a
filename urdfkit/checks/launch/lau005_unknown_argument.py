"""A launch file passes an argument that the xacro does not have.

xacro takes it without a word and uses its default instead: the robot comes up without the camera,
or with the hardware of the simulator. The name differs, or the xacro has lost the argument.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "robot.launch"
BAD = (
    '<launch><param name="robot_description" command="xacro $(dirname)/arm.xacro camera:=false"/>'
    "</launch>"
)
GOOD = BAD.replace("camera:", "with_camera:")
FILES = {
    "arm.xacro": b"""\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="with_camera" default="true"/>
  <link name="base"/>
  <xacro:if value="$(arg with_camera)">
    <link name="camera"/>
    <joint name="mount" type="fixed">
      <parent link="base"/>
      <child link="camera"/>
    </joint>
  </xacro:if>
</robot>
""",
}


@rule("LAU005", "unknown-argument", Severity.WARNING, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    for description in subject.launch.descriptions:
        if not description.arguments:
            continue
        xacro = subject.beside(description.path, description.arguments).reading.xacro
        if xacro is None or xacro.document is None:
            continue  # LAU004
        known = {argument.name for argument in xacro.arguments}
        for name in description.arguments:
            if name not in known:
                yield Finding(
                    Location(description.frame.call.span, description.frame.outer),
                    f"'{description.path}' has no argument '{name}'{did_you_mean(name, known)}",
                    "pass one of: " + ", ".join(sorted(known)) if known else "pass none",
                )
