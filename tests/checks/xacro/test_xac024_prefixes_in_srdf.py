"""XAC024: names in an SRDF without the prefix of the robot."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.xacros import xacro
from urdfkit import check

PREFIX = '<xacro:arg name="prefix" default=""/>'
ROBOT = (
    PREFIX
    + '<link name="$(arg prefix)base"/><link name="$(arg prefix)tip"/>'
    + '<joint name="$(arg prefix)end" type="fixed">'
    + '<parent link="$(arg prefix)base"/><child link="$(arg prefix)tip"/></joint>'
)
CHAIN = '<group name="g"><chain base_link="{}base" tip_link="{}tip"/></group>'
PAIR = '<disable_collisions link1="{}base" link2="{}tip" reason="Adjacent"/>'
WITH = "$(arg prefix)"


@pytest.mark.parametrize(
    ("body", "names"),
    [
        (PREFIX + CHAIN.format(WITH, WITH) + PAIR.format(WITH, WITH), []),
        (PREFIX + CHAIN.format(WITH, ""), ["tip"]),
        (PREFIX + CHAIN.format(WITH, WITH) + PAIR.format("", ""), ["base", "tip"]),
        (PREFIX + CHAIN.format("", ""), []),  # for the robot without a prefix
        (CHAIN.format("", ""), []),
    ],
)
def test_names_in_an_srdf(tmp_path: Path, body: str, names: list[str]) -> None:
    """neuromeka-robotics/indy-ros2: its collision matrix lacks the prefix of its groups."""
    (tmp_path / "r.urdf.xacro").write_text(xacro(ROBOT))
    (tmp_path / "r.srdf.xacro").write_text(xacro(body))
    found = check(tmp_path / "r.urdf.xacro", select=["XAC024"]).diagnostics
    tag = "<chain>" if len(names) == 1 else "<disable_collisions>"
    assert [one.message for one in found] == [
        naming(name, f"left_{name}", "left_", tag) for name in names
    ]
    assert {one.span.source.path for one in found} <= {str(tmp_path / "r.srdf.xacro")}
