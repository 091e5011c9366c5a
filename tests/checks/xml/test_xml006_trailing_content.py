from __future__ import annotations

import pytest

from tests.reported import reported


@pytest.mark.parametrize(
    ("behind", "marked", "message"),
    [
        ('<robot name="s"/>', '<robot name="s"/>', "<robot> behind the end of <robot>"),
        ('<link name="b"></link>', '<link name="b">', "<link> behind the end of <robot>"),
        ("the end", "the end", "text behind the end of <robot>"),
    ],
)
@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
def test_what_follows(name: str, behind: str, marked: str, message: str) -> None:
    robot = f'<robot name="r"><link name="a"/></robot>\n\n  {behind}\n'
    (found,) = reported("XML006", robot, name)
    assert (found.span.line, found.span.column, found.span.text) == (3, 3, marked)
    assert found.message == message
    (related,) = found.related
    assert (related.span.line, related.message) == (1, "<robot> begins here")


def test_the_first_is_enough() -> None:
    assert len(reported("XML006", "<robot/><a/><b/>text<c>")) == 1


def test_comments_and_white_space_may_follow() -> None:
    assert reported("XML006", '<robot name="r"><link name="a"/></robot>\n<!-- end -->\n\n') == []
