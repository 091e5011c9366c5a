"""A launch file cannot be read.

`roslaunch` and `ros2 launch` stop before anything starts: the XML is not well formed, the root is
not `<launch>`, or the Python of a ROS 2 launch file has a syntax error. An info for files of other
programs with the same suffix (Eclipse), standalone scripts, parameter files, and templates.

Sources:
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
"""

import os

from urdfkit.lint.rules import Context, Findings, Need, Severity, reported, rule

NAME = "robot.launch"
BAD = "<launch><node></launch>"
GOOD = "<launch/>"


@rule(Severity.ERROR, needs=(Need.LAUNCH,), help="fix the file; the parser stopped here")
def check(context: Context) -> Findings:
    is_template = "template" in os.path.basename(context.source.path).lower()
    for finding in reported(context, "LAU001"):
        yield finding._replace(severity=Severity.INFO) if is_template else finding
