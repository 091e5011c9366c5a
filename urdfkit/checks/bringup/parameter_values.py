"""Parameters that a node lacks, and values that it rejects.

Sources: the nodes of ros-navigation/navigation2 and SteveMacenski/slam_toolbox, and
``camera_info_manager.cpp``, humble to rolling.
"""

import re
from collections.abc import Iterable
from math import inf

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.robot.values import number
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.known_parameters import given_values, kind_of
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Node, Value, scalar, scalars

_PREFIX = "frame_prefix"
#: Frames of localization that have the name of the other one.
_SWAPPED = {
    "odom_frame_id": "map",
    "odom_frame": "map",
    "global_frame_id": "odom",
    "map_frame": "odom",
}
_LOCALIZING = ("amcl", "slam_toolbox")
#: The place of the calibration of a camera, which camera_info_manager loads.
_CALIBRATION = "camera_info_url"


def missing(node: NodeParameters) -> Findings:
    """Parameters without which the node does not start; only if it has others."""
    required: dict[str, str] = data("node_parameters")["required"].get(node.name, {})
    for name, since in required.items():
        if name not in node.values and len(node.values) > 1:
            yield Finding(
                node.at,
                f"'{node.name}' of {since} stops: parameter '{name}' is not given",
                f"add {name}",
                severity=Severity.WARNING,
            )


def invalid_prefixes(programs: Iterable[StartedProgram]) -> Findings:
    """Prefixes that make names of frames which tf2 or the reader does not know."""
    for node in programs:
        prefix = node.parameters.values.get(_PREFIX) or ""
        if node.package != "robot_state_publisher" or "$" in prefix:
            continue
        if prefix == "/":
            continue  # tf2 strips it
        if prefix.startswith("/"):
            message = f"{_PREFIX} '{prefix}' begins with a slash, as no name of tf2 does"
            yield Finding(
                node.at, message, f"write {prefix.strip('/')}/", severity=Severity.WARNING
            )
        elif prefix and prefix == (node.namespace or "").strip("/"):
            message = f"{_PREFIX} '{prefix}' has no slash: the frames are called {prefix}base_link"
            yield Finding(node.at, message, f"write {prefix}/", severity=Severity.WARNING)


def missing_of_programs(context: Context) -> Findings:
    """The same for programs whose nodes have any name."""
    for program in context.launch.started:
        required: dict[str, str] = data("node_parameters")["required"].get(program.key, {})
        for parameter, since in required.items() if program.is_ros_2 else ():
            if given_parameter(program, parameter, context.resolver) == "":
                yield Finding(
                    program.at,
                    f"'{program.title}' of {since} stops: parameter '{parameter}' is not given",
                    f"add {parameter}",
                    severity=Severity.WARNING,
                )


