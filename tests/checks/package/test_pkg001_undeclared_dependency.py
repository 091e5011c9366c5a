from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch
from tests.naming import naming
from tests.workspaces import add_files
from urdfkit import Diagnostic, Severity, check


def reported(directory: Path, text: str, dependencies: str = "") -> list[Diagnostic]:
    for name in ("arm", "hand"):
        (directory / name).mkdir(exist_ok=True)
        content = dependencies if name == "arm" else ""
        (directory / name / "package.xml").write_text(
            f"<package><name>{name}</name>{content}</package>"
        )
    (directory / "hand" / "hand.xacro").write_text("<robot/>")
    file = directory / "arm" / "arm.xacro"
    xacro = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    file.write_text(f'<robot name="r" {xacro}>\n<link name="base"/>\n{text}\n</robot>')
    report = check(file, select=["PKG001"])
    assert report.crashed == ()
    return list(report.diagnostics)


HAND = '<xacro:include filename="$(find hand)/hand.xacro"/>'


def test_a_package_that_is_not_declared(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, HAND)
    manifest = tmp_path / "arm" / "package.xml"
    assert found.message == naming("hand", manifest)
    assert found.help == naming("<run_depend>hand</run_depend>", "package.xml")
    assert (found.span.line, found.span.text) == (3, "$(find hand)/hand.xacro")


def test_once_for_each_package(tmp_path: Path) -> None:
    assert len(reported(tmp_path, HAND * 3)) == 1


def test_every_kind_of_dependency_declares(tmp_path: Path) -> None:
    for kind in ("depend", "exec_depend", "run_depend", "build_depend", "test_depend"):
        assert reported(tmp_path, HAND, f"<{kind}>hand</{kind}>") == []


def test_packages_that_need_no_declaration(tmp_path: Path) -> None:
    uses = "<!-- $(find hand) -->" + '<xacro:property name="p" value="package://{}/x"/>'
    assert reported(tmp_path, uses.format("arm")) == []
    assert reported(tmp_path, uses.format("gazebo_ros")) == [], "comes with ROS"
    assert reported(tmp_path, uses.format("lies_nowhere")) == [], "XAC011"
    assert len(reported(tmp_path, uses.format("hand"))) == 1


def test_a_file_outside_of_packages(tmp_path: Path) -> None:
    file = tmp_path / "r.urdf"
    file.write_text('<robot name="r"><link name="package://hand/x"/></robot>')
    assert check(file, select=["PKG001"]).diagnostics == ()


def test_the_fix_stands_behind_dependencies_of_its_kind(tmp_path: Path) -> None:
    lines = "\n  <run_depend>urdf</run_depend>\n  <test_depend>ament</test_depend>\n"
    (found,) = reported(tmp_path, HAND, lines)
    assert found.fix is not None
    (edit,) = found.fix.edits
    text = edit.span.source.data.decode()
    place = text.index("<run_depend>urdf</run_depend>") + len("<run_depend>urdf</run_depend>")
    assert (edit.span.start, edit.text) == (place, "\n  <run_depend>hand</run_depend>")


def test_the_help_names_the_tag_of_the_format(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, HAND)
    assert found.help == naming("<run_depend>hand</run_depend>", "package.xml")
    assert found.fix is not None
    assert "<run_depend>" in found.fix.edits[0].text
    manifest = tmp_path / "arm" / "package.xml"
    manifest.write_text("<package format='3'><name>arm</name></package>")
    (found,) = check(tmp_path / "arm" / "arm.xacro", select=["PKG001"]).diagnostics
    assert found.help == naming("<exec_depend>hand</exec_depend>", "package.xml")


