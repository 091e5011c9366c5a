"""Completion: tags, attributes, names, packages and their files, plugins."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from urdfkit.lsp.completion_in_text import (
    FILES,
    CompletionItem,
    files_in,
    in_text,
    last_word,
    named_items,
)
from urdfkit.lsp.grammar import REFERRING_ELEMENTS, XACRO_TAGS, grammar_of, kind_of_reference
from urdfkit.lsp.markup import Cursor, Markup, TagNode, cursor
from urdfkit.lsp.names import macro_name, parameters, path_in, plugin_parameters
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.ros.catalog import extensions, materials, plugins, sensors
from urdfkit.text.schema import JOINT, JOINT_TYPES, LINK

_BOOLEANS = ("true", "false")


def complete(robot: OpenRobot, markup: Markup, offset: int) -> list[CompletionItem]:
    """All completions at an offset, not filtered by the typed prefix."""
    if markup.source.path.endswith(".py"):
        return []  # a launch file: '<' is not a tag
    here = cursor(markup, offset)
    node = here.node
    if node is None:
        return []
    items: Iterable[CompletionItem] = ()
    if here.place == "tag":
        items = _tags(robot, node)
    elif here.place == "end":
        start = markup.end_name_at(offset) or offset
        items = [CompletionItem(node.name, "tag", "end tag", start)]
    elif here.place == "attribute":
        items = _attributes(robot, here, node)
    elif here.place in ("value", "text"):
        items = _values_or_text(robot, markup, here, node)
    return list({item.text: item for item in items}.values())


def _values_or_text(
    robot: OpenRobot, markup: Markup, here: Cursor, node: TagNode
) -> Iterable[CompletionItem]:
    """Completions in the value of an attribute, or in the text of an element."""
    value = here.attribute.value_span if here.attribute else None
    start = value.start if value else node.tag_end
    before = markup.source.data[: here.offset]
    if items := list(in_text(robot, markup, before[start:], start)):
        return items
    if here.place == "text":
        return _contents(robot, node, here.offset - len(last_word(before)))
    typed = before[start:].decode("utf-8", "replace")
    return _values(robot, node, here.attribute.name, typed, start) if here.attribute else ()


# ----------------------------------------------------------------------- tags


def _tags(robot: OpenRobot, node: TagNode) -> Iterator[CompletionItem]:
    start = node.start + 1
    for name, detail, required in _children(robot, node.parent):
        yield CompletionItem(name, "tag", detail, start, required)
    if node.parent:
        yield CompletionItem(f"/{node.parent.name}>", "end", "end tag", start)


def _children(robot: OpenRobot, parent: TagNode | None) -> Iterator[tuple[str, str, bool]]:
    """Name, detail and necessity of the elements that are allowed in an element."""
    if parent is None:
        yield "robot", "the description", True
        return
    grammar = grammar_of(parent)
    present = {child.name for child in parent.children}
    for name in grammar.children if grammar else ():
        required = name in grammar.required and name not in present if grammar else False
        yield name, "required" if required else "", required
    yield from ((name, detail, False) for name, detail in _in_gazebo(parent))
    if b"xmlns:xacro" in parent.source.data or robot.path.endswith(".xacro"):
        for name in XACRO_TAGS:
            yield name, "xacro", False
        for name, macro in sorted(robot.names.macros.items()):
            yield f"xacro:{name}", " ".join(parameters(macro)), False


def _in_gazebo(parent: TagNode) -> Iterator[tuple[str, str]]:
    """The elements that are allowed in a ``<gazebo>`` block, a plugin or a sensor."""
    plugin = parent if parent.name == "plugin" else parent.ancestor("plugin")
    if plugin is not None:
        yield from _parameters(parent, plugin)
    elif parent.name == "gazebo":
        for name, extension in sorted(extensions.extensions().items()):
            yield name, f"{extension.type} {extension.unit}".strip()
        kind = "link" if parent.get("reference") else "model"
        for name in extensions.copied(kind):
            yield name, "SDF"
    elif parent.name == "sensor":
        for name in sorted(sensors.children()):
            yield name, "SDF"


def _parameters(parent: TagNode, plugin: TagNode) -> Iterator[tuple[str, str]]:
    """The parameters that a plugin reads in an element."""
    prefix = "" if parent is plugin else f"{path_in(parent, plugin)}/"
    for entry in plugins.find(plugin.get("filename").strip()):
        for path, parameter in entry.parameters.items():
            rest = path.removeprefix(prefix)
            if not path.startswith(prefix) or rest.startswith("@"):
                continue
            default = f" = {parameter.default}" if parameter.default else ""
            yield rest.partition("/")[0], f"{parameter.type}{default} ({entry.generation})"


# ----------------------------------------------------------------- attributes


def _attributes(robot: OpenRobot, here: Cursor, node: TagNode) -> Iterator[CompletionItem]:
    start = here.attribute.name_span.start if here.attribute else _word_start(node, here.offset)
    present = {written.name for written in node.attributes if written is not here.attribute}
    for name, detail, required in _attributes_of(robot, node):
        if name not in present:
            yield CompletionItem(name, "attribute", detail, start, required)


def _attributes_of(robot: OpenRobot, node: TagNode) -> Iterator[tuple[str, str, bool]]:
    macro = robot.names.macros.get(macro_name(node.name))
    if node.name in XACRO_TAGS:
        yield from ((name, "xacro", False) for name in XACRO_TAGS[node.name])
    elif macro is not None and node.name.startswith("xacro:"):
        yield from ((name, "parameter", True) for name in parameters(macro))
    elif grammar := grammar_of(node):
        for name, rule in grammar.attributes.items():
            yield name, rule.type, rule.required
    elif node.name == "gazebo":
        yield "reference", "a link or a joint", False
    elif node.name == "plugin":
        yield "name", "", True
        yield "filename", "the library", True
    elif node.name == "sensor":
        yield "name", "", True
        yield "type", "", True


# --------------------------------------------------------------------- values


def _values(
    robot: OpenRobot, node: TagNode, attribute: str, typed: str, start: int
) -> Iterator[CompletionItem]:
    """Names, words and files that an attribute may have as its value, which begins at ``start``."""
    for text, detail in _words(robot, node, attribute):
        yield CompletionItem(text, "name", detail, start)
    if attribute == "filename" and node.name in FILES:
        for name in sorted(robot.resolver.packages.known(node.source.path)):
            yield CompletionItem(f"package://{name}/", "directory", "package", start)
        directory = os.path.dirname(os.path.abspath(node.source.path))
        yield from files_in(directory, typed, start, FILES[node.name])


def _words(robot: OpenRobot, node: TagNode, attribute: str) -> Iterator[tuple[str, str]]:
    """The words that an attribute may have, and a detail of each."""
    for kind in _kinds_of_names(node, attribute):
        yield from ((name, kind) for name in robot.defined(kind))
    key = (node.name, attribute)
    if key == ("joint", "type"):
        yield from ((name, "") for name in JOINT_TYPES)
    elif key == ("sensor", "type"):
        yield from ((name, "sensor") for name in sorted(sensors.types()))
    elif key == ("plugin", "filename"):
        for plugin in plugins.all_plugins():
            yield from ((file, plugin.generation) for file in plugin.files)


def _kinds_of_names(node: TagNode, attribute: str) -> tuple[str, ...]:
    """What an attribute refers to by name, such as links."""
    key = (node.name, attribute)
    if key == ("material", "name"):
        return ("material",)
    if key in (("link", "name"), ("joint", "name")) and node.ancestor(*REFERRING_ELEMENTS):
        return (node.name,)
    kind = kind_of_reference(node, attribute)
    return (LINK, JOINT) if kind == "frame" else (kind,)


def _contents(robot: OpenRobot, node: TagNode, start: int) -> Iterator[CompletionItem]:
    """The text of an element: names that a plugin refers to, Gazebo materials, booleans."""
    if node.name == "material" and node.parent and node.parent.name == "gazebo":
        for name in sorted(materials.materials()):
            yield CompletionItem(f"Gazebo/{name.removeprefix('Gazebo/')}", "word", "", start)
    if node.ancestor("plugin") is None:
        extension = extensions.extensions().get(node.name)
        if extension and extension.type == "bool":
            yield from named_items(_BOOLEANS, "word", "", start)
    for entry, parameter in plugin_parameters(node):
        if parameter.type in ("link", "frame"):
            yield from named_items(robot.defined("link"), "name", "link", start)
        elif parameter.type.startswith("joint"):
            yield from named_items(robot.defined("joint"), "name", "joint", start)
        elif parameter.type == "bool":
            yield from named_items(_BOOLEANS, "word", "", start)
        numbers = [str(number) for number, _ in enumerate(parameter.words)]
        words = numbers if parameter.type == "int" else parameter.words
        yield from named_items(words, "word", entry.generation, start)


def _word_start(node: TagNode, offset: int) -> int:
    return offset - len(last_word(node.source.data[node.start : offset]))
