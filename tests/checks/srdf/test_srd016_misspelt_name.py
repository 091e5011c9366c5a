"""SRD016: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings


@pytest.mark.parametrize(
    ("body", "text", "message"),
    [
        (
            '<group_sate name="s" group="g"/>',
            "group_sate",
            "unknown element <group_sate> in <robot> (ignored); did you mean 'group_state'?",
        ),
        (
            '<group name="g"><chian base_link="base" tip_link="arm"/></group>',
            "chian",
            "unknown element <chian> in <group> (ignored); did you mean 'chain'?",
        ),
        (
            '<disable_collisions link1="base" link_2="arm"/>',
            "link_2",
            "unknown attribute 'link_2' in <disable_collisions> (ignored); did you mean 'link2'?",
        ),
    ],
)
def test_slips_are_told_with_what_was_meant(
    tmp_path: Path, body: str, text: str, message: str
) -> None:
    (finding,) = findings(tmp_path, body, "SRD016")
    assert finding.message == message
    assert finding.span.line == 2
    assert finding.span.text == text


@pytest.mark.parametrize(
    "body",
    [
        '<gripper name="g" clearance="0.1"/>',  # of another program
        '<group name="g"><link name="arm" clearance="0.1"/></group>',
        '<hpp:group_stat xmlns:hpp="x"/>',
        '<joint_property joint_name="shoulder" property_name="p" value="1"/>',
    ],
)
def test_what_is_no_slip_is_calm(tmp_path: Path, body: str) -> None:
    assert findings(tmp_path, body, "SRD016") == []
