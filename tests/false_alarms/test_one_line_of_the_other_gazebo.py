"""One line of another Gazebo is the mistake: it does not make mistakes of all that is right."""

from pathlib import Path

import pytest

from tests.gazebos import BASE, plugin
from tests.naming import naming
from tests.reported import reported
from urdfkit import check
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver

ROBOT = """<robot name="r">
<link name="base"><inertial><mass value="1"/>
  <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
<link name="arm"><inertial><mass value="1"/>
  <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/>
  <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="10" velocity="1"/></joint>
<ros2_control name="arm" type="system">
  <hardware><plugin>{hardware}</plugin></hardware>
  <joint name="shoulder">
    <command_interface name="position"/><state_interface name="position"/>
  </joint>
</ros2_control>
<gazebo>
  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
    <parameters>/x.yaml</parameters>
  </plugin>
  {plugins}
</gazebo>
<gazebo reference="arm">
  <sensor name="lidar" type="gpu_lidar"><update_rate>10</update_rate></sensor>
  <sensor name="gps" type="navsat"><update_rate>10</update_rate></sensor>
</gazebo>
</robot>
"""
#: What is about the simulators.
CODES = ["RCT005", "GAZ012", "GAZ040"]


def codes(directory: Path, hardware: str, plugins: str = "") -> list[str]:
    robot = directory / "r.urdf"
    robot.write_text(ROBOT.format(hardware=hardware, plugins=plugins))
    return [one.code for one in check(robot, select=CODES).diagnostics]


def test_a_hardware_plugin_of_gazebo_classic(tmp_path: Path) -> None:
    assert codes(tmp_path, "gazebo_ros2_control/GazeboSystem") == ["RCT005"]
    assert codes(tmp_path, "gz_ros2_control/GazeboSimSystem") == []


def test_a_plugin_of_gazebo_classic_is_reported_once(tmp_path: Path) -> None:
    system = "gz_ros2_control/GazeboSimSystem"
    old = '<plugin name="p3d" filename="libgazebo_ros_p3d.so"><bodyName>arm</bodyName></plugin>'
    assert codes(tmp_path, system, old) == ["GAZ012"]


def test_a_robot_for_both_is_checked_for_both(tmp_path: Path) -> None:
    both = (
        '<plugin name="control" filename="libgazebo_ros2_control.so"/>'
        '<plugin name="p3d" filename="libgazebo_ros_p3d.so"/>'
    )
    found = codes(tmp_path, "gz_ros2_control/GazeboSimSystem", both)
    assert found.count("GAZ040") == 2
    sensors = check(tmp_path / "r.urdf", select=["GAZ040"]).diagnostics
    assert {one.severity.value for one in sensors} == {"info"}, "one of the two makes them"


def test_a_package_for_both_generations_of_ros(tmp_path: Path) -> None:
    """LimX's robot-description: catkin in ROS 1 and ament in ROS 2, by conditions."""
    tools = (f"<buildtool_depend>{tool}</buildtool_depend>" for tool in ("catkin", "ament_cmake"))
    (tmp_path / "package.xml").write_text(f"<package><name>a</name>{''.join(tools)}</package>")
    manifest = manifest_of(Resolver(environment={}), str(tmp_path / "r.urdf"))
    assert manifest is not None
    assert manifest.ros is None


@pytest.mark.parametrize(
    ("targets", "count"), [(("classic-ros1", "classic-ros2"), 0), (("classic-ros2",), 1)]
)
def test_a_plugin_that_is_complete_for_one_of_the_gazebos(
    targets: tuple[str, ...], count: int
) -> None:
    """Interbotix' locobot of ROS 1, with one plugin of ROS 2 left: required is `<bodyName>`."""
    tags = "<bodyName>base</bodyName><topicName>pose</topicName><frameName>map</frameName>"
    more = (
        "<update_rate>9</update_rate><xyz_offset>0 0 0</xyz_offset><rpy_offset>0 0 0</rpy_offset>"
    )
    own = "<gaussian_noise>0</gaussian_noise>"
    robot = BASE + plugin("libgazebo_ros_p3d.so", tags + more + own)
    assert len(reported("GAZ017", robot, targets=targets)) == count


@pytest.mark.parametrize(
    ("filename", "name", "severity"),
    [
        ("gz-sim-sensors-system", "gz::sim::systems::Sensors", "info"),
        ("ignition-gazebo-sensors-system", "gz::sim::systems::Sensors", "info"),
        ("libgazebo_ros_laser.so", "laser", "error"),
    ],
)
def test_the_names_of_gz_sim_in_fortress(filename: str, name: str, severity: str) -> None:
    """An Aubo in Fortress, which has known them since January 2024."""
    text = BASE + plugin(filename, name=name)
    (found,) = reported("GAZ012", text, targets=("gz-fortress",))
    assert found.severity.value == severity


@pytest.mark.parametrize("target", [None, "classic-ros2"])
def test_plugins_of_ros_1_in_a_package_of_ros_2(tmp_path: Path, target: str | None) -> None:
    """The da Vinci's description: moved to ROS 2 for RViz, its plugins are of ROS 1 throughout."""
    text = "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(text)
    robot = tmp_path / "arm.urdf"
    old = plugin("libgazebo_ros_control.so")
    robot.write_text(f'<robot name="arm">{BASE}{old}</robot>')
    (found,) = check(robot, select=["GAZ012"], targets=[target] if target else []).diagnostics
    assert found.severity.value == ("error" if target else "warning")


@pytest.mark.parametrize("ros", ["1", "2"])
def test_a_misspelt_plugin_is_suggested_for_the_own_ros(ros: str) -> None:
    """An Elfin of ROS 2 with "gazebo_ros_control.so"."""
    text = BASE + plugin("gazebo_ros_control.so")
    (found,) = reported("GAZ011", text, targets=(f"ros{ros}", f"classic-ros{ros}"))
    assert found.help == naming(f"libgazebo_ros{'2' if ros == '2' else ''}_control.so")
