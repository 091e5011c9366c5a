"""Links and joints that other files of a robot's package name: YAML of controllers, launch files.

Only places count of which it is plain what they name, and files of which it is plain whose they
are: where another robot of the package has the same name, nothing is known.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Collection, Iterator

from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lsp.markup import Page
from urdfkit.text import python_source
from urdfkit.text.located_yaml import Key, Value, load
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: Keys of YAML and names of parameters whose values are joints or links.
_JOINTS, _LINKS = re.compile(r"joint|wheel"), re.compile(r"frame|link")
#: Keys whose keys are joints: of controllers, of MoveIt, of ros2_control's mock hardware.
_BY_JOINT = re.compile(r"joint_limits|gains|constraints|initial_positions|default_positions")
#: The program whose arguments are frames.
_PUBLISHER = "static_transform_publisher"

_YAML, _ROBOTS = (".yaml", ".yml"), (".urdf", ".xacro")
_LAUNCH, _PYTHON = (".launch", ".launch.xml"), ".launch.py"
#: Files of a package that are looked at, and directories in one another.
MAX_FILES, MAX_DEPTH = 300, 4


class NameReference(Record):
    """One place that names a link or joint."""

    kind: str  # ``link`` or ``joint``
    span: Span  # the name


def package_references(
    names: Collection[str], robot: str, own: Collection[str], resolver: Resolver
) -> list[NameReference]:
    """Where the package of a robot names a link or a joint outside of the robot's own files.

    Args:
        names: of the link or joint, after expansion.
        own: real paths of the files it is made of.
    """
    package = resolver.packages.enclosing(robot)
    if package is None:
        return []
    words = [name.encode() for name in names]
    found: list[NameReference] = []
    for path in _files(package[1], resolver):
        if os.path.realpath(path) in own:
            continue
        try:
            source = resolver.read(path)
        except UrdfkitError:
            continue
        if not any(word in source.data for word in words):
            continue
        if path.endswith(_ROBOTS):
            return []
        found += [one for one in _in_file(source) if one.span.text in names]
    return found


def reference_at(source: Source, offset: int) -> NameReference | None:
    """The place in a file of YAML or a launch file; None elsewhere, and in other files."""
    if not source.path.endswith((*_YAML, *_LAUNCH, _PYTHON)):
        return None
    found = (one for one in _in_file(source) if one.span.start <= offset <= one.span.end)
    return next(found, None)


def _files(directory: str, resolver: Resolver) -> Iterator[str]:
    """The files of a package that may name something, up to a number."""
    count, queue = 0, [(directory, 0)]
    for place, depth in queue:  # grows while it is walked
        for name, is_directory in sorted((resolver.directories.entries(place) or {}).items()):
            path = os.path.join(place, name)
            if is_directory and depth < MAX_DEPTH and not name.startswith("."):
                queue.append((path, depth + 1))
            elif name.endswith((*_YAML, *_LAUNCH, *_ROBOTS, _PYTHON)) and count < MAX_FILES:
                count += 1
                yield path


def _in_file(source: Source) -> Iterator[NameReference]:
    if source.path.endswith(_YAML):
        return _in_yaml(source)
    return _in_python(source) if source.path.endswith(_PYTHON) else _in_launch(source)


def _kind(key: str) -> str:
    """What the value of a key or parameter names; empty if that is not known."""
    if _JOINTS.search(key):
        return "joint"
    return "link" if _LINKS.search(key) else ""


def _in_yaml(source: Source) -> Iterator[NameReference]:
    stem = os.path.basename(source.path).partition(".")[0]
    stack = [(load(source), stem)]
    while stack:
        node, key = stack.pop()
        if isinstance(node, dict):
            for inner, value in node.items():
                if isinstance(inner, Key) and _BY_JOINT.search(key):
                    yield NameReference("joint", _bare(inner.span))
                stack.append((value, inner))
        elif isinstance(node, list):
            stack += [(value, key) for value in node]
        elif isinstance(node, Value) and (kind := _kind(key)):
            yield NameReference(kind, _bare(node.span))


def _in_launch(source: Source) -> Iterator[NameReference]:
    for node in Page(source).nodes:
        value, args = node.attribute("value"), node.attribute("args")
        if node.name == "param" and value and value.value_span:
            if kind := _kind(node.get("name")):
                yield NameReference(kind, value.value_span)
        elif args and args.value_span and _PUBLISHER in (node.get("exec"), node.get("type")):
            span = args.value_span
            for word in re.finditer(rb"\S+", source.data[span.start : span.end]):
                at = Span(source, span.start + word.start(), span.start + word.end())
                yield NameReference("link", at)


def _in_python(source: Source) -> Iterator[NameReference]:
    try:
        tree = python_source.parse(source.data)
    except SyntaxError:
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            for key, value in zip(node.keys, node.values, strict=True):
                if kind := _kind(python_source.string(key) or ""):
                    yield from _strings(source, kind, value)
        elif isinstance(node, ast.Call):
            given = {keyword.arg: keyword.value for keyword in node.keywords}
            if python_source.string(given.get("executable")) == _PUBLISHER:
                yield from _strings(source, "link", given.get("arguments"))


def _strings(source: Source, kind: str, value: ast.expr | None) -> Iterator[NameReference]:
    """A string, or those of a list."""
    for one in value.elts if isinstance(value, ast.List | ast.Tuple) else [value]:
        if one is not None and python_source.string(one) and one.end_lineno is not None:
            start = source.offset(one.lineno, 1) + one.col_offset
            end = source.offset(one.end_lineno, 1) + (one.end_col_offset or 0)
            yield NameReference(kind, _bare(Span(source, start, end)))


def _bare(span: Span) -> Span:
    """A scalar or a string without its quotes."""
    source, start, end = span
    quote = source.data[start : start + 1]
    is_quoted = end - start > 1 and quote in (b"'", b'"') and source.data[end - 1 : end] == quote
    return Span(source, start + 1, end - 1) if is_quoted else span
