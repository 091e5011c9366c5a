"""Validation of the bytes of Wavefront OBJ files."""

import re

from urdfkit.mesh.io.facts import Defect, empty, truncated, unreadable

#: Faces at the end of the file whose indices are compared with the number of vertices.
_LAST_FACES = 200

# Each line after a line end, with which a search is 20 times as fast as one for line starts.
_VERTEX = re.compile(rb"\n[ \t]*v[ \t]")
_FACE = re.compile(rb"\n[ \t]*f[ \t]+([^\r\n]*)")
_OBJECT = re.compile(rb"\n[ \t]*[go](?=[ \t\r\n])")
_BAD_VERTEX = re.compile(rb"\n[ \t]*v[ \t]([^\r\n]*(?:nan|inf|#ind)[^\r\n]*)")


def validate(data: bytes) -> tuple[Defect | None, str]:
    """The defect of an OBJ file, and its first non-finite vertex."""
    text = b"\n" + data
    vertices = len(_VERTEX.findall(text))
    if not _FACE.search(text):
        return empty(f"contains no faces (number of vertices: {vertices})"), ""
    last = data.rpartition(b"\n")[2].split()
    if last and last[0] == b"f" and len(last) < 4:
        words = b" ".join(last)[:60].decode("utf-8", "replace")
        return truncated(f"ends inside a face: '{words}'"), ""
    return _beyond(text, vertices), _non_finite(text)


def objects(data: bytes) -> int:
    """Number of objects or groups with faces; some programs load only the first one."""
    pieces = _OBJECT.split(b"\n" + data)
    return sum(_FACE.search(piece) is not None for piece in pieces)


def _beyond(text: bytes, vertices: int) -> Defect | None:
    """The defect of a face, among the last ones, that refers to a missing vertex."""
    tail = max(0, len(text) - 100 * _LAST_FACES)
    for match in list(_FACE.finditer(text, tail))[-_LAST_FACES:]:
        for corner in match.group(1).split():
            word = corner.partition(b"/")[0].lstrip(b"-")
            if word.isdigit() and len(word) < 20 and int(word) > vertices:
                line = text.count(b"\n", 0, match.end())
                return unreadable(
                    f"refers to vertex {int(word)} in line {line}, but has {vertices} vertices"
                )
    return None


def _non_finite(text: bytes) -> str:
    text = text.lower()
    if b"nan" in text or b"inf" in text or b"#ind" in text:
        match = _BAD_VERTEX.search(text)
        if match:
            line = text.count(b"\n", 0, match.end())
            words = match.group(1)[:60].decode("utf-8", "replace").split()
            return f"the vertex in line {line} is ({', '.join(words[:3])})"
    return ""
