"""SRD017: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            '<group name="g"><chain tip_link="arm"/></group>',
            "<chain> has no base_link, so MoveIt leaves it out",
        ),
        ('<group_state name="s"/>', "<group_state> has no group, so MoveIt leaves it out"),
        ('<disable_collisions link1="arm"/>', "<disable_collisions> has no link2, so MoveIt"),
        (
            '<group_state name="s" group="g"><joint name="shoulder" value="0,5"/></group_state>',
            "state 's': '0,5' is not a position of a joint",
        ),
    ],
)
def test_what_is_left_out(tmp_path: Path, body: str, message: str) -> None:
    (finding,) = findings(tmp_path, body, "SRD017")
    assert finding.message.startswith(message)
    assert finding.span.line == 2


@pytest.mark.parametrize(
    "body",
    [
        '<disable_collisions link1="arm" lnik2="base"/>',  # SRD016
        '<group name="g"><joint name="shoulder"/></group>',  # of a group: no value
        '<group_state name="s" group="g"><joint name="p" value="0 0 1.5"/></group_state>',
        '<group name="g"><chain base_link="base" tip_link="arm"/></group>',
    ],
)
def test_what_is_read(tmp_path: Path, body: str) -> None:
    assert findings(tmp_path, body, "SRD017") == []
