"""Robots of tutorials, of learners and of hobbyists that the rules had not seen."""

from pathlib import Path

import pytest

from tests.controls import CLASSIC, control, controller, driven, plugin
from tests.driving import reported_in_ros_1
from tests.jointed import joint as moving
from tests.jointed import limit, mimic
from tests.jointed import robot as robot_of
from tests.launched import MANIFEST
from tests.launched import reported as of_launch
from tests.massive import inertial, joint, link
from tests.meshed import mesh
from tests.meshed import messages as of_meshes
from tests.naming import naming
from tests.reported import reported
from tests.sensing import findings
from tests.workspaces import add_files, add_package
from urdfkit import check
from urdfkit.lint.grouping import groups
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh import samples
from urdfkit.ros.launch import read_launch
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

_SPAWNER = '<node name="s" pkg="controller_manager" type="spawner" args="{}"/>'


@pytest.mark.parametrize(("name", "count"), [("joint_state_controller", 0), ("wheel_contoller", 1)])
def test_a_controller_in_a_file_of_its_own_package(tmp_path: Path, name: str, count: int) -> None:
    """A course's bumperbot: joint_state_controller installs a file with its parameters."""
    text = (
        '<rosparam file="$(find joint_state_controller)/joint_state_controller.yaml"/>\n'
        '<rosparam file="$(find arm)/config/c.yaml"/>\n'
    )
    files = {"config/c.yaml": "wheel_controller:\n  type: effort_controllers/X\n"}
    found = of_launch(tmp_path, "LAU013", "a.launch", text + _SPAWNER.format(name), files)
    assert len(found) == count


@pytest.mark.parametrize(("file", "count"), [("plugins.xml", 0), ("config/p.xml", 0), ("", 1)])
def test_a_class_that_a_package_adds_to_the_names_of_another(
    tmp_path: Path, file: str, count: int
) -> None:
    """robotican's `position_controllers/GripperActionControllerTwo`."""
    kind = "effort_controllers/JointEffortControllerr"
    if file:
        export = f'<export><controller_interface plugin="${{prefix}}/{file}"/></export></package>'
        own = add_package(tmp_path / "own", "own")
        manifest = (own / "package.xml").read_text().replace("</package>", export)
        classes = f'<library path="l"><class name="{kind}" type="a::B"/></library>'
        add_files(own, {"package.xml": manifest, file: classes})
    yaml = f"grip:\n  type: {kind}\n  joint: left_joint\n"
    assert len(reported_in_ros_1(tmp_path / "arm", "RCT034", yaml)) == count


@pytest.mark.parametrize(
    ("kind", "target", "count"),
    [
        ("camera", "gz-harmonic", 0),
        ("camera", "gz-fortress", 0),
        ("camera", "gz-jetty", 1),
        ("gpu_lidar", "gz-harmonic", 1),
    ],
)
def test_the_optical_frame_of_a_camera(kind: str, target: str, count: int) -> None:
    """A rover of a course: gz-sensors stamps images with it, until Jetty."""
    tag = "<camera><optical_frame_id>base</optical_frame_id></camera>"
    assert len(findings("GAZ058", kind, tag, targets=(target,))) == count
    (found,) = findings("GAZ058", "camera", tag.replace(">base", ">bas"), targets=("gz-fortress",))
    assert found.message == naming("s", "frame_id", "bas")


@pytest.mark.parametrize(("turn", "count"), [("0 0 0", 0), ("3.14159 0 0", 1)])
def test_two_eyes_of_one_mesh(tmp_path: Path, turn: str, count: int) -> None:
    """The same rover: the files of the mesh, copies that Blender numbers, are alike."""
    tensor = (0.01, 0.001, 0.0008, 0.01, 0.001, 0.008)
    image = (0.01, -0.001, 0.0008, 0.01, -0.001, 0.008)
    wrong = (0.01, 0.001, 0.0008, 0.01, -0.001, 0.008)
    text = link("base")
    for name, right in (("leg_a", image), ("leg_b", image), ("eye", wrong)):
        for side, moments, y in (("left", tensor, 0.1), ("right", right, -0.1)):
            origin = f'<origin rpy="{turn}"/>' if side == "right" else ""
            visual = mesh(f"{side}.stl", "visual", origin=origin) if name == "eye" else ""
            center = f"0.01 {y / 5} -0.1"
            text += link(f"{side}_{name}", inertial(1, moments, center), visual)
            text += joint("base", f"{side}_{name}", "revolute", f"{len(name)} {y} 0")
    solid = samples.stl(samples.box((0, 0, 0), (0.1, 0.2, 0.3)))
    found = of_meshes(tmp_path, "INE012", text, {"left.stl": solid, "right.stl": solid})
    assert len(found) == count


_SWITCH = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="sim" default="true"/>
{}</robot>
"""
_CONTROLLER = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import {condition}
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    sim = LaunchConfiguration("sim")
    robot = Command(["xacro ", {path!r}, " sim:=false"])
    return LaunchDescription([DeclareLaunchArgument("sim", default_value="true"),
        Node(package="controller_manager", executable="ros2_control_node",
             parameters=[{{"robot_description": robot}}], condition={condition}(sim))])
"""
_BRINGUP = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource

def generate_launch_description():
    included = PythonLaunchDescriptionSource({path!r})
    return LaunchDescription([IncludeLaunchDescription(included,
        launch_arguments={{"sim": "true"}}.items())])
