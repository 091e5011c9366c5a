"""Parser of xacro files, whose nodes have source locations."""

from xml.dom import XMLNS_NAMESPACE, expatbuilder
from xml.parsers import expat

from urdfkit.core.static_typing import Any
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import CallFrame, Tag
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import DocumentTooLarge, entity_problem, require_shallow_dtd
from urdfkit.xacro.budget import ELEMENT_SIZE, NODE_SIZE, Budget
from urdfkit.xacro.dom import TEXT, Attr, Dom, Node, Text

#: Most levels of elements, which xacro processes by recursion. Real robots have ten.
MAX_DEPTH = 500

# The stubs describe the DOM, not its internal attributes.
_StockBuilder: Any = expatbuilder.ExpatBuilderNS
_append_child: Any = vars(expatbuilder)["_append_child"]
_parse_ns_name: Any = vars(expatbuilder)["_parse_ns_name"]


def parse(
    source: Source, frame: CallFrame | None, budget: Budget
) -> tuple[Dom, list[Problem], list[Node]]:
    """Parse one xacro file.

    Returns:
        The DOM, the problems of the text, and the ``xacro:arg`` elements.

    Args:
        frame: the include that refers to it; None for the checked file.
        budget: of the run.

    Raises:
        DocumentTooLarge: it exceeds the budget.
        xml.parsers.expat.ExpatError: it is not well formed, or a prefix is not declared.
    """
    budget.charge(len(source.data))
    require_shallow_dtd(source.data)
    builder = _NodeBuilder(source, frame, budget)
    document = builder.parseString(source.data)
    return document, builder.problems, builder.arguments


class _NodeBuilder(_StockBuilder):  # type: ignore[misc]
    """The builder of ``minidom``, with nodes of urdfkit."""

    curNode: Any  # noqa: N815

    def __init__(self, source: Source, frame: CallFrame | None, budget: Budget) -> None:
        super().__init__()
        self._source = source
        self._frame = frame
        self._budget = budget
        self._starts: list[int] = []  # of the open elements
        self.problems: list[Problem] = []
        self.arguments: list[Node] = []

    def start_element_handler(self, name: str, attributes: list[str]) -> None:
        self._budget.charge(ELEMENT_SIZE + NODE_SIZE * (len(attributes) // 2))
        uri, _, prefix, tag = self._parsed(name)
        parent = self.curNode
        self.curNode = node = Node(tag, uri, prefix)
        node.ownerDocument = self.document
        _append_child(parent, node)
        node.raw = self._attributes(node, attributes)
        node.parent_start = self._starts[-1] if self._starts else -1
        self._starts.append(self._parser.CurrentByteIndex)
        node.frame = self._frame
        node.budget = self._budget
        if len(self._starts) > MAX_DEPTH:
            raise DocumentTooLarge(f"elements are nested more than {MAX_DEPTH} levels deep")
        if tag == "xacro:arg":
            self.arguments.append(node)

    def _attributes(self, node: Node, pairs: list[str]) -> list[str]:
        """Add the attributes to an element; returns names and values as written, alternating."""
        declared = self._ns_ordered_prefixes
        if declared or pairs:
            node._ensure_attributes()
        for prefix, uri in declared:
            name = f"xmlns:{prefix}" if prefix else "xmlns"
            local, own_prefix = (prefix, "xmlns") if prefix else ("xmlns", None)
            Attr(node, name, uri, XMLNS_NAMESPACE, local, own_prefix)
        declared.clear()
        raw: list[str] = []
        for number in range(0, len(pairs), 2):
            uri, local, prefix, name = self._parsed(pairs[number])
            value = pairs[number + 1]
            Attr(node, name, value, uri, local, prefix)
            raw += (name, value)
        return raw

    def _parsed(self, name: str) -> tuple[str | None, str | None, str | None, str]:
        """URI, local name, prefix and the name as written, of what expat says."""
        return _parse_ns_name(self, name) if " " in name else (None, None, None, name)

    def end_element_handler(self, name: str) -> None:
        node = self.curNode
        self.curNode = node.parentNode
        self._finish_end_element(node)
        start, end = self._starts.pop(), self._parser.CurrentByteIndex
        node.tag_at = Tag.between(self._source, start, end, empty=not node.childNodes)

    def character_data_handler_cdata(self, data: str) -> None:
        siblings = self.curNode.childNodes
        if self._cdata:
            super().character_data_handler_cdata(data)
        elif siblings and siblings[-1].nodeType == TEXT:
            siblings[-1].data += data
        else:
            _append_child(self.curNode, Text(data, self.document))
        text = siblings[-1]
        if "$" in data or getattr(text, "end_offset", None):
            text.end_offset = self._parser.CurrentByteIndex

    def comment_handler(self, data: str) -> None:
        self._budget.charge(NODE_SIZE)
        super().comment_handler(data)
        if "$" in data:
            comment = self.curNode.childNodes[-1]
            comment.end_offset = self._source.data.find(b"-->", self._parser.CurrentByteIndex)

    def pi_handler(self, target: str, data: str) -> None:
        self._budget.charge(NODE_SIZE)
        super().pi_handler(target, data)

    def start_cdata_section_handler(self) -> None:
        self._budget.charge(NODE_SIZE)
        super().start_cdata_section_handler()

    def entity_decl_handler(self, *declaration: Any) -> None:
        at = self._parser.CurrentByteIndex
        self.problems.append(entity_problem(self._source, at, declaration[0]))
        super().entity_decl_handler(*declaration)

    def createParser(self) -> Any:  # noqa: N802
        # Source has already applied the encoding of the declaration.
        parser = expat.ParserCreate("utf-8", namespace_separator=" ")
        parser.namespace_prefixes = True
        parser.buffer_size = 1 << 20  # the builder joins parts of a text one by one
        return parser
