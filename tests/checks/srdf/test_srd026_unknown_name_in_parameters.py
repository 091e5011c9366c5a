"""SRD026: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import ROBOT, TRAJECTORY_CONTROLLERS, WITHOUT_MANAGER, findings
from urdfkit import Diagnostic, Severity, check


def reported(directory: Path, *joints: str, place: str = "joint_limits.yaml") -> list[Diagnostic]:
    lines = "".join(f"  {name}:\n    max_velocity: 1.0\n" for name in joints)
    (directory / place).parent.mkdir(exist_ok=True)
    (directory / place).write_text(f"joint_limits:\n{lines}")
    return findings(directory, "", "SRD026")


def test_a_misspelt_joint(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "shoulder", "shuolder")
    assert found.message == naming("unknown", "shuolder", "shoulder")
    assert found.span.source.path == str(tmp_path / "joint_limits.yaml")
    assert (found.span.line, found.span.text) == (4, "shuolder")


def test_another_joint_is_not_suggested(tmp_path: Path) -> None:
    """RePAIR: left_hand_synergy_joint is not left_hand_grasp_joint."""
    reported(tmp_path, "left_hand_synergy_joint", "wrist")
    (tmp_path / "r.urdf").write_text(ROBOT.replace("shoulder", "left_hand_grasp_joint"))
    (found,) = check(tmp_path / "r.urdf", select=["SRD026"]).diagnostics
    assert found.message == naming("unknown", "left_hand_synergy_joint")
    assert "did you mean" not in found.message


def test_limits_of_another_robot_are_reported_once(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "a", "b", "c")
    assert "'a'" in found.message


def test_limits_in_a_file_for_all_nodes(tmp_path: Path) -> None:
    """grassjelly/robot_arm: the launch file passes it as a parameter file."""
    reported(tmp_path, "shoulder", "shuolder")
    limits = (tmp_path / "joint_limits.yaml").read_text().replace("\n", "\n      ")
    parameters = "/**:\n  ros__parameters:\n    robot_description_planning:\n      "
    (tmp_path / "joint_limits.yaml").write_text(parameters + limits)
    (found,) = findings(tmp_path, "", "SRD026")
    assert (found.span.line, found.span.text) == (7, "shuolder")


def test_known_joints_and_files_without_limits(tmp_path: Path) -> None:
    assert reported(tmp_path, "shoulder", "wrist") == []
    for text in ("", "joint_limits: 3", "joint_limits:\n  elbow: 3", "- a", "joint_limits: ["):
        (tmp_path / "joint_limits.yaml").write_text(text)
        assert findings(tmp_path, "", "SRD026") == []


@pytest.mark.parametrize(
    ("variable", "count"),
    [("x", 0), ("theta", 0), ("z", 1), ("rot_w", 1)],
)
def test_limits_of_the_variables_of_a_planar_joint(
    tmp_path: Path, variable: str, count: int
) -> None:
    """A mobile base of which MoveIt plans the motion: limits of ``position/x``."""
    virtual = '<virtual_joint name="v" type="planar" parent_frame="world" child_link="base"/>'
    reported(tmp_path, "shoulder", f"v/{variable}")
    assert len(findings(tmp_path, virtual, "SRD026")) == count


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
    (found,) = findings(robot, GROUPS, "SRD026")
    assert found.message == naming("unknown", "hnad", "hand")
    assert "('arm', 'hand')" in found.help
    assert (found.span.line, found.span.text) == (3, "hnad")


@pytest.mark.parametrize(
    ("name", "count"), [("RRT", 0), ("PRMkConfigDefault", 1), ("PRMstar", 1), ("mine", 0)]
)
def test_planners_that_the_file_does_not_have(tmp_path: Path, name: str, count: int) -> None:
    text = "planner_configs:\n  RRT: {type: geometric::RRT}\narm:\n  default_planner_config: "
    (tmp_path / "ompl_planning.yaml").write_text(text + name)
    found = findings(tmp_path, GROUPS, "SRD026")
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
    (found,) = findings(tmp_path, GROUPS, "SRD026")
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
    assert findings(tmp_path, GROUPS, "SRD026") == []


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
        found = [one for one in findings(tmp_path, GROUPS, "SRD026") if "group" in one.message]
        assert [one.span.text for one in found] == ["manipulator"] * count


ONE = "controller_list:\n  - name: arm_controller\n    joints: [shoulder, wrist, knuckle]\n"


@pytest.mark.parametrize(
    ("file", "text", "old", "new", "line"),
    [
        ("moveit_controllers.yaml", TRAJECTORY_CONTROLLERS, "wrist", "wrsit", 5),
        ("simple_moveit_controllers.yaml", ONE, "wrist", "wrsit", 3),
        ("controllers.yaml", ONE, "wrist", "wrsit", 3),
        ("moveit_controllers.yaml", WITHOUT_MANAGER, "wrist", "wrsit", 2),
        ("initial_positions.yaml", "initial_positions:\n  shoulder: 0\n", "should", "shuold", 2),
    ],
)
def test_unknown_names(tmp_path: Path, file: str, text: str, old: str, new: str, line: int) -> None:
    (tmp_path / file).write_text(text)
    assert findings(tmp_path, "", "SRD026") == []
    (tmp_path / file).write_text(text.replace(old, new))
    (found,) = findings(tmp_path, "", "SRD026")
    assert (Path(found.span.source.path).name, found.span.line) == (file, line)
    assert "did you mean" in found.message


def test_a_list_of_fake_controllers_next_to_the_section(tmp_path: Path) -> None:
    """Only a manager that MoveIt 2 does not have would read it."""
    text = TRAJECTORY_CONTROLLERS + WITHOUT_MANAGER.replace("arm_controller", "fake_arm_controller")
    (tmp_path / "moveit_controllers.yaml").write_text(text)
    assert findings(tmp_path, "", "SRD026") == []
    (tmp_path / "moveit_controllers.yaml").write_text(text.replace("wrist", "wrsit", 1))
    (found,) = findings(tmp_path, "", "SRD026")
    assert (found.span.line, found.message) == (5, naming("arm_controller", "wrsit", "wrist"))


@pytest.mark.parametrize(
    ("old", "new"),
    [("shoulder, wrist", "a, b"), ("wrist", "$(arg wrist)"), ("joints: [", "joints: 3 # ")],
)
def test_other_or_unresolved_names_are_accepted(tmp_path: Path, old: str, new: str) -> None:
    (tmp_path / "moveit_controllers.yaml").write_text(TRAJECTORY_CONTROLLERS.replace(old, new))
    assert findings(tmp_path, "", "SRD026") == []


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
    assert [one.help for one in findings(tmp_path, GROUPS, "SRD026")] == [help] * bool(help)


@pytest.mark.parametrize(
    ("solver", "suggested"),
    [
        ("kdl_kinematics_plugin/KDLKinematicPlugin", "kdl_kinematics_plugin/KDLKinematicsPlugin"),
        ("KDLKinematicsPlugin", "kdl_kinematics_plugin/KDLKinematicsPlugin"),
        ("trac_ik_kinematics_plugin/TRACIKKinematicsPlugin", None),
        ("kdl_kinematics_plugin/KDLKinematicsPlugin", ""),
        ("ur_kinematics/UR5eKinematicsPlugin", ""),
        ("my_arm/IKFastKinematicsPlugin", ""),
        ("my_solvers/Mine", ""),
    ],
)
def test_misspelt_solvers(tmp_path: Path, solver: str, suggested: str | None) -> None:
    (tmp_path / "kinematics.yaml").write_text(f"arm:\n  kinematics_solver: {solver}\n")
    found = findings(tmp_path, GROUPS, "SRD026")
    assert len(found) == (suggested != "")
    for one in found:
        assert one.span.text == solver
        assert suggested is None or one.help == f"write {suggested}"


DISPLAY = (
    "Visualization Manager:\n  Displays:\n    - Class: moveit_rviz_plugin/MotionPlanning\n"
    "      Planning Request:\n        Planning Group: {}\n"
)


@pytest.mark.parametrize(("group", "count"), [("panda_arm", 1), ("arm", 0), ("''", 0)])
def test_a_planning_group_of_another_robot_in_rviz(tmp_path: Path, group: str, count: int) -> None:
    (tmp_path / "v.rviz").write_text(DISPLAY.format(group))
    found = findings(tmp_path, GROUPS, "SRD026")
    assert [(one.span.line, one.severity, one.help) for one in found] == [
        (5, Severity.INFO, "write one of arm, hand")
    ] * count
    assert [one.message for one in found] == [naming("RViz", "unknown", "panda_arm")] * count


@pytest.mark.parametrize("prefix", ["$(var tf_prefix)", "<prefix>"])
def test_limits_with_a_substitution(tmp_path: Path, prefix: str) -> None:
    """ar4_ros_driver, iRC_ROS: names that launch, or ReplaceString of Nav2, substitutes."""
    assert reported(tmp_path, f"{prefix}shoulder") == []
