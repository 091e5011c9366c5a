"""Validation of the bytes of ASCII STL files."""

import re

from urdfkit.core.words import counted
from urdfkit.mesh.io.facts import Defect, empty, truncated, unreadable

#: Bytes at the end that are searched for 'endsolid', which the solid's name follows.
_END = 20_000

_NUMBER = rb"[ \t]+[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_GOOD_VERTEX = re.compile(rb"\svertex(?:%b){3}(?=\s|\Z)" % _NUMBER)
# The solid's name, in the first and the last line, may contain "vertex", too.
_BAD_VERTEX = re.compile(
    rb"(?<=\s)(?<!solid )vertex(?!(?:%b){3}(?:\s|\Z))[ \t]([^\r\n]*)" % _NUMBER
)
_NOT_FINITE = re.compile(rb"nan|inf|#")


def validate(data: bytes) -> tuple[Defect | None, str]:
    """The defect of an ASCII STL file, and its first non-finite vertex."""
    text = data.lower()
    facets = text.count(b"endfacet")
    defect, not_finite = _bad_vertex(text)
    if b"endsolid" not in text[-_END:].rpartition(b"endfacet")[2]:
        place = f"after {counted(facets, 'triangle')}" if facets else "before its first triangle"
        return truncated(f"ends {place}, without 'endsolid'"), not_finite
    if defect:
        return defect, not_finite
    if not facets:
        return empty("contains no triangles"), ""
    corners = len(_GOOD_VERTEX.findall(text))
    if corners < 3 * facets and not not_finite:
        reason = f"has {counted(facets, 'triangle')} and only {counted(corners, 'corner')}"
        return unreadable(reason), ""
    return None, not_finite


def _bad_vertex(text: bytes) -> tuple[Defect | None, str]:
    """The first vertex that is not three finite numbers."""
    match = _BAD_VERTEX.search(text)
    if match is None:
        return None, ""
    line = text.count(b"\n", 0, match.start()) + 1
    words = match.group(1)[:60].decode("utf-8", "replace").split()
    if _NOT_FINITE.search(match.group(1)):
        return None, f"the vertex in line {line} is ({', '.join(words)})"
    return unreadable(f"has 'vertex {' '.join(words)}' in line {line}, not three numbers"), ""
