"""A node stops at a parameter of another type than it declares.

Parameters of ROS 2 are typed: an integer for a double stops the node ("expected [double] got
[integer]"), and so does a value in quotes for a number. The size of a costmap is an integer.

The map saver has a `save_map_timeout` in ms (warning): since Galactic it is a double in s.

Sources:
    ROS 2, parser of parameter files: https://github.com/ros2/rcl/blob/rolling/rcl_yaml_param_parser/src/parse.c
    rst-tu-dortmund/teb_local_planner#202: https://github.com/rst-tu-dortmund/teb_local_planner/issues/202
"""

import re
from math import ceil

from urdfkit.checks.bringup.read_parameters import (
    OF_INPUT,
    inputs_of_twist_mux,
    parameters_of_nodes,
    read_sections,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.launch.known_parameters import given_values, kind_of
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.ros.parameter_types import TYPES, correction, type_of
from urdfkit.text.located_yaml import Node, Value, scalar, scalars

NAME = "launch/filter.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [Node(package="nav2_amcl", executable="amcl", parameters=["../amcl.yaml"])]
"""
GOOD = BAD.replace("amcl.yaml", "sound.yaml")
_AMCL = b"amcl:\n  ros__parameters: {update_min_d: %s}\n"
FILES = {
    "amcl.yaml": _AMCL % b"1",
    "sound.yaml": _AMCL % b"1.0",
    "package.xml": b"<package><name>arm</name></package>",
}

_SIZES = ("width", "height")
_SIM_TIME = "use_sim_time"
#: The map saver of Nav2, the parameter that is in ms up to Foxy, and its least value in ms.
_MAP_SAVER, _TIMEOUT, _LEAST_MS = "map_saver", "save_map_timeout", 100


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for section in parameters_of_nodes(context):
        yield from _wrong_types(section)
        yield from _timeout_in_ms(section)
    for section in read_sections(context):
        yield from _inputs_of_twist_mux(section)
        yield from _wrong_sizes(section)


def _wrong_types(node: NodeParameters) -> Findings:
    """Values of another type than the declared one, which stop the node."""
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


def _wrong_sizes(node: NodeParameters) -> Findings:
    """Doubles for the sizes of a costmap, which are integers in m."""
    for key in _SIZES if node.name.endswith("_costmap") else ():
        value = scalar(node.values, key)
        if value and re.fullmatch(r"[-+]?\d+\.\d*", value.text):
            message = f"'{node.name}' stops: {key} is declared as an integer, not {value.text}"
            yield Finding(value.span, message, f"write {ceil(float(value.text))}")


def _timeout_in_ms(node: NodeParameters) -> Findings:
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


def _inputs_of_twist_mux(node: NodeParameters) -> Findings:
    for name, values in inputs_of_twist_mux(node):
        for key, kind in OF_INPUT.items():
            value = values.get(key)
            actual = type_of(value) if isinstance(value, Value) else None
            if actual and actual != kind and isinstance(value, Value):
                message = f"'{node.name}' stops: {key} of '{name}' is {TYPES[actual]}, must be "
                yield Finding(value.span, message + TYPES[kind], correction(value, kind))
