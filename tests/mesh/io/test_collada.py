from functools import partial

import pytest

from tests.mesh import made
from tests.mesh.io.sniffed import sniffed
from urdfkit.mesh.io.facts import Defect, DefectKind

SOUND = made.collada()


judged = partial(sniffed, suffix=".dae", format="COLLADA")


def changed(old: str, new: str) -> bytes:
    assert old.encode() in SOUND
    return SOUND.replace(old.encode(), new.encode())


@pytest.mark.parametrize(
    "data",
    [
        b"\xef\xbb\xbf" + SOUND,
        SOUND.decode().replace("utf-8", "utf-16").encode("utf-16"),
        changed("<unit", "<title>t\xeate</title><unit").decode().encode("latin-1"),
        SOUND.replace(b"utf-8", b"gb2312"),
        changed('id="scene"', 'id="scene" name="a &gt; b > c"'),
        changed("<unit", "<title>a &amp; b &nbsp; c</title><unit"),
        changed("triangles", "polylist"),
        changed("<p>0 1 2</p>", "<p></p>"),
        changed('<triangles count="1">', '<lines count="2"/><triangles count="1">'),
        changed("instance_geometry", "instance_controller"),
        SOUND.replace(b"<COLLADA", b"<c:COLLADA xmlns:c='x'").replace(b"</COLLADA", b"</c:COLLADA"),
        changed("</COLLADA>", "</COLLADA><!-- the end -->\n"),
        # Gazebo and RViz show these: the meshes of velodyne_description, and of a KUKA.
        changed('id="scene"', 'id="scene" name="<STL_BINARY>"'),
        SOUND + b"\0\0\0",
        b"\xef\xbb\xbf\r\n \t" + SOUND,
        changed("<library_visual", '<sampler><input source="#gone"/></sampler><library_visual'),
    ],
)
def test_sound_files(data: bytes) -> None:
    assert judged(data) == (None, "")


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (made.collada(faces=0), DefectKind.EMPTY, "contains no triangles"),
        (changed("triangles", "lines"), DefectKind.EMPTY, "contains no triangles, only lines"),
        (
            b'\n<?xml version="1.0"?>\n<COLLADA><a></b></COLLADA>',
            DefectKind.UNREADABLE,
            "is not well-formed XML: mismatched tag in line 3",
        ),
        (b"<COLLADA></COLLADA>", DefectKind.EMPTY, "contains no triangles"),
        (
            changed('<instance_geometry url="#part"/>', ""),
            DefectKind.EMPTY,
            "contains geometry, but no instance of it in its scene",
        ),
        (
            changed('<instance_visual_scene url="#scene"/>', ""),
            DefectKind.EMPTY,
            "contains geometry, but no <scene> that refers to it",
        ),
        (
            changed('source="#positions"', 'source="#elsewhere"'),
            DefectKind.UNREADABLE,
            "refers in <input> to '#elsewhere', which does not exist",
        ),
        (
            changed('url="#part"', 'url="#other"'),
            DefectKind.UNREADABLE,
            "refers in <instance_geometry> to '#other', which does not exist",
        ),
        (
            changed("</technique_common>\n        </source>", "</source>"),
            DefectKind.UNREADABLE,
            "is not well-formed XML: mismatched tag in line 10",
        ),
        (
            changed("0 0 0 1", "0 0 \0 1"),
            DefectKind.UNREADABLE,
            "is not well-formed XML: not well-formed (invalid token) in line 9",
        ),
        (SOUND[:20], DefectKind.TRUNCATED, "ends inside its first tag, before any triangle"),
        (
            SOUND[: SOUND.index(b"1 0 0 0 1")],
            DefectKind.TRUNCATED,
            "ends inside <float_array> in <source>, before any triangle",
        ),
        (
            SOUND[: SOUND.index(b"<visual_scene")],
            DefectKind.TRUNCATED,
            "ends inside <library_visual_scenes> in <COLLADA>",
        ),
    ],
)
def test_broken_files(data: bytes, kind: DefectKind, reason: str) -> None:
    assert judged(data) == (Defect(kind, reason), "")


@pytest.mark.parametrize("word", ["nan", "-NaN", "INF", "-1.#IND"])
def test_a_coordinate_that_is_not_finite(word: str) -> None:
    assert judged(made.collada(f"0 0 0\n1 {word} 0 0 1 0")) == (
        None,
        f"a coordinate in line 10 is {word}",
    )


def test_more_than_one_error_names_the_first_line() -> None:
    data = SOUND.replace(b"<asset>", b"<asset><a>").replace(b"<scene>", b"<scene><b>")
    assert judged(data)[0] == Defect(
        DefectKind.UNREADABLE, "is not well-formed XML: mismatched tag in line 4"
    )
