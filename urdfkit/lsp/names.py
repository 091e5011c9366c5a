"""The names in the texts of a robot: definitions and references.

The index is built from the source text, so that it exists for a robot that cannot be expanded yet.
A name with an expression is identified by its values in the expanded document.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property
from html import unescape

from urdfkit.core.record import Record
from urdfkit.lsp.grammar import REFERRING_ELEMENTS, XACRO_TAGS, kind_of_reference, kind_of_text
from urdfkit.lsp.markup import Markup, TagNode
from urdfkit.ros.catalog import plugins
from urdfkit.text.document import Document
from urdfkit.text.source import Source, Span

#: Kinds of names. A ``frame`` is a link or a joint; a ``parameter`` belongs to a macro.
KINDS = ("link", "joint", "frame", "material", "macro", "property", "parameter", "arg", "package")

_EXPRESSION = re.compile(rb"\$\{([^}]*)\}?|\$\((\w+)\s+([^)]*)\)?")
#: A name in an expression, but no attribute and no keyword of a call.
_WORD = re.compile(rb"(?<![\w.'\"])[A-Za-z_]\w*(?!\w|\s*=(?!=))")
#: A property of a namespace, which ``<xacro:include ns="...">`` creates.
_MEMBER = re.compile(rb"(?<![\w.'\"])([A-Za-z_]\w*)\.([A-Za-z_]\w*)")
_QUOTED = re.compile(rb"'[^']*'|\"[^\"]*\"")
_PREFIX = b"xacro:"
_PACKAGE = re.compile(rb"\b(?:package|model)://([\w-]+)")
#: The argument of ``xacro.arg('name')``.
_ARGUMENT = re.compile(rb"\barg\(\s*['\"](\w+)['\"]")
#: A parameter of a macro; the second group is the ``^`` that forwards a property of its name.
_PARAMETER = re.compile(
    rb"""(?:^|(?<=\s))\**(\w+)(?:\s*:?=\s*(\^)?"""
    rb"""(?:\$\{[^}$]*\}|\$\([^)$]*\)|'[^'\n]*'|"[^"\n]*"|[^\s'"])*)?"""
)
_PLUGIN_WORD = re.compile(rb"[^\s,]+")

#: Kinds that may refer to the same thing.
_COMPATIBLE_KINDS = {
    "link": ("link", "frame"),
    "joint": ("joint", "frame"),
    "frame": ("link", "joint", "frame"),
    "material": ("material",),
}


class NameUse(Record):
    """An occurrence of a name."""

    kind: str  # one of ``KINDS``
    text: str  # as written
    span: Span  # the name
    is_definition: bool  # False for a reference
    node: TagNode  # the element that contains it
    attribute: str = ""  # name of the attribute whose whole value it is; empty otherwise
    #: For a parameter, path of the macro's file and offset of its start tag.
    macro: tuple[str, int] | None = None

    @property
    def is_computed(self) -> bool:
        return "$" in self.text


def _cursor_start(name: NameUse) -> int:
    """Offset from which a cursor is on a name; in a macro call, that of the prefix."""
    source, start, _ = name.span
    at = start - len(_PREFIX)
    return at if name.kind == "macro" and source.data.startswith(_PREFIX, max(at, 0)) else start


