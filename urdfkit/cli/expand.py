"""``urdfkit expand``: the ``xacro`` command without ROS."""

import os
from collections.abc import Iterator
from functools import partial
from typing import Any

import click

from urdfkit.cli import output, stdin
from urdfkit.cli.decorators import described, option, to_file
from urdfkit.cli.progress import working
from urdfkit.cli.robot import one_robot, only_file, reading
from urdfkit.core import atomic
from urdfkit.lint.rule_index import get
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.source import STANDARD_INPUT, Source
from urdfkit.xacro import Xacro

#: An option of the ``xacro`` command that has no effect here.
_IGNORED = partial(
    click.option,
    expose_value=False,
    show_default=False,
    help="Accepted for compatibility with xacro.",
)


@described("expand")
@one_robot
@to_file("target", "Write to FILE instead of standard output.")
@option("--deps", "Print the files that it depends on, and nothing else.")
@option("--map FILE", "Write the source location of every element as JSON.", to="map_file")
@option("--root-dir DIRECTORY", "Directory that relative paths start from.", default=os.curdir)
@option("-q, --quiet", "Do not print warnings.")
@_IGNORED("-v", count=True)
@option("--verbosity LEVEL", "0 is the same as -q, as in xacro.", type=int)
@_IGNORED("-i", "--inorder", is_flag=True)
def command(
    inputs: dict[str, Any],
    target: str | None,
    deps: bool,
    map_file: str | None,
    root_dir: str,
    quiet: bool,
    verbosity: int | None,
) -> int:
    """Expand a xacro file, as the xacro command does, without ROS.

    The output equals that of xacro byte for byte. All errors of a file are reported, each at its
    source line. --map writes JSON: the file, line and column of every element of the output, and
    the macro calls and includes that it comes from; '-' writes it to standard output instead of
    the model.

    Exit codes: 0 done, 2 usage or input error, 3 internal error (a bug in urdfkit).

    Examples:
        urdfkit expand robot.urdf.xacro prefix:=left_ -o robot.urdf
        urdfkit expand robot.urdf.xacro --map -
    """
    from urdfkit.workspace.resolve import Resolver
    from urdfkit.xacro import expand

    file = only_file(inputs)
    source = _read(file, root_dir)
    read = reading(inputs, file if file == "-" else os.path.join(root_dir, file))
    with working():
        xacro = expand(
            source, Resolver(read.packages), read.arguments, trust=read.trust, root_dir=root_dir
        )
    error = _error(xacro)
    _print_notes(xacro, error, quiet=quiet or verbosity == 0)
    if error is not None:
        return 2
    if map_file is not None:
        _write_map(xacro, map_file)
    if map_file != "-":
        text = " ".join(xacro.dependencies) if deps else xacro.text()
        _write(text, target)
    return 0


def _read(file: str, root_dir: str) -> Source:
    if file == "-":
        return stdin.read(STANDARD_INPUT)
    if root_dir == os.curdir:
        return Source.read(file)
    source = Source.read(os.path.join(root_dir, file))
    source.path = file  # the banner contains the path as the user typed it
    return source


def _error(xacro: Xacro) -> str | None:
    """The error that xacro stops with.

    Only checks use a default after the argument's use, and read on behind a byte that is no text.
    """
    early = (problem.argument for problem in xacro.problems if problem.code == "XAC020")
    if (name := next(early, None)) is not None:
        return f"Undefined substitution argument {name}"
    not_text = (
        problem.message
        for problem in xacro.problems
        if problem.code == "XML002" and problem.span.source.undecodable is not None
    )
    return xacro.first_error or next(not_text, None)


def _print_notes(xacro: Xacro, error: str | None, *, quiet: bool) -> None:
    """Print warnings, and errors with their locations, to standard error."""
    for message in () if quiet else xacro.messages:
        where = f" ({message.span})" if message.span else ""
        kind = f"{message.kind}: " if message.kind else ""
        output.log(f"{kind}{message.text}{where}")
    if error is None:
        return
    output.log(*f"error: {error}".split("\n"))  # with the line breaks of xacro
    for problem in _errors(xacro):
        output.log(f"{problem.span}: {problem.code} {problem.message}")
        steps = problem.frame.steps() if problem.frame else ()
        for step in reversed(steps):
            output.log(f"  in {step.kind} {step.name}, called at {step.span}")
        for related in problem.related:
            output.log(f"  {related.span}: {related.message}")
        if problem.help:
            output.log(f"  help: {problem.help}")


def _errors(xacro: Xacro) -> Iterator[Problem]:
    """The distinct errors; warnings were printed in the words of xacro."""
    reported = set()
    for problem in xacro.problems:
        key = (problem.code, problem.span, problem.message)
        is_error = get(problem.code).severity is Severity.ERROR
        if is_error and key not in reported:
            reported.add(key)
            yield problem


def _write_map(xacro: Xacro, file: str) -> None:
    import json

    from urdfkit.text.locations import place_map

    assert xacro.document is not None
    text = json.dumps(place_map(xacro.document), indent=1, ensure_ascii=False) + "\n"
    _write(text, None if file == "-" else file)


def _write(text: str, target: str | None) -> None:
    if target is None:
        output.write(text)
        return
    directory = os.path.dirname(target)
    if directory:
        atomic.make_directory(directory)  # as xacro does
    atomic.write(target, output.encode(text))
