"""The parameter files that the nodes of a launch file read."""

from __future__ import annotations

from urdfkit.lint.rules import Context
from urdfkit.ros.launch.program_parameters import parameters_of_programs
from urdfkit.ros.node_parameters import NodeParameters, node_parameters


def parameter_files(context: Context) -> dict[str, list[NodeParameters]]:
    """The sections of the parameter files of ROS 2, by the paths of the files."""
    read = (file for file in context.launch.parameters if file.exists and not file.is_of_ros1)
    sources = map(context.resolver.readable, dict.fromkeys(file.path for file in read))
    return {source.path: list(node_parameters(source)) for source in sources if source}


def parameters_of_started(
    context: Context, files: dict[str, list[NodeParameters]]
) -> list[NodeParameters]:
    """What known programs of any name get from the launch file and from parameter files."""
    return list(parameters_of_programs(context.launch.started, files))


def parameter_sections(context: Context) -> list[NodeParameters]:
    """The sections of all parameter files."""
    return [section for sections in parameter_files(context).values() for section in sections]


def whole_sections(sections: list[NodeParameters]) -> list[NodeParameters]:
    """The sections that no other section may complete, as it has the same name."""
    names = [section.name for section in sections]
    return [section for section in sections if names.count(section.name) == 1]
