"""Validation of the bytes of binary STL files.

Format: 80 bytes of header, the number of triangles (32 bits, little endian), and 50 bytes for each
triangle: normal and three corners as 12 floats of 32 bits, and 2 bytes of colour.
"""

from math import isfinite
from struct import unpack_from

from urdfkit.core.words import counted
from urdfkit.mesh.io.facts import Defect, empty, truncated

HEADER = 84
TRIANGLE = 50

# 1 for the values of the highest and the second byte of a float that is nan or infinite.
_HIGH = bytes(byte & 0x7F == 0x7F for byte in range(256))
_BELOW = bytes(byte >> 7 for byte in range(256))


def is_stl(head: bytes, size: int) -> bool:
    """True if the size of a file fits the triangle count in its first 84 bytes."""
    return len(head) >= HEADER and size == whole_size(head)


def whole_size(data: bytes) -> int:
    """The file size that the declared number of triangles requires."""
    return HEADER + TRIANGLE * _count(data)


def _count(data: bytes) -> int:
    return int.from_bytes(data[80:HEADER], "little")


def validate(data: bytes) -> tuple[Defect | None, str]:
    """The defect of a binary STL file, and its first non-finite corner."""
    size = len(data)
    if size < HEADER:
        return truncated(f"ends after {size} of the {HEADER} bytes of a binary STL header"), ""
    declared = _count(data)
    complete, rest = divmod(size - HEADER, TRIANGLE)
    not_finite = _non_finite_corner(data, min(declared, complete))
    if declared == 0 and size == HEADER:
        return empty("contains no triangles"), ""
    if declared > complete:
        reason = f"declares {counted(declared, 'triangle')} and contains {complete}"
        return truncated(reason), not_finite
    if declared < complete or rest:
        extra = counted(size - HEADER - TRIANGLE * declared, "byte")
        reason = f"has {extra} after the declared {counted(declared, 'triangle')}"
        return truncated(reason), not_finite
    return None, not_finite


def _non_finite_corner(data: bytes, triangles: int) -> str:
    """The first corner with a coordinate that is nan or infinite; normals are ignored.

    Slices of every 50th byte take 9 operations instead of a loop over the triangles.
    """
    end = HEADER + TRIANGLE * triangles
    first = triangles
    for offset in range(HEADER + 12, HEADER + 48, 4):
        high = data[offset + 3 : end : TRIANGLE]
        if b"\x7f" in high or b"\xff" in high:
            below = data[offset + 2 : end : TRIANGLE].translate(_BELOW)
            both = int.from_bytes(high.translate(_HIGH), "little") & int.from_bytes(below, "little")
            if both:
                first = min(first, ((both & -both).bit_length() - 1) // 8)
    if first == triangles:
        return ""
    numbers = unpack_from("<9f", data, HEADER + TRIANGLE * first + 12)
    corners = [numbers[i : i + 3] for i in (0, 3, 6)]
    corner = next(i for i, values in enumerate(corners) if not all(map(isfinite, values)))
    values = ", ".join(f"{value:g}" for value in corners[corner])
    return f"corner {corner + 1} of triangle {first + 1} is ({values})"
