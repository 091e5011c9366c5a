from __future__ import annotations

import pytest

from tests.massive import link, shape
from tests.reported import messages, places, reported


def mesh(name: str, scale: str, tag: str = "visual") -> str:
    return link(name, shape(tag, f'<mesh filename="a.stl" scale="{scale}"/>'))


@pytest.mark.parametrize("scale", ["-1 1 1", "0.001 -0.001 0.001", "-1 -1 -1"])
def test_a_mirrored_mesh(scale: str) -> None:
    assert messages("GEO006", mesh("arm", scale)) == [
        f"link 'arm': the mesh of its visual is mirrored by scale {scale}"
    ]
    assert places("GEO006", mesh("arm", scale)) == [(2, scale)]


@pytest.mark.parametrize("scale", ["1 1 1", "-1 -1 1", "0 -1 1", "-1"])
def test_what_is_all_right_or_another_rule_s(scale: str) -> None:
    assert messages("GEO006", mesh("arm", scale)) == []


def test_a_whole_side_is_one_finding() -> None:
    robot = "".join(
        mesh(f"{name}", "1 -1 1", tag) for name in "abc" for tag in ("visual", "collision")
    )
    (found,) = reported("GEO006", robot)
    assert found.message.endswith("mirrored by scale 1 -1 1 (and 5 more like this)")
    assert [(note.span.line, note.message) for note in found.related] == [
        (3, "link 'a': its collision"),
        (4, "link 'b': its visual"),
        (5, "link 'b': its collision"),
        (6, "link 'c': its visual"),
        (7, "link 'c': its collision"),
    ]


def test_twenty_places_are_enough() -> None:
    (found,) = reported("GEO006", "".join(mesh(f"a{number}", "1 -1 1") for number in range(30)))
    assert found.message.endswith("(and 29 more like this)")
    assert len(found.related) == 20
