"""The value of a plugin's tag is not of the type that the plugin reads.

Where a number is wanted, text reads as 0 or as the default, and a decimal comma ends the number.
Where a boolean is wanted, only `true` and `1` are true: `yes` and `on` read as false. Where one of
a few words is wanted, any other is passed over or refused.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 1: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
"""

from __future__ import annotations

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.robot.model import number
from urdfkit.ros.catalog.plugins import Parameter
from urdfkit.ros.gazebo.values import leading
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_planar_move.so">
    <odometryRate>20 Hz</odometryRate>
    <cmdTimeout>0,5</cmdTimeout>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("0,5", "0.5")

#: A quaternion is written as roll, pitch and yaw: so gz-math reads it from a stream.
_LENGTHS = {"vector2": 2, "vector3": 3, "quaternion": 3, "pose": 6}
#: Words that other programs take for a boolean; what is meant by them is plain.
_TRUE, _FALSE = ("true", "1"), ("false", "0", "no", "off")


@rule(Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Findings:
    for use in subject.plugins:
        parameters = use.plugin.parameters if use.plugin else {}
        for item in use.items:
            parameter = parameters.get(item.path)
            if parameter is None or (found := _wrong(parameter, item.text)) is None:
                continue
            reads, remedy = found
            shown = f"'{item.text}'" if item.text else "empty"
            message = f"{use.title}: <{item.path}> is {shown}, {reads}"
            yield Finding(item.at, message, remedy)


def _wrong(parameter: Parameter, text: str) -> tuple[str, str] | None:
    """What is read instead, and what to write."""
    if parameter.type in ("float", "int"):
        read, rest = leading(text)
        if not read:
            return "and no number", "write a number"
        if rest:
            right = text.replace(",", ".")
            help = f"write {right}" if number(right) is not None else "write the number alone"
            return f"which reads as {read}", help
    elif parameter.words and parameter.type == "string" and text not in parameter.words:
        suggested = did_you_mean(text, parameter.words)
        return f"and must be {' or '.join(parameter.words)}{suggested}", "write one of these words"
    elif parameter.name == "ros/remapping" and ":=" not in text:
        return "and renames nothing", "write FROM:=TO, such as cmd_vel:=robot/cmd_vel"
    elif parameter.type == "bool" and text.lower() not in (*_TRUE, *_FALSE):
        return "which reads as false", "write true or false"
    elif length := _LENGTHS.get(parameter.type):
        read_parts = [leading(part)[0] for part in text.split()]
        if len(read_parts) < length or "" in read_parts:
            return f"not {length} numbers", f"write {length} numbers with spaces between them"
    return None
