"""References to links and joints in other files of a package: controller YAML, launch files.

Only unambiguous references count, and only in packages without another robot of the same names.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Collection, Iterator

from urdfkit.core.record import Record
from urdfkit.lsp.markup import Markup
from urdfkit.text import python_source
from urdfkit.text.located_yaml import Key, Value, load
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: YAML keys and parameter names whose values are joints or links.
_JOINTS, _LINKS = re.compile(r"joint|wheel"), re.compile(r"frame|link")
#: Keys whose children are keyed by joint: of controllers, MoveIt, and ros2_control's mock hardware.
_BY_JOINT = re.compile(r"joint_limits|gains|constraints|initial_positions|default_positions")
_WORD = re.compile(rb"\S+")
#: The executable whose arguments are frames.
_PUBLISHER = "static_transform_publisher"

_YAML, _ROBOTS = (".yaml", ".yml"), (".urdf", ".xacro")
_LAUNCH, _PYTHON = (".launch", ".launch.xml"), ".launch.py"
#: Limits of the files of a package that are read, and of the depth of directories.
MAX_FILES, MAX_DEPTH = 300, 4


class NameReference(Record):
    """A reference to a link or joint."""

    kind: str  # ``link`` or ``joint``
    span: Span  # the name


def package_references(
    names: Collection[str], robot: str, own: Collection[str], resolver: Resolver
) -> list[NameReference]:
    """References to a link or joint in the robot's package outside of the robot's files.

    Args:
        names: of the link or joint, after expansion.
        own: real paths of the robot's files.
    """
    package = resolver.packages.enclosing(robot)
    if package is None:
        return []
    words = [name.encode() for name in names]
    references: list[NameReference] = []
    for path in _files(package[1], resolver):
        if os.path.realpath(path) in own:
            continue
        source = resolver.readable(path)
        if source is None or not any(word in source.data for word in words):
            continue
        if path.endswith(_ROBOTS):
            return []
        references += [reference for reference in _in_file(source) if reference.span.text in names]
    return references


def reference_at(source: Source, offset: int) -> NameReference | None:
    """The reference at an offset in a YAML or launch file; None elsewhere."""
    if not source.path.endswith((*_YAML, *_LAUNCH, _PYTHON)):
        return None
    candidates = (
        reference
        for reference in _in_file(source)
        if reference.span.start <= offset <= reference.span.end
    )
    return next(candidates, None)


def _files(directory: str, resolver: Resolver) -> Iterator[str]:
    """The files of a package that may contain references, up to `MAX_FILES`."""
    count, queue = 0, [(directory, 0)]
    for parent, depth in queue:  # appended to in the loop
        for name, is_directory in sorted((resolver.directories.entries(parent) or {}).items()):
            path = os.path.join(parent, name)
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
    """Kind of the value of a key or parameter; empty if unknown."""
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
                    yield NameReference("joint", _unquoted(inner.span))
                stack.append((value, inner))
        elif isinstance(node, list):
            stack += [(value, key) for value in node]
        elif isinstance(node, Value) and (kind := _kind(key)):
            yield NameReference(kind, _unquoted(node.span))


def _in_launch(source: Source) -> Iterator[NameReference]:
    for node in Markup(source).nodes:
        value, args = node.attribute("value"), node.attribute("args")
        if node.name == "param" and value and value.value_span:
            if kind := _kind(node.get("name")):
                yield NameReference(kind, value.value_span)
        elif args and args.value_span and _PUBLISHER in (node.get("exec"), node.get("type")):
            span = args.value_span
            for word in _WORD.finditer(source.data, span.start, span.end):
                yield NameReference("link", Span(source, *word.span()))


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
            arguments = {keyword.arg: keyword.value for keyword in node.keywords}
            if python_source.string(arguments.get("executable")) == _PUBLISHER:
                yield from _strings(source, "link", arguments.get("arguments"))


def _strings(source: Source, kind: str, value: ast.expr | None) -> Iterator[NameReference]:
    """The references in a string or a list of strings."""
    for item in value.elts if isinstance(value, ast.List | ast.Tuple) else [value]:
        if item is not None and python_source.string(item) and item.end_lineno is not None:
            start = source.offset(item.lineno, 1) + item.col_offset
            end = source.offset(item.end_lineno, 1) + (item.end_col_offset or 0)
            yield NameReference(kind, _unquoted(Span(source, start, end)))


def _unquoted(span: Span) -> Span:
    """The span of a scalar or string without quotes."""
    source, start, end = span
    quote = source.data[start : start + 1]
    is_quoted = end - start > 1 and quote in (b"'", b'"') and source.data[end - 1 : end] == quote
    return Span(source, start + 1, end - 1) if is_quoted else span
