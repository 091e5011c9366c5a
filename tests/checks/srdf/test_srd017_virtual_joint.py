"""SRD017: virtual joints."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings, message_of
from urdfkit import check

BAD = [
    (
        '<virtual_joint name="v" type="hinge" parent_frame="w" child_link="base"/>',
        naming("v", "hinge", "fixed", "planar", "floating"),
    ),
    (
        '<virtual_joint name="v" type="fixed" parent_frame="w" child_link="arm"/>',
        naming("v", "arm", "root"),
    ),
]
GOOD = [
    '<virtual_joint name="v" type="floating" parent_frame="world" child_link="base"/>',
]


@pytest.mark.parametrize(("text", "message"), BAD)
def test_it_is_reported_in_the_srdf(tmp_path: Path, text: str, message: str) -> None:
    assert message_of(tmp_path, text, "SRD017") == message


@pytest.mark.parametrize("text", GOOD)
def test_valid_configuration_is_accepted(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD017") == []


WORLD = """<robot name="r">
<link name="world">{inside}</link>
<link name="base"/>
<joint name="stand" type="fixed"><parent link="world"/><child link="base"/></joint>
</robot>"""


@pytest.mark.parametrize(
    ("kind", "inside", "count"),
    [
        ("fixed", "", 0),
        ("planar", "", 1),
        ("fixed", "<visual><geometry><sphere radius='1'/></geometry></visual>", 1),
    ],
)
def test_world_link_of_gazebo_is_accepted(
    tmp_path: Path, kind: str, inside: str, count: int
) -> None:
    (tmp_path / "r.urdf").write_text(WORLD.format(inside=inside))
    (tmp_path / "r.srdf").write_text(
        f'<robot name="r">\n<virtual_joint name="v" type="{kind}" parent_frame="w" '
        'child_link="base"/></robot>'
    )
    assert len(check(tmp_path / "r.urdf", select=["SRD017"]).diagnostics) == count
