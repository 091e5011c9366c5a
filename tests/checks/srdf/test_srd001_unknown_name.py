"""SRD001: see the rule."""

from pathlib import Path

import pytest

from tests.conftest import CORPUS, needs_corpus
from tests.controls import control, driven
from tests.naming import naming
from tests.srdfs import ROBOT, findings
from urdfkit import check

BAD = [
    (
        '<group name="g"><link name="amr"/></group>',
        naming("unknown", "amr", "arm"),
        "amr",
    ),
    (  # that one is in the group already
        '<group name="g"><link name="arm"/><link name="amr"/></group>',
        "unknown link 'amr'",
        "amr",
    ),
    (
        '<group name="g"><joint name="elbow"/></group>',
        "unknown joint 'elbow'",
        "elbow",
    ),
    (
        '<group_state name="s" group="g"/>',
        "unknown group 'g'",
        "g",
    ),
    (
        '<end_effector name="e" group="h" parent_link="hand"/>',
        "unknown group 'h'",
        "h",
    ),
    (
        '<group_state name="s" group=""><joint name="root_joint" value="0"/></group_state>',
        "unknown joint 'root_joint'",
        "root_joint",
    ),
    (
        '<passive_joint name="x"/>',
        "unknown joint 'x'",
        "x",
    ),
    (
        '<disable_collisions link1="base" link2="hnad" reason="Never"/>',
        naming("unknown", "hnad", "hand"),
        "hnad",
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
    '<disable_collisions link1="base" link2="hand" reason="Never"/>',
]


@pytest.mark.parametrize(("text", "message", "word"), BAD)
def test_it_is_reported_in_the_srdf(
    tmp_path: Path, text: str, message: str, word: str | None
) -> None:
    (finding,) = findings(tmp_path, text, "SRD001")
    assert finding.message == message
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert finding.span.line == 2
    assert word is None or finding.span.text == word


@pytest.mark.parametrize("text", GOOD)
def test_valid(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD001") == []


@needs_corpus
def test_real_files() -> None:
    panda = CORPUS / "moveit_resources" / "panda_description" / "urdf" / "panda.urdf"
    assert check(panda, select=["SRD001", "SRD015"]).diagnostics == ()


STATE = '<group_state name="s" group="g">\n<joint name="shoulder" value="0"/></group_state>'


def test_a_joint_of_another_group(tmp_path: Path) -> None:
    body = f'<group name="g"><link name="hand"/></group>\n{STATE}'
    (finding,) = findings(tmp_path, body, "SRD001")
    assert finding.message == naming("s", "shoulder", "g")
    assert finding.span.line == 4


@pytest.mark.parametrize(
    "group",
    [
        '<joint name="shoulder"/>',
        '<link name="arm"/>',
        '<chain base_link="base" tip_link="hand"/>',
    ],
)
def test_a_joint_of_the_group(tmp_path: Path, group: str) -> None:
    assert findings(tmp_path, f'<group name="g">{group}</group>{STATE}', "SRD001") == []


def test_srdf_of_a_robot_with_other_arguments(tmp_path: Path) -> None:
    """xarm_ros: one SRDF for arms of five to seven joints, by the argument dof."""
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="{}"/>'
    (tmp_path / "r.urdf.xacro").write_text(
        head.format('dof" default="5') + '<link name="link$(arg dof)"/></robot>'
    )
    (tmp_path / "r.srdf.xacro").write_text(
        head.format('dof" default="7')
        + '<group name="g"><link name="link$(arg dof)"/></group></robot>'
    )
    for dof, count in (("5", 0), ("6", 0)):
        report = check(tmp_path / "r.urdf.xacro", arguments={"dof": dof}, select=["SRD001"])
        assert len(report.diagnostics) == count


@pytest.mark.parametrize(("block", "corrected"), [("", "r.srdf"), (driven("shoulder"), "r.urdf")])
def test_joint_is_misspelt_if_srdf_and_ros2_control_agree(
    block: str, corrected: str, tmp_path: Path
) -> None:
    robot = ROBOT.replace('"shoulder"', '"sholder"').replace(
        "</robot>", control(block) + "</robot>"
    )
    (tmp_path / "r.urdf").write_text(robot)
    (tmp_path / "r.srdf").write_text('<robot name="r"><passive_joint name="shoulder"/></robot>')
    (found,) = check(tmp_path / "r.urdf", select=["SRD001"]).diagnostics
    assert found.fix is not None
    assert [Path(edit.span.source.path).name for edit in found.fix.edits] == [corrected]


def test_few_of_many_get_a_suggestion(tmp_path: Path) -> None:
    """Each was compared with all, and the known names collected for each: 20,000 took minutes."""
    groups = "".join(f'<group name="speed_{number}"/>' for number in range(100))
    states = "".join(f'<group_state name="s" group="spead_{number}"/>' for number in range(100))
    pairs = '<disable_collisions link1="base" link2="hnad" reason="Never"/>'
    found = findings(tmp_path, groups + states + pairs, "SRD001")
    assert len(found) == 101
    assert ["did you mean" in one.message for one in found] == [True] * 50 + [False] * 51


@pytest.mark.parametrize(("tip", "suggested"), [("tool0", "arm_tool0"), ("tool1", None)])
def test_a_forgotten_prefix(tmp_path: Path, tip: str, suggested: str | None) -> None:
    """The definition behind the prefix is in no false condition."""
    links = '<link name="arm_base"/><link name="${p}tool0"/>'
    joint = (
        '<joint name="j" type="fixed"><parent link="arm_base"/><child link="arm_tool0"/></joint>'
    )
    (tmp_path / "r.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:property name="p" value="arm_"/>{links}{joint}</robot>'
    )
    group = f'<group name="g"><chain base_link="arm_base" tip_link="{tip}"/></group>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">{group}</robot>')
    (found,) = check(tmp_path / "r.urdf.xacro", select=["SRD001"]).diagnostics
    hint = f"; did you mean '{suggested}'?" if suggested else ""
    assert found.message == f"unknown link '{tip}'{hint}"
