"""SRD003: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

BAD = [
    (
        '<group name="g"><chain base_link="hand" tip_link="base"/></group>',
        "group 'g': tip link 'base' is not a descendant of base link 'hand'",
        None,
    ),
    (
        '<group name="g"/>',
        "group 'g' is empty",
        None,
    ),
    (
        '<group name="a"><group name="b"/></group><group name="b"><group name="a"/></group>',
        "groups contain one another: a -> b -> a",
        None,
    ),
    (
        '<group name="a"><group name="a"/></group>',
        "groups contain one another: a -> a",
        None,
    ),
]
GOOD = [
    '<group name="g"><chain base_link="base" tip_link="finger"/></group>',
    '<group name="g"><chain base_link="arm" tip_link="arm"/></group>',
    '<group name="g"/><group name="g"><link name="arm"/></group>',
    (
        '<group name="a"><group name="b"/><group name="c"/></group><group name="b">'
        '<group name="c"/></group><group name="c"><link name="arm"/></group>'
    ),
]


@pytest.mark.parametrize(("text", "message", "word"), BAD)
def test_it_is_reported_in_the_srdf(
    tmp_path: Path, text: str, message: str, word: str | None
) -> None:
    (finding,) = findings(tmp_path, text, "SRD003")
    assert finding.message == message
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert finding.span.line == 2
    assert word is None or finding.span.text == word


@pytest.mark.parametrize("text", GOOD)
def test_valid(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD003") == []
