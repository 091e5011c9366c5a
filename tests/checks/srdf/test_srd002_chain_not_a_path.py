"""SRD002: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

BAD = [
    (
        '<group name="g"><chain base_link="hand" tip_link="base"/></group>',
        "group 'g': link 'base' is not a descendant of 'hand'",
        None,
    ),
]
GOOD = [
    '<group name="g"><chain base_link="base" tip_link="finger"/></group>',
    '<group name="g"><chain base_link="arm" tip_link="arm"/></group>',
]


@pytest.mark.parametrize(("text", "message", "word"), BAD)
def test_it_is_told_in_the_srdf(tmp_path: Path, text: str, message: str, word: str | None) -> None:
    (finding,) = findings(tmp_path, text, "SRD002")
    assert finding.message == message
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert finding.span.line == 2
    assert word is None or finding.span.text == word


@pytest.mark.parametrize("text", GOOD)
def test_what_fits_is_calm(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD002") == []
