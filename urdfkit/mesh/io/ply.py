"""Judging PLY files from their bytes: a text header, then vertices, faces and more."""

from __future__ import annotations

import re
from struct import Struct

from urdfkit.core.record import Record
from urdfkit.mesh.io.facts import Defect, empty, truncated, unreadable

MAX_HEADER = 64 * 1024
#: Lists are walked one by one, which takes time: the length is not validated beyond this.
MAX_LISTS = 1_000_000

_END_OF_HEADER = re.compile(rb"\nend_header[ \t]*\r?\n")
_CODES = {
    "char": "b", "int8": "b", "uchar": "B", "uint8": "B",
    "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
    "int": "i", "int32": "i", "uint": "I", "uint32": "I",
    "float": "f", "float32": "f", "double": "d", "float64": "d",
}  # fmt: skip
_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">"}


class _Property(Record):
    """A number, or a list of numbers if ``length`` is the type of its length."""

    name: str
    type: str
    length: str = ""


class _PlyElement(Record):
    """One kind of thing in the file: ``vertex``, ``face`` or another."""

    name: str
    number: int
    properties: list[_Property]

    def single(self, order: str) -> Struct | None:
        """The layout of one of them, if all have the same."""
        if any(property.length for property in self.properties):
            return None
        return Struct(order + "".join(_CODES[property.type] for property in self.properties))


def judge(data: bytes) -> tuple[Defect | None, str]:
    """What is wrong with a PLY file; coordinates that are not finite are found by loading it."""
    end = _END_OF_HEADER.search(data[:MAX_HEADER])
    if end is None:
        if len(data) < MAX_HEADER:
            return truncated("ends inside its header"), ""
        return unreadable("has no 'end_header'"), ""
    encoding, elements = _header(data[: end.start()].decode("utf-8", "replace"))
    if encoding != "ascii" and encoding not in _ORDERS:
        return unreadable(f"has the format '{encoding}', which PLY does not know"), ""
    for element in elements:
        for property in element.properties:
            if property.type not in _CODES or not _counts(property.length):
                words = " ".join(property).strip()
                return unreadable(f"has the property '{words}', which PLY does not know"), ""
    counts = {element.name: element.number for element in elements}
    if not counts.get("vertex") or not (counts.get("face") or counts.get("tristrips")):
        return empty("holds no triangles"), ""
    body = data[end.end() :]
    if encoding == "ascii":
        return _judge_ascii(body, elements), ""
    return _judge_binary(body, elements, _ORDERS[encoding]), ""


def _counts(length: str) -> bool:
    """True if a type can hold the length of a list; a single number has none."""
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


def _judge_ascii(body: bytes, elements: list[_PlyElement]) -> Defect | None:
    lines = [line for line in body.split(b"\n") if line.strip()]
    at = 0
    for element in elements:
        held = lines[at : at + element.number]
        at += len(held)
        if len(held) < element.number:
            return _too_few(element, len(held))
        if held and not _is_whole(held[-1], element):
            return _too_few(element, len(held) - 1)
    return None


def _is_whole(line: bytes, element: _PlyElement) -> bool:
    """True if a line has as many numbers as one of the element needs."""
    words = line.split()
    needed = 0
    for property in element.properties:
        if property.length and needed < len(words) and words[needed].isdigit():
            needed += int(words[needed][:9])
        needed += 1
    return len(words) >= needed


def _judge_binary(body: bytes, elements: list[_PlyElement], order: str) -> Defect | None:
    at = 0
    for element in elements:
        single = element.single(order)
        if single is None:
            held, at = _walk(body, at, element, order)
        else:
            held = element.number
            if single.size:
                held = min(held, (len(body) - at) // single.size)
            at += held * single.size
        if held < element.number:
            return _too_few(element, held)
    return None


def _walk(body: bytes, at: int, element: _PlyElement, order: str) -> tuple[int, int]:
    """How many elements with lists are there, and where they end."""
    steps = [
        (Struct(order + _CODES[p.length]) if p.length else None, Struct(order + _CODES[p.type]))
        for p in element.properties
    ]
    end = len(body)
    for number in range(element.number):
        if number >= MAX_LISTS:
            return element.number, end
        for length, item in steps:
            many = 1
            if length is not None:
                if at + length.size > end:
                    return number, end
                many = max(int(length.unpack_from(body, at)[0]), 0)
                at += length.size
            at += many * item.size
        if at > end:
            return number, end
    return element.number, at


def _too_few(element: _PlyElement, held: int) -> Defect:
    things = {"vertex": "vertices", "face": "faces"}.get(element.name, f"'{element.name}'")
    if element.number == 1:
        return truncated(f"declares 1 {element.name} and holds {held}")
    return truncated(f"declares {element.number} {things} and holds {held}")
