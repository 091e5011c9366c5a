from __future__ import annotations

from tests.massive import BALL, joint, link, shape
from tests.reported import messages, places

ARM = link("base") + link("arm") + joint("base", "arm", "revolute")


def test_a_robot_of_frames() -> None:
    assert messages("GEO008", ARM) == ["none of the 2 links has a visual or a collision"]
    assert places("GEO008", ARM) == [(1, '<robot name="example">')]
    assert messages("GEO008", link("base")) == ["the link has neither visual nor collision"]


def test_one_shape_is_enough() -> None:
    for tag in ("visual", "collision"):
        assert messages("GEO008", ARM + link("tip", shape(tag, BALL)) + joint("arm", "tip")) == []


def test_a_macro_library_is_no_robot() -> None:
    assert messages("GEO008", '<robot name="parts"/>') == []
