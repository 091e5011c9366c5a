"""``urdfkit trace``: the origin of a value."""

from collections.abc import Iterator
from typing import Any

import click

from urdfkit.cli import options, output, stdin
from urdfkit.cli.decorators import described
from urdfkit.cli.progress import working
from urdfkit.cli.robot import first_error, read_by_options, reading
from urdfkit.errors import UnreadableRobot
from urdfkit.lint.loading import require_robot_root
from urdfkit.text.document import Attribute, Element, Step
from urdfkit.text.source import Source, Span
from urdfkit.xacro.origin import Origin

#: Levels of definitions that are printed; real models need seven.
MAX_LEVELS = 20

#: Most characters of a tag that are shown: a macro call may have twenty arguments.
_MOST = 100


@described("trace")
@click.argument("file")
@click.argument("address", metavar="ELEMENT[@ATTRIBUTE]")
@click.argument("arguments", nargs=-1, metavar="[NAME:=VALUE]...")
@read_by_options
def command(file: str, address: str, arguments: tuple[str, ...], **values: Any) -> int:
    """Show the source of an element or a value of an expanded xacro.

    ELEMENT is a path below the robot such as link/base_link/inertial/inertia, as in findings.
    With @ATTRIBUTE the names in its expression are followed through macro arguments and
    properties down to the number, in a xacro or a YAML file.

    Exit codes: 0 done, 2 unknown element, or the file does not expand.

    Examples:
        urdfkit trace robot.urdf.xacro link/base_link
        urdfkit trace robot.urdf.xacro link/base_link/inertial/mass@value
    """
    from urdfkit.text.locations import NoSuchElement, find
    from urdfkit.workspace.resolve import Resolver
    from urdfkit.xacro import expand

    source = Source.of(stdin.opened(file))
    read = reading({**values, options.FILES: (file, *arguments)}, file)
    resolver = Resolver(read.packages)
    with working():
        xacro = expand(source, resolver, read.arguments, trust=read.trust, traced=True)
    if xacro.document is None:
        error = UnreadableRobot(f"{file} does not expand: {xacro.first_error}", xacro.problems)
        raise first_error(error, file)
    try:
        target = find(xacro.document, address)
    except NoSuchElement:
        require_robot_root(xacro.document.root, source.path)
        raise
    inputs = xacro.inputs(target) if isinstance(target, Attribute) else ()
    output.page(render(target, inputs))
    return 0


def render(target: Element | Attribute, inputs: tuple[Origin, ...]) -> Iterator[str]:
    """The lines with the origin of an element or attribute."""
    if isinstance(target, Attribute):
        yield f"{target.path} = {target.value}"
        yield f'  {target.span}  {target.name}="{target.span.text}"'
    else:
        yield target.path
        yield f"  {target.span}  {_one_line(target.span)}"
    for origin in _without_tables(inputs):
        yield from _origin(origin, 2)
    yield from _calls(target.via)


def _origin(origin: Origin, level: int) -> Iterator[str]:
    place = f"  {origin.span}" if origin.span else ""
    yield f"{'  ' * level}{origin.name} = {origin.value}  ({origin.kind}){place}"
    if origin.text and origin.text != origin.value:
        yield f"{'  ' * level}    {' '.join(origin.text.split())}"
    if level < MAX_LEVELS:
        for deeper in _without_tables(origin.inputs):
            yield from _origin(deeper, level + 1)


def _without_tables(inputs: tuple[Origin, ...]) -> Iterator[Origin]:
    """The inputs without the tables that contain a YAML value among them."""
    from_yaml = any(origin.kind == "YAML" for origin in inputs)
    for origin in inputs:
        if not (from_yaml and origin.value.startswith(("{", "["))):
            yield origin


def _calls(via: tuple[Step, ...]) -> Iterator[str]:
    for step in reversed(via):
        verb = "included" if step.kind == "include" else "called"
        yield f"  {verb} at {step.span}  {_one_line(step.span)}"


def _one_line(span: Span) -> str:
    text = " ".join(span.text.split())
    return text if len(text) <= _MOST else f"{text[:_MOST]}..."
