"""Parameters that no node reads: misspelt ones, and inputs of robot_localization.

Sources: the nodes of ros-navigation/navigation2, SteveMacenski/slam_toolbox and
cra-ros-pkg/robot_localization, humble to rolling.
"""

import re

from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, is_typo, nearest
from urdfkit.lint.rules import Context, Finding, Findings
from urdfkit.ros.launch.known_parameters import CONFIGURATION, GivenValue, given_values
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Value, entries

_INPUT = re.compile(r"(odom|imu|pose|twist)\d+")
_FILTERS = ("ekf_node", "ukf_node")
#: Letters of words that are not typos of each other.
_SHORT = 3


def misspelt(node: NodeParameters) -> Findings:
    """Parameters that the node ignores, and that are one letter away from one that it reads."""
    for given in given_values(node):
        if suggested := _meant(given):
            yield Finding(
                given.at.span,
                f"'{node.name}': unknown parameter '{given.at}'; did you mean '{suggested}'?",
                f"write {suggested}",
            )


def with_commas(node: NodeParameters) -> Findings:
    """Commas in names of parameters, where a dot is meant."""
    for key, _ in entries(node.values):
        if re.fullmatch(r"\w+,\w+", key):
            message = f"'{node.name}': the name of the parameter '{key}' contains a comma"
            help = f"write {key.replace(',', '.')}"
            yield Finding(key.span, message, help)


def _meant(given: GivenValue) -> str | None:
    names = {name.rpartition(".")[2] for name in given.known}
    if given.at in names or not isinstance(given.value, Value | list):
        return None
    if given.at.startswith("_") and given.at[1:] in names:
        return given.at[1:]  # as on the command line of ROS 1
    suggested = nearest(given.at, names, CLOSE_TYPO) or next(
        (name for name in names if len(name) > 4 and is_typo(given.at, name)), None
    )
    is_other = suggested in given.siblings or (suggested and _is_of_other_axis(given.at, suggested))
    return None if is_other else suggested


def _is_of_other_axis(name: str, other: str) -> bool:
    """True for ``az_max`` and ``ay_max``, which differ in a short word."""
    pairs = zip(name.split("_"), other.split("_"), strict=False)
    return any(word != known and len(word) <= _SHORT >= len(known) for word, known in pairs)


def without_inputs(context: Context) -> Findings:
    """Filters of robot_localization whose parameters name no input, mostly for lack of a file."""
    for node in context.launch.started if not context.launch.has_scopes else ():
        is_filter = node.package == "robot_localization" and node.executable in _FILTERS
        given = node.parameters.every if is_filter and node.is_ros_2 else None
        if given is not None and node.is_sure and not any(map(_INPUT.fullmatch, given)):
            message = f"'{node.title}' has no inputs: it gets no odom0, imu0 or the like"
            yield Finding(node.at, message, "load its parameter file")


def unread_inputs(node: NodeParameters) -> Findings:
    """Inputs of robot_localization without the list of what is read of them."""
    if not any(CONFIGURATION.fullmatch(name) for name in node.values):
        return
    for name, value in node.values.items():
        is_input = _INPUT.fullmatch(name) and isinstance(value, Value)
        if not is_input or f"{name}_config" in node.values or not isinstance(name, Key):
            continue
        others = [other for other in node.values if other.startswith(name) and other != name]
        yield Finding(
            name.span,
            f"'{node.name}': nothing of {name} is read: {name}_config is not given"
            f"{did_you_mean(f'{name}_config', others)}",
            f"add {name}_config with 15 booleans",
        )
