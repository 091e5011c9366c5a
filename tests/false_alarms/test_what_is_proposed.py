"""Findings that were right, and whose help would have sent the author the wrong way."""

from pathlib import Path

import pytest

from tests.controls import CLASSIC, ROBOT, control, controller, driven, reported_with_file
from tests.gazebos import BASE, plugin, sensor
from tests.jointed import joint, limit, robot
from tests.launched import MANIFEST
from tests.launched import reported as of_launch
from tests.massive import BOX, inertial, link, shape
from tests.meshed import SOUND
from tests.naming import naming
from tests.reported import reported
from tests.workspaces import add_file, add_files, add_package
from tests.xacros import reported as xacro_findings
from tests.xacros import xacro
from urdfkit import check

ENDLESS = limit("0", "0", "10", "2")


@pytest.mark.parametrize(
    ("unknown", "suggested"), [("rr_swerve", ["mr_swerve"]), ("rf_swervee", ["rf_swerve"])]
)
def test_a_joint_that_the_controller_has_already(
    tmp_path: Path, unknown: str, suggested: list[str]
) -> None:
    """A base with wheels lf, rf and mr, whose controllers are those of one with four."""
    wheels = robot(*(joint(f"{side}_swerve", "continuous", ENDLESS) for side in ("lf", "rf", "mr")))
    text = controller("c", joints=f"[lf_swerve, rf_swerve, {unknown}]")
    (found,) = reported_with_file("RCT001", tmp_path, text, "", robot=wheels)
    assert found.message == naming("c", unknown, *suggested)


@pytest.mark.parametrize(
    ("name", "help"),
    [
        ("arms/MMTrajectoryControler", "write arms/MMTrajectoryController, or"),
        (
            "arms/ScaledJointTrajectoryController",
            "write one of arms/MMTrajectoryController, arms/MM",
        ),
    ],
)
def test_a_class_of_which_only_the_kind_is_alike(tmp_path: Path, name: str, help: str) -> None:
    """A servo, a path and a trajectory controller in one package, and the type of a fourth."""
    classes = ("arms/MMTrajectoryController", "arms/MMServoController")
    library = "".join(f'<class name="{one}" type="{one}" base_class_type="x"/>' for one in classes)
    build = "find_package(ament_cmake)\npluginlib_export_plugin_description_file("
    files = {
        "CMakeLists.txt": f"{build}controller_interface arms.xml)\n",
        "arms.xml": f'<library path="arms">{library}</library>',
    }
    add_files(add_package(tmp_path / "arms", "arms"), files)
    text = controller("c", kind=name)
    (found,) = reported_with_file("RCT034", tmp_path, text, control(driven("swing")), robot=ROBOT)
    assert found.help.startswith(help)


@pytest.mark.parametrize(("installed", "count"), [("hands", 0), ("feet", 1)])
def test_a_package_whose_manifest_alone_has_another_name(
    tmp_path: Path, installed: str, count: int
) -> None:
    """setup.py, setup.cfg, the index and the launch files agree, so that ROS finds the programs."""
    manifest = MANIFEST.replace(
        "</package>", "<export><build_type>ament_python</build_type></export></package>"
    )
    setup = (
        "from setuptools import setup\n\npackage_name = 'hands'\nsetup(\n    name=package_name,\n"
        "    data_files=[('share/ament_index/resource_index/packages', "
        "['resource/' + package_name])],\n"
        "    entry_points={'console_scripts': ['grip = hands.grip:main']},\n)\n"
    )
    add_files(
        tmp_path / "hands",
        {
            "package.xml": manifest,
            "setup.py": setup,
            "setup.cfg": f"[install]\ninstall_scripts=$base/lib/{installed}\n",
            "resource/hands": "",
            "hands/grip.py": "def main(): ...\n",
            "launch/a.launch.py": "from launch_ros.actions import Node\n"
            "x = Node(package='hands', executable='grip')\n",
        },
    )
    path = tmp_path / "hands/launch/a.launch.py"
    found = [one.message for one in check(path, select=["PKG008"]).diagnostics]
    assert naming("hands", "setup.py", "arm", "package.xml") in found
    assert found.count(naming(f"lib/{installed}")) == len(found) - 1 == count
    assert not any("'hands'" in one.message for one in check(path, select=["PKG001"]).diagnostics)


