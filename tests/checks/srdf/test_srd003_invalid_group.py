"""SRD003: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings, message_of

BAD = [
    (
        '<group name="g"><chain base_link="hand" tip_link="base"/></group>',
        "group 'g': tip link 'base' is not a descendant of base link 'hand'",
    ),
    (
        '<group name="g"/>',
        "group 'g' is empty",
    ),
    (
        '<group name="a"><group name="b"/></group><group name="b"><group name="a"/></group>',
        "groups contain one another: a -> b -> a",
    ),
    (
        '<group name="a"><group name="a"/></group>',
        "groups contain one another: a -> a",
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


@pytest.mark.parametrize(("text", "message"), BAD)
def test_it_is_reported_in_the_srdf(tmp_path: Path, text: str, message: str) -> None:
    assert message_of(tmp_path, text, "SRD003") == message


@pytest.mark.parametrize("text", GOOD)
def test_valid(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD003") == []
