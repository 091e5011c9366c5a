from functools import partial

import pytest

from tests.mesh import made
from tests.mesh.io.sniffed import sniffed
from urdfkit.mesh.io.facts import Defect, DefectKind

ASCII = made.ascii_ply()
BINARY = made.binary_ply()


judged = partial(sniffed, suffix=".ply", format="PLY")


@pytest.mark.parametrize(
    "data",
    [
        ASCII,
        ASCII.replace(b"\n", b"\r\n"),
        ASCII.rstrip(),
        BINARY,
        made.binary_ply(">"),
        BINARY + b"more",
        BINARY.replace(b"element face", b"element user 0\nproperty float a\nelement face"),
    ],
)
def test_sound_files(data: bytes) -> None:
    assert judged(data) == (None, "")


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (ASCII.replace(b"face 1", b"face 0"), DefectKind.EMPTY, "contains no triangles"),
        (ASCII.replace(b"vertex 3", b"vertex 0"), DefectKind.EMPTY, "contains no triangles"),
        (ASCII[:90], DefectKind.TRUNCATED, "ends inside its header"),
        (ASCII[:-3], DefectKind.TRUNCATED, "ends inside its last line"),
        (ASCII[:-12], DefectKind.TRUNCATED, "declares 4 elements and contains 3"),
        (BINARY[:-1], DefectKind.TRUNCATED, "needs 49 bytes after its header and has 48"),
        (
            ASCII.replace(b"ascii", b"text"),
            DefectKind.UNREADABLE,
            "has the format 'text', which PLY does not define",
        ),
        (
            ASCII.replace(b"float z", b"real z"),
            DefectKind.UNREADABLE,
            "has the property 'z real', which PLY does not define",
        ),
        (
            ASCII.replace(b"list uchar", b"list float"),
            DefectKind.UNREADABLE,
            "has the property 'vertex_indices int float', which PLY does not define",
        ),
        (
            ASCII.replace(b"end_header", b"comment " + b"x" * 70_000),
            DefectKind.UNREADABLE,
            "has no 'end_header'",
        ),
    ],
)
def test_broken_files(data: bytes, kind: DefectKind, reason: str) -> None:
    assert judged(data) == (Defect(kind, reason), "")


def test_counts_beyond_all_measure_take_no_time() -> None:
    huge = b"99999999999999999"
    defect, _ = judged(BINARY.replace(b"face 1", b"face " + huge))
    assert defect is not None
    assert defect.kind is DefectKind.TRUNCATED
    nothing = BINARY.replace(b"element face", b"element user " + huge + b"\nelement face")
    assert judged(nothing) == (None, "")
