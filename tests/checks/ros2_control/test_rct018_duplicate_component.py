from __future__ import annotations

from tests.controls import NEXT, ROBOT, control, driven
from tests.reported import messages, places, reported


def test_two_blocks_of_one_name() -> None:
    text = ROBOT + control(driven("swing")) + control(driven("slide"))
    assert messages("RCT018", text) == ["two <ros2_control> have the name 'c'"]
    assert places("RCT018", text) == [(NEXT + 4, "c")]
    (found,) = reported("RCT018", text)
    assert [(one.span.line, one.message) for one in found.related] == [(NEXT, "first here")]


def test_names_of_their_own() -> None:
    text = ROBOT + control(driven("swing")) + control(driven("slide"), name="d")
    assert reported("RCT018", text) == []
    assert reported("RCT018", text.replace('"c"', '""').replace('"d"', '""')) == [], "RCT017"
    assert reported("RCT018", text.replace('"c"', '"${n}"').replace('"d"', '"${n}"')) == [], (
        "XAC003"
    )
