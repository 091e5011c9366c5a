"""ROS 2 rejects a parameter file, so that the node that reads it does not start.

A value is not below `ros__parameters`, or is missing. A list has values of several types, such as
`[1, 0.5]`, or contains mappings or lists. The file is invalid YAML. Of the file of a composable
node, launch takes all values if none is below `ros__parameters`.

Sources:
    ROS 2, parser of parameter files: https://github.com/ros2/rcl/blob/rolling/rcl_yaml_param_parser/src/parse.c
    launch_ros, to_parameters_list.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/utilities/to_parameters_list.py
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.bringup.read_parameters import all_parameters
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.controllers import MANAGER
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.node_parameters import PARAMETERS, NodeParameters
from urdfkit.ros.parameter_types import TYPES, correction, type_of
from urdfkit.text.file_kinds import is_parameter_file
from urdfkit.text.located_yaml import (
    Key,
    Node,
    Value,
    entries,
    items,
    load,
    mapping,
    scalars,
    syntax_error,
)
from urdfkit.text.source import Source

NAME = "launch/joystick.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [Node(package="joy", executable="joy_node", parameters=["../joy.yaml"])]
"""
GOOD = BAD.replace("joy.yaml", "sound.yaml")
FILES = {
    "joy.yaml": b"joy_node:\n  deadzone: 0.1\n",
    "sound.yaml": b"joy_node:\n  ros__parameters:\n    deadzone: 0.1\n",
    "package.xml": b"<package><name>arm</name></package>",
}

#: Keys of the description of a map, which map_server reads itself.
_OF_MAPS = {"image", "resolution", "origin"}
#: Functions of Nav2 that write the file anew.
_REWRITTEN = (b"RewrittenYaml", b"ReplaceString")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    readers: dict[str, StartedProgram | None] = {}
    if is_parameter_file(context.source):  # also with no section of a known program
        readers[context.source.path] = None
    # Those of nodes first: a file may be a component's, too.
    for node in sorted(context.launch.started, key=lambda node: node.is_component):
        for path in node.parameters.files if node.is_ros_2 else ():
            readers.setdefault(path, node)
    is_rewritten = any(name in context.source.data for name in _REWRITTEN)
    has_robots = bool(context.launch.descriptions)
    for path, reader in readers.items():
        source = context.resolver.readable(path)
        if source is None:
            continue
        notes = (Related(reader.span, f"'{reader.title}' stops at it"),) if reader else ()
        if error := syntax_error(source, in_python=is_rewritten):
            if not has_robots:  # else RCT026 reports it
                at, reason = error
                yield Finding(at, f"invalid YAML: {reason}", "fix the file", related=notes)
            continue
        # RCT026 reports it for a robot.
        is_component = reader is not None and reader.is_component
        may_be_outside = is_component or (has_robots and MANAGER in mapping(load(source)))
        for finding in _rejected(source, may_be_outside, is_rewritten=is_rewritten):
            yield finding._replace(related=notes)
    for section in all_parameters(context):
        yield from _lists_of_lists(section)


def _rejected(source: Source, may_be_outside: bool, *, is_rewritten: bool) -> Iterator[Finding]:
    inside: list[Node] = []
    sections: list[tuple[Node, Key | None]] = [(load(source), None)]
    for node, owner in sections:  # the inner ones are added to it
        for key, value in items(node):
            if key == PARAMETERS:
                inside.append(value)
            if key == PARAMETERS and owner is None:
                message = f"ROS 2 rejects the file: {PARAMETERS} is not below the name of a node"
                yield Finding(key.span, message, "write the name of the node, or /**, above it")
            elif isinstance(value, Value | list):
                if not may_be_outside:
                    yield _outside(key, owner, is_map=set(mapping(load(source))) >= _OF_MAPS)
                return  # at the first one
            elif key != PARAMETERS:
                sections.append((value, key))
    for parameters in inside:
        yield from _wrong_values(parameters, is_rewritten=is_rewritten)


def _outside(key: Key, owner: Key | None, *, is_map: bool) -> Finding:
    """A value that is not below ``ros__parameters``."""
    if key == PARAMETERS:
        message = f"ROS 2 rejects the file: {PARAMETERS} has no values"
        return Finding(key.span, message, "indent the parameters below it")
    message = f"ROS 2 rejects the file: '{key}' is not below {PARAMETERS}"
    is_typo = owner is not None and nearest(owner, (PARAMETERS,)) is not None
    if is_typo and owner is not None:
        return Finding(owner.span, f"{message}, but '{owner}'", f"write {PARAMETERS}")
    help = f"write {PARAMETERS}: above it, below the name of the node"
    if is_map:
        help = "remove it from the parameters: a map is for yaml_filename of map_server"
    return Finding(key.span, message, help)


def _wrong_values(parameters: Node, *, is_rewritten: bool) -> Iterator[Finding]:
    sections = [parameters]
    for section in sections:
        for key, value in items(section):
            if isinstance(value, dict):
                sections.append(value)
            elif isinstance(value, list):
                if isinstance(section := _only_section(value), dict):
                    sections.append(section)
                    continue
                yield from _mixed(key, value)
                if any(isinstance(item, dict) for item in value):
                    message = f"ROS 2 does not read '{key}', a list of mappings"
                    yield Finding(key.span, message, "write a section for each of them")
            elif not is_rewritten and _is_empty(value):
                message = f"ROS 2 rejects the file: '{key}' has no value"
                yield Finding(key.span, message, f'write a value, or {key}: ""')


def _only_section(values: list[Node]) -> Node | None:
    """The mapping that ROS 2 reads without its dash, as in ``- interfaces: [enable]``.

    So the documentation of gpio_controllers writes it. The parser takes the values of a list for
    parts of it until the next list ends: so the first value in the mapping must be a list.
    """
    is_alone = len(values) == 1 and isinstance(values[0], dict) and values[0]
    return values[0] if is_alone and isinstance(next(iter(is_alone.values())), list) else None


def _is_empty(node: Node) -> bool:
    """True for a value of which nothing is written, not even quotes."""
    return isinstance(node, Value) and not (node.text or node.tag or node.span.text)


def _mixed(key: str, values: list[Node]) -> Iterator[Finding]:
    """The first item of another type than the others."""
    items = scalars(values)
    kinds = [type_of(item) for item in items]
    if None in kinds or len(items) < len(values) or len(set(kinds)) < 2:
        return
    # A number without a decimal point is more likely a mistake than the others are.
    of_numbers = {"int", "double"}
    expected = "double" if set(kinds) == of_numbers else max(kinds, key=kinds.count)
    item, kind = next((i, k) for i, k in zip(items, kinds, strict=True) if k != expected)
    message = f"ROS 2 rejects the file: '{key}' mixes types: {item.text} is {TYPES[kind or '']}"
    yield Finding(item.span, message, correction(item, expected or "string"))


def _lists_of_lists(node: NodeParameters) -> Findings:
    for key, value in entries(node.values):
        # The end of an inner list ends the outer list: a single inner list is read as flat.
        if isinstance(value, list) and sum(isinstance(item, list) for item in value) > 1:
            yield Finding(
                key.span,
                f"'{node.name}': {key} is a list of lists, which ROS 2 does not read",
                'write one list, or for a footprint a text: "[[x, y], ...]"',
            )
