from functools import partial

import pytest

from tests.mesh import made
from tests.mesh.io.sniffed import sniffed
from urdfkit.mesh.io.facts import Defect, DefectKind

SOUND = made.obj()


judged = partial(sniffed, suffix=".obj", format="OBJ")


@pytest.mark.parametrize(
    "data",
    [
        SOUND.replace(b"\n", b"\r\n"),
        SOUND.rstrip(),
        SOUND.replace(b"f 1 2 3", b"f -4 -3 -2"),
        SOUND.replace(b"f 1 2 3", b"f 1//1 2//1 3//1 4//1"),
        SOUND.replace(b"f 1", b"vn nan nan nan\ng infinite\nf 1"),
        b"# a long comment\n" * 400 + SOUND,
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
    ],
)
def test_sound_files(data: bytes) -> None:
    assert judged(data) == (None, "")


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (b"# only a comment\n", DefectKind.EMPTY, "contains no faces (number of vertices: 0)"),
        (b"v 0 0 0\nv 1 0 0\n", DefectKind.EMPTY, "contains no faces (number of vertices: 2)"),
        (SOUND + b"f 1 2", DefectKind.TRUNCATED, "ends inside a face: 'f 1 2'"),
        (
            SOUND.replace(b"f 1/1 2/1 4/1", b"f 1/1 2/1 5/1"),
            DefectKind.UNREADABLE,
            "refers to vertex 5 in line 8, but has 4 vertices",
        ),
        (
            SOUND.replace(b"f 1/1 2/1 4/1", b"f -1 -2 -5"),
            DefectKind.UNREADABLE,
            "refers to vertex 5 in line 8, but has 4 vertices",
        ),
    ],
)
def test_broken_files(data: bytes, kind: DefectKind, reason: str) -> None:
    assert judged(data) == (Defect(kind, reason), "")


@pytest.mark.parametrize("word", ["nan", "-NAN", "inf", "1.#IND"])
def test_a_vertex_that_is_not_finite(word: str) -> None:
    data = SOUND.replace(b"v 0 1 0", f"v 0 {word} 0".encode())
    assert judged(data) == (None, f"the vertex in line 5 is (0, {word.lower()}, 0)")
