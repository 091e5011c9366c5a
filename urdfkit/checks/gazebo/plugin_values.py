"""Values in the tags of plugins that are not of the type that the plugin reads."""

from collections.abc import Iterable

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.catalog.plugins import Parameter
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.values import corrected, leading, quoted

#: A quaternion is written as roll, pitch and yaw: so gz-math reads it from a stream.
_LENGTHS = {"vector2": 2, "vector3": 3, "quaternion": 3, "pose": 6}
#: Words for booleans; the last two read as false, as intended.
_BOOLEANS = ("true", "1", "false", "0", "no", "off")
#: End messages about a value for which the plugin takes another one.
_DEFAULT, _OTHER = "; it stays at ", "; it is read as "


def invalid_in_plugins(plugins: Iterable[PluginUse]) -> Findings:
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
            return "not a number", "write a number"
        return (f"which reads as {read}", f"write {corrected(text)}") if rest else None
    if parameter.words and parameter.type == "string" and text not in parameter.words:
        hint = did_you_mean(text, parameter.words)
        if parameter.other_words:
            hint = f"{_OTHER}{parameter.other_words}{hint}"
        elif not hint and parameter.default:
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
