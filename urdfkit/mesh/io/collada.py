"""Validation of the bytes of COLLADA files, without parsing their numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import inf
from xml.parsers import expat

from urdfkit.mesh.io.facts import Defect, empty, truncated, unreadable

#: Unterminated comments extend to the end: searching from each beginning again would take hours.
_TAG = re.compile(rb"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)|<[^<>]*>", re.DOTALL)
_SURFACE = re.compile(
    rb"""<(?:triangles|polylist|polygons|trifans|tristrips)\s[^<>]*\bcount\s*=\s*["']0*[1-9]"""
)
_REFERENCE = re.compile(
    rb"""<(?:instance_geometry|accessor|input)\s[^<>]*\b(?:url|source)\s*=\s*["']#([^"'&]*)"""
)
_ID = re.compile(rb"""\sid\s*=\s*["']([^"'&]*)""")
_UNIT = re.compile(rb"""<unit\s[^<>]*\bmeter\s*=\s*["']\s*(\d*\.?\d+(?:[eE][-+]?\d+)?)\s*["']""")
_UP_AXIS = re.compile(rb"<up_axis>\s*([XYZ]_UP)\s*<")
_NOT_FINITE = re.compile(rb"[^\s<>]{0,20}?(?:nan|in[fd])[^\s<>]*", re.IGNORECASE)
_VALUE = re.compile(rb"""=\s*(?:"[^"<]*<[^"]*"|'[^'<]*<[^']*')""")
_LATE_DECLARATION = re.compile(rb"\A(?:\xef\xbb\xbf)?\s+<\?xml\b[^>]*\?>")
_SURFACES = frozenset(("triangles", "polylist", "polygons", "trifans", "tristrips"))
_REFERENCES = {"instance_geometry": "url", "accessor": "source", "input": "source"}
#: Errors of expat caused by a truncated file: no element, unclosed token, partial character,
#: unclosed CDATA section.
_CUT_OFF = (3, 5, 6, 20)
#: Error of expat: the XML declaration is not at the start.
_DECLARED_LATE = 17
#: Nested entities grow without bound, or overflow the stack of the parser.
ENTITIES = "declares XML entities, which are not supported"
#: Errors of expat that the XML parsers of Gazebo and assimp ignore: undefined entity, encoding.
_TOLERATED = (11, 18, 19)


def validate(data: bytes) -> tuple[Defect | None, str]:
    """The defect of a COLLADA file, and its first non-finite coordinate."""
    if declares_entities(data):
        return unreadable(ENTITIES), ""
    content = _Content()
    error: expat.ExpatError | None = None
    if not data.startswith((b"\xff\xfe", b"\xfe\xff")) and b"\0" not in data:
        # The tags, 4 % of the bytes, are well formed if the file is.
        tags = b"".join(_TAG.findall(data)).replace(b"<p></p>", b"")
        if _is_sound(tags) and not any(map(_has_letters, _number_lists(data))):
            return None, ""
        error = content.parse(tags)
    if error is not None or not content.root:
        content = _Content()
        error = content.parse(data)
    if error is not None and (forgiven := forgive(data)) != data:
        again = _Content()
        later = again.parse(forgiven)
        if later is None or error.code == _DECLARED_LATE:
            content, error = again, later
    if error is not None and error.code not in _TOLERATED:
        if error.code in _CUT_OFF:
            return truncated(_where_it_ends(content)), ""
        reason = expat.ErrorString(error.code)
        return unreadable(f"is not well-formed XML: {reason} in line {error.lineno}"), ""
    return content.defect(), _non_finite(data, content)


def declares_entities(data: bytes) -> bool:
    return b"<!ENTITY" in (data.replace(b"\0", b"") if b"\0" in data else data)


def forgive(data: bytes) -> bytes:
    """XML without the errors that Gazebo (tinyxml2) and assimp (pugixml) accept, but not expat.

    They stop at a zero byte, and accept "<" in attribute values and white space before the XML
    declaration, which is not needed.
    """
    if not data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.partition(b"\0")[0]
    data = _LATE_DECLARATION.sub(lambda found: b"\n" * found.group().count(b"\n"), data)
    return _VALUE.sub(lambda found: found.group().replace(b"<", b"&lt;"), data)