def invalid_values(node: NodeParameters) -> Findings:
    """Modes that a node does not have, lists of another length, and footprints."""
    choices: dict[str, str] = data("node_parameters")["choices"]
    lengths: dict[str, list[int]] = data("node_parameters")["lengths"].get(kind_of(node), {})
    most: dict[str, int] = data("node_parameters")["most"]
    names: dict[str, str] = data("node_parameters")["names"]
    for given in given_values(node):
        value, expected = given.value, lengths.get(given.at)
        modes = choices.get(f"{given.owner}.{given.at}", "").split()
        if isinstance(value, Value) and modes and value.text not in modes:
            if value.text and value.text[0].isalpha() and not _is_of_workspace(value.text, modes):
                message = f"'{node.name}': unknown {given.at} '{value.text}'"
                message += did_you_mean(value.text, modes)
                help = f"write one of {', '.join(modes)}"
                # slam_toolbox compares its mode with "localization" only, and goes on.
                goes_on = f"{given.owner}.{given.at}" == "slam_toolbox.mode"
                severity = Severity.WARNING if goes_on else None
                yield Finding(value.span, message, help, severity=severity)
        elif given.at == _CALIBRATION and isinstance(value, Value) and _is_path(value.text):
            message = f"'{node.name}' does not load {given.at} '{value.text}', which is no URL"
            path = value.text if value.text.startswith("/") else "/PATH"
            yield Finding(value.span, message, f"write file://{path}, or package://PACKAGE/PATH")
        elif f"{given.owner}.{given.at}" in names and _is_device(value):
            message = f"'{node.name}': {given.at} is a name, not a path"
            yield Finding(given.at.span, message, f"write {names[f'{given.owner}.{given.at}']}")
        elif isinstance(value, list) and expected and len(value) not in expected:
            message = f"'{node.name}': {given.at} has {len(value)} numbers, must have {expected[0]}"
            yield Finding(given.at.span, message, "write one for x, y and the rotation")
        elif isinstance(value, Value) and (number(value.text) or 0.0) > most.get(given.at, inf):
            message = f"'{node.name}': {given.at} is {value.text}, must be at most "
            yield Finding(value.span, f"{message}{most[given.at]}", f"write {most[given.at]}")
        elif given.at == "footprint" and isinstance(value, Value) and not _is_footprint(value.text):
            message = f"'{node.name}': the footprint is no list of three or more points"
            yield Finding(value.span, message, 'write "[[x, y], [x, y], [x, y]]"')


def _is_of_workspace(plugin: str, known: list[str]) -> bool:
    """True for a plugin of another library: Isaac_Sim_ROS2_Nav has its own solver."""
    library, separator, _ = plugin.partition("::")
    libraries = {one.partition("::")[0] for one in known}
    return bool(separator) and library not in libraries and not did_you_mean(library, libraries)


def _is_path(text: str) -> bool:
    """True for a place of a calibration without ``file:///`` or ``package://``."""
    return "/" in text and not re.match(r"file:///|package://[^/]+/|flash://|.*[$<{]", text)


def _is_device(value: Node) -> bool:
    return isinstance(value, Value) and value.text.startswith("/dev/")


def wrong_signs(node: NodeParameters) -> Findings:
    """Limits with the wrong sign; those of velocities stop the node only from Jazzy on."""
    signs: dict[str, int] = data("node_parameters")["signs"].get(kind_of(node), {})
    for given in given_values(node):
        sign = signs.get(given.at, 0)
        for value in scalars(given.value) if sign else ():
            if (number(value.text) or 0.0) * sign < 0:
                is_negative = sign < 0
                since = " of Jazzy and later" if "velocity" in given.at else ""
                yield Finding(
                    value.span,
                    f"'{node.name}'{since} stops: {given.at} has {value.text}, must not be "
                    f"{'positive' if is_negative else 'negative'}",
                    f"write {'-' if is_negative else ''}{value.text.lstrip('+-')}",
                    severity=Severity.WARNING if since else None,
                )


def _is_footprint(text: str) -> bool:
    """True for a list of points, for none, and for a value that is known at run time only."""
    number = r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?\s*"
    point = rf"\s*\[{number},{number}\]\s*"
    is_open = not text.strip() or text.strip() == "[]" or any(mark in text for mark in "$<{")
    return is_open or bool(
        re.fullmatch(rf"\s*\[({point},){{2,}}{point},?\]\s*", text, re.IGNORECASE)
    )


def swapped_frames(node: NodeParameters) -> Findings:
    """The frame of the map in place of that of odometry, or the reverse."""
    for key, wrong in _SWAPPED.items() if node.name in _LOCALIZING else ():
        value = scalar(node.values, key)
        if value and value.text.strip("/") == wrong:
            right = "odom" if wrong == "map" else "map"
            yield Finding(
                value.span,
                f"'{node.name}': {key} is '{wrong}', the frame of "
                f"{'the map' if wrong == 'map' else 'odometry'}",
                f"write {right}",
                severity=Severity.WARNING,
            )
