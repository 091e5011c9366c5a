"""Validating binary STL files from their bytes.

80 bytes of header, the number of triangles (32 bits, little endian), and for each
triangle 50 bytes: normal and three corners as 12 floats of 32 bits, and 2 bytes of colour.
"""

from math import isfinite
from struct import unpack_from

from urdfkit.core.words import counted
from urdfkit.mesh.io.facts import Defect, empty, truncated

HEADER = 84
TRIANGLE = 50

# 1 for the bytes that the high byte, or the one below it, of a float has when it is no number.
_HIGH = bytes(byte & 0x7F == 0x7F for byte in range(256))
_BELOW = bytes(byte >> 7 for byte in range(256))


def is_stl(head: bytes, size: int) -> bool:
    """True if the size of a file fits the triangle count in its first 84 bytes."""
    return len(head) >= HEADER and size == whole_size(head)


def whole_size(data: bytes) -> int:
    """The bytes that a binary STL of the declared number of triangles has."""
    return HEADER + TRIANGLE * _count(data)


def _count(data: bytes) -> int:
    return int.from_bytes(data[80:HEADER], "little")


def validate(data: bytes) -> tuple[Defect | None, str]:
    """What is wrong with a binary STL, and which coordinate is not finite."""
    size = len(data)
    if size < HEADER:
        return truncated(f"ends after {size} of the {HEADER} bytes of a binary STL header"), ""
    declared = _count(data)
    held, rest = divmod(size - HEADER, TRIANGLE)
    not_finite = _non_finite_corner(data, min(declared, held))
    if declared == 0 and size == HEADER:
        return empty("holds no triangles"), ""
    if declared > held:
        return truncated(f"declares {counted(declared, 'triangle')} and holds {held}"), not_finite
    if declared < held or rest:
        extra = size - HEADER - TRIANGLE * declared
        reason = f"holds {counted(extra, 'byte')} beyond the {counted(declared, 'triangle')}"
        return truncated(f"{reason} it declares"), not_finite
    return None, not_finite


def _non_finite_corner(data: bytes, triangles: int) -> str:
    """The first corner with a coordinate that is nan or infinite; the normals do not matter.

    Works on every 50th byte at C speed: 9 slices instead of a loop over the triangles.
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
