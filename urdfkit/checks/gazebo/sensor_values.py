"""Values in the settings of sensors that SDF does not accept, and swapped bounds."""

from collections.abc import Iterator
from math import isnan

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity
from urdfkit.robot.values import number
from urdfkit.ros.catalog.sensors import Setting, settings
from urdfkit.ros.gazebo import REJECTED_BY_GZ
from urdfkit.ros.gazebo.sensors import Sensor, sensors, written
from urdfkit.ros.gazebo.values import corrected, is_placeholder, leading, quoted, value
from urdfkit.ros.targets import CLASSIC, GZ
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import swap

_NUMBERS = ("float", "int", "uint")
#: Settings that must be 1 or more.
_POSITIVE = ("width", "height", "samples")
#: Settings whose bounds are checked elsewhere: here below, and by GAZ047.
_BOUNDED_ELSEWHERE = ("horizontal_fov", "near", "far")
_LENGTHS = {"vector2": 2, "vector3": 3, "pose": 6}
_BOOLEANS = ("true", "false", "1", "0")
#: Words of a setting that a message lists.
_MAX_WORDS = 7


def invalid_in_sensors(context: Context) -> Findings:
    """The values of sensors that are not of their type or range."""
    for sensor in sensors(context.model):
        for at, name, text, setting in _settings(sensor):
            if problem := _problem(name, setting, text):
                shown = f"attribute {name}" if isinstance(at, Attribute) else f"<{name}>"
                message = f"{sensor.who}: {shown} is {quoted(text)}, {problem[0]}"
                yield Finding(at, message, problem[1], severity=_severity(context, problem[0]))
        yield from _lidar(sensor, context)
        yield from _clip(sensor)


def _severity(context: Context, problem: str) -> Severity | None:
    """Warning for values that gz-sim rejects, if the robot is for Gazebo Classic, with defaults."""
    is_for_classic = context.targets.any_of(CLASSIC) and not context.targets.any_of(GZ)
    return Severity.WARNING if is_for_classic and REJECTED_BY_GZ in problem else None


def _settings(sensor: Sensor) -> Iterator[tuple[Element | Attribute, str, str, Setting]]:
    """Where a value is written, its name, the value, and what SDF accepts there."""
    for child in sensor.at.children:
        if setting := settings("sensor").get(child.tag):
            yield child, child.tag, child.text.strip(), setting
    for inner in written(sensor):
        if inner.setting is not None:
            yield inner.at, inner.at.tag, inner.at.text.strip(), inner.setting
        for attribute, setting in inner.attributes():
            yield attribute, attribute.name, attribute.value.strip(), setting


def _problem(name: str, setting: Setting, text: str) -> tuple[str, str] | None:
    """The end of a message, and the help; None for a valid value."""
    if is_placeholder(text):
        return None
    if setting.type == "pose" and not text:
        return None  # its default
    if setting.words and text not in setting.words:
        return _word_problem(name, setting.words, text)
    if setting.type in _NUMBERS:
        return _number_problem(name, setting, text)
    if setting.type == "bool" and text.lower() not in _BOOLEANS:
        return f"must be true or false: {REJECTED_BY_GZ}", "write true or false"
    length = _LENGTHS.get(setting.type)
    parts = [number(part) for part in text.split()]
    if length and (len(parts) != length or None in parts):
        help = f"write {length} numbers with spaces between"
        return f"not {length} numbers: {REJECTED_BY_GZ}", help
    return None


def _word_problem(name: str, words: tuple[str, ...], text: str) -> tuple[str, str]:
    is_long = len(words) > _MAX_WORDS
    problem = "unknown to SDF" if is_long else f"must be {' or '.join(words)}"
    if name == "format":
        problem += f": {REJECTED_BY_GZ}"
    help = f"write a value of SDF, such as {words[0]}" if is_long else "write one of these values"
    return problem + did_you_mean(text, words), help


def _number_problem(name: str, setting: Setting, text: str) -> tuple[str, str] | None:
    is_whole = setting.type != "float"
    read, rest = leading(text, whole=is_whole)
    if not read or isnan(found := value(read)):
        return f"not a number: {REJECTED_BY_GZ}", "write a number"
    if rest and not (is_whole and rest[0] == "." and rest[1:].isdecimal()):
        return f"which Gazebo reads as {read}", f"write {corrected(text)}"
    if name in _BOUNDED_ELSEWHERE:
        return None
    minimum, maximum = setting.minimum, setting.maximum
    if name in _POSITIVE and found < 1:
        return "must be >= 1", "write 1 or more"
    if setting.type == "uint" and found < 0:
        return "must be >= 0", "write 0 or more"
    if minimum is not None and found < minimum:
        return f"must be >= {minimum:g}: {REJECTED_BY_GZ}", f"write {minimum:g} or more"
    if maximum is not None and found > maximum:
        return f"must be <= {maximum:g}: {REJECTED_BY_GZ}", f"write {maximum:g} or less"
    return None


def _lidar(sensor: Sensor, context: Context) -> Findings:
    block = sensor.at.child(sensor.lidar) if sensor.lidar else None
    if block is None:
        return
    if sensor.find(f"{block.tag}/range") is None:
        message = f"{sensor.who}: <{block.tag}> has no <range>: minimum and maximum are 0 m"
        yield Finding(block, message, "add <range> with <min> and <max>")
    nearest = sensor.number(f"{block.tag}/range/min")
    if nearest and nearest.value < 0:
        message = f"{sensor.who}: minimum range is {nearest.value:g} m, must be >= 0"
        yield Finding(nearest, message, "write 0 or more")
    yield from _swapped(sensor, f"{block.tag}/range", ("min", "max"), "range", "m")
    targets = context.targets
    # Rays of Gazebo Classic may sweep backwards, or all go one way: those of a light barrier.
    is_either_way = sensor.type == "ray" and targets.any_of(CLASSIC) and not targets.any_of(GZ)
    for way in ("horizontal", "vertical"):
        scan = f"{block.tag}/scan/{way}"
        samples = sensor.number(f"{scan}/samples")
        first, last = (sensor.number(f"{scan}/{end}_angle") for end in ("min", "max"))
        is_no_sweep = bool(first and last and first.value >= last.value)
        if samples and samples.value > 1 and not (is_either_way and is_no_sweep):
            yield from _swapped(sensor, scan, ("min_angle", "max_angle"), f"{way} angle", "rad")


def _clip(sensor: Sensor) -> Findings:
    near = sensor.number("camera/clip/near")
    if near and near.value <= 0:
        message = f"{sensor.who}: near clipping distance is {near.value:g} m, must be > 0"
        yield Finding(near, message, "write the shortest distance that it sees, such as 0.05")
    else:
        yield from _swapped(sensor, "camera/clip", ("near", "far"), "clipping distance", "m")


def _swapped(
    sensor: Sensor, path: str, tags: tuple[str, str], quantity: str, unit: str
) -> Findings:
    """A lower bound that is not below its upper bound."""
    lower, upper = (sensor.number(f"{path}/{tag}") for tag in tags)
    if lower is None or upper is None or lower.value < upper.value:
        return
    edits = swap(lower.at, upper.at) if lower.value > upper.value else None
    yield Finding(
        lower,
        f"{sensor.who}: minimum {quantity} {lower.value:g} {unit} is not below the maximum "
        f"{upper.value:g} {unit}",
        f"write a <{tags[0]}> below <{tags[1]}>",
        Fix.of("swap the two", edits),
    )
