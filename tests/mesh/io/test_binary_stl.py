import struct
from functools import partial
from math import inf, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.mesh import made
from tests.mesh.io.sniffed import sniffed
from urdfkit.mesh.io.facts import Defect, DefectKind

SOUND = made.binary_stl()


judged = partial(sniffed, suffix=".stl", format="binary STL")


@pytest.mark.parametrize(
    "header", [b"solid part", b"facet normal", b"<html>", b"glTF", b"\xff" * 80]
)
def test_the_size_tells_whatever_the_header_says(header: bytes) -> None:
    assert judged(made.binary_stl(header=header)) == (None, "")


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (made.binary_stl([]), DefectKind.EMPTY, "contains no triangles"),
        (SOUND[:-1], DefectKind.TRUNCATED, "declares 4 triangles and contains 3"),
        (SOUND[:84], DefectKind.TRUNCATED, "declares 4 triangles and contains 0"),
        (
            made.binary_stl(made.TETRAHEDRON[:1])[:-1],
            DefectKind.TRUNCATED,
            "declares 1 triangle and contains 0",
        ),
        (SOUND[:83], DefectKind.TRUNCATED, "ends after 83 of the 84 bytes of a binary STL header"),
        (
            b"VCG \xcd\x01\x0b" + SOUND[7:-1],
            DefectKind.TRUNCATED,
            "declares 4 triangles and contains 3",
        ),
        (SOUND + b"\n", DefectKind.TRUNCATED, "has 1 byte after the declared 4 triangles"),
        (
            SOUND[:80] + b"\0\0\0\0" + SOUND[84:],
            DefectKind.TRUNCATED,
            "has 200 bytes after the declared 0 triangles",
        ),
        (
            made.binary_stl(header=b"solid x")[:-50],
            DefectKind.TRUNCATED,
            "declares 4 triangles and contains 3",
        ),
    ],
)
def test_broken_files(data: bytes, kind: DefectKind, reason: str) -> None:
    assert judged(data) == (Defect(kind, reason), "")


@pytest.mark.parametrize(
    ("bad", "triangle", "corner", "axis"), [(nan, 0, 0, 0), (inf, 3, 2, 2), (-inf, 1, 1, 0)]
)
def test_a_corner_that_is_not_finite(bad: float, triangle: int, corner: int, axis: int) -> None:
    data = bytearray(SOUND)
    struct.pack_into("<f", data, 84 + 50 * triangle + 12 + 12 * corner + 4 * axis, bad)
    point = list(made.TETRAHEDRON[triangle][corner])
    point[axis] = bad
    numbers = ", ".join(f"{number:g}" for number in point)
    reported = f"corner {corner + 1} of triangle {triangle + 1} is ({numbers})"
    assert judged(bytes(data)) == (None, reported)


def test_the_first_of_several_is_reported() -> None:
    data = bytearray(SOUND)
    for triangle, number in ((3, 0), (1, 8), (1, 5), (2, 0)):
        struct.pack_into("<f", data, 84 + 50 * triangle + 12 + 4 * number, nan)
    assert judged(bytes(data)) == (None, "corner 2 of triangle 2 is (1, 0, nan)")


def test_normals_may_be_anything_and_coordinates_large() -> None:
    large = 3.4e38
    data = bytearray(made.binary_stl([((large, -large, 0), (0, 1, 0), (1e-40, 0, 0))]))
    data[84:96] = struct.pack("<3f", nan, inf, -inf)
    assert judged(bytes(data)) == (None, "")


def test_a_part_of_a_file_can_be_not_finite_too() -> None:
    data = made.binary_stl([((nan, 0, 0), (0, 1, 0), (1, 0, 0)), made.TETRAHEDRON[0]])
    defect, not_finite = judged(data[:-10])
    assert defect == Defect(DefectKind.TRUNCATED, "declares 2 triangles and contains 1")
    assert not_finite == "corner 1 of triangle 1 is (nan, 0, 0)"


@given(st.lists(st.tuples(*[st.floats(width=32)] * 9), min_size=1, max_size=20))
def test_exactly_what_is_not_finite_is_reported(rows: list[tuple[float, ...]]) -> None:
    data = made.binary_stl([(row[0:3], row[3:6], row[6:9]) for row in rows])
    finite = all(number - number == 0 for row in rows for number in row)
    assert (judged(data)[1] == "") is finite
