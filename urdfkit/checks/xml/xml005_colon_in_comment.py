"""A comment contains a colon and white space, which ROS 2 launch files may read as YAML.

If a launch file passes the output of xacro as a parameter without declaring it as text
(`ParameterValue(..., value_type=str)`), ROS 2 parses it as YAML. A `: ` in a comment then stops the
launch with "mapping values are not allowed here", without naming the comment. The rule checks only
packages built with ament, and in a xacro only the comments that xacro keeps.

Sources:
    launch_ros, evaluate_parameters.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/utilities/evaluate_parameters.py
    ros2/launch_ros#214: https://github.com/ros2/launch_ros/issues/214
    UniversalRobots/Universal_Robots_ROS2_Driver#1103: https://github.com/UniversalRobots/Universal_Robots_ROS2_Driver/issues/1103
"""

import os
import re

from urdfkit.lint.context import Context
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.text.diagnostic import Confidence, Severity
from urdfkit.text.source import Source, Span

FILES = {"package.xml": b"<package><name>a</name><build_type>ament_cmake</build_type></package>"}
BAD = '<robot name="r"><!-- units: metres --><link name="a"/></robot>'
GOOD = '<robot name="r"><!-- units are metres --><link name="a"/></robot>'

_COMMENT = rb"<!--.*?-->"


@rule(
    Severity.INFO,
    needs=(Need.FILES,),
    help="write the comment without the colon, or set value_type=str in the launch file",
)
def check(context: Context) -> Findings:
    xacro = context.reading.xacro
    if not _is_ament(context):
        return
    if xacro is None:
        found = _colon(context.source, _COMMENT)
    elif xacro.document is None or xacro.is_library:
        return
    else:
        texts = (text.encode() for text in xacro.comments() if re.search(r":\s", text))
        found = next(filter(None, (_written(xacro.sources, text) for text in texts)), None)
    if found:
        yield Finding(
            found,
            "':' and white space in a comment: a ROS 2 launch file may parse the robot as YAML",
            confidence=Confidence.INFERRED,
        )


def _colon(source: Source, comment: bytes) -> Span | None:
    """The first colon with white space in a comment that matches a pattern."""
    for match in re.finditer(comment, source.data, re.DOTALL):
        if colon := re.compile(rb":\s").search(source.data, match.start(), match.end() - 3):
            return Span(source, *colon.span())
    return None


def _written(sources: tuple[Source, ...], text: bytes) -> Span | None:
    """The source location of a comment of the expanded robot."""
    pattern = b"<!--" + re.escape(text) + b"-->"
    return next(filter(None, (_colon(source, pattern) for source in sources)), None)


def _is_ament(context: Context) -> bool:
    """True if the package of the file is built with ament, that is, for ROS 2."""
    package = context.resolver.packages.enclosing(context.source.path)
    if package is None:
        return False
    # A package of rosbuild has another file.
    manifest = context.resolver.readable(os.path.join(package[1], "package.xml"))
    return manifest is not None and b"<build_type>ament" in manifest.data