class NameIndex:
    """Index of the names in texts.

    Args:
        document: the expanded document; None if the expansion fails.
    """

    def __init__(self, markups: Iterable[Markup], document: Document | None) -> None:
        self.markups = {markup.source.path: markup for markup in markups}
        self._document = document

    @cached_property
    def macros(self) -> dict[str, TagNode]:
        """Macros by name; the last definition counts."""
        return {
            node.get("name").removeprefix("xacro:"): node
            for markup in self.markups.values()
            for node in markup.nodes
            if node.name == "xacro:macro"
        }

    @cached_property
    def _namespaces(self) -> set[bytes]:
        return {
            node.get("ns").encode()
            for markup in self.markups.values()
            for node in markup.nodes
            if node.name == "xacro:include"
        }

    @cached_property
    def all(self) -> tuple[NameUse, ...]:
        return tuple(
            name
            for markup in self.markups.values()
            for node in markup.nodes
            for name in self._in_node(node)
        )

    @cached_property
    def _values(self) -> dict[tuple[str, int, str], dict[str, None]]:
        """Values of attributes after expansion, by file, offset of the tag, and name."""
        values: dict[tuple[str, int, str], dict[str, None]] = {}
        for element in self._document.root.walk() if self._document else ():
            at = element.tag_at
            for attribute in element.attributes.values():
                key = (at.source.path, at.start, attribute.name)
                values.setdefault(key, {})[attribute.value] = None
        return values

    def at(self, source: Source, offset: int) -> NameUse | None:
        """The innermost name at an offset."""
        names = [
            name
            for name in self.all
            if name.span.source is source and _cursor_start(name) <= offset <= name.span.end
        ]
        return min(names, key=lambda name: name.span.end - name.span.start, default=None)

    def occurrences(self, name: NameUse) -> list[NameUse]:
        """All occurrences of the thing that a name refers to, including this one."""
        if name.kind in _COMPATIBLE_KINDS:
            values = self.values(name)
            kinds = _COMPATIBLE_KINDS[name.kind]
            same = [
                use
                for use in self.all
                if use.kind in kinds and not values.isdisjoint(self.values(use))
            ]
            return same if name.kind != "frame" else self._frames_resolved(same)
        return [
            use
            for use in self.all
            if (use.kind, use.text, use.macro) == (name.kind, name.text, name.macro)
        ]

    def _frames_resolved(self, names: list[NameUse]) -> list[NameUse]:
        """The names of links if a link is defined, else of joints, as Gazebo resolves them."""
        defined = {name.kind for name in names if name.is_definition}
        excluded = "joint" if "link" in defined or "joint" not in defined else "link"
        return [name for name in names if name.kind != excluded]

    def values(self, name: NameUse) -> set[str]:
        """The values of a name: the text, or the values of its expression."""
        if not name.is_computed:
            return {unescape(name.text)}
        return set(self.expanded(name.node, name.attribute)) or {name.text}

    def expanded(self, node: TagNode, attribute: str) -> list[str]:
        """The distinct values of an attribute after expansion, in the order of calls."""
        return list(self._values.get((node.source.path, node.start, attribute), ()))

    def defined(self, *kinds: str) -> list[str]:
        """Defined names of some kinds after expansion, sorted."""
        names: set[str] = set()
        for name in self.all:
            if name.is_definition and name.kind in kinds:
                names |= self.values(name)
        return sorted(text for text in names if text and "$" not in text)

    # ------------------------------------------------------------ one element

    def _in_node(self, node: TagNode) -> Iterator[NameUse]:
        own = node.name.removeprefix("xacro:")
        if node.name == "xacro:macro":
            yield from self._value(node, "macro", "name", is_definition=True, prefix="xacro:")
            yield from self._parameters(node)
        elif node.name in ("xacro:property", "xacro:arg"):
            yield from self._value(node, own, "name", is_definition=True)
        elif node.name == "xacro:insert_block":
            yield from self._inserted_block(node)
        elif node.name == "xacro:call":
            yield from self._value(node, "macro", "macro", is_definition=False)
            yield from self._arguments(node, node.get("macro"))
        elif node.name.startswith("xacro:") and node.name not in XACRO_TAGS:
            yield from self._call(node)
        else:
            yield from self._in_robot_element(node)
        for written in node.attributes:
            if written.value_span and not (node.name == "xacro:macro" and written.name == "name"):
                yield from self._in_text(node, written.value_span)
        yield from self._in_text(node, node.text_span)

    def _parameters(self, macro: TagNode) -> Iterator[NameUse]:
        written = macro.attribute("params")
        if not (written and written.value_span):
            return
        source, start, end = written.value_span
        for match in _PARAMETER.finditer(source.data[start:end]):
            span, forward = (
                Span(source, start + match.start(group), start + match.end(group))
                for group in (1, 2)
            )
            yield NameUse("parameter", span.text, span, True, macro, "", _id(macro))
            if match[2]:
                yield NameUse("parameter", span.text, forward, False, macro, "", _id(macro))
                yield self._variable(macro, span)._replace(span=forward)

    def _inserted_block(self, node: TagNode) -> Iterator[NameUse]:
        written = node.attribute("name")
        if written and written.value_span:
            yield self._variable(node, written.value_span)

    def _call(self, node: TagNode) -> Iterator[NameUse]:
        """The name of the macro in start tag and end tag, and the parameters that it sets."""
        for span in (node.name_span, node.end_name):
            if span:
                text = macro_name(span.text)
                at = Span(span.source, span.end - len(text.encode()), span.end)
                yield NameUse("macro", text, at, False, node)
        yield from self._arguments(node, macro_name(node.name))

    def _arguments(self, node: TagNode, name: str) -> Iterator[NameUse]:
        """The parameters that a call of a macro sets."""
        macro = self.macros.get(name)
        for written in node.attributes if macro else ():
            assert macro is not None
            yield NameUse("parameter", written.name, written.name_span, False, node, "", _id(macro))

    def _in_robot_element(self, node: TagNode) -> Iterator[NameUse]:
        user = node.ancestor(*REFERRING_ELEMENTS)
        if node.name in ("link", "joint") and node.attribute("name"):
            yield from self._value(node, node.name, "name", is_definition=user is None)
        elif node.name == "material" and node.attribute("name"):
            defined = any(child.name in ("color", "texture") for child in node.children)
            yield from self._value(node, "material", "name", is_definition=defined)
        for written in node.attributes:
            if kind := kind_of_reference(node, written.name):
                yield from self._value(node, kind, written.name, is_definition=False)
        if not node.children and node.text_span.text:
            yield from self._in_contents(node, node.text_span)

    def _value(
        self, node: TagNode, kind: str, attribute: str, *, is_definition: bool, prefix: str = ""
    ) -> Iterator[NameUse]:
        """The value of an attribute as a name, without a prefix."""
        written = node.attribute(attribute)
        if written and written.value_span and written.value:
            text = written.value.removeprefix(prefix)
            source, start, end = written.value_span
            span = Span(source, start + len(written.value) - len(text), end)
            yield NameUse(kind, text, span, is_definition, node, attribute)

    def _in_contents(self, node: TagNode, span: Span) -> Iterator[NameUse]:
        """The link or joint that a text refers to; in a Gazebo plugin perhaps several."""
        if kind := kind_of_text(node):
            yield NameUse(kind, span.text, span, False, node)
            return
        for _, parameter in plugin_parameters(node):
            if parameter.type in (*plugins.REFERENCES, "frame"):
                kind = "joint" if parameter.type.startswith("joint") else "link"
                for word in _PLUGIN_WORD.finditer(span.source.data, span.start, span.end):
                    at = Span(span.source, *word.span())
                    yield NameUse(kind, at.text, at, False, node)
                return

    def _in_text(self, node: TagNode, span: Span) -> Iterator[NameUse]:
        """The names in the expressions of a text, and its package names."""
        source, start, end = span
        for match in _PACKAGE.finditer(source.data, start, end):
            at = Span(source, *match.span(1))
            yield NameUse("package", at.text, at, False, node)
        for match in _EXPRESSION.finditer(source.data, start, end):
            command = match[2]
            at = Span(source, *match.span(1 if command is None else 3))
            if command in (b"arg", b"find"):
                yield NameUse("arg" if command == b"arg" else "package", at.text, at, False, node)
            elif command in (None, b"eval"):
                yield from self._in_expression(node, at, is_eval=command is not None)

    def _in_expression(self, node: TagNode, span: Span, *, is_eval: bool) -> Iterator[NameUse]:
        """The names in an expression; in ``$(eval ...)`` they are arguments."""
        source, start, end = span
        for name in _ARGUMENT.finditer(source.data, start, end):
            at = Span(source, *name.span(1))
            yield NameUse("arg", at.text, at, False, node)
        expression = source.data[start:end]
        masked = _QUOTED.sub(lambda quoted: b" " * len(quoted.group()), expression)
        for word in _WORD.finditer(masked):
            at = Span(source, start + word.start(), start + word.end())
            yield NameUse("arg", at.text, at, False, node) if is_eval else self._variable(node, at)
        for member in _MEMBER.finditer(masked):
            if member[1] in self._namespaces:
                at = Span(source, start + member.start(2), start + member.end(2))
                yield NameUse("property", at.text, at, False, node)

    def _variable(self, node: TagNode, span: Span) -> NameUse:
        """A word of an expression: a parameter of the enclosing macro, or else a property.

        Defaults of parameters are evaluated where the macro is called.
        """
        for macro in (node, *node.ancestors()):
            is_inside = macro.name == "xacro:macro" and span.start >= macro.tag_end
            if is_inside and span.text in parameters(macro):
                return NameUse("parameter", span.text, span, False, node, "", _id(macro))
        return NameUse("property", span.text, span, False, node)


def macro_name(tag: str) -> str:
    """The name of the macro that a tag calls, without ``xacro:`` and its namespaces."""
    return tag.removeprefix("xacro:").rpartition(".")[2]


def parameters(macro: TagNode) -> list[str]:
    return [match[1].decode() for match in _PARAMETER.finditer(macro.get("params").encode())]


def _id(macro: TagNode) -> tuple[str, int]:
    return (macro.source.path, macro.start)


def plugin_parameters(node: TagNode) -> Iterator[tuple[plugins.Plugin, plugins.Parameter]]:
    """The parameter that a tag in a plugin sets, for each plugin that reads it."""
    plugin = node.ancestor("plugin")
    if plugin is None:
        return
    for entry in plugins.find(plugin.get("filename").strip()):
        if parameter := entry.parameters.get(path_in(node, plugin)):
            yield entry, parameter


def path_in(node: TagNode, plugin: TagNode) -> str:
    """Path of a tag relative to its plugin."""
    parts = [node.name]
    for outer in node.ancestors():
        if outer is plugin:
            break
        parts.append(outer.name)
    return "/".join(reversed(parts))
