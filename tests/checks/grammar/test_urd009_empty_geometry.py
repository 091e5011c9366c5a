from __future__ import annotations

import pytest

from tests.reported import messages, places, reported

VISUAL = '<link name="a"><visual>\n<geometry>{}</geometry></visual></link>'


@pytest.mark.parametrize(
    ("content", "message", "place"),
    [
        ("", "link 'a': <geometry> holds no shape", "<geometry>"),
        ("<!-- box -->", "link 'a': <geometry> holds no shape", "<geometry>"),
        (
            '<plane normal="0 0 1"/>',
            "link 'a': <geometry> begins with <plane>, which is not a shape",
            '<plane normal="0 0 1"/>',
        ),
        (
            '<material name="m"/><box size="1 1 1"/>',
            "link 'a': <geometry> begins with <material>, which is not a shape",
            '<material name="m"/>',
        ),
    ],
)
def test_no_shape_where_readers_look(content: str, message: str, place: str) -> None:
    robot = VISUAL.format(content)
    assert messages("URD009", robot) == [message]
    assert places("URD009", robot) == [(3, place)]
    assert [reported(code, robot) for code in ("URD001", "URD004", "URD012", "URD013")] == [[]] * 4


@pytest.mark.parametrize(
    "content",
    [
        '<box size="1 1 1"/><material name="m"/>',  # URD012: read, but without the colour
        '<drake:ellipsoid xmlns:drake="http://drake.mit.edu"/>',
        '<capsule radius="1" length="1"/>',  # URD016
        "<bx/>",  # URD013
    ],
)
def test_a_shape_or_another_finding(content: str) -> None:
    assert reported("URD009", VISUAL.format(content)) == []
