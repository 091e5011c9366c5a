"""Completion inside of values and texts: ``${...}``, ``$(...)``, packages and their files."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from itertools import islice

from urdfkit.core.record import Record
from urdfkit.lsp.markup import Markup
from urdfkit.lsp.names import parameters
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.workspace.directories import Directories

#: Offered entries of a directory.
MAX_FILES = 500
_IN_EXPRESSION = re.compile(rb"\$\{[^}]*\Z")
_IN_COMMAND = re.compile(rb"\$\((\w*)(\s+)?[^)]*\Z")
_IN_PACKAGE = re.compile(rb"(?:package|model)://([\w-]+)/([^\"'<]*)\Z")
_PACKAGE_NAME = re.compile(rb"(?:package|model)://[\w-]*\Z")
_IN_FOUND = re.compile(rb"\$\(find\s+([\w-]+)\)/([^\"'<]*)\Z")
_COMMANDS = ("arg", "dirname", "env", "eval", "find", "optenv")
_BUILT_IN = ("pi", "radians", "degrees", "sin", "cos", "tan", "sqrt", "load_yaml", "True", "False")
_WORD = re.compile(rb"[\w.:/-]*\Z")
_MESHES = (".stl", ".dae", ".obj", ".ply", ".glb", ".gltf")
FILES = {
    "mesh": _MESHES,
    "texture": (".png", ".jpg", ".jpeg", ".bmp", ".tga"),
    "xacro:include": (".xacro", ".urdf", ".gazebo", ".xml"),
}


class CompletionItem(Record):
    """A completion."""

    text: str  # inserted text, and label
    kind: str  # ``tag``, ``attribute``, ``name``, ``word``, ``file``, ``directory`` or ``end``
    detail: str  # short description
    start: int  # offset of the replaced word, which ends at the cursor
    required: bool = False  # True for required elements and attributes, which are offered first


def in_text(
    robot: OpenRobot, markup: Markup, before: bytes, start: int
) -> Iterator[CompletionItem]:
    """Completions in ``${...}``, ``$(...)`` and package URIs; ``before`` begins at ``start``."""
    end = start + len(before)
    word = end - len(last_word(before))
    packages = robot.resolver.packages.known(markup.source.path)
    if _IN_EXPRESSION.search(before):
        yield from named_items(robot.defined("property"), "name", "property", word)
        yield from _macro_parameters(markup, end, word)
        yield from named_items(_BUILT_IN, "word", "built in", word)
    elif match := _IN_FOUND.search(before) or _IN_PACKAGE.search(before):
        directory = packages.get(match[1].decode("utf-8", "replace"))
        if directory:
            suffixes = (*_MESHES, *FILES["xacro:include"], *FILES["texture"], ".yaml")
            typed = match[2].decode("utf-8", "replace")
            yield from files_in(directory, typed, start + match.start(2), suffixes)
    elif match := _IN_COMMAND.search(before):
        yield from _command_arguments(robot, match, packages, word)
    elif match := _PACKAGE_NAME.search(before):
        for name in sorted(packages):
            yield CompletionItem(
                f"package://{name}/", "directory", "package", start + match.start()
            )


def _command_arguments(
    robot: OpenRobot, match: re.Match[bytes], packages: Iterable[str], word: int
) -> Iterator[CompletionItem]:
    if match[2] is None:
        yield from named_items(_COMMANDS, "word", "substitution", word)
    elif match[1] == b"arg":
        yield from named_items(robot.defined("arg"), "name", "argument", word)
    elif match[1] == b"find":
        yield from named_items(sorted(packages), "name", "package", word)


def _macro_parameters(markup: Markup, offset: int, word: int) -> Iterator[CompletionItem]:
    """The parameters of the macro around an offset."""
    node = markup.node_at(offset)
    for macro in (node, *node.ancestors()) if node else ():
        if macro.name == "xacro:macro":
            yield from named_items(parameters(macro), "name", "parameter", word)


def files_in(
    directory: str, typed: str, start: int, suffixes: tuple[str, ...]
) -> Iterator[CompletionItem]:
    """The files with some suffixes and the directories in a directory, one level at a time."""
    inner, _, _ = typed.rpartition("/")
    at = start + len(inner.encode()) + bool(inner)
    if os.path.isabs(inner) or ".." in inner.split("/"):
        return
    # Not from the cache: a file may have been created since the robot was read.
    entries = Directories().entries(os.path.join(directory, inner)) or {}
    matching = (
        (name, is_directory)
        for name, is_directory in sorted(entries.items())
        if not name.startswith(".") and (is_directory or name.lower().endswith(suffixes))
    )
    for name, is_directory in islice(matching, MAX_FILES):
        yield CompletionItem(
            f"{name}/" if is_directory else name, "directory" if is_directory else "file", "", at
        )


def named_items(
    names: Iterable[str], kind: str, detail: str, start: int
) -> Iterator[CompletionItem]:
    return (CompletionItem(name, kind, detail, start) for name in names)


def last_word(before: bytes) -> bytes:
    match = _WORD.search(before[-200:])
    return match.group() if match else b""
