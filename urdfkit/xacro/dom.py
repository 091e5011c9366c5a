"""The DOM that xacro works on, with nodes that know where they were written.

xacro rewrites a ``minidom`` tree in place and copies pieces of it with ``cloneNode``. Node is a
``minidom.Element`` whose place survives that: the parser sets it, ``cloneNode`` hands it on.
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

# minidom's stubs describe the DOM, not the attributes that its own code works with.
_StockElement: Any = minidom.Element
_StockAttr: Any = minidom.Attr
_StockText: Any = minidom.Text
_NodeList: Any = vars(minidom)["NodeList"]
Dom = Any  #: a ``minidom.Document`` whose elements are Nodes


class Attr(_StockAttr):  # type: ignore[misc]
    """An attribute: a name and a value, which are no properties.

    That of ``minidom`` has a text node for every value besides, which nothing uses and which
    takes most of the time.
    """

    nodeName = value = ""  # noqa: N815
    childNodes = _NodeList()  # noqa: N815 - the name of the DOM; there are none

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
    """A text, whose ``data`` is an attribute and no property."""

    data = ""
    #: Where in the file what comes behind it begins, if there is a ``$`` in it.
    ends: int | None = None

    def __init__(self, data: str = "", document: Any = None) -> None:
        self.data = data  # the text
        self.ownerDocument = document
        self.parentNode = self.previousSibling = self.nextSibling = None


class Node(_StockElement):  # type: ignore[misc]
    """An element of a xacro file.

    Attributes:
        tag_at: where it was written.
        around: where in the file the element around it begins; -1 for a root.
        raw: names and values of its attributes as written, alternating.
        frame: the innermost macro call or include that led here.
        given: attributes that an ``<xacro:attribute>`` gave it, with that tag.
        traces: what the expressions of its attributes looked up, if the run is traced.
        budget: what the whole expansion may make.
        cursor: number of the child that was looked for last.
    """

    tag_at: Tag
    around: int
    raw: list[str]
    frame: CallFrame | None
    given: dict[str, Tag] | None = None
    traces: dict[str, tuple[Origin, ...]] | None = None
    budget: Budget
    cursor = 0

    def cloneNode(self, deep: bool) -> Any:  # noqa: N802 - the name of the DOM
        frame = self.frame
        if self.tagName == "xacro:macro":
            frame = self._frame_of_call()
            return _clone(self, frame, keep=False)
        if self.tagName == "xacro:property":
            # A property block: it was written elsewhere and belongs to the place that inserts it.
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

    def written(self) -> dict[str, str]:
        """The values of its attributes by name, as written."""
        return dict(zip(self.raw[::2], self.raw[1::2], strict=True))

    @property
    def attributes(self) -> dict[str, str]:
        """The values of its attributes by name, which is all that xacro uses of them."""
        return {name: attribute.value for name, attribute in (self._attrs or {}).items()}

    def removeAttribute(self, name: str) -> None:  # noqa: N802
        """Take an attribute out if it is there; stock raises an error that xacro ignores."""
        if self._attrs and name in self._attrs:
            super().removeAttribute(name)

    def setAttribute(self, attname: str, value: str) -> None:  # noqa: N802
        value = str(value)  # stock xacro writes a number here and fails much later
        present = self._attrs.get(attname) if self._attrs else None
        if present is not None:
            present.value = value
            return
        self._note_giver(attname)
        super().setAttribute(attname, value)

    def _note_giver(self, name: str) -> None:
        giver = sys._getframe(2).f_locals.get("node")
        if isinstance(giver, Node) and giver.tagName == "xacro:attribute":
            self.given = {**(self.given or {}), name: giver.tag_at}


def _clone(node: Node, frame: CallFrame | None, *, keep: bool) -> Node:
    """A deep copy. ``keep``: every node keeps its own frame instead of taking ``frame``.

    ``minidom`` does the same five times slower, by way of ``setAttributeNS``.
    """
    size = ELEMENT_SIZE
    copy = Node(node.tagName, node.namespaceURI, node.prefix)
    copy.ownerDocument = node.ownerDocument
    copy.tag_at, copy.around = node.tag_at, node.around
    copy.raw, copy.budget = node.raw, node.budget
    copy.given, copy.traces = node.given, node.traces
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
    if text.ends is not None:
        copy.ends = text.ends
    return copy


def replace_node(node: Any, by: Any, content_only: bool = False) -> None:
    """xacro's ``replace_node``; by one step instead of one for every child.

    Args:
        by: a node or a list of nodes that come; None for none.
    """
    coming = [] if by is None else by if isinstance(by, list) else [by]
    if content_only:
        around, coming = coming, [child for one in coming for child in one.childNodes]
        for one in around:
            one.childNodes = _NodeList()
    else:
        for one in coming:
            if one.parentNode is not None:
                one.parentNode.removeChild(one)
    parent = node.parentNode
    parent.budget.charge(1)
    at = _index(parent, node)
    parent.childNodes[at : at + 1] = coming
    _link(node.previousSibling, coming, node.nextSibling)
    for one in coming:
        one.parentNode = parent
    node.parentNode = node.previousSibling = node.nextSibling = None


def _index(parent: Node, node: Any) -> int:
    """Where a child stands; near the one asked for before, as xacro works from left to right."""
    siblings = parent.childNodes
    start = max(parent.cursor - 8, 0)
    try:
        parent.cursor = siblings.index(node, start, start + 24)
    except ValueError:
        parent.cursor = siblings.index(node)
    return parent.cursor


def _link(before: Any, nodes: list[Any], after: Any) -> None:
    """Make nodes siblings, in their order."""
    previous = before
    for one in (*nodes, after):
        if one is not None:
            one.previousSibling = previous
        if previous is not None:
            previous.nextSibling = one
        previous = one


def remove_previous_comments(node: Any, marker: Any) -> None:
    """xacro's function of this name; by one step instead of one for every comment.

    Args:
        marker: an empty text that keeps the next element from taking those above.
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
        _take_out(comments, node)


def _insert_after(node: Any, marker: Any) -> None:
    if marker.parentNode is not None:
        replace_node(marker, None)
    parent = node.parentNode
    parent.childNodes.insert(_index(parent, node) + 1, marker)
    _link(node, [marker], node.nextSibling)
    marker.parentNode = parent


def _is_line_end(node: Any) -> bool:
    return bool(node.nodeType == TEXT and node.data.isspace() and node.data.count("\n") <= 1)


def _take_out(nodes: list[Any], before: Any) -> None:
    """Take out some of the nodes before a node, the last of which is the first in order."""
    parent = before.parentNode
    parent.budget.charge(1)
    siblings = parent.childNodes
    end = _index(parent, before)
    start = end - 1
    while siblings[start] is not nodes[-1]:
        start -= 1
    gone = set(map(id, nodes))
    kept = [one for one in siblings[start:end] if id(one) not in gone]
    siblings[start:end] = kept
    _link(nodes[-1].previousSibling, kept, before)
    for one in nodes:
        one.parentNode = one.previousSibling = one.nextSibling = None


def comments(dom: Dom) -> Iterator[str]:
    """The texts of all comments, in no particular order."""
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
    given = node.given or {}
    for name, attribute in (node._attrs or {}).items():
        element.attributes[name] = Attribute(name, attribute.value, element, given.get(name))
    return element
