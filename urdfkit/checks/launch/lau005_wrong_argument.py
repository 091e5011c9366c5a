"""A launch file passes an argument that a file does not have, or leaves out a required one.

- An argument that the xacro or the included launch file does not have (warning): xacro uses its
  default, so the robot has no camera, or the hardware of the simulator. `roslaunch` stops with
  "unused args"; in ROS 2 the included file goes on with its default. The name differs, or the
  argument was removed.
- An included launch file has an argument without a default, and none is passed. `roslaunch` stops
  with "requires the 'x' arg to be set", `ros2 launch` with "missing required argument".

Sources:
    xacro: https://wiki.ros.org/xacro
    roslaunch, loader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/loader.py
    roslaunch, xmlloader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/xmlloader.py
    launch, include_launch_description.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/include_launch_description.py
"""

import os

from urdfkit.core.suggest import did_you_mean
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


@rule(Severity.WARNING, needs=(Need.LAUNCH,), help="pass an argument that the file has")
def check(context: Context) -> Findings:
    for finding in reported(context, "LAU005"):
        _, _, argument = finding.message.partition("': ")
        yield finding._replace(group_key=argument)
    for description, robot in context.described_robots:  # for the others LAU004
        xacro = robot.reading.xacro
        if xacro is None:
            continue
        # One that the xacro uses and does not declare must be passed.
        known = xacro.usage.arguments.union(xacro.defaults)
        call = description.frame.call.span
        # A launch file for any robot passes what some of them have.
        is_for_any = os.path.basename(description.path).encode() not in call.source.data
        unused = known.difference(description.arguments)
        for name in description.arguments:
            if name not in known:
                yield Finding(
                    Location(call, description.frame.outer),
                    f"'{description.path}': unknown argument '{name}'{did_you_mean(name, unused)}",
                    "pass one of: " + ", ".join(sorted(known)) if known else "remove the argument",
                    severity=Severity.INFO if is_for_any else None,
                )
