"""Values of parameters that a node rejects.

Sources: the nodes of ros-navigation/navigation2 and SteveMacenski/slam_toolbox, and
``camera_info_manager.cpp``, humble to rolling.
"""

import re
from math import inf

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.values import number
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import GivenValue, given_values, kind_of
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value, scalars

#: The place of the calibration of a camera, which camera_info_manager loads.
_CALIBRATION = "camera_info_url"


def invalid_values(node: NodeParameters) -> Findings:
    """Modes that a node does not have, lists of another length, paths and footprints."""
    for given in given_values(node):
        yield from _unknown_choices(node, given)
        yield from _wrong_lengths(node, given)
        if isinstance(given.value, Value):
            yield from _misread_texts(node, given, given.value)
            yield from _too_large(node, given, given.value)


def _unknown_choices(node: NodeParameters, given: GivenValue) -> Findings:
    name = f"{given.owner}.{given.at}"
    value, choices = given.value, data("node_parameters")["choices"].get(name, "").split()
    if not isinstance(value, Value) or not choices or value.text in (*choices, *given.siblings):
        return  # a sibling of this name describes a plugin, as mppi::DiffDriveMotionModel
    if value.text[:1].isalpha() and not _is_of_workspace(value.text, choices):
        message = f"'{node.name}': unknown {given.at} '{value.text}'"
        message += did_you_mean(value.text, choices)
        # slam_toolbox compares its mode with "localization" only, and goes on.
        severity = Severity.WARNING if name == "slam_toolbox.mode" else None
        yield Finding(value.span, message, f"write one of {', '.join(choices)}", severity=severity)


def _wrong_lengths(node: NodeParameters, given: GivenValue) -> Findings:
    lengths: dict[str, list[int]] = data("node_parameters")["lengths"].get(kind_of(node), {})
    value, expected = given.value, lengths.get(given.at)
    if isinstance(value, list) and expected and len(value) not in expected:
        message = f"'{node.name}': {given.at} has {len(value)} numbers, must have {expected[0]}"
        yield Finding(given.at.span, message, "write one for x, y and the rotation")


def _misread_texts(node: NodeParameters, given: GivenValue, value: Value) -> Findings:
    """Paths in place of URLs and of names, and texts that are no footprint."""
    names: dict[str, str] = data("node_parameters")["names"]
    if given.at == _CALIBRATION and _is_path(value.text):
        message = f"'{node.name}' does not load {given.at} '{value.text}', which is no URL"
        path = value.text if value.text.startswith("/") else "/PATH"
        yield Finding(value.span, message, f"write file://{path}, or package://PACKAGE/PATH")
    if (name := names.get(f"{given.owner}.{given.at}")) and value.text.startswith("/dev/"):
        message = f"'{node.name}': {given.at} is a name, not a path"
        yield Finding(given.at.span, message, f"write {name}")
    if given.at == "footprint" and not _is_footprint(value.text):
        message = f"'{node.name}': the footprint is no list of three or more points"
        yield Finding(value.span, message, 'write "[[x, y], [x, y], [x, y]]"')


def _too_large(node: NodeParameters, given: GivenValue, value: Value) -> Findings:
    most = data("node_parameters")["most"].get(given.at, inf)
    if (number(value.text) or 0.0) > most:
        message = f"'{node.name}': {given.at} is {value.text}, must be at most {most}"
        yield Finding(value.span, message, f"write {most}")


def _is_of_workspace(plugin: str, known: list[str]) -> bool:
    """True for a plugin of another library: Isaac_Sim_ROS2_Nav has its own solver."""
    library, separator, _ = plugin.partition("::")
    libraries = {one.partition("::")[0] for one in known}
    return bool(separator) and library not in libraries and not did_you_mean(library, libraries)


def _is_path(text: str) -> bool:
    """True for a place of a calibration without ``file:///`` or ``package://``."""
    return "/" in text and not re.match(r"file:///|package://[^/]+/|flash://|.*[$<{]", text)


def _is_footprint(text: str) -> bool:
    """True for a list of points, for none, and for a value that is known at run time only."""
    number = r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?\s*"
    point = rf"\s*\[{number},{number}\]\s*"
    is_open = not text.strip() or text.strip() == "[]" or any(mark in text for mark in "$<{")
    return is_open or bool(
        re.fullmatch(rf"\s*\[({point},){{2,}}{point},?\]\s*", text, re.IGNORECASE)
    )


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
