"""The DOM of xacro, whose nodes have source locations.

xacro rewrites a ``minidom`` tree in place and copies parts of it with ``cloneNode``. Node is a
``minidom.Element`` with a location, which the parser sets and ``cloneNode`` copies.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from xml.dom import minidom

from urdfkit.core.static_typing import Any
from urdfkit.text.document import Attribute, CallFrame, Document, Element, Tag
from urdfkit.text.source import Source
from urdfkit.xacro.budget import ELEMENT_SIZE, Budget
from urdfkit.xacro.origin import Origin

ELEMENT = minidom.Node.ELEMENT_NODE
TEXT = minidom.Node.TEXT_NODE
COMMENT = minidom.Node.COMMENT_NODE
CDATA = minidom.Node.CDATA_SECTION_NODE

# minidom's stubs describe the DOM, not its internal attributes.
_StockElement: Any = minidom.Element
_StockAttr: Any = minidom.Attr
_StockText: Any = minidom.Text
_NodeList: Any = vars(minidom)["NodeList"]
Dom = Any  #: a ``minidom.Document`` whose elements are Nodes


class Attr(_StockAttr):  # type: ignore[misc]
    """An attribute, with name and value as plain attributes.

    ``minidom``'s class also creates a text node for every value, which is unused and takes most of
    the time.
    """

    nodeName = value = ""  # noqa: N815
    childNodes = _NodeList()  # noqa: N815 - the name of the DOM; always empty

    def __init__(
        self,
        owner: Node,
        name: str,
        value: str,
        uri: str | None = None,
        local: str | None = None,
        prefix: str | None = None,
    ) -> None:
        self.nodeName = self._name = name
        self.value = value
        self.namespaceURI, self._prefix = uri, prefix
        self._localName = local or name
        self.ownerElement, self.ownerDocument = owner, owner.ownerDocument
        owner._attrs[name] = owner._attrsNS[uri, self._localName] = self


class Text(_StockText):  # type: ignore[misc]
    """A text, with ``data`` as a plain attribute."""

    data = ""
    #: Offset of the end in the file, if the text contains a ``$``.
    end_offset: int | None = None

    def __init__(self, data: str = "", document: Any = None) -> None:
        self.data = data
        self.ownerDocument = document
        self.parentNode = self.previousSibling = self.nextSibling = None


class Node(_StockElement):  # type: ignore[misc]
    """An element of a xacro file.

    Attributes:
        tag_at: source location.
        parent_start: offset of the parent element in the file; -1 for a root.
        raw: names and values of its attributes as written, alternating.
        frame: the innermost macro call or include that led here.
        added: the ``<xacro:attribute>`` tags of attributes that were added, by name.
        traces: the names that the expressions of its attributes looked up, if the run is traced.
        budget: of the whole run.
        cursor: index of the child that was searched last.
    """

    tag_at: Tag
    parent_start: int
    raw: list[str]
    frame: CallFrame | None
    added: dict[str, Tag] | None = None
    traces: dict[str, tuple[Origin, ...]] | None = None
    budget: Budget
    cursor = 0

    def cloneNode(self, deep: bool) -> Any:  # noqa: N802 - the name of the DOM
        frame = self.frame
        if self.tagName == "xacro:macro":
            frame = self._frame_of_call()
            return _clone(self, frame, keep=False)
        if self.tagName == "xacro:property":
            # A property block: it belongs to the element that inserts it.
            inserter = sys._getframe(1).f_locals.get("node")
            frame = inserter.frame if isinstance(inserter, Node) else frame
            return _clone(self, frame, keep=False)
        return _clone(self, frame, keep=True)

    def _frame_of_call(self) -> CallFrame | None:
        """The frame of the call that xacro's ``handle_macro_call`` is expanding."""
        call = sys._getframe(2).f_locals.get("node")
        if not isinstance(call, Node):
            return self.frame
        name = call.tagName.removeprefix("xacro:")
        return CallFrame("macro", name, call.tag_at, self.tag_at, call.frame)

    def raw_attributes(self) -> dict[str, str]:
        """The values of its attributes by name, as written."""
        return dict(zip(self.raw[::2], self.raw[1::2], strict=True))

    @property
    def attributes(self) -> dict[str, str]:
        """The values of its attributes by name; xacro uses nothing else of ``attributes``."""
        return {name: attribute.value for name, attribute in (self._attrs or {}).items()}

    def removeAttribute(self, name: str) -> None:  # noqa: N802
        """Remove an attribute if it exists; ``minidom`` raises an error that xacro ignores."""
        if self._attrs and name in self._attrs:
            super().removeAttribute(name)

    def setAttribute(self, attname: str, value: Any) -> None:  # noqa: N802
        """Set an attribute to a text; ``<xacro:attribute>`` also passes the value of an expression.

        Raises:
            TypeError: the value is not a text: stock xacro fails when it writes the document, or
                writes nothing for 0.
        """
        if not isinstance(value, str):
            if value:
                kind = type(value).__name__
                raise TypeError(f"'{attname}' is a {kind}, which xacro cannot write: use str()")
            value = ""
        present = self._attrs.get(attname) if self._attrs else None
        if present is not None:
            present.value = value
            return
        self._note_definer(attname)
        super().setAttribute(attname, value)

    def _note_definer(self, name: str) -> None:
        definer = sys._getframe(2).f_locals.get("node")
        if isinstance(definer, Node) and definer.tagName == "xacro:attribute":
            self.added = {**(self.added or {}), name: definer.tag_at}


