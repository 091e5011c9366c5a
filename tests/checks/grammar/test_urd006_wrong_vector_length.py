from __future__ import annotations

import pytest

from tests.reported import fixed, messages, reported

VISUAL = (
    '<link name="a"><visual><origin {}/><geometry><mesh filename="a.stl" {}/></geometry>'
    '<material name="m"><color {}/></material></visual></link>'
)
RIGHT = ('xyz="0 0 0"', 'scale="1 1 1"', 'rgba="1 1 1 1"')


@pytest.mark.parametrize(
    ("place", "written", "message"),
    [
        (0, 'xyz="0 0"', "link 'a': xyz of <origin> has 2 numbers, not 3 (x y z)"),
        (0, 'xyz=""', "link 'a': xyz of <origin> has 0 numbers, not 3 (x y z)"),
        (0, 'rpy="0 0 0 1"', "link 'a': rpy of <origin> has 4 numbers, not 3 (x y z)"),
        (1, 'scale="2"', "link 'a': scale of <mesh> has 1 number, not 3 (x y z)"),
        (
            2,
            'rgba="1 1 1"',
            "link 'a': rgba of <color> has 3 numbers, not 4 (red green blue alpha)",
        ),
    ],
)
def test_count_and_bound_are_told(place: int, written: str, message: str) -> None:
    parts = list(RIGHT)
    parts[place] = written
    assert messages("URD006", VISUAL.format(*parts)) == [message]


def test_any_number_of_spaces_separates() -> None:
    assert reported("URD006", VISUAL.format('xyz="  0  0   0 "', *RIGHT[1:])) == []


@pytest.mark.parametrize(
    ("place", "written", "better"),
    [
        (1, 'scale="0.001"', 'scale="0.001 0.001 0.001"'),
        (2, "rgba='1 0 0'", "rgba='1 0 0 1'"),
        (0, 'xyz="0 0"', 'xyz="0 0"'),  # nobody knows which is missing
        (1, 'scale="1 1"', 'scale="1 1"'),
    ],
)
def test_what_is_surely_meant_is_offered(place: int, written: str, better: str) -> None:
    bad, good = list(RIGHT), list(RIGHT)
    bad[place], good[place] = written, better
    assert fixed("URD006", VISUAL.format(*bad)) == (
        f'<robot name="example">\n{VISUAL.format(*good)}\n</robot>\n'
    )
