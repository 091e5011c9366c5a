"""SRD001: see the rule."""

from pathlib import Path

import pytest

from tests.conftest import CORPUS, needs_corpus
from tests.controls import control, driven
from tests.naming import naming
from tests.srdfs import ROBOT, findings
from urdfkit import Diagnostic, check

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


def reported(directory: Path, *joints: str, place: str = "joint_limits.yaml") -> list[Diagnostic]:
    lines = "".join(f"  {name}:\n    max_velocity: 1.0\n" for name in joints)
    (directory / place).parent.mkdir(exist_ok=True)
    (directory / place).write_text(f"joint_limits:\n{lines}")
    return findings(directory, "", "SRD001")


def test_a_misspelt_joint(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "shoulder", "shuolder")
    assert found.message == naming("unknown", "shuolder", "shoulder")
    assert found.span.source.path == str(tmp_path / "joint_limits.yaml")
    assert (found.span.line, found.span.text) == (4, "shuolder")


def test_limits_of_another_robot_are_reported_once(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "a", "b", "c")
    assert "'a'" in found.message


def test_known_joints_and_files_without_limits(tmp_path: Path) -> None:
    assert reported(tmp_path, "shoulder", "wrist") == []
    for text in ("", "joint_limits: 3", "joint_limits:\n  elbow: 3", "- a", "joint_limits: ["):
        (tmp_path / "joint_limits.yaml").write_text(text)
        assert findings(tmp_path, "", "SRD001") == []


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


GROUPS = (
    '<group name="arm"><link name="arm"/></group><group name="hand"><link name="hand"/></group>'
)
SOLVER = "{}:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n"


@pytest.mark.parametrize("place", [".", "config"])
def test_solver_of_an_unknown_group(tmp_path: Path, place: str) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "srdf").mkdir()
    directory = tmp_path / place
    directory.mkdir(exist_ok=True)
    (directory / "kinematics.yaml").write_text(SOLVER.format("arm") + SOLVER.format("hnad"))
    robot = tmp_path if place == "." else tmp_path / "srdf"
    (found,) = findings(robot, GROUPS, "SRD001")
    assert found.message == naming("unknown", "hnad", "hand")
    assert "('arm', 'hand')" in found.help
    assert (found.span.line, found.span.text) == (3, "hnad")


@pytest.mark.parametrize(("name", "count"), [("RRT", 0), ("PRMkConfigDefault", 1), ("mine", 0)])
def test_planners_that_the_file_does_not_have(tmp_path: Path, name: str, count: int) -> None:
    text = "planner_configs:\n  RRT: {type: geometric::RRT}\narm:\n  default_planner_config: "
    (tmp_path / "ompl_planning.yaml").write_text(text + name)
    found = findings(tmp_path, GROUPS, "SRD001")
    assert ["not in planner_configs" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    "text",
    [
        "planner_configs:\n  RRT: {type: geometric::RRT}\nmanipulator:\n  planner_configs: [RRT]",
        "manipulator:\n  default_planner_config: RRT",
    ],
)
def test_planners_of_an_unknown_group(tmp_path: Path, text: str) -> None:
    (tmp_path / "ompl_planning.yaml").write_text(text)
    (found,) = findings(tmp_path, GROUPS, "SRD001")
    assert found.span.text == "manipulator"


@pytest.mark.parametrize(
    "text",
    [
        SOLVER.format("arm"),
        SOLVER.format("$(arg arm)"),
        SOLVER.format("left") + SOLVER.format("right"),  # of another robot
        "other: 3",
        "arm: [",
    ],
)
def test_known_or_other_names_are_accepted(tmp_path: Path, text: str) -> None:
    (tmp_path / "kinematics.yaml").write_text(text)
    assert findings(tmp_path, GROUPS, "SRD001") == []


@pytest.mark.parametrize(
    "around",
    [
        "/**: {{ros__parameters: {{robot_description_kinematics: {{{}}}}}}}",
        "/move_group: {{ros__parameters: {{{}}}}}",
        "robot_description_kinematics: {{{}}}",
    ],
)
def test_groups_in_parameters(tmp_path: Path, around: str) -> None:
    """Flexiv's launch files load the solvers as parameters of all nodes."""
    for group, count in (("arm", 0), ("manipulator", 1)):
        text = around.format(f"{group}: {{kinematics_solver: kdl_kinematics_plugin}}")
        (tmp_path / "kinematics.yaml").write_text(text)
        found = [one for one in findings(tmp_path, GROUPS, "SRD001") if "group" in one.message]
        assert [one.span.text for one in found] == ["manipulator"] * count


TWO = """\
moveit_simple_controller_manager:
  controller_names: [arm_controller]
  arm_controller:
    type: FollowJointTrajectory
    joints: [shoulder, wrist, knuckle]
"""
#: Launch files of their own pass the whole file as the settings of the manager.
FLAT = """\
controller_names: [arm_controller]
arm_controller: {type: FollowJointTrajectory, joints: [shoulder, wrist, knuckle]}
"""
ONE = "controller_list:\n  - name: arm_controller\n    joints: [shoulder, wrist, knuckle]\n"


