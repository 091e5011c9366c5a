"""A launch file cannot be read.

`roslaunch` and `ros2 launch` stop before anything starts: the XML is not well formed, the root is
not `<launch>`, or the Python of a ROS 2 launch file has a syntax error. A file of another program,
as Eclipse writes them with the same suffix, a script that is run by itself, a parameter file, or
a template, by its name, is an info.

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
    for found in reported(context, "LAU001"):
        yield found._replace(severity=Severity.INFO) if is_template else found