def test_a_property_that_is_used_without_the_dollar() -> None:
    """A wheel with friction="{wheel_friction}": the property must not be deleted."""
    value = '<xacro:property name="wheel_friction" value="0.1"/>'
    mark = '<gazebo reference="base"><mu1>{}</mu1><mu2>0.1</mu2></gazebo>'
    for text, codes in (("{wheel_friction}", ["XAC003"]), ("0.2", ["XAC004"])):
        found = [
            one
            for code in ("XAC003", "XAC004")
            for one in xacro_findings(code, value + '<link name="base"/>' + mark.format(text))
        ]
        assert [one.code for one in found] == codes


def test_a_file_below_a_directory_that_is_no_longer_there(tmp_path: Path) -> None:
    """The meshes of a UR5e in robots/ur5e/meshes/visual, and once below meshes/ur5e."""
    package = add_package(tmp_path / "arm", "arm")
    add_files(package, {"robots/ur5e/meshes/visual/base.stl": SOUND})
    mesh = '<geometry><mesh filename="package://arm/robots/ur5e/meshes/ur5e/visual/base.stl"/>'
    text = f'<robot name="r"><link name="a"><visual>{mesh}</geometry></visual></link></robot>'
    (found,) = check(add_file(package / "urdf/a.urdf", text), select=["MSH001"]).diagnostics
    assert found.help == naming("package://arm/robots/ur5e/meshes/visual/base.stl")


@pytest.mark.parametrize(
    ("package", "effect"), [("map_server", "roslaunch"), ("nav2_map_server", "lifecycle")]
)
def test_a_map_server_of_ros_1_that_is_started_twice(
    tmp_path: Path, package: str, effect: str
) -> None:
    """A robot whose navigation starts it, and includes a file that does."""
    node = f'<node pkg="{package}" type="map_server" name="map_server"/>'
    text = f'{node}<include file="$(find arm)/launch/b.launch"/>'
    files = {"launch/b.launch": f"<launch>{node}</launch>"}
    (found,) = of_launch(tmp_path / "arm", "LAU043", "a.launch", text, files)
    assert effect in found.message


def test_products_of_a_tensor_that_become_zero() -> None:
    """A hand with the product 5.7e-03 beside moments of 1e-06, all others as they should be."""
    moments = (4e-6, 5.7e-3, 0.0, 1.5e-5, 0.0, 1.3e-5)
    (found,) = reported("INE003", link("a", shape("collision", BOX), inertial(0.06, moments)))
    assert 'ixy="0"' in found.help
    assert "ixz" not in found.help


def test_a_list_of_joints_in_one_tag() -> None:
    """libgazebo_ros_joint_state_publisher.so reads one name in each <joint_name>."""
    tags = "<joint_name>swing, slide, lost</joint_name>"
    block = plugin("libgazebo_ros_joint_state_publisher.so", tags)
    (found,) = reported("GAZ021", ROBOT + control(driven("swing"), plugin=CLASSIC) + block)
    assert found.help == naming("<joint_name>")


@pytest.mark.parametrize(
    ("directory", "is_portable"), [("$(find hull)/mesh", True), ("/home/me/hull/mesh", False)]
)
def test_a_property_with_the_directory_of_the_meshes(
    tmp_path: Path, directory: str, is_portable: bool
) -> None:
    """A torpedo: `file://$(find ...)` in a property is found by all computers."""
    mesh = '<geometry><mesh filename="file://${meshes}/hull.dae"/></geometry>'
    text = f'<xacro:property name="meshes" value="{directory}"/>'
    text = xacro(f'{text}<link name="a"><visual>{mesh}</visual></link>')
    path = add_file(add_package(tmp_path / "hull", "hull") / "urdf/a.xacro", text)
    (found,) = check(path, select=["MSH001"]).diagnostics
    assert ("package://" not in found.help) is is_portable


