"""SRD017: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings
from tests.workspaces import add_files
from urdfkit import check
from urdfkit.text.diagnostic import Severity


def test_a_state_without_group_is_for_pinocchio(tmp_path: Path) -> None:
    """Pinocchio's states set all joints; MoveIt loads the robot without them."""
    state = '<group_state name="s"><joint name="shoulder" value="0"/></group_state>'
    (finding,) = findings(tmp_path, state, "SRD017")
    assert finding.severity is Severity.WARNING


def test_a_robot_without_a_name(tmp_path: Path) -> None:
    """melfa_ros2_driver: srdfdom logs an error, and goes on with the groups."""
    findings(tmp_path, "", "SRD017")
    (tmp_path / "r.srdf").write_text("<robot/>")
    (finding,) = check(tmp_path / "r.urdf", select=["SRD017"]).diagnostics
    assert finding.message == naming("<robot>", "name", "MoveIt", "reads")
    assert finding.severity is Severity.WARNING


def test_a_virtual_joint_without_a_name(tmp_path: Path) -> None:
    """abb_ros2: MoveIt plans for the robot, with its root fixed, as with an invalid joint."""
    joint = '<virtual_joint type="fixed" parent_frame="world" child_link="base"/>'
    (finding,) = findings(tmp_path, joint, "SRD017")
    assert finding.message == naming("<virtual_joint>", "name")
    assert finding.severity is Severity.WARNING


@pytest.mark.parametrize(("groups", "severity"), [("", "warning"), ('<group name="g"/>', "error")])
def test_states_of_a_file_without_groups_are_for_pinocchio(
    tmp_path: Path, groups: str, severity: str
) -> None:
    """Pinocchio's simple_humanoid.srdf has states of a group 'all', and no group."""
    state = '<group_state name="s" group="all"><joint name="shoulder" value="9"/></group_state>'
    for code in ("SRD001", "SRD004"):
        (finding,) = findings(tmp_path, groups + state, code)
        assert finding.severity.value == severity


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            '<group name="g"><chain tip_link="arm"/></group>',
            "<chain> has no base_link (ignored)",
        ),
        ('<group_state name="s"/>', "<group_state> has no group (MoveIt ignores it)"),
        ('<disable_collisions link1="arm"/>', "<disable_collisions> has no link2 (ignored)"),
        (
            '<group_state name="s" group="g"><joint name="shoulder" value="0,5"/></group_state>',
            "state 's': value '0,5' is not a number",
        ),
    ],
)
def test_ignored_elements(tmp_path: Path, body: str, message: str) -> None:
    (finding,) = findings(tmp_path, body, "SRD017")
    assert finding.message.startswith(message)
    assert finding.span.line == 2


@pytest.mark.parametrize(
    "body",
    [
        '<group name="g"><joint name="shoulder"/></group>',  # of a group: no value
        '<group_state name="s" group="g"><joint name="p" value="0 0 1.5"/></group_state>',
        '<group name="g"><chain base_link="base" tip_link="arm"/></group>',
    ],
)
def test_valid_elements(tmp_path: Path, body: str) -> None:
    assert findings(tmp_path, body, "SRD017") == []


@pytest.mark.parametrize(
    ("body", "text", "message"),
    [
        (
            '<group_sate name="s" group="g"/>',
            "group_sate",
            naming("unknown", "<group_sate>", "<robot>", "ignored", "group_state"),
        ),
        (
            '<group name="g"><chian base_link="base" tip_link="arm"/></group>',
            "chian",
            naming("unknown", "<chian>", "<group>", "ignored", "chain"),
        ),
        (
            '<disable_collisions link1="base" link_2="arm"/>',
            "link_2",
            naming("unknown", "link_2", "<disable_collisions>", "ignored", "link2"),
        ),
    ],
)
def test_misspelt_names(tmp_path: Path, body: str, text: str, message: str) -> None:
    (finding,) = findings(tmp_path, body, "SRD017")
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
def test_names_of_other_programs(tmp_path: Path, body: str) -> None:
    assert findings(tmp_path, body, "SRD017") == []


def test_xml_that_is_not_well_formed(tmp_path: Path) -> None:
    (finding,) = findings(tmp_path, '<group name="g">', "SRD017")
    assert finding.span.source.path == str(tmp_path / "r.srdf")
    assert (finding.span.line, finding.span.text) == (2, '<group name="g">')


def test_an_srdf_of_a_package_beside_the_robot_that_is_cut_off(tmp_path: Path) -> None:
    """A package without .setup_assistant: its SRDF is known by the name of the robot."""
    add_files(
        tmp_path,
        {
            "arm/package.xml": "<package><name>arm</name></package>",
            "arm/urdf/arm.urdf": "<robot name='arm'><link name='base'/></robot>",
            "arm_moveit/package.xml": "<package><name>arm_moveit</name></package>",
            "arm_moveit/config/arm.srdf": "<robot name='arm'>\n<group name='g'>\n",
        },
    )
    (found,) = check(tmp_path / "arm" / "urdf" / "arm.urdf", select=["SRD017"]).diagnostics
    assert found.span.source.path == str(tmp_path / "arm_moveit" / "config" / "arm.srdf")


@pytest.mark.parametrize(
    ("build", "severity"), [("catkin", Severity.WARNING), ("ament_cmake", Severity.ERROR)]
)
def test_a_comment_that_only_strict_parsers_reject(
    tmp_path: Path, build: str, severity: Severity
) -> None:
    """khi_robot: a comment ends with ``--!>``. MoveIt 1 reads it, MoveIt 2 passes it to xacro."""
    manifest = f"<package><name>p</name><buildtool_depend>{build}</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(manifest)
    body = '<!-- a --!>\n<!-- b -->\n<group name="g"><link name="lost"/></group>'
    (finding,) = findings(tmp_path, body, "SRD017")
    assert (finding.span.text, finding.severity) == ("<!--", severity)
    assert [one.span.text for one in findings(tmp_path, body, "SRD001")] == ["lost"]


def test_one_of_several_with_another_name_is_accepted(tmp_path: Path) -> None:
    (tmp_path / "other.srdf").write_text("<robot")
    assert findings(tmp_path, "", "SRD017") == []
    (tmp_path / "r.srdf").write_text("<robot")
    assert len(check(tmp_path / "r.urdf", select=["SRD017"]).diagnostics) == 1


def test_valid_file_is_accepted(tmp_path: Path) -> None:
    assert findings(tmp_path, '<group name="g"><link name="arm"/></group>', "SRD017") == []
