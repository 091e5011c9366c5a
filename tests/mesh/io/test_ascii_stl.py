from functools import partial

import pytest

from tests.mesh import made
from tests.mesh.io.sniffed import sniffed
from urdfkit.mesh.io.facts import Defect, DefectKind

SOUND = made.ascii_stl()


judged = partial(sniffed, suffix=".stl", format="ASCII STL")


@pytest.mark.parametrize(
    "data",
    [
        SOUND.upper(),
        SOUND.replace(b"\n", b"\r\n"),
        b" \n" + SOUND,
        SOUND.rstrip(),
        SOUND + SOUND.replace(b"part", b"other"),
        SOUND.replace(b" 1", b" +1.0E+00").replace(b" 0", b" -.5e-3"),
        SOUND.replace(b"normal 0 0 0", b"normal nan nan nan"),
        made.ascii_stl(name="vertex nan of the facet"),
        made.ascii_stl(name=""),
        made.ascii_stl(name="t\xe9te"),
    ],
)
def test_sound_files(data: bytes) -> None:
    assert judged(data) == (None, "")


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (made.ascii_stl([]), DefectKind.EMPTY, "contains no triangles"),
        (SOUND[:-15], DefectKind.TRUNCATED, "ends after 4 triangles, without 'endsolid'"),
        (SOUND[:220], DefectKind.TRUNCATED, "ends after 1 triangle, without 'endsolid'"),
        (SOUND[:40], DefectKind.TRUNCATED, "ends before its first triangle, without 'endsolid'"),
        (
            SOUND + SOUND[:220],
            DefectKind.TRUNCATED,
            "ends after 5 triangles, without 'endsolid'",
        ),
        (
            SOUND.replace(b"vertex 0 1 0", b"vertex 0,0 1,0 0,0"),
            DefectKind.UNREADABLE,
            "has 'vertex 0,0 1,0 0,0' in line 5, not three numbers",
        ),
        (
            SOUND.replace(b"vertex 0 1 0", b"vertex 0 1"),
            DefectKind.UNREADABLE,
            "has 'vertex 0 1' in line 5, not three numbers",
        ),
        (
            SOUND.replace(b"      vertex 0 1 0\n", b"", 1),
            DefectKind.UNREADABLE,
            "has 4 triangles and only 11 corners",
        ),
    ],
)
def test_broken_files(data: bytes, kind: DefectKind, reason: str) -> None:
    assert judged(data) == (Defect(kind, reason), "")


@pytest.mark.parametrize("word", ["nan", "-NaN", "inf", "-Infinity", "1.#QNAN", "-1.#IND"])
def test_a_vertex_that_is_not_finite(word: str) -> None:
    data = SOUND.replace(b"vertex 0 1 0", f"vertex 0 {word} 0".encode(), 1)
    assert judged(data) == (None, f"the vertex in line 5 is (0, {word.lower()}, 0)")