def test_the_ends_of_a_clip() -> None:
    """An ackermann_robot has <min> and <max> in it, as a lidar has: "remove it"."""
    block = "<camera><clip><min>0.1</min><max>9</max></clip></camera>\n"
    found = reported("GAZ003", BASE + sensor("camera", block))
    assert [one.message.rpartition("mean ")[2] for one in found] == ["'near'?", "'far'?"]


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("position_controllers/JointGroupPositionController", "define"),
        ("joint_trajectory_controller/JointTrajectoryController", "write group"),
        ("position_controllers/GripperActionController", "write group"),
        ("acme/Trajectories", "write group"),
    ],
)
def test_a_controller_without_an_action(tmp_path: Path, kind: str, words: str) -> None:
    """A rover's arm: MoveIt cannot use the only controller of the joints, which has topics."""
    manifest = MANIFEST.replace(
        "</license>", "</license><export><build_type>ament_cmake</build_type></export>"
    )
    add_file(tmp_path / "package.xml", manifest)
    model = robot(joint("j", "revolute", limit("0", "1")))
    file = add_file(tmp_path / "r.urdf", f'<robot name="r">{model}</robot>')
    srdf = '<robot name="r"><group name="arm"><joint name="j"/></group></robot>'
    add_file(tmp_path / "config/r.srdf", srdf)
    manager = "moveit_simple_controller_manager"
    action = "{type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [j]}"
    add_file(
        tmp_path / "config/moveit_controllers.yaml",
        f"moveit_controller_manager: {manager}/MoveItSimpleControllerManager\n"
        f"{manager}: {{controller_names: [arm_moveit], arm_moveit: {action}}}\n",
    )
    add_file(
        tmp_path / "config/ros2_controllers.yaml",
        f"controller_manager: {{ros__parameters: {{group: {{type: {kind}}}}}}}\n"
        "group: {ros__parameters: {joints: [j]}}\n",
    )
    (found,) = check(file, select=["SRD029"]).diagnostics
    assert found.help.startswith(words)


def test_a_plugin_that_lacks_its_filename_too() -> None:
    """motion_planning_gazebo: gazebo_ros_control in the block of a link."""
    text = BASE + '<gazebo reference="base"><plugin name="gazebo_ros_control"/></gazebo>'
    (found,) = reported("GAZ014", text)
    assert found.help.endswith("with its filename")


@pytest.mark.parametrize(("edge", "factor"), [("0.35", "100"), ("0.3", "1000")])
def test_a_collision_in_centimetres(edge: str, factor: str) -> None:
    """teleop_robot: an actuator of 0.35 m, with a collision of 35 m."""
    text = link(
        "actuator",
        shape("visual", f'<box size="0.2 0.2 {edge}"/>'),
        shape("collision", '<box size="20 20 35"/>'),
    )
    (found,) = reported("JNT012", text + link("tip", shape("visual", '<box size="0.1 0.1 0.1"/>')))
    assert found.help.startswith(f"divide by {factor}:")


WHEEL = (
    '<link name="{0}_wheel">{1}<collision><geometry><cylinder radius="0.1" length="0.05"/>'
    '</geometry></collision></link><joint name="{0}_wheel_joint" type="continuous">'
    '<parent link="base_link"/><child link="{0}_wheel"/><origin xyz="0 {2} 0.1"/>'
    '<axis xyz="0 1 0"/></joint>'
)
UPRIGHT = '<visual><geometry><box size="0.2 0.05 0.2"/></geometry></visual>'
BASE_LINK = (
    '<robot name="r"><link name="base_link"><collision><origin xyz="0 0 0.2"/><geometry>'
    '<box size="0.4 0.3 0.35"/></geometry></collision></link>'
)


def test_wheels_whose_cylinders_lie_flat() -> None:
    """HAMAL: the axis of both wheels is right, and so are their visuals and their height."""
    wheels = [WHEEL.format("left", UPRIGHT, 0.2), WHEEL.format("right", UPRIGHT, -0.2)]
    text = BASE_LINK + "".join(wheels) + "</robot>"
    turned = [found.help for found in reported("JNT033", text)]
    assert len(turned) == 2
    assert all(help.startswith("rotate the collision cylinder") for help in turned)
    assert all("for the collision" in found.message for found in reported("GEO004", text))
    assert reported("TRE008", text) == []
    alone = BASE_LINK + wheels[0] + "</robot>"
    assert [found.help.split(",")[0] for found in reported("JNT033", alone)] == [
        "write the axis of the collision cylinder"
    ]


def test_a_visual_moved_away_from_the_centre_of_mass() -> None:
    """ROV-Ricketts: the inertia is that of the collision, whose origin is the frame of the CAD."""
    body = '<collision><origin xyz="0 0 0.1" rpy="0 0 {}"/><geometry>{}</geometry></collision>'
    at = '<inertial><origin xyz="0 0 {}"/><mass value="1"/></inertial>'
    seen = f"<visual><geometry>{BOX}</geometry></visual>"
    for height, moved in ((0.1, "visual"), (0.07, "collision")):
        parts = at.format(height) + seen + body.format(1.5707963, BOX)
        (found,) = reported("GEO004", link("a", parts))
        assert found.help.startswith(f"give the {moved}")
