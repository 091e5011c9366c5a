"""The parameters that a launch file gives to a node, itself or in parameter files."""

from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import topic_name
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.resolve import Resolver


def given_parameter(program: StartedProgram, name: str, resolver: Resolver) -> str | None:
    """A parameter of a node, from the launch file or its parameter files.

    Returns:
        An empty string if it is not given; None if it is known only at run time.
    """
    given = program.parameters
    if name in given.values:
        return given.values[name]
    if not given.is_whole or any(name in (word.text or name) for word in program.words):
        return None
    values: set[str | None] = set()
    for source in map(resolver.readable, given.files):
        if source is None:
            return None
        nodes = (node.values for node in node_parameters(source) if name in node.values)
        values.update(
            value.text if isinstance(value, Value) else None
            for value in (parameters[name] for parameters in nodes)
        )
    return next(iter(values), "") if len(values) < 2 else None


def lacks_description(program: StartedProgram) -> bool:
    """True for a robot_state_publisher that stops, as it gets no robot."""
    given = program.parameters.every
    is_publisher = program.package == "robot_state_publisher" and not program.words
    return is_publisher and given is not None and "robot_description" not in given


def topic_of_program(program: StartedProgram, name: str, resolver: Resolver) -> str | None:
    """Full name of a topic in the catalogue, which may be PARAMETER=DEFAULT; None if unknown."""
    parameter, _, default = name.partition("=")
    given = given_parameter(program, parameter, resolver) if default else name
    return None if given is None else topic_name(given or default, program)
