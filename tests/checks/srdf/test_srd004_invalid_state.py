"""SRD004: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings, message_of
from urdfkit.text.diagnostic import Severity

BAD = [
    (
        '<group_state name="s" group="g"><joint name="shoulder" value="1.1"/></group_state>',
        naming("s", "shoulder", "1.1 rad", "outside", "[-1, 1] rad"),
    ),
    (
        '<group_state name="s" group="g"><joint name="wrist" value="0"/></group_state>',
        naming("s", "wrist", "fixed"),
    ),
]
GOOD = [
    '<group_state name="s" group="g"><joint name="shoulder" value="1.0005"/></group_state>',
    '<group_state name="s" group="g"><joint name="shoulder" value="0"/></group_state>',
]


@pytest.mark.parametrize(("text", "message"), BAD)
def test_it_is_reported_in_the_srdf(tmp_path: Path, text: str, message: str) -> None:
    assert message_of(tmp_path, text, "SRD004") == message


def test_a_fixed_joint_does_not_invalidate_the_state(tmp_path: Path) -> None:
    group = '<group name="g"/>'
    outside, fixed = (findings(tmp_path, group + text, "SRD004")[0].severity for text, _ in BAD)
    assert (outside, fixed) == (Severity.ERROR, Severity.WARNING)


@pytest.mark.parametrize("text", GOOD)
def test_valid(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD004") == []


GROUPS = '<group name="arm"><link name="arm"/></group><group name="all"><link name="hand"/></group>'
STATE = '<group_state name="{}" group="{}"><joint name="shoulder" value="0"/></group_state>'


def test_two_states_of_one_name(tmp_path: Path) -> None:
    body = f"{GROUPS}\n{STATE.format('up', 'arm')}\n{STATE.format('up', 'arm')}"
    (found,) = findings(tmp_path, body, "SRD004")
    assert found.span.line == 4
    assert found.related[0].span.line == 3


def test_same_name_in_two_groups_is_accepted(tmp_path: Path) -> None:
    body = GROUPS + STATE.format("up", "arm") + STATE.format("up", "all")
    assert findings(tmp_path, body, "SRD004") == []


def state(name: str, *joints: str) -> str:
    values = "".join(f'<joint name="{joint}" value="0.1"/>' for joint in joints)
    return f'<group_state name="{name}" group="g">{values}</group_state>'


def test_the_only_state_without_a_joint(tmp_path: Path) -> None:
    others = state("up", "shoulder", "elbow") + state("down", "elbow", "shoulder")
    text = others + state("home", "elbow")
    (found,) = findings(tmp_path, text, "SRD004")
    assert (found.message, found.severity) == (
        naming("home", "shoulder", "2", "g"),
        Severity.WARNING,
    )
    for alike in (
        state("up", "shoulder", "elbow") + state("home", "elbow"),
        text + state("left", "shoulder"),
        others + state("home"),
    ):
        assert findings(tmp_path, alike, "SRD004") == []
