"""SRD008: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings
from urdfkit import check

BAD = [
    (
        '<disable_collisions link1="base" link2="hand" reason="Adjacent"/>',
        "no joint holds 'base' and 'hand' together",
        None,
    ),
]
GOOD = [
    '<disable_collisions link1="base" link2="arm" reason="Adjacent"/>',
    '<disable_collisions link1="arm" link2="finger" reason="Adjacent"/>',
    '<disable_collisions link1="base" link2="hand" reason="Never"/>',
]


@pytest.mark.parametrize(("text", "message", "word"), BAD)
def test_it_is_told_in_the_srdf(tmp_path: Path, text: str, message: str, word: str | None) -> None:
    (finding,) = findings(tmp_path, text, "SRD008")
    assert finding.message == message
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert finding.span.line == 2
    assert word is None or finding.span.text == word


@pytest.mark.parametrize("text", GOOD)
def test_what_fits_is_calm(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD008") == []


def test_all_around_a_link_without_geometry_are_adjacent_to_moveit(tmp_path: Path) -> None:
    """The Setup Assistant takes such links out, and joins what they held."""
    body = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
    links = "".join(f'<link name="leg{number}">{body}</link>' for number in (1, 2))
    joints = "".join(
        f'<joint name="j{number}" type="continuous"><parent link="base"/>'
        f'<child link="leg{number}"/></joint>'
        for number in (1, 2)
    )
    (tmp_path / "r.urdf").write_text(f'<robot name="r"><link name="base"/>{links}{joints}</robot>')
    pair = '<disable_collisions link1="leg1" link2="leg2" reason="Adjacent"/>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">{pair}</robot>')
    assert check(tmp_path / "r.urdf", select=["SRD008"]).diagnostics == ()