def _clone(node: Node, frame: CallFrame | None, *, keep: bool) -> Node:
    """A deep copy; with ``keep``, every node keeps its own frame instead of ``frame``.

    ``minidom``'s copy through ``setAttributeNS`` is five times slower.
    """
    size = ELEMENT_SIZE
    copy = Node(node.tagName, node.namespaceURI, node.prefix)
    copy.ownerDocument = node.ownerDocument
    copy.tag_at, copy.parent_start = node.tag_at, node.parent_start
    copy.raw, copy.budget = node.raw, node.budget
    copy.added, copy.traces = node.added, node.traces
    copy.frame = node.frame if keep else frame
    if node._attrs:
        copy._ensure_attributes()
        for name, old in node._attrs.items():
            Attr(copy, name, old.value, old.namespaceURI, old.localName, old.prefix)
            size += len(old.value or "")
    previous: Any = None
    for child in node.childNodes:
        copied: Any
        if child.nodeType == ELEMENT:
            copied = _clone(child, frame, keep=keep)
        else:
            copied = _clone_text(child) if type(child) is Text else child.cloneNode(True)
            size += len(child.data)
        copied.parentNode = copy
        copied.previousSibling = previous
        if previous is not None:
            previous.nextSibling = copied
        copy.childNodes.append(copied)
        previous = copied
    node.budget.charge(size)
    return copy


def _clone_text(text: Text) -> Text:
    copy = Text(text.data, text.ownerDocument)
    if text.end_offset is not None:
        copy.end_offset = text.end_offset
    return copy


def replace_node(node: Any, by: Any, content_only: bool = False) -> None:
    """xacro's ``replace_node``, in one step instead of one for every child.

    Args:
        by: the new node, a list of nodes, or None.
    """
    new = [] if by is None else by if isinstance(by, list) else [by]
    if content_only:
        containers, new = new, [child for container in new for child in container.childNodes]
        for container in containers:
            container.childNodes = _NodeList()
    else:
        for item in new:
            if item.parentNode is not None:
                item.parentNode.removeChild(item)
    parent = node.parentNode
    parent.budget.charge(1)
    at = _index(parent, node)
    parent.childNodes[at : at + 1] = new
    _link(node.previousSibling, new, node.nextSibling)
    for item in new:
        item.parentNode = parent
    node.parentNode = node.previousSibling = node.nextSibling = None


def _index(parent: Node, node: Any) -> int:
    """Index of a child; searched near the previous one first, as xacro works from left to right."""
    siblings = parent.childNodes
    start = max(parent.cursor - 8, 0)
    try:
        parent.cursor = siblings.index(node, start, start + 24)
    except ValueError:
        parent.cursor = siblings.index(node)
    return parent.cursor


def _link(before: Any, nodes: list[Any], after: Any) -> None:
    """Link nodes as siblings, in order."""
    previous = before
    for node in (*nodes, after):
        if node is not None:
            node.previousSibling = previous
        if previous is not None:
            previous.nextSibling = node
        previous = node


def remove_previous_comments(node: Any, marker: Any) -> None:
    """xacro's function of this name, in one step instead of one for every comment.

    Args:
        marker: an empty text that separates the comments from the next element.
    """
    comments: list[Any] = []
    previous = node.previousSibling
    while previous is not None:
        if _is_line_end(previous):
            previous = previous.previousSibling
        if previous is None or previous.nodeType != COMMENT:
            if node.nextSibling not in (None, marker):
                _insert_after(node, marker)
            break
        comments.append(previous)
        previous = previous.previousSibling
    if comments:
        _remove(comments, node)


def _insert_after(node: Any, marker: Any) -> None:
    if marker.parentNode is not None:
        replace_node(marker, None)
    parent = node.parentNode
    parent.childNodes.insert(_index(parent, node) + 1, marker)
    _link(node, [marker], node.nextSibling)
    marker.parentNode = parent


def _is_line_end(node: Any) -> bool:
    return bool(node.nodeType == TEXT and node.data.isspace() and node.data.count("\n") <= 1)


def _remove(nodes: list[Any], before: Any) -> None:
    """Remove preceding siblings of a node, which are in reverse order."""
    parent = before.parentNode
    parent.budget.charge(1)
    siblings = parent.childNodes
    end = _index(parent, before)
    start = end - 1
    while siblings[start] is not nodes[-1]:
        start -= 1
    removed = set(map(id, nodes))
    remaining = [node for node in siblings[start:end] if id(node) not in removed]
    siblings[start:end] = remaining
    _link(nodes[-1].previousSibling, remaining, before)
    for node in nodes:
        node.parentNode = node.previousSibling = node.nextSibling = None


def comments(dom: Dom) -> Iterator[str]:
    """The texts of all comments, unordered."""
    stack = [dom]
    while stack:
        for child in stack.pop().childNodes:
            if child.nodeType == COMMENT:
                yield child.data
            elif child.nodeType == ELEMENT:
                stack.append(child)


def to_document(dom: Dom, sources: tuple[Source, ...]) -> Document:
    root = _to_element(dom.documentElement, None)
    stack = [(dom.documentElement, root)]
    while stack:
        node, element = stack.pop()
        text: list[str] = []
        for child in node.childNodes:
            if child.nodeType == ELEMENT:
                inner = _to_element(child, element)
                element.children.append(inner)
                stack.append((child, inner))
            elif child.nodeType in (TEXT, CDATA):
                text.append(child.data)
        element.text = "".join(text)
    return Document(root, sources)


def _to_element(node: Node, parent: Element | None) -> Element:
    element = Element(node.tagName, node.tag_at, parent, node.frame)
    added = node.added or {}
    for name, attribute in (node._attrs or {}).items():
        element.attributes[name] = Attribute(name, attribute.value, element, added.get(name))
    return element