@pytest.mark.parametrize(
    ("path", "tag"), [("test/a.xacro", "test_depend"), ("urdf/test/a.xacro", "run_depend")]
)
def test_what_a_test_uses_is_a_dependency_of_the_tests(tmp_path: Path, path: str, tag: str) -> None:
    reported(tmp_path, HAND)
    file = tmp_path / "arm" / path
    file.parent.mkdir(parents=True)
    (tmp_path / "arm" / "arm.xacro").rename(file)
    (found,) = check(file, select=["PKG001"]).diagnostics
    assert found.help == naming(f"<{tag}>hand</{tag}>", "package.xml")


def test_no_cycle_of_packages_is_made(tmp_path: Path) -> None:
    """xarm_ros2: its description uses the controller package, which depends on it."""
    arm = tmp_path / "arm" / "arm.xacro"
    assert reported(tmp_path, HAND)[0].fix is not None
    hand, palm = tmp_path / "hand" / "package.xml", tmp_path / "palm" / "package.xml"
    for text in ("<depend>arm</depend>", "<depend>palm</depend>"):
        palm.parent.mkdir(exist_ok=True)
        palm.write_text("<package><name>palm</name><depend>arm</depend></package>")
        hand.write_text(f"<package><name>hand</name>{text}</package>")
        (found,) = check(arm, select=["PKG001"]).diagnostics
        assert found.fix is None
        assert found.help == naming("hand", "arm", "arm", "hand")


def test_two_packages_that_use_one_another_get_no_fix(tmp_path: Path) -> None:
    reported(tmp_path, HAND)
    (tmp_path / "hand" / "hand.xacro").write_text("<robot>$(find arm)/x</robot>")
    (found,) = check(tmp_path / "arm" / "arm.xacro", select=["PKG001"]).diagnostics
    assert found.fix is None


def test_a_directory_of_a_package_is_none_of_that_name(tmp_path: Path) -> None:
    """unitree_ros: the robot lies in xacro/, and the package that it uses depends on `xacro`."""
    arm = tmp_path / "arm" / "xacro" / "arm.xacro"
    reported(tmp_path, HAND)
    arm.parent.mkdir()
    (tmp_path / "arm" / "arm.xacro").rename(arm)
    (tmp_path / "hand" / "package.xml").write_text(
        "<package><name>hand</name><depend>xacro</depend></package>"
    )
    (found,) = check(arm, select=["PKG001"]).diagnostics
    assert found.help == naming("<run_depend>hand</run_depend>", "package.xml")
    assert found.fix is not None


NODE = '<node name="n" pkg="{}" type="t"/>'


