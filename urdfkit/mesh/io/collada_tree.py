"""The elements of a COLLADA file by tag and by id."""

from collections.abc import Iterator
from typing import Any, TypeAlias
from urllib.parse import unquote

from lxml import etree

from urdfkit.mesh.geometry import NoTriangles
from urdfkit.mesh.io.collada import ENTITIES, declares_entities, forgive

Element: TypeAlias = Any  # lxml has no types

#: libxml2 rejects longer texts unless `huge_tree` is set, which disables other checks, too.
_LONG_TEXT = 10_000_000


class ColladaTree:
    """A COLLADA file."""

    def __init__(self, data: bytes, *, recover: bool = False) -> None:
        self.root = parse(data, recover=recover)
        self._by_id: dict[str, Element] = {}
        for element in self.root.iter(etree.Element):
            identity = element.get("id")
            if identity:
                self._by_id.setdefault(identity, element)

    def named(self, reference: str | None, *tags: str) -> Element | None:
        """The element that ``#id`` refers to, if it has one of the tags."""
        if not reference:
            return None
        identity = reference.strip().partition("#")[2]
        element = self._by_id.get(identity)
        if element is None:
            element = self._by_id.get(unquote(identity))
        return element if element is not None and tag(element) in tags else None


def parse(data: bytes, *, recover: bool = False) -> Element:
    """The root element of XML.

    Raises:
        NoTriangles: the XML is not well formed, or declares entities.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", "replace").encode()
        encoding = "utf-8"
    else:
        # Names may have other encodings, and no encoding can hide an entity.
        encoding = "utf-8" if _is_utf8(data) else "iso-8859-1"
    if declares_entities(data):
        raise NoTriangles(ENTITIES)
    parser = etree.XMLParser(
        encoding=encoding,
        recover=recover,
        huge_tree=len(data) > _LONG_TEXT,
        load_dtd=False,
        no_network=True,
        resolve_entities=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        root = etree.fromstring(data, parser)
    except etree.XMLSyntaxError as error:
        if (forgiven := forgive(data)) != data:
            return parse(forgiven, recover=recover)
        raise NoTriangles(f"is not well-formed XML: {error.msg}") from error
    if root is None:
        raise NoTriangles("contains no XML")
    return root


def tag(element: Element) -> str:
    return str(element.tag).rpartition("}")[2]


def children(element: Element | None, *tags: str) -> Iterator[Element]:
    """The children of an element, or those with one of the tags."""
    for candidate in element if element is not None else ():
        if isinstance(candidate.tag, str) and (not tags or tag(candidate) in tags):
            yield candidate


def child(element: Element | None, *path: str) -> Element | None:
    """The first child with a tag, the first child of that, and so on."""
    for name in path:
        element = next(children(element, name), None)
    return element


def text(element: Element | None) -> str:
    """The stripped text of an element; empty if there is none."""
    return (element.text or "").strip() if element is not None else ""


def _is_utf8(data: bytes) -> bool:
    try:
        data.decode()
    except UnicodeDecodeError:
        return False
    return True
