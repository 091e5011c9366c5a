"""A launch file passes an argument that a file does not have, or omits a required one.

- The xacro or the included launch file does not have the argument (warning): xacro and ROS 2
  silently use the defaults, so that the robot lacks a camera or uses the simulator's hardware;
  `roslaunch` stops with "unused args".
- An argument of an included launch file has no default, and is not passed. `roslaunch` stops with
  "requires the 'x' arg to be set", `ros2 launch` with "missing required argument".

Sources:
    xacro: https://wiki.ros.org/xacro
    roslaunch, loader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/loader.py
    roslaunch, xmlloader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/xmlloader.py
    launch, include_launch_description.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/include_launch_description.py
"""

import os
from itertools import chain

from urdfkit.core.suggest import Suggester, did_you_mean
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

NAME = "robot.launch"
BAD = (
    '<launch><param name="robot_description" command="xacro $(dirname)/arm.xacro camera:=false"/>'
    "</launch>"
)
GOOD = BAD.replace("camera:", "with_camera:")
FILES = {
    "arm.xacro": xacro_xml(
        '<xacro:arg name="with_camera" default="true"/>',
        '<link name="base"/>',
        '<xacro:if value="$(arg with_camera)"><gazebo/></xacro:if>',
    ).encode()
}

#: Most arguments that the help lists.
_MAX_LISTED = 8


@rule(Severity.WARNING, needs=(Need.LAUNCH,), help="pass an argument that the file has")
def check(context: Context) -> Findings:
    for finding in reported(context, "LAU005"):
        _, _, argument = finding.message.partition("': ")
        yield finding._replace(group_key=argument)
    for description, robot in chain(context.described_robots, context.configured_robots):
        xacro = robot.reading.xacro
        if xacro is None:
            continue
        # An argument that the xacro uses but does not declare must be passed.
        known = xacro.usage.arguments.union(xacro.defaults)
        call = description.frame.call.span
        # A launch file for several robots passes arguments that only some of them have.
        is_for_any = os.path.basename(description.path).encode() not in call.source.data
        unused = known.difference(description.arguments)
        unknown = [name for name in description.arguments if name not in known]
        help = f"pass one of: {few(sorted(known), _MAX_LISTED)}" if known else "remove the argument"
        for number, name in enumerate(unknown):
            hint = did_you_mean(name, unused) if number < Suggester.MAX_WORDS else ""
            yield Finding(
                Location(call, description.frame.outer),
                f"'{description.path}': unknown argument '{name}'{hint}",
                help,
                group_key=description.path,
                severity=Severity.INFO if is_for_any else None,
            )