def of_launch(directory: Path, text: str, depends: str = "") -> list[Diagnostic]:
    for name in ("arm", "hand"):
        (directory / name).mkdir()
        own = MANIFEST.replace("<name>arm", f"<name>{name}")
        (directory / name / "package.xml").write_text(
            own.replace("</package>", f"{depends}</package>")
        )
    (directory / "hand" / "b.launch").write_text(launch(NODE.format("hand")))
    (directory / "arm" / "a.launch").write_text(launch(text))
    report = check(directory / "arm" / "a.launch", select=["PKG001"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize("text", [NODE.format("hand"), '<include file="$(find hand)/b.launch"/>'])
def test_a_package_that_is_there_by_chance(tmp_path: Path, text: str) -> None:
    (found,) = of_launch(tmp_path, text)
    assert found.message.startswith("package 'hand' is used")
    assert found.help == naming("<exec_depend>hand</exec_depend>", "package.xml")
    assert (found.severity, found.span.line) == (Severity.INFO, 2)


@pytest.mark.parametrize(
    ("name", "depends"),
    [
        ("hand", "<exec_depend>hand</exec_depend>"),
        ("hand", "<depend>hand</depend>"),
        ("arm", ""),
        ("rviz", ""),
        ("not_there", ""),
    ],
)
def test_what_a_launch_file_may_use(tmp_path: Path, name: str, depends: str) -> None:
    assert of_launch(tmp_path, NODE.format(name), depends) == []


MOVE_GROUP = '<node pkg="moveit_ros_move_group" exec="move_group"/>'


@pytest.mark.parametrize(
    ("solver", "name"),
    [
        ("trac_ik_kinematics_plugin/TRAC_IKKinematicsPlugin", "trac_ik_kinematics_plugin"),
        ("kdl_kinematics_plugin/KDLKinematicsPlugin", ""),
        ("my_solver/Plugin", ""),
    ],
)
def test_the_package_of_a_kinematics_solver(tmp_path: Path, solver: str, name: str) -> None:
    (tmp_path / "package.xml").write_text(
        MANIFEST.replace(
            "</package>",
            "<exec_depend>moveit_ros_move_group</exec_depend>"
            "<export><build_type>ament_cmake</build_type></export></package>",
        )
    )
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "kinematics.yaml").write_text(f"arm:\n  kinematics_solver: {solver}\n")
    (tmp_path / "a.launch.xml").write_text(launch(MOVE_GROUP))
    found = check(tmp_path / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [one.help for one in found] == (
        [naming(f"<exec_depend>{name}</exec_depend>", "package.xml")] if name else []
    )


@pytest.mark.parametrize(
    ("plugin", "declared", "name"),
    [
        ("chomp_interface/CHOMPPlanner", "", "moveit_planners_chomp"),
        ("pilz_industrial_motion_planner/CommandPlanner", "", "pilz_industrial_motion_planner"),
        ("chomp_interface/CHOMPPlanner", "<exec_depend>moveit_planners</exec_depend>", ""),
        ("my_planner/Planner", "", ""),
    ],
)
def test_the_package_of_a_planner(tmp_path: Path, plugin: str, declared: str, name: str) -> None:
    kind = "<export><build_type>ament_cmake</build_type></export></package>"
    declared += "<exec_depend>moveit_ros_move_group</exec_depend>"
    (tmp_path / "package.xml").write_text(MANIFEST.replace("</package>", declared + kind))
    (tmp_path / "config").mkdir()
    text = f"planning_plugins:\n  - {plugin}\n"
    (tmp_path / "config" / "ompl_planning.yaml").write_text(text)
    (tmp_path / "a.launch.xml").write_text(launch(MOVE_GROUP))
    found = check(tmp_path / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [one.help for one in found] == (
        [naming(f"<exec_depend>{name}</exec_depend>", "package.xml")] if name else []
    )


def test_a_package_by_the_name_of_its_directory(tmp_path: Path) -> None:
    """A robot of Isaac Gym in the directory Pi, whose package is called pi."""
    (tmp_path / "Hand").mkdir()
    (tmp_path / "Hand" / "package.xml").write_text("<package><name>hand_v2</name></package>")
    (tmp_path / "Hand" / "hand.xacro").write_text("<robot/>")
    (found,) = reported(tmp_path, HAND.replace("hand)", "Hand)"))
    manifest = tmp_path / "Hand" / "package.xml"
    assert found.message == naming("Hand", "hand_v2", manifest)
    assert (found.help, found.fix) == (naming("hand_v2", "rename"), None)


@pytest.mark.parametrize(
    ("declared", "used", "count"),
    [
        ("navigation2", "nav2_amcl", 0),
        ("navigation2", "nav2_bringup", 1),  # "doesn't belong for recursive dependencies"
        ("nav2_bringup", "nav2_amcl", 0),
    ],
)
def test_what_a_metapackage_brings(tmp_path: Path, declared: str, used: str, count: int) -> None:
    lines = f"<exec_depend>{declared}</exec_depend>"
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    (tmp_path / "package.xml").write_text(MANIFEST.replace("</package>", lines))
    (tmp_path / "a.launch.xml").write_text(launch(f'<node pkg="{used}" exec="amcl"/>'))
    found = check(tmp_path / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [one.span.text for one in found] == [used] * count


@pytest.mark.parametrize(
    ("declared", "severities"),
    [
        ("rviz2 joint_state_publisher_gui", [Severity.WARNING]),
        ("rviz2 joint_state_publisher_gui xacro robot_state_publisher", []),
        ("rviz2", [Severity.INFO] * 2),  # nobody declared what the launch files start
    ],
)
def test_the_only_package_that_is_not_declared(
    tmp_path: Path, declared: str, severities: list[Severity]
) -> None:
    lines = "".join(f"<exec_depend>{name}</exec_depend>" for name in declared.split())
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    (tmp_path / "package.xml").write_text(MANIFEST.replace("</package>", lines))
    started = ("rviz2", "robot_state_publisher", "joint_state_publisher_gui")
    nodes = "".join(f'<node pkg="{name}" exec="{name}"/>' for name in started)
    (tmp_path / "a.launch.xml").write_text(launch(nodes))
    found = check(tmp_path / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [one.severity for one in found] == severities


@pytest.mark.parametrize(
    ("declared", "severities"),
    [
        ("a b", [Severity.WARNING]),
        ("a b c", []),
        ("a", [Severity.INFO] * 2),
    ],
)
def test_the_only_package_of_the_workspace(
    tmp_path: Path, declared: str, severities: list[Severity]
) -> None:
    lines = "".join(f"<exec_depend>{name}</exec_depend>" for name in declared.split())
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    nodes = "".join(f'<node pkg="{name}" exec="run"/>' for name in "abc")
    files = {f"{name}/package.xml": f"<package><name>{name}</name></package>" for name in "abc"}
    files["arm/package.xml"] = MANIFEST.replace("</package>", lines)
    files["arm/a.launch.xml"] = launch(nodes)
    add_files(tmp_path, files)
    found = check(tmp_path / "arm" / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [one.severity for one in found] == severities


OPTIONAL = """
from ament_index_python.packages import {asker}
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package=name, executable='run') for name in {names}])
"""


@pytest.mark.parametrize("names", [["rviz2", "nav2_amcl", "slam_toolbox"], ["a", "b", "c"]])
@pytest.mark.parametrize(
    ("asker", "severity"),
    [
        ("get_package_share_directory", Severity.WARNING),
        ("get_packages_with_prefixes", Severity.INFO),
        ("PackageNotFoundError", Severity.INFO),
    ],
)
def test_a_launch_file_that_asks_which_packages_are_installed(
    tmp_path: Path, names: list[str], asker: str, severity: Severity
) -> None:
    lines = "".join(f"<exec_depend>{name}</exec_depend>" for name in names[:2])
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    files = {f"{name}/package.xml": f"<package><name>{name}</name></package>" for name in "abc"}
    files["arm/package.xml"] = MANIFEST.replace("</package>", lines)
    files["arm/a.launch.py"] = OPTIONAL.format(asker=asker, names=names)
    add_files(tmp_path, files)
    found = check(tmp_path / "arm" / "a.launch.py", select=["PKG001"]).diagnostics
    assert [one.severity for one in found] == [severity]


@pytest.mark.parametrize(
    ("declared", "other", "helps"),
    [
        ("robot_localisation", "", ["write robot_localization"]),
        (
            "robot_location",
            "",
            ["add <exec_depend>robot_localization</exec_depend> to package.xml"],
        ),
        ("robot_localization robot_localisation", "", []),
        (
            "robot_localisation",  # a package of the workspace
            "robot_localisation",
            ["add <exec_depend>robot_localization</exec_depend> to package.xml"],
        ),
    ],
)
def test_a_typo_in_a_dependency(
    tmp_path: Path, declared: str, other: str, helps: list[str]
) -> None:
    lines = "".join(f"<exec_depend>{name}</exec_depend>\n" for name in declared.split())
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    files = {"arm/package.xml": MANIFEST.replace("</package>", lines)}
    files["arm/a.launch.xml"] = launch('<node pkg="robot_localization" exec="ekf_node"/>')
    files |= {f"{other}/package.xml": f"<package><name>{other}</name></package>"} if other else {}
    add_files(tmp_path, files)
    found = check(tmp_path / "arm" / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [one.help for one in found] == helps


def test_the_place_of_a_typo_in_a_dependency(tmp_path: Path) -> None:
    lines = "<exec_depend>tf2_rso</exec_depend>\n"
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    manifest = tmp_path / "package.xml"
    manifest.write_text(MANIFEST.replace("</package>", lines))
    node = '<node pkg="tf2_ros" exec="static_transform_publisher"/>'
    (tmp_path / "a.launch.xml").write_text(launch(node))
    (found,) = check(tmp_path / "a.launch.xml", select=["PKG001"]).diagnostics
    assert (found.severity, found.span.source.path) == (Severity.WARNING, str(manifest))
    assert found.message == naming("tf2_rso", "tf2_ros")


@pytest.mark.parametrize(
    ("declared", "severity"),
    [
        ("rviz2", Severity.INFO),
        ("rviz2 xacro launch launch_ros", Severity.WARNING),
        ("xacro launch launch_ros ros2launch", Severity.INFO),  # neither is declared
        ("rviz2 own another third", Severity.INFO),  # not of ROS
    ],
)
def test_the_only_package_next_to_many(tmp_path: Path, declared: str, severity: Severity) -> None:
    lines = "".join(f"<exec_depend>{name}</exec_depend>" for name in declared.split())
    lines += "<export><build_type>ament_cmake</build_type></export></package>"
    (tmp_path / "package.xml").write_text(MANIFEST.replace("</package>", lines))
    started = ("rviz2", "joint_state_publisher_gui")
    nodes = "".join(f'<node pkg="{name}" exec="{name}"/>' for name in started)
    (tmp_path / "a.launch.xml").write_text(launch(nodes))
    found = check(tmp_path / "a.launch.xml", select=["PKG001"]).diagnostics
    assert [(one.span.text, one.severity) for one in found][-1] == (started[1], severity)


ROBOT = """<robot name="r"><link name="base"/><gazebo>
<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/>
</gazebo></robot>"""
STATE = """<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
<param name="robot_description" value="$(command 'cat $(find-pkg-share model)/r.urdf')"/>
</node></launch>"""
SIMULATION = """<launch><include file="$(find-pkg-share model)/launch/state.launch.xml"/>
<node pkg="ros_gz_sim" exec="create" args="-topic robot_description"/></launch>"""
CONTROL = "<exec_depend>gz_ros2_control</exec_depend>"


@pytest.mark.parametrize(
    ("simulation", "model", "count"), [("", "", 1), (CONTROL, "", 0), ("", CONTROL, 0)]
)
def test_the_control_plugin_of_an_included_robot(
    tmp_path: Path, simulation: str, model: str, count: int
) -> None:
    """A workspace with a package for the robot, and one for its simulation."""
    own = "<exec_depend>model</exec_depend><exec_depend>ros_gz_sim</exec_depend>" + simulation
    kind = "<export><build_type>ament_cmake</build_type></export></package>"
    for name, depends in (("model", model), ("simulation", own)):
        manifest = MANIFEST.replace("<name>arm<", f"<name>{name}<")
        (tmp_path / name / "launch").mkdir(parents=True)
        (tmp_path / name / "package.xml").write_text(manifest.replace("</package>", depends + kind))
    (tmp_path / "model" / "r.urdf").write_text(ROBOT)
    (tmp_path / "model" / "launch" / "state.launch.xml").write_text(STATE)
    file = tmp_path / "simulation" / "launch" / "sim.launch.xml"
    file.write_text(SIMULATION)
    found = check(file, select=["PKG001"]).diagnostics
    assert [one.help for one in found] == [naming(CONTROL, "package.xml")] * count
    assert all(one.span.source.path == str(file) for one in found)
