"""Validation of the bytes of PLY files: a text header, then vertices, faces and other elements."""

from __future__ import annotations

import re
from struct import calcsize

from urdfkit.core.record import Record
from urdfkit.mesh.io.facts import Defect, empty, truncated, unreadable

MAX_HEADER = 64 * 1024

_END_OF_HEADER = re.compile(rb"\nend_header[ \t]*\r?\n")
_CODES = {
    "char": "b", "int8": "b", "uchar": "B", "uint8": "B",
    "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
    "int": "i", "int32": "i", "uint": "I", "uint32": "I",
    "float": "f", "float32": "f", "double": "d", "float64": "d",
}  # fmt: skip
_ENCODINGS = ("ascii", "binary_little_endian", "binary_big_endian")


class _Property(Record):
    """A number, or a list of numbers if ``length`` is the type of its length."""

    name: str
    type: str
    length: str = ""


class _PlyElement(Record):
    """An element type of the file: ``vertex``, ``face`` or another."""

    name: str
    number: int
    properties: list[_Property]

    @property
    def least_words(self) -> int:
        """Least number of words of one element; a face has at least three corners."""
        return len(self.properties) + 3 * self._lists

    @property
    def least_bytes(self) -> int:
        """Least number of bytes of one element."""
        sizes = [calcsize("=" + _CODES[item.length or item.type]) for item in self.properties]
        corners = [3 * calcsize("=" + _CODES[item.type]) for item in self.properties if item.length]
        return sum(sizes) + sum(corners[: self._lists])

    @property
    def _lists(self) -> int:
        """1 for a face with a list of corners, otherwise 0."""
        return int(self.name == "face" and any(item.length for item in self.properties))


def validate(data: bytes) -> tuple[Defect | None, str]:
    """The defect of a PLY file; only loading finds non-finite coordinates."""
    end = _END_OF_HEADER.search(data[:MAX_HEADER])
    if end is None:
        if len(data) < MAX_HEADER:
            return truncated("ends inside its header"), ""
        return unreadable("has no 'end_header'"), ""
    encoding, elements = _header(data[: end.start()].decode("utf-8", "replace"))
    if encoding not in _ENCODINGS:
        return unreadable(f"has the format '{encoding}', which PLY does not define"), ""
    for element in elements:
        for property in element.properties:
            if property.type not in _CODES or not _is_length_type(property.length):
                words = " ".join(property).strip()
                return unreadable(f"has the property '{words}', which PLY does not define"), ""
    counts = {element.name: element.number for element in elements}
    if not counts.get("vertex") or not (counts.get("face") or counts.get("tristrips")):
        return empty("contains no triangles"), ""
    return _too_short(data[end.end() :], elements, encoding), ""


def _is_length_type(length: str) -> bool:
    """True for an integer type, or the empty type of a single number."""
    return not length or _CODES.get(length, "f") not in "fd"


def _header(text: str) -> tuple[str, list[_PlyElement]]:
    encoding = ""
    elements: list[_PlyElement] = []
    for line in text.split("\n"):
        words = line.split()
        if words[:1] == ["format"] and len(words) > 1:
            encoding = words[1]
        elif words[:1] == ["element"] and len(words) == 3 and words[2].isdecimal():
            elements.append(_PlyElement(words[1], int(words[2][:18]), []))
        elif words[:2] == ["property", "list"] and len(words) == 5 and elements:
            elements[-1].properties.append(_Property(words[4], words[3], words[2]))
        elif words[:1] == ["property"] and len(words) == 3 and elements:
            elements[-1].properties.append(_Property(words[2], words[1]))
    return encoding, elements


def _too_short(body: bytes, elements: list[_PlyElement], encoding: str) -> Defect | None:
    """The defect of a body that is shorter than the header declares."""
    if encoding != "ascii":
        needed = sum(element.number * element.least_bytes for element in elements)
        if len(body) < needed:
            return truncated(f"needs {needed} bytes after its header and has {len(body)}")
        return None
    lines = [line for line in body.split(b"\n") if line.strip()]
    needed = sum(element.number for element in elements)
    if len(lines) < needed:
        return truncated(f"declares {needed} elements and contains {len(lines)}")
    if len(lines) == needed and len(lines[-1].split()) < elements[-1].least_words:
        return truncated("ends inside its last line")
    return None
