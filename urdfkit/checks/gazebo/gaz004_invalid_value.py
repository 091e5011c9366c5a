"""A value in a `<gazebo>` block has a type or range that Gazebo does not read.

- Tags of the block: if Gazebo's converter expects a number, other text aborts the whole conversion
  with an exception, and a decimal comma, or any other text after a number, ends the number. If it
  expects a boolean, it accepts `true`, `yes` and `1` (for `turnGravityOff`: `false`, `no` and `0`)
  and reads any other text as the opposite.
- Plugins: a plugin that expects a number reads text as 0 or as the default. If it expects a
  boolean, only `true` and `1` are true: `yes` and `on` are false. An unknown keyword is ignored or
  stops the plugin.
- Sensors: gz-sim rejects the model or uses a default, and Gazebo Classic uses a default (a warning,
  if the robot is for it) or creates no sensor. A number ends at the first other character: `50 cm`
  is 50 m, and an image `1e3` pixels wide has one pixel; 666.5 beams, which are read as 666, are not
  reported.
- Swapped bounds of sensors: a lidar whose minimum range or angle is not below the maximum, and a
  camera whose near clipping distance is not below the far one, detect nothing. Missing ranges of a
  lidar are 0. The rays of Gazebo Classic may sweep backwards, or all go one way.

GAZ047 reports angles in degrees.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebo_ros_diff_drive.cpp of ROS 1: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Camera.cc: https://github.com/gazebosim/sdformat/blob/main/src/Camera.cc
    sdformat, Param.cc: https://github.com/gazebosim/sdformat/blob/main/src/Param.cc
    gz-sensors, Lidar.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Lidar.cc
    measured: what libsdformat 12.3 rejects
"""

from collections.abc import Iterable, Sequence
from math import isnan

from urdfkit.checks.gazebo.sensor_values import invalid_in_sensors
from urdfkit.core.suggest import hint_for, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import robot_xml
from urdfkit.robot.values import number
from urdfkit.ros.catalog.extensions import Extension, extensions
from urdfkit.ros.catalog.plugins import Parameter
from urdfkit.ros.gazebo import REJECTED_BY_GZ
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.ros.gazebo.values import corrected, is_placeholder, leading, quoted, text_of, value
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value

BAD = robot_xml(solid_xml("wheel"), gazebo_xml("<mu1>0,8</mu1>", reference="wheel"))
FIXED = GOOD = BAD.replace("0,8", "0.8")

_WORDS = ("true", "yes", "1", "false", "no", "0")
#: Friction and stiffness.
_NOT_NEGATIVE = ("mu1", "mu2", "kp", "kd", "minDepth", "maxVel", "maxContacts")
#: Booleans of SDF that the converter copies as they are.
_COPIED = ("gravity", "self_collide", "kinematic", "enable_wind", "must_be_base_link")
#: A quaternion is written as roll, pitch and yaw: so gz-math reads it from a stream.
_LENGTHS = {"vector2": 2, "vector3": 3, "quaternion": 3, "pose": 6}
#: Words for booleans; the last two read as false, as intended.
_BOOLEANS = ("true", "1", "false", "0", "no", "off")
#: End messages about a value for which the plugin takes another one.
_DEFAULT, _OTHER = "; it stays at ", "; it is read as "