"""


@pytest.mark.parametrize(("condition", "count"), [("UnlessCondition", 0), ("IfCondition", 1)])
def test_a_robot_of_a_node_that_never_runs(tmp_path: Path, condition: str, count: int) -> None:
    """arduinobot, whose controllers get the real robot unless it is simulated."""
    package = tmp_path / "arm"
    part, sheet = package / "launch/control.launch.py", str(package / "bot.xacro")
    files = {
        "package.xml": MANIFEST,
        "bot.xacro": _SWITCH.format(whole_robot('<link name="base"/>')),
        "launch/control.launch.py": _CONTROLLER.format(path=sheet, condition=condition),
        "launch/sim.launch.py": _BRINGUP.format(path=str(part)),
    }
    add_files(package, files)
    source = Source.read(str(package / "launch/sim.launch.py"))
    assert len(read_launch(source, Resolver()).descriptions) == count


@pytest.mark.parametrize(
    ("hardware", "count"), [("bot/Servos", 0), ("bot/GazeboServos", 1), (CLASSIC, 1)]
)
def test_a_mimic_joint_of_the_real_robot(hardware: str, count: int) -> None:
    """The same robot, whose file always has the plugin of Gazebo."""
    text = robot_of(moving("a", "continuous"), moving("b", "continuous", mimic("a")))
    text += control(driven("a"), plugin=hardware) + plugin("libgazebo_ros2_control.so")
    assert len(reported("JNT026", text, targets=("classic-ros2",))) == count


_ARM = """\
<robot name="r"><link name="base"/>{}
<gazebo><plugin filename="libgazebo_ros2_control.so" name="p">
<parameters>{}</parameters></plugin></gazebo></robot>
"""
_START = """\
import xacro
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    robot = xacro.process_file({!r}).toxml()
    return LaunchDescription([Node(package="robot_state_publisher",
        executable="robot_state_publisher", parameters=[{{"robot_description": robot}}])])
"""


@pytest.mark.parametrize(
    ("starts", "of_other", "severity"),
    [
        ("new", "c.yaml", "warning"),
        ("old", "c.yaml", "error"),
        ("", "c.yaml", "error"),
        ("new", "d.yaml", "error"),
    ],
)
def test_the_controllers_of_the_robot_that_is_started(
    tmp_path: Path, starts: str, of_other: str, severity: str
) -> None:
    """A course's arm of seven joints, next to one of four with the same parameter file."""
    yaml = controller("arm", joints="[a, b, c]", command_interfaces="[position]")
    manager = "controller_manager:\n  ros__parameters: {{arm: {{type: {}}}}}\n".format(
        "joint_trajectory_controller/JointTrajectoryController"
    )
    files = {"package.xml": MANIFEST, "c.yaml": manager + yaml, "d.yaml": manager + yaml}
    joints = {"old": "ab", "new": "abc"}
    for name, file in (("old", "c.yaml"), ("new", of_other)):
        parts = (moving(one, "revolute", limit("-1", "1")) for one in joints[name])
        files[f"{name}.xacro"] = _ARM.format("\n".join(parts), tmp_path / file)
    if starts:
        files["launch/a.launch.py"] = _START.format(str(tmp_path / f"{starts}.xacro"))
    add_files(tmp_path, files)
    (found,) = check(tmp_path / "old.xacro", select=["RCT001"]).diagnostics
    assert found.severity.value == severity
    assert found.span.source.path.endswith("old.xacro") == (severity == "warning")


@pytest.mark.parametrize(
    ("name", "argument", "count"),
    [
        ("a_spawner.launch", "$(find arm)/launch/a.launch", 0),
        ("b_spawner.launch", "$(find arm)/launch/a.launch", 1),
        ("a_spawner.launch", "$(find arm)/launch/b.launch", 1),
    ],
)
def test_a_launch_file_that_a_program_writes(
    tmp_path: Path, name: str, argument: str, count: int
) -> None:
    """The boats of usv_sim: `parse:=true` makes a file next to each scenario, for Gazebo."""
    text = (
        f'<include file="$(find arm)/launch/{name}"/>\n<arg name="parse" default="false"/>\n'
        f'<node if="$(arg parse)" name="n" pkg="p" type="t" args="{argument}"/>'
    )
    assert len(of_launch(tmp_path, "LAU003", "a.launch", text)) == count


def test_expressions_of_a_urdf_that_nothing_expands() -> None:
    """The quadruped of a university, with 13 meshes: one mistake."""
    meshes = (
        f'<link name="{n}"><visual><geometry><mesh filename="file://$(find arm)/{n}.stl"/>'
        "</geometry></visual></link>"
        for n in "abc"
    )
    found = reported("XAC003", "".join(meshes))
    assert [len(group) for group in groups(found)] == [3]


@pytest.mark.parametrize(("more", "count"), [("", 1), ('<link name="tip"/>', 2)])
def test_an_srdf_that_the_robot_includes(tmp_path: Path, more: str, count: int) -> None:
    """The rover of a course: its elements are right where they are."""
    srdf = f'<robot name="r">{more}<group name="a"/><group_state name="s" group="a"/></robot>'
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
    text = f'{head}<xacro:include filename="r.srdf"/><link name="base"/></robot>'
    add_files(tmp_path, {"r.srdf": srdf, "r.xacro": text})
    found = check(tmp_path / "r.xacro", select=["URD001"]).diagnostics
    assert [one.span.source.path.endswith("r.xacro") for one in found] == [count == 1] * count


@pytest.mark.parametrize(("name", "count"), [("", 1), (", namespace='left'", 0)])
def test_two_controller_managers(tmp_path: Path, name: str, count: int) -> None:
    """The real bumperbot: the launch file and one that it includes start one each."""
    node = "Node(package='controller_manager', executable='ros2_control_node'{})"
    program = (
        f"from launch_ros.actions import Node\nnodes = [{node.format('')}, {node.format(name)}]"
    )
    found = of_launch(tmp_path, "LAU043", "a.launch.py", program)
    assert [one.message for one in found] == [naming("ros2_control_node")] * count
