"""The parameter files that the nodes of a launch file read."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping

from urdfkit.checks.bringup.parameter_sections import misnamed_sections, misplaced
from urdfkit.lint.rules import Context
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import GivenParameters, StartedProgram
from urdfkit.ros.node_parameters import NodeParameters, node_parameters
from urdfkit.text.located_yaml import Key, Node, Value, items, mapping
from urdfkit.text.source import Span

#: Sections of a file that every node reads.
_OF_ALL = "**"
#: The parameters of each input and each lock of twist_mux, all of them required.
OF_INPUT = {"topic": "string", "timeout": "double", "priority": "int"}


def parameter_files(context: Context) -> dict[str, list[NodeParameters]]:
    """The sections of the parameter files of ROS 2, by the paths of the files."""
    read = (file for file in context.launch.parameters if file.exists and not file.is_of_ros1)
    sources = map(context.resolver.readable, dict.fromkeys(file.path for file in read))
    return {source.path: list(node_parameters(source)) for source in sources if source}


def parameters_of_started(
    context: Context, files: dict[str, list[NodeParameters]]
) -> list[NodeParameters]:
    """What known programs of any name get from the launch file and from parameter files.

    A program whose source is in the workspace may be of a release with other parameters.
    """
    programs = context.launch.started
    is_any = any(map(_kind, programs))
    own = context.resolver.packages.known(context.source.path) if is_any else ()
    return list(_parameters_of_programs(programs, files, own))


def all_parameters(context: Context) -> list[NodeParameters]:
    """The sections of all parameter files, and what known programs of any name get."""
    files = parameter_files(context)
    sections = [section for own in files.values() for section in own]
    return [*sections, *parameters_of_started(context, files)]


def read_sections(context: Context) -> list[NodeParameters]:
    """The sections of all parameter files, without those that LAU024 reports as not read."""
    files = parameter_files(context)
    sections = [section for own in files.values() for section in own]
    reported = [finding for section in whole_sections(sections) for finding in misplaced(section)]
    unread = {finding.at for finding in (*reported, *misnamed_sections(context, files))}
    return [section for section in sections if section.at not in unread]


def parameters_of_nodes(context: Context) -> list[NodeParameters]:
    """The sections that nodes read, and what known programs of any name get."""
    return [*read_sections(context), *parameters_of_started(context, parameter_files(context))]


def whole_sections(sections: list[NodeParameters]) -> list[NodeParameters]:
    """The sections that no other section may complete, as it has the same name."""
    names = [section.name for section in sections]
    return [section for section in sections if names.count(section.name) == 1]


def inputs_of_twist_mux(node: NodeParameters) -> Iterator[tuple[Key, dict[str, Node]]]:
    """The inputs and the locks of twist_mux that have a parameter, by name."""
    for group in ("topics", "locks") if node.name == "twist_mux" else ():
        for name, entry in items(node.values, group):
            if values := mapping(entry):
                yield name, values


def _parameters_of_programs(
    programs: tuple[StartedProgram, ...],
    files: Mapping[str, list[NodeParameters]],
    own: Container[str],
) -> Iterator[NodeParameters]:
    """What a launch file gives to them itself, and sections that are not called after the program.

    Args:
        files: the sections of parameter files by path.
        own: names of packages with programs that are not those of the catalogue.
    """
    readers = [path for program in programs for path in program.parameters.files]
    for program in programs:
        kind = _kind(program)
        if not kind or program.package in own or not program.is_ros_2:
            continue
        if values := _given(program.parameters):
            yield NodeParameters(program.title, program.span, values, kind=kind)
        for path in program.parameters.files:
            for section in files.get(path, ()):
                is_own = section.name == program.name != kind
                if is_own or (section.name == _OF_ALL and readers.count(path) == 1):
                    yield section._replace(name=program.title, kind=kind)


def _kind(program: StartedProgram) -> str:
    """The program in the catalogue of parameters; empty if it is not there."""
    facts = data("node_parameters")
    kind: str = facts["programs"].get(program.key, "")
    return kind or (program.key if program.key in facts["nodes"] else "")


def _given(parameters: GivenParameters) -> dict[str, Node]:
    """The parameters in a launch file itself, as a file would contain them."""
    values: dict[str, Node] = {}
    for name, text in parameters.values.items():
        span = parameters.at.get(name)
        if text is None or span is None or name in parameters.lists:
            continue
        value = _value(text, span)
        *sections, last = name.split(".")
        owner = values
        for section in sections:
            inner = owner.setdefault(_key(section, value), {})
            owner = inner if isinstance(inner, dict) else {}
        owner[_key(last, value)] = value
    return values


def _key(name: str, value: Value) -> Key:
    key = Key(name)
    key.at = value
    return key


def _value(text: str, span: Span) -> Value:
    """A value of YAML at the place of an expression, as launch gives it to the node.

    A string of Python stays a string: it keeps its quotes. Launch parses an attribute of XML.
    """
    is_python = span.source.path.endswith(".py")
    is_converted = span.text.startswith("ParameterValue")
    trimmed = int(not is_python and span.text[:1] in ("'", '"') and span.end - span.start > 1)
    start, end = (
        span.source.position(offset) for offset in (span.start + trimmed, span.end - trimmed)
    )
    first, last = ((line - 1, column - 1) for line, column in (start, end))
    return Value(text, span.source, first, last, "converted" if is_converted else "")
