"""SRD024: see the rule."""

from pathlib import Path

from tests.srdfs import findings

GROUPS = '<group name="arm"><link name="arm"/></group><group name="all"><link name="hand"/></group>'
STATE = '<group_state name="{}" group="{}"><joint name="shoulder" value="0"/></group_state>'


def test_two_states_of_one_name(tmp_path: Path) -> None:
    body = f"{GROUPS}\n{STATE.format('up', 'arm')}\n{STATE.format('up', 'arm')}"
    (found,) = findings(tmp_path, body, "SRD024")
    assert found.span.line == 4
    assert found.related[0].span.line == 3


def test_the_same_name_in_two_groups_is_calm(tmp_path: Path) -> None:
    body = GROUPS + STATE.format("up", "arm") + STATE.format("up", "all")
    assert findings(tmp_path, body, "SRD024") == []
