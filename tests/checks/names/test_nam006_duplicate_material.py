from __future__ import annotations

from tests.reported import reported

BLUE = '<material name="blue"><color rgba="0 0 1 1"/></material>\n'


def test_every_further_one_is_told_with_the_first() -> None:
    found = reported("NAM006", f'{BLUE * 3}<link name="a"/>')
    assert [one.message for one in found] == ["material 'blue' is defined again"] * 2
    assert [one.span.line for one in found] == [3, 4]
    assert [one.related[0].span.line for one in found] == [2, 2]


def test_in_visuals_a_name_may_be_repeated() -> None:
    visual = f'<visual><geometry><sphere radius="1"/></geometry>{BLUE}</visual>'
    assert reported("NAM006", f'{BLUE}<link name="a">{visual * 2}</link>') == []
