from __future__ import annotations

from tests.massive import BALL, link, shape
from tests.reported import messages, places


def test_a_link_that_is_not_seen() -> None:
    robot = link("caster", shape("collision", BALL), shape("collision", BALL)) + link("frame")
    assert messages("GEO003", robot) == ["link 'caster' has a collision and no visual"]
    assert places("GEO003", robot) == [(2, "<collision>")]


def test_a_link_that_is_seen() -> None:
    assert messages("GEO003", link("a", shape("visual", BALL), shape("collision", BALL))) == []
    assert messages("GEO003", link("a", shape("visual", BALL))) == []