@pytest.mark.parametrize(
    ("file", "text", "old", "new", "line"),
    [
        ("moveit_controllers.yaml", TWO, "wrist", "wrsit", 5),
        ("simple_moveit_controllers.yaml", ONE, "wrist", "wrsit", 3),
        ("controllers.yaml", ONE, "wrist", "wrsit", 3),
        ("moveit_controllers.yaml", TWO, "[arm_controller]", "[arm_controler]", 2),
        ("moveit_controllers.yaml", FLAT, "wrist", "wrsit", 2),
        ("moveit_controllers.yaml", FLAT, "[arm_controller]", "[arm_controler]", 1),
        ("initial_positions.yaml", "initial_positions:\n  shoulder: 0\n", "should", "shuold", 2),
    ],
)
def test_unknown_names(tmp_path: Path, file: str, text: str, old: str, new: str, line: int) -> None:
    (tmp_path / file).write_text(text)
    assert findings(tmp_path, "", "SRD001") == []
    (tmp_path / file).write_text(text.replace(old, new))
    (found,) = findings(tmp_path, "", "SRD001")
    assert (Path(found.span.source.path).name, found.span.line) == (file, line)
    assert "did you mean" in found.message


def test_settings_one_level_too_high(tmp_path: Path) -> None:
    text = (
        TWO.replace("[arm_controller]", "[arm_controller, hand]") + "hand:\n  joints: [knuckle]\n"
    )
    (tmp_path / "moveit_controllers.yaml").write_text(text)
    (found,) = findings(tmp_path, "", "SRD001")
    assert found.message == naming("hand", "moveit_simple_controller_manager")
    assert found.help == "indent the settings"


def test_a_list_of_fake_controllers_next_to_the_section(tmp_path: Path) -> None:
    """Only a manager that MoveIt 2 does not have would read it."""
    text = TWO + FLAT.replace("arm_controller", "fake_arm_controller")
    (tmp_path / "moveit_controllers.yaml").write_text(text)
    assert findings(tmp_path, "", "SRD001") == []
    (tmp_path / "moveit_controllers.yaml").write_text(text.replace("wrist", "wrsit", 1))
    (found,) = findings(tmp_path, "", "SRD001")
    assert (found.span.line, found.message) == (5, naming("arm_controller", "wrsit", "wrist"))


@pytest.mark.parametrize(
    ("old", "new"),
    [("shoulder, wrist", "a, b"), ("wrist", "$(arg wrist)"), ("joints: [", "joints: 3 # ")],
)
def test_other_or_unresolved_names_are_accepted(tmp_path: Path, old: str, new: str) -> None:
    (tmp_path / "moveit_controllers.yaml").write_text(TWO.replace(old, new))
    assert findings(tmp_path, "", "SRD001") == []


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


@pytest.mark.parametrize(
    ("text", "help"),
    [
        ("request_adapters: [default_planning_request_adapters/CheckStartStateBounds]", ""),
        (
            "request_adapters: own/Own default_planner_request_adapters/FixWorkspaceBounds",
            "",
        ),
        (
            "request_adapters: [default_planner_request_adapters/ResolveConstraintFrames]",
            "",
        ),
        (
            (
                "planning_plugins: [ompl_interface/OMPLPlanner]\n"
                "request_adapters: [default_planner_request_adapters/ResolveConstraintFrames]"
            ),
            "write default_planning_request_adapters/ResolveConstraintFrames in request_adapters",
        ),
        (
            "request_adapters: [default_planning_request_adapters/AddTimeOptimalParameterization]",
            (
                "write default_planning_response_adapters/AddTimeOptimalParameterization in "
                "response_adapters"
            ),
        ),
        (
            "response_adapters: default_planning_response_adapters/ValidateSolutions",
            "write default_planning_response_adapters/ValidateSolution in response_adapters",
        ),
    ],
)
def test_adapters(tmp_path: Path, text: str, help: str) -> None:
    (tmp_path / "ompl_planning.yaml").write_text(text)
    assert [one.help for one in findings(tmp_path, GROUPS, "SRD001")] == [help] * bool(help)


def test_few_of_many_get_a_suggestion(tmp_path: Path) -> None:
    """Each was compared with all, and the known names collected for each: 20,000 took minutes."""
    groups = "".join(f'<group name="speed_{number}"/>' for number in range(100))
    states = "".join(f'<group_state name="s" group="spead_{number}"/>' for number in range(100))
    pairs = '<disable_collisions link1="base" link2="hnad" reason="Never"/>'
    found = findings(tmp_path, groups + states + pairs, "SRD001")
    assert len(found) == 101
    assert ["did you mean" in one.message for one in found] == [True] * 50 + [False] * 51