def _is_sound(tags: bytes) -> bool:
    """True if the tags are valid: a fast check that is enough for all but broken files."""
    try:
        expat.ParserCreate("iso-8859-1").Parse(tags, True)
    except expat.ExpatError:
        return False
    return (
        bool(_SURFACE.search(tags))
        and b"<instance_geometry" in tags
        and b"<instance_visual_scene" in tags
        and set(_REFERENCE.findall(tags)) <= set(_ID.findall(tags))
    )


def _where_it_ends(content: _Content) -> str:
    open_tags = " in ".join(f"<{tag}>" for tag in reversed(content.open[-2:]))
    before = "" if content.surfaces else ", before any triangle"
    return f"ends inside {open_tags or 'its first tag'}{before}"


def conventions(data: bytes) -> tuple[float, str]:
    """Metres per unit of length and the up axis, from the first ``<asset>``."""
    start = data.find(b"<asset")
    asset = data[start : data.find(b"</asset>", start)] if start >= 0 else b""
    unit, axis = _UNIT.search(asset), _UP_AXIS.search(asset)
    meter = float(unit.group(1)) if unit else 1.0
    return meter if 0 < meter < inf else 1.0, axis.group(1).decode() if axis else ""


class _Content:
    """Information from the tags of a COLLADA file."""

    def __init__(self) -> None:
        self.root = ""  # tag of the root element
        self.open: list[str] = []  # tags of the open elements
        self.surfaces = 0  # declared number of faces
        #: For each ``float_array``, in order, the id of its source.
        self.arrays: list[str] = []
        self.positions: set[str] = set()  # ids of sources with vertex coordinates
        self._ids: set[str] = set()
        self._references: dict[str, str] = {}
        self._tags: set[str] = set()
        self._source = ""

    def parse(self, data: bytes) -> expat.ExpatError | None:
        # In Latin-1, every byte is a character, so names in other encodings are accepted.
        encoding = None if data.startswith((b"\xff\xfe", b"\xfe\xff")) else "iso-8859-1"
        parser = expat.ParserCreate(encoding)
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        try:
            parser.Parse(data, True)
        except expat.ExpatError as error:
            return error
        return None

    def defect(self) -> Defect | None:
        if not self.surfaces:
            lines = self._tags & {"lines", "linestrips"}
            return empty(f"contains no triangles{', only lines' if lines else ''}")
        if not self._tags & {"instance_geometry", "instance_controller"}:
            return empty("contains geometry, but no instance of it in its scene")
        if "instance_visual_scene" not in self._tags:
            return empty("contains geometry, but no <scene> that refers to it")
        for reference, tag in self._references.items():
            if reference not in self._ids:
                return unreadable(f"refers in <{tag}> to '#{reference}', which does not exist")
        return None

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        tag = name.rpartition(":")[2]
        self.root = self.root or tag
        self.open.append(tag)
        self._tags.add(tag)
        if "id" in attributes:
            self._ids.add(attributes["id"])
        if tag in _SURFACES:
            number = attributes.get("count", "1")
            self.surfaces += int(number) if number.isdecimal() else 1
        elif tag == "source":
            self._source = attributes.get("id", "")
        elif tag == "float_array":
            self.arrays.append(self._source)
        reference = attributes.get(_REFERENCES.get(tag, ""), "")
        # References of animations and controllers are not needed for the mesh.
        if reference.startswith("#") and (tag == "instance_geometry" or "mesh" in self.open):
            self._references.setdefault(reference[1:], tag)
            if attributes.get("semantic") == "POSITION":
                self.positions.add(reference[1:])

    def _end(self, _: str) -> None:
        self.open.pop()


def _number_lists(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Offset and text of every ``float_array``."""
    at = data.find(b"<float_array")
    while at >= 0:
        start = data.find(b">", at) + 1
        end = data.find(b"<", start)
        if start == 0 or end < 0:
            return
        yield start, data[start:end]
        at = data.find(b"<float_array", end)


def _has_letters(numbers: tuple[int, bytes]) -> bool:
    return b"n" in numbers[1] or b"N" in numbers[1]


def _non_finite(data: bytes, content: _Content) -> str:
    """The first vertex coordinate that is nan or infinite."""
    for source, (start, numbers) in zip(content.arrays, _number_lists(data), strict=False):
        match = _NOT_FINITE.search(numbers) if source in content.positions else None
        if match:
            line = data.count(b"\n", 0, start + match.start()) + 1
            word = match.group()[:20].decode("utf-8", "replace")
            return f"a coordinate in line {line} is {word}"
    return ""
