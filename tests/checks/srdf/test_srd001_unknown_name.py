"""SRD001: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

BAD = [
    (
        '<group name="g"><link name="amr"/></group>',
        "there is no link 'amr'; did you mean 'arm'?",
        "amr",
    ),
    (
        '<group name="g"><joint name="elbow"/></group>',
        "there is no joint 'elbow'",
        "elbow",
    ),
    (
        '<group_state name="s" group="g"/>',
        "there is no group 'g'",
        "g",
    ),
    (
        '<end_effector name="e" group="h" parent_link="hand"/>',
        "there is no group 'h'",
        "h",
    ),
    (
        '<group_state name="s" group=""><joint name="root_joint" value="0"/></group_state>',
        "there is no joint 'root_joint'",
        "root_joint",
    ),
    (
        '<passive_joint name="x"/>',
        "there is no joint 'x'",
        "x",
    ),
]
GOOD = [
    (
        '<group name="g"><chain base_link="base" tip_link="hand"/></group>'
        '<group_state name="s" group="g"><joint name="shoulder" value="0"/>'
        "</group_state>"
    ),
    (
        '<virtual_joint name="v" type="fixed" parent_frame="world" child_link="base"/>'
        '<group name="g"><joint name="v"/></group>'
    ),
    (  # Pinocchio's floating base
        '<group name="g"><link name="arm"/></group><group_state name="s" group="g">'
        '<joint name="root_joint" value="0 0 1 0 0 0 1"/></group_state>'
    ),
]


@pytest.mark.parametrize(("text", "message", "word"), BAD)
def test_it_is_told_in_the_srdf(tmp_path: Path, text: str, message: str, word: str | None) -> None:
    (finding,) = findings(tmp_path, text, "SRD001")
    assert finding.message == message
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert finding.span.line == 2
    assert word is None or finding.span.text == word


@pytest.mark.parametrize("text", GOOD)
def test_what_fits_is_calm(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD001") == []
