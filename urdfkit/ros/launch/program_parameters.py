"""The parameters of programs whose parameters are known, whatever their nodes are called."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import GivenParameters, StartedProgram
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value
from urdfkit.text.source import Span

#: Sections of a file that every node reads.
_OF_ALL = "**"


def parameters_of_programs(
    programs: tuple[StartedProgram, ...], files: Mapping[str, list[NodeParameters]]
) -> Iterator[NodeParameters]:
    """What a launch file gives to them itself, and sections that are not called after the program.

    Args:
        files: the sections of parameter files by path.
    """
    readers = [path for program in programs for path in program.parameters.files]
    for program in programs:
        kind = _kind(program)
        if not kind or not program.is_ros_2:
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
    name = f"{program.package}/{program.executable}"
    kind: str = facts["programs"].get(name, "")
    return kind or (name if name in facts["nodes"] else "")


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
    """A value of YAML at the place of an expression; launch parses the text of a string, too."""
    is_converted = span.text.startswith("ParameterValue")
    trimmed = int(span.text[:1] in ("'", '"') and span.end - span.start > 1)
    start, end = (
        span.source.position(offset) for offset in (span.start + trimmed, span.end - trimmed)
    )
    first, last = ((line - 1, column - 1) for line, column in (start, end))
    return Value(text, span.source, first, last, "converted" if is_converted else "")