@rule(Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    handled = extensions()
    for block in context.model.gazebo:
        for child in block.children:
            text = text_of(child)
            if is_placeholder(text):
                continue
            if extension := handled.get(child.tag):
                if extension.type != "bool" or _is_read(context.model, block, extension):
                    yield from _handled(child, extension, text)
            elif child.tag in _COPIED and text.lower() not in ("true", "false", "1", "0"):
                message = (
                    f"<{child.tag}> is {quoted(text)}, must be true or false: {REJECTED_BY_GZ}"
                )
                yield Finding(child, message, "write true or false")
    yield from _invalid_in_plugins(context.plugins)
    yield from invalid_in_sensors(context)


def _is_read(model: RobotModel, block: Element, extension: Extension) -> bool:
    """False if a tag for links is in the block of a joint, or the reverse (GAZ005)."""
    name = block.get("reference")
    is_link, is_joint = name in model.links_by_name, name in model.joints_by_name
    return is_link == is_joint or extension.on != ("joint" if is_link else "link")


def _handled(child: Element, extension: Extension, text: str) -> Findings:
    found = f"<{child.tag}> is {quoted(text)}"
    if extension.type in ("float", "int"):
        yield from _number(child, text, found)
    elif extension.type == "vector3":
        parts = [number(part) for part in text.split()]
        if len(parts) != 3 or None in parts:
            yield Finding(child, f"{found}, not 3 numbers", "write 3 numbers with spaces between")
    elif extension.type == "bool" and text.lower() not in _WORDS:
        read = "false" if extension.words == "yes" else "true"
        yield Finding(child, f"{found}, which Gazebo reads as {read}", "write true or false")


def _number(child: Element, text: str, found: str) -> Findings:
    read, rest = leading(text)
    if not read:
        message = f"{found}, not a number: Gazebo's URDF converter ends with an exception"
        yield Finding(child, message, "write a number")
    elif rest:
        right = corrected(text)
        is_written = rest.startswith(",") and child.text.strip() == text
        fix = fix_value(child, right) if is_written else None
        severity = Severity.WARNING if right == read else None
        message = f"{found}, which Gazebo reads as {read}"
        yield Finding(child, message, f"write {right}", fix, severity=severity)
    elif isnan(value(read)):
        yield Finding(child, f"{found}: the simulation spreads it to all links", "write a number")
    elif child.tag in _NOT_NEGATIVE and value(read) < 0:
        message = f"{found}, must be >= 0: contacts pull or the simulation becomes unstable"
        yield Finding(child, message, "write 0 or more")


def _invalid_in_plugins(plugins: Iterable[PluginUse]) -> Findings:
    """The values that a plugin reads differently from their text, or not at all."""
    for use in plugins:
        parameters = use.plugin.parameters if use.plugin else {}
        for item in use.items:
            parameter = parameters.get(item.path)
            if parameter and (problem := _problem(parameter, item.text)):
                message = f"{use.title}: <{item.path}> is {quoted(item.text)}, {problem[0]}"
                is_read = _DEFAULT in message or _OTHER in message
                severity = Severity.WARNING if is_read else None
                yield Finding(item.at, message, problem[1], severity=severity)


def _problem(parameter: Parameter, text: str) -> tuple[str, str] | None:
    """The end of a message, and the help."""
    if parameter.type in ("float", "int"):
        read, rest = leading(text)
        if not read:
            right = _number_of(text, parameter.words)
            return "not a number", f"write {right}" if right else "write a number"
        return (f"which reads as {read}", f"write {corrected(text)}") if rest else None
    if parameter.words and parameter.type == "string" and text not in parameter.words:
        suggested = nearest(text, parameter.words)
        hint = hint_for(suggested)
        if parameter.other_words:
            hint = f"{_OTHER}{parameter.other_words}{hint}"
        elif parameter.default and suggested in (None, parameter.default):
            hint = f"{_DEFAULT}{parameter.default}"
        return f"must be {' or '.join(parameter.words)}{hint}", "write one of these words"
    if parameter.name == "ros/remapping" and ":=" not in text:
        return "which renames nothing", "write FROM:=TO, such as cmd_vel:=robot/cmd_vel"
    if parameter.type == "bool" and text.lower() not in _BOOLEANS:
        return "which reads as false", "write true or false"
    if length := _LENGTHS.get(parameter.type):
        read_parts = [leading(part)[0] for part in text.split()]
        if len(read_parts) < length or "" in read_parts:
            return f"not {length} numbers", f"write {length} numbers with spaces between"
    return None


def _number_of(text: str, words: Sequence[str]) -> str:
    """The number of one of the words, which are counted from 0; else empty."""
    return str(words.index(text.lower())) if text.lower() in words else ""
