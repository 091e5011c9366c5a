"""LAU031: see the rule."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import MANAGER, NODE, STATE, messages
from tests.launched import reported
from tests.naming import naming
from urdfkit import Severity


@pytest.mark.parametrize(
    ("parameters", "count"),
    [
        (", parameters=[{'robot_description': x}]", 1),
        (", parameters=[{'robot_description': x, 'use_sim_time': True}]", 0),
        (", parameters=[unknown]", 0),
    ],
)
def test_clocks(tmp_path: Path, parameters: str, count: int) -> None:
    other = NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    bridge = NODE.format(
        "ros_gz_bridge",
        "parameter_bridge",
        "arguments=['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock']",
    )
    assert (
        len(messages(tmp_path, "LAU031", STATE.format(parameters) + other + spawn + bridge))
        == count
    )
    assert messages(tmp_path, "LAU031", STATE.format(parameters) + other) == []


GAZEBO = """IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        os.path.join(get_package_share_directory("ros_gz_sim"), "launch", "gz_sim.launch.py")
    ),
    launch_arguments={"gz_args": "-r empty.sdf"}.items(),
)
"""


@pytest.mark.parametrize(
    ("words", "more", "count"),
    [
        # BILLEE: the remapping is in the command line
        (", '--ros-args', '-r', '/world/w/clock:=/clock'", "", 0),
        (", '--ros-args', '--remap', 'bridge:/world/w/clock:=/clock'", "", 0),
        (", '--ros-args', '-r', unknown", "", 0),
        ("", ", ros_arguments=['-r', '/world/w/clock:=/clock']", 0),
        (", '--ros-args', '-r', '__ns:=/bot'", "", 1),
        ("", "", 1),
    ],
)
def test_a_clock_that_is_remapped(tmp_path: Path, words: str, more: str, count: int) -> None:
    state = STATE.format(", parameters=[{'robot_description': x, 'use_sim_time': True}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    topic = "'/world/w/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock'"
    bridge = NODE.format("ros_gz_bridge", "parameter_bridge", f"arguments=[{topic}{words}]{more}")
    found = messages(tmp_path, "LAU031", state + spawn + bridge + GAZEBO)
    assert len([one for one in found if "/clock" in one]) == count


@pytest.mark.parametrize(("publisher", "count"), [("True", 1), ("False", 0)])
def test_programs_that_do_not_use_their_time(tmp_path: Path, publisher: str, count: int) -> None:
    """A robot for a competition: `create` has the parameter, and robot_state_publisher has it."""
    sim_time = "parameters=[{'use_sim_time': True}]"
    spawn = NODE.format("ros_gz_sim", "create", f"arguments=['-topic', 'x'], {sim_time}")
    bridge = NODE.format("ros_gz_bridge", "parameter_bridge", f"arguments=[], {sim_time}")
    state = STATE.format(f", parameters=[{{'robot_description': x, 'use_sim_time': {publisher}}}]")
    found = messages(tmp_path, "LAU031", spawn + bridge + state + GAZEBO)
    expected = naming("robot_state_publisher", "use_sim_time", "/clock", "0")
    assert [one for one in found if "/clock" in one] == [expected] * count


@pytest.mark.parametrize(
    ("package", "clock", "count"),
    [
        ("rviz2", "use_sim_time", 1),
        ("rviz2", "other", 0),
        ("nav2_amcl", "use_sim_time", 1),
        ("acme_robots", "use_sim_time", 0),
    ],
)
def test_a_clock_without_optional_programs(
    tmp_path: Path, package: str, clock: str, count: int
) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus: RViz has a condition."""
    state = STATE.format(f", parameters=[{{'robot_description': x, '{clock}': True}}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    bridge = NODE.format("ros_gz_bridge", "parameter_bridge", "arguments=[]")
    condition = "condition=IfCondition(LaunchConfiguration('x'))"
    optional = NODE.format(package, package, f"parameters=[{{'use_sim_time': True}}], {condition}")
    found = messages(tmp_path, "LAU031", state + spawn + bridge + GAZEBO + optional)
    assert len([one for one in found if "/clock" in one]) == count


@pytest.mark.parametrize(
    ("value", "words"), [("False", "is false, but"), ("True", ""), (None, "lacks use_sim_time")]
)
def test_a_node_without_simulation_time(tmp_path: Path, value: str | None, words: str) -> None:
    own = f", parameters=[{{'use_sim_time': {value}}}]" if value else ", parameters=[{}]"
    text = (
        NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
        + NODE.format("ros_gz_sim", "create", "arguments=['-string', '<robot/>']")
        + STATE.format(own)
    )
    found = [one for one in messages(tmp_path, "LAU031", text) if "use_sim_time" in one]
    assert len(found) == bool(words)
    assert all(words in one for one in found)


CHOICE = "condition=UnlessCondition(LaunchConfiguration('sim'))"


@pytest.mark.parametrize(
    ("own", "more", "words"),
    [
        ("{'use_sim_time': False}", "", "is false, but"),
        ("{'use_sim_time': True}", "", ""),
        ("{}", "", "lacks use_sim_time"),
        ("{}", "SetParameter('use_sim_time', True)\n", ""),
        ("{'use_sim_time': False}", "SetParameter('use_sim_time', True)\n", "is false, but"),
    ],
)
def test_a_choice_between_gazebo_and_the_robot(
    tmp_path: Path, own: str, more: str, words: str
) -> None:
    """What another choice starts does not make the clock of the others uncertain."""
    text = (
        "from launch_ros.actions import Node, SetParameter\n"
        "DeclareLaunchArgument('sim', default_value='true')\n"
        + more
        + NODE.format("own", "driver", CHOICE)
        + NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
        + NODE.format("ros_gz_sim", "create", "arguments=['-string', '<robot/>']")
        + NODE.format("nav2_amcl", "amcl", f"parameters=[{own}]")
    )
    files = {"src/own/package.xml": "<package><name>own</name></package>"}
    found = reported(tmp_path, "LAU031", "a.launch.py", text, files)
    assert [words in one.message for one in found] == [True] * bool(words)


def test_the_clock_of_an_included_file(tmp_path: Path) -> None:
    included = "IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'b.launch.py'))\n"
    text = (
        "import os\n"
        + NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
        + NODE.format("ros_gz_sim", "create", "arguments=['-string', '<robot/>']")
        + included
    )
    amcl = NODE.format("nav2_amcl", "amcl", "parameters=[{'use_sim_time': False}]")
    files = {"launch/b.launch.py": amcl}
    (found,) = reported(tmp_path, "LAU031", "a.launch.py", text, files)
    expected = 'give it {"use_sim_time": True}, or pass use_sim_time to b.launch.py'
    assert (found.help, found.severity) == (expected, Severity.WARNING)


SWITCHED = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><link name="a"/>
<xacro:arg name="sim" default="false"/>
<ros2_control name="c" type="system"><hardware>
<xacro:if value="$(arg sim)"><plugin>{}</plugin></xacro:if>
<xacro:unless value="$(arg sim)"><plugin>{}</plugin></xacro:unless>
</hardware></ros2_control>
<gazebo><plugin filename="gz_ros2_control-system" name="p"/></gazebo></robot>"""
GZ = "gz_ros2_control/GazeboSimSystem"


@pytest.mark.parametrize(
    ("simulated", "real", "arguments", "count"),
    [
        (GZ, "acme/Driver", "", 1),
        (GZ, "acme/Driver", " sim:=true", 0),
        (GZ, "acme/OwnGazeboSystem", "", 0),
        ("acme/Other", "acme/Driver", "", 0),
        ("acme/Other", "mock_components/GenericSystem", "", 1),
    ],
)
def test_hardware_in_gazebo(
    tmp_path: Path, simulated: str, real: str, arguments: str, count: int
) -> None:
    robot = f"Command(['xacro {tmp_path}/r.xacro{arguments}'])"
    text = STATE.format(f", parameters=[{{'robot_description': {robot}}}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    files = {"r.xacro": SWITCHED.format(simulated, real)}
    found = reported(tmp_path, "LAU031", "a.launch.py", text + spawn, files)
    assert [f"not load {real}" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("package", "executable", "words", "plugins", "count"),
    [
        ("ros_gz_sim", "create", "'-topic', 'robot_description'", ("gazebo_ros2_control",), 1),
        ("ros_gz_sim", "create", "'-file', 'box.sdf'", ("gazebo_ros2_control",), 0),
        (
            "ros_gz_sim",
            "create",
            "'-topic', 'robot_description'",
            ("gazebo_ros2_control", "gz_ros2_control-system"),
            0,
        ),
        ("gazebo_ros", "spawn_entity.py", "'-topic', 'r'", ("gazebo_ros2_control",), 0),
        ("gazebo_ros", "spawn_entity.py", "'-topic', 'r'", ("gz_ros2_control-system",), 1),
    ],
)
def test_plugins_of_another_gazebo(
    tmp_path: Path, package: str, executable: str, words: str, plugins: tuple[str, ...], count: int
) -> None:
    """Cengaver: a second launch file for Fortress, with the plugins of Gazebo Classic."""
    tags = "".join(f'<plugin name="p" filename="lib{name}.so"/>' for name in plugins)
    robot = f'<robot name="r"><link name="a"/><gazebo>{tags}</gazebo></robot>'
    text = STATE.format(
        f", parameters=[{{'robot_description': Command(['xacro {tmp_path}/r.urdf'])}}]"
    )
    text += NODE.format(package, executable, f"arguments=[{words}]")
    found = reported(tmp_path, "LAU031", "a.launch.py", text, {"r.urdf": robot})
    assert [one.message for one in found if "not load" in one.message] == [
        naming("p", f"lib{plugins[0]}.so")
    ] * count


@pytest.mark.parametrize(("first", "count"), [("true", 0), ("false", 1)])
def test_hardware_of_a_second_description(tmp_path: Path, first: str, count: int) -> None:
    """Elfin: the robot in Gazebo has its arguments; that for MoveIt has the defaults."""
    node = f"Command(['xacro {tmp_path}/r.xacro sim:={first}'])"
    text = STATE.format(f", parameters=[{{'robot_description': {node}}}]")
    text += NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    more = f"parameters=[{{'robot_description': Command(['xacro {tmp_path}/r.xacro'])}}]"
    text += NODE.format("moveit_ros_move_group", "move_group", more)
    files = {"r.xacro": SWITCHED.format(GZ, "acme/Driver")}
    found = reported(tmp_path, "LAU031", "a.launch.py", text, files)
    words = "gz_ros2_control-system does not load acme/Driver"
    assert len([one for one in found if words in one.message]) == count


@pytest.mark.parametrize(("own", "count"), [("", 1), (", {'use_sim_time': True}", 0)])
def test_move_group_without_simulation_time(tmp_path: Path, own: str, count: int) -> None:
    text = (
        "config = MoveItConfigsBuilder('arm', package_name='arm').to_moveit_configs()\n"
        + NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
        + NODE.format("moveit_ros_move_group", "move_group", f"parameters=[config.to_dict(){own}]")
    )
    found = messages(tmp_path, "LAU031", text)
    assert ["move_group lacks use_sim_time" in one for one in found] == [True] * count


@pytest.mark.parametrize(("stated", "count"), [("true", 0), ("false", 1), (None, 1)])
def test_simulation_time_in_a_file(tmp_path: Path, stated: str | None, count: int) -> None:
    values = "frequency: 30.0" + (f", use_sim_time: {stated}" if stated else "")
    text = NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]") + NODE.format(
        "robot_localization", "ekf_node", f"name='ekf', parameters=['{tmp_path}/ekf.yaml']"
    )
    files = {"ekf.yaml": f"ekf: {{ros__parameters: {{{values}}}}}\n"}
    found = reported(tmp_path, "LAU031", "a.launch.py", text, files)
    assert sum("ekf_node" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("real", "given", "section", "count"),
    [
        ("acme/Driver", "", "controller_manager", 1),
        ("acme/Driver", "", "/**", 1),
        ("acme/Driver", "", "arm", 0),
        ("mock_components/GenericSystem", "", "controller_manager", 1),
        ("acme/MujocoSystem", "", "controller_manager", 0),
        ("acme/Driver", ", {'use_sim_time': False}", "controller_manager", 0),
    ],
)
def test_simulation_time_of_a_robot(
    tmp_path: Path, real: str, given: str, section: str, count: int
) -> None:
    robot = f"Command(['xacro {tmp_path}/r.xacro'])"
    text = STATE.format(f", parameters=[{{'robot_description': {robot}}}]")
    text += MANAGER.format(tmp_path, "").replace("c.yaml'", f"c.yaml'{given}")
    stated = f"{section}: {{ros__parameters: {{use_sim_time: true}}}}\n"
    files = {"r.xacro": SWITCHED.format(GZ, real), "c.yaml": stated}
    found = reported(tmp_path, "LAU031", "a.launch.py", text, files)
    assert sum("controllers wait with use_sim_time" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("package", "file", "count"),
    [
        ("nav2_bringup", "navigation_launch.py", 1),
        ("slam_toolbox", "online_async_launch.py", 1),
        ("nav2_bringup", "rviz_launch.py", 1),
        ("nav2_bringup", "tb3_simulation_launch.py", 0),
        ("turtlebot3_gazebo", "robot.launch.py", 0),
    ],
)
def test_a_clock_with_included_files_of_ros(
    tmp_path: Path, package: str, file: str, count: int
) -> None:
    """Moth-Balls/husky_kinova_sim with navigation."""
    state = STATE.format(", parameters=[{'robot_description': x, 'use_sim_time': True}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    other = GAZEBO.replace("ros_gz_sim", package).replace("gz_sim.launch.py", file)
    other = other.replace('{"gz_args": "-r empty.sdf"}', "{}")
    found = messages(tmp_path, "LAU031", state + spawn + GAZEBO + other)
    assert len([one for one in found if "/clock" in one]) == count


@pytest.mark.parametrize(("condition", "count"), [("", 1), ("condition=IfCondition(x)", 1)])
def test_a_paused_gazebo_with_an_optional_program(
    tmp_path: Path, condition: str, count: int
) -> None:
    text = (
        'x = LaunchConfiguration("x")\n'
        'ExecuteProcess(cmd=["gz", "sim", "empty.sdf"])\n'
        'Node(package="ros_gz_sim", executable="create", arguments=["-string", "<robot/>"])\n'
        'Node(package="controller_manager", executable="spawner", arguments=["arm"])\n'
        f'Node(package="nav2_amcl", executable="amcl", {condition})\n'
    )
    found = reported(tmp_path, "LAU031", "a.launch.py", text)
    assert ["no controller becomes active" in one.message for one in found] == [True] * count
