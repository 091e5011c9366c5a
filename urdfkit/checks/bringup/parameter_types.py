"""Parameters whose type a node of ROS 2 rejects.

Sources: rcl_yaml_param_parser (no lists in lists); the declarations of Nav2 and robot_localization;
rst-tu-dortmund/teb_local_planner#202 ("expected [double] got [integer]").
"""

import re

from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import CONFIGURATION, given_values, kind_of
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.ros.parameter_types import TYPES, correction, type_of
from urdfkit.text.located_yaml import Node, Value, entries, items, mapping, scalar, scalars

_SIZES = ("width", "height")
_SIM_TIME = "use_sim_time"
#: The map saver of Nav2, the parameter that is in ms up to Foxy, and its least value in ms.
_MAP_SAVER, _TIMEOUT, _LEAST_MS = "map_saver", "save_map_timeout", 100
#: Values of a configuration of robot_localization: position, angles, velocities, rates,
#: accelerations.
_STATES = 15
#: Of each input and each lock of twist_mux its parameters, all of them required.
_OF_INPUT = {"topic": "string", "timeout": "double", "priority": "int"}


def wrong_types(node: NodeParameters) -> Findings:
    """Values of another type than the declared one, which stop the node, and lists of lists."""
    for key, value in entries(node.values):
        # The end of an inner list ends the outer list: a single inner list is read as flat.
        if isinstance(value, list) and sum(isinstance(item, list) for item in value) > 1:
            yield Finding(
                key.span,
                f"'{node.name}': {key} is a list of lists, which ROS 2 does not read",
                'write one list, or for a footprint a text: "[[x, y], ...]"',
            )
    is_checked = False
    for given in given_values(node):
        is_checked = is_checked or given.at == _SIM_TIME
        if given.at not in _SIZES and not _is_in_ms(given.at, given.value):
            yield from _wrong_type(node, given.at, given.value, given.type)
    if _SIM_TIME in node.values and not is_checked:  # every node has it
        yield from _wrong_type(node, _SIM_TIME, node.values[_SIM_TIME], "bool")


def _wrong_type(node: NodeParameters, name: str, value: Node, expected: str | None) -> Findings:
    actual = type_of(value) if isinstance(value, Value | list) else None
    if expected and actual and actual != expected and value:
        at = value.span if isinstance(value, Value) else scalars(value)[0].span
        message = f"'{node.name}' stops: {name} is {TYPES[actual]}, must be {TYPES[expected]}"
        yield Finding(at, message, correction(value, expected))


def wrong_sizes(node: NodeParameters) -> Findings:
    """Doubles for the sizes of a costmap, which are integers in m."""
    for key in _SIZES if node.name.endswith("_costmap") else ():
        value = scalar(node.values, key)
        if value and re.fullmatch(r"[-+]?\d+\.\d*", value.text):
            message = f"'{node.name}' stops: {key} is declared as an integer, not {value.text}"
            yield Finding(value.span, message, f"write {round(float(value.text))}")


def timeout_in_ms(node: NodeParameters) -> Findings:
    """The timeout of the map saver as Foxy reads it: an integer in ms."""
    value = scalar(node.values, _TIMEOUT) if kind_of(node) == _MAP_SAVER else None
    if value and _is_in_ms(_TIMEOUT, value):
        message = f"'{node.name}' of Galactic and later stops: {_TIMEOUT} is in s, "
        message += f"{TYPES['double']}, not {value.text} ms"
        seconds = int(value.text) / 1000
        yield Finding(value.span, message, f"write {seconds}", severity=Severity.WARNING)


def _is_in_ms(name: str, value: Node) -> bool:
    """True for a timeout that only the map saver of Foxy reads."""
    if name != _TIMEOUT or not isinstance(value, Value) or type_of(value) != "int":
        return False
    return abs(int(value.text)) >= _LEAST_MS


def wrong_configurations(node: NodeParameters) -> Findings:
    """Configurations of robot_localization of another length than the filter reads."""
    for key, value in items(node.values):
        is_configuration = CONFIGURATION.fullmatch(key) is not None
        if is_configuration and isinstance(value, list) and len(value) != _STATES:
            yield Finding(
                key.span,
                f"'{node.name}': {key} has {len(value)} values, not {_STATES}",
                "write five rows: x y z, roll pitch yaw, their velocities, accelerations of x y z",
            )


def outdated_motion_model(node: NodeParameters) -> Findings:
    """A motion model of AMCL with its name in ROS 1 and Foxy."""
    model = scalar(node.values, "robot_model_type")
    if model is None or node.name != "amcl":
        return
    if name := data("nodes")["motion_models"].get(model.text):
        yield Finding(
            model.span,
            f"'amcl' of Humble and later stops: robot_model_type is a class, not '{model.text}'",
            f"write {name}",
            severity=Severity.WARNING,
        )


def inputs_of_twist_mux(node: NodeParameters) -> Findings:
    """Inputs of twist_mux without a parameter, or with one of another type, at which it stops."""
    for group in ("topics", "locks") if node.name == "twist_mux" else ():
        for name, entry in items(node.values, group):
            values = mapping(entry)
            for key, kind in _OF_INPUT.items():
                value = values.get(key)
                actual = type_of(value) if isinstance(value, Value) else None
                who = f"'{node.name}' stops: {key} of '{name}' is"
                if values and key not in values:
                    yield Finding(name.span, f"{who} not given", f"add {key}")
                elif actual and actual != kind and isinstance(value, Value):
                    message = f"{who} {TYPES[actual]}, must be {TYPES[kind]}"
                    yield Finding(value.span, message, correction(value, kind))
