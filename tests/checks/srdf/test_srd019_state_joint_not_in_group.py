"""SRD019: see the rule."""

from pathlib import Path

import pytest

from tests.srdfs import findings

STATE = '<group_state name="s" group="g">\n<joint name="shoulder" value="0"/></group_state>'


def test_a_joint_of_another_group(tmp_path: Path) -> None:
    body = f'<group name="g"><link name="hand"/></group>\n{STATE}'
    (finding,) = findings(tmp_path, body, "SRD019")
    assert finding.message == "state 's': joint 'shoulder' is not in group 'g'"
    assert finding.span.line == 4


@pytest.mark.parametrize(
    "group",
    [
        '<joint name="shoulder"/>',
        '<link name="arm"/>',
        '<chain base_link="base" tip_link="hand"/>',
        '<chain base_link="base" tip_link="nowhere"/>',  # SRD001
    ],
)
def test_a_joint_of_the_group(tmp_path: Path, group: str) -> None:
    assert findings(tmp_path, f'<group name="g">{group}</group>{STATE}', "SRD019") == []
