"""LAU032: velocity commands that nothing reads, or with another message."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, SPAWNER
from tests.launched import reported
from tests.naming import naming

MUX = NODE.format("twist_mux", "twist_mux", "{}")
NAV2 = NODE.format("nav2_controller", "controller_server", "{}")
TELEOP = NODE.format("teleop_twist_joy", "teleop_node", "{}")
OPTIONAL = NODE.format("joy", "joy_node", "condition=IfCondition(LaunchConfiguration('joy'))")
VIEWER = NODE.format("rviz2", "rviz2", "arguments=['-d', '{}/not_committed.rviz']")
COMMANDS = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['/drive/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist']",
)


@pytest.mark.parametrize(
    ("text", "topic"),
    [
        (MUX.format("") + COMMANDS, "/cmd_vel_out"),
        (MUX.format("") + COMMANDS + OPTIONAL, "/cmd_vel_out"),
        (MUX.format("") + COMMANDS + VIEWER, "/cmd_vel_out"),
        (MUX.format("remappings=[('/cmd_vel_out', '/drive/cmd_vel')]") + COMMANDS, ""),
        (MUX.format("remappings=[('cmd_vel_out', x)]") + COMMANDS, ""),
        (MUX.format("") + COMMANDS.replace("]gz", "[gz"), ""),  # nothing reads any
        (MUX.format("") + COMMANDS + NODE.format("arm", "driver", ""), ""),
        (TELEOP.format("") + COMMANDS, "/cmd_vel"),
        (TELEOP.format("namespace='drive'") + COMMANDS, ""),
        (TELEOP.format("") + COMMANDS + NODE.format("nav2_velocity_smoother", "x", ""), ""),
        (TELEOP.format("parameters=['{}/mux.yaml']") + COMMANDS, ""),
        (NAV2.format("") + COMMANDS, "/cmd_vel"),
        (NAV2.format("remappings=[('cmd_vel', '/drive/cmd_vel')]") + COMMANDS, ""),
        (NAV2.format("") + COMMANDS + "ExecuteProcess(cmd=['sleep', '3'])\n", "/cmd_vel"),
        (NAV2.format("") + COMMANDS + "ExecuteProcess(cmd=['./driver'])\n", ""),
    ],
)
def test_velocity_commands(tmp_path: Path, text: str, topic: str) -> None:
    files = {"mux.yaml": "mux: {ros__parameters: {topics: {joy: {topic: cmd_vel}}}}\n"}
    text = text.replace("{}", str(tmp_path))
    found = [one.message for one in reported(tmp_path, "LAU032", "a.launch.py", text, files)]
    assert [one.split("'")[3] for one in found] == [topic] * bool(topic)
    assert all("read on '/drive/cmd_vel'" in one for one in found)


CONTROLLERS = """
controller_manager: {ros__parameters: {
  drive: {type: diff_drive_controller/DiffDriveController}, arm: {type: a/B}}}
mux:
  ros__parameters:
    use_stamped: true
    topics: {joy: {topic: joy_vel}, nav: {topic: nav_vel}}
"""
MUXED = MUX.format("parameters=['{}/c.yaml'], remappings=[('cmd_vel_out', '/drive/cmd_vel')]")
NAVIGATED = NAV2.format("remappings=[('cmd_vel', 'nav_vel')]")


@pytest.mark.parametrize(
    ("text", "values"),
    [
        (MUXED + NAVIGATED, ("twist_mux", "/drive/cmd_vel", "drive")),
        (MUXED + NAVIGATED + SPAWNER.format(["drive"]), ()),
        (MUXED.replace("/drive/", "/base/") + NAVIGATED, ()),  # nothing to propose
        (
            MUXED + NAVIGATED + SPAWNER.format(["drive"]) + TELEOP.format(""),
            ("teleop_node", "/cmd_vel", "/joy_vel"),  # which nothing publishes, unlike /nav_vel
        ),
    ],
)
def test_what_would_read_them(tmp_path: Path, text: str, values: tuple[str, ...]) -> None:
    files = {"c.yaml": CONTROLLERS}
    found = reported(tmp_path, "LAU032", "a.launch.py", text.replace("{}", str(tmp_path)), files)
    messages = [one.message for one in found if "nothing reads" in one.message]
    assert messages == [naming(*values)] * bool(values)


HOLD = """
from geometry_msgs.msg import Twist

class Hold(Node):
    def start(self):
        self.publisher = self.create_publisher(Twist, "/drive/cmd_vel", 10)
        self.publisher.publish(Twist())
"""


@pytest.mark.parametrize(
    ("program", "count"),
    [
        (HOLD, 1),
        ("", 0),
        (f"{HOLD}\nkind = Twist", 0),
        (HOLD.replace("publisher(", "subscription("), 0),
    ],
)
def test_a_program_of_the_workspace(tmp_path: Path, program: str, count: int) -> None:
    files = {"src/mine/package.xml": "<package><name>mine</name></package>"}
    files |= {"src/mine/hold.py": program} if program else {}
    text = NAV2.format("") + COMMANDS + NODE.format("mine", "hold", "")
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert ["which nothing reads" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("parameters", "own", "stamped", "reported_words"),
    [
        ("", "cmd_vel", "False", "velocity commands"),
        ("", "/drive/cmd_vel", "False", "'/drive/cmd_vel', where TwistStamped"),
        ("", "/drive/cmd_vel", "True", ""),
        ("", "/drive/cmd_vel", "unknown", ""),
        ("use_stamped_vel: false", "/drive/cmd_vel_unstamped", "False", ""),
        ("use_stamped_vel: false", "/drive/cmd_vel_unstamped", "True", "where Twist is"),
        ("use_stamped_vel: false", "/drive/cmd_vel", "False", "where TwistStamped"),
        ("use_stamped_vel: false", "/cmd_vel", "False", "which nothing reads"),
        ("", "/drive/cmd_vel_unstamped", "False", "/drive/cmd_vel_unstamped', which nothing reads"),
        ("use_stamped_vel: true", "/drive/cmd_vel_unstamped", "True", "which nothing reads"),
    ],
)
def test_velocity_commands_of_a_controller(
    tmp_path: Path, parameters: str, own: str, stamped: str, reported_words: str
) -> None:
    files = {
        "c.yaml": "controller_manager: {ros__parameters: "
        "{drive: {type: diff_drive_controller/DiffDriveController}}}\n"
        f"drive: {{ros__parameters: {{{parameters}}}}}\n"
    }
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + SPAWNER.format(["drive"])
        + TELEOP.format(
            f"remappings=[('cmd_vel', '{own}')], "
            f"parameters=[{{'publish_stamped_twist': {stamped}}}]"
        )
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [reported_words in one.message for one in found] == [True] * bool(reported_words)


@pytest.mark.parametrize(
    ("parameters", "count"),
    [
        ("parameters=['{}/mux.yaml']", 1),
        ("", 0),  # the default depends on the distribution
        ("arguments=['--ros-args', '-p', 'use_stamped:=true']", 0),
    ],
)
def test_type_of_velocity_commands(tmp_path: Path, parameters: str, count: int) -> None:
    files = {"mux.yaml": "mux: {ros__parameters: {use_stamped: true}}\n"}
    given = f"remappings=[('cmd_vel_out', '/drive/cmd_vel')], {parameters}"
    text = MUX.format(given).replace("{}", str(tmp_path)) + COMMANDS
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    expected = naming("twist_mux", "TwistStamped", "/drive/cmd_vel", "where Twist is")
    assert [one.message for one in found] == [expected] * count


@pytest.mark.parametrize(
    ("is_stamped", "topic", "count"), [("true", "joy", 1), ("true", "key", 0), ("false", "joy", 0)]
)
def test_type_of_the_inputs_of_a_mux(
    tmp_path: Path, is_stamped: str, topic: str, count: int
) -> None:
    files = {
        "mux.yaml": f"twist_mux: {{ros__parameters: {{use_stamped: {is_stamped}, "
        "topics: {joystick: {topic: joy}}}}\n"
    }
    text = NODE.format(
        "twist_mux", "twist_mux", f"parameters=['{tmp_path}/mux.yaml']"
    ) + TELEOP.format(f"remappings=[('cmd_vel', '{topic}')]")
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert sum("where TwistStamped" in one.message for one in found) == count


NAVIGATION = """
IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        [FindPackageShare('nav2_bringup'), '/launch/navigation_launch.py']
    ),
    launch_arguments={{'params_file': '{}/nav2.yaml'}}.items(),
)
"""
MONITOR = "collision_monitor: {{ros__parameters: {{cmd_vel_in_topic: {}, use_sim_time: true}}}}\n"


@pytest.mark.parametrize(
    ("topic", "count"), [("cmd_vel_smoothed", 0), ("cmd_vel_nav", 0), ("cmd_vel_raw", 1)]
)
def test_commands_of_the_collision_monitor(tmp_path: Path, topic: str, count: int) -> None:
    files = {"nav2.yaml": MONITOR.format(topic)}
    text = NAVIGATION.format(tmp_path)
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    words = "'velocity_smoother' publishes '/cmd_vel_smoothed'"
    assert [words in one.message for one in found] == [True] * count


@pytest.mark.parametrize(("program", "count"), [("rate = 5", 1), ("cmd = Twist", 0), ("", 0)])
def test_commands_next_to_an_own_program(tmp_path: Path, program: str, count: int) -> None:
    """What names no velocity commands does not publish them; without a source it may."""
    files = {"nav2.yaml": MONITOR.format("cmd_vel_raw")}
    files["src/mine/package.xml"] = "<package><name>mine</name></package>"
    files |= {"src/mine/watch.py": program} if program else {}
    text = NAVIGATION.format(tmp_path) + NODE.format("mine", "watch", "")
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    expected = naming("collision_monitor", "/cmd_vel_raw", "velocity_smoother", "/cmd_vel_smoothed")
    assert [one.message for one in found] == [expected] * count


OUT = "collision_monitor: {{ros__parameters: {{cmd_vel_out_topic: {}, use_sim_time: true}}}}\n"


@pytest.mark.parametrize(
    ("topic", "other", "count"),
    [
        ("drive/cmd_vel", "", 0),
        ("drive/cmd_vels", "", 1),
        ("cmd_vel_nav", "", 0),  # of the smoother
        ("mux/nav", "mux: {ros__parameters: {topics: {nav: {topic: mux/nav}}}}\n", 0),
    ],
)
def test_output_of_the_collision_monitor(
    tmp_path: Path, topic: str, other: str, count: int
) -> None:
    files = {"nav2.yaml": OUT.format(topic) + other}
    remapped = MUX.format("remappings=[('cmd_vel_out', '/drive/cmd_vel')]")
    text = NAVIGATION.format(tmp_path) + COMMANDS + remapped
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    expected = ["write drive/cmd_vel"] * count
    assert [one.help for one in found if "collision_monitor" in one.message] == expected


def test_a_mux_does_not_read_its_own_output(tmp_path: Path) -> None:
    yaml = "mux: {ros__parameters: {use_stamped: false, topics: {nav: {topic: /cmd_vel_nav}}}}\n"
    given = f"remappings=[('cmd_vel_out', '/cmd_vel_x')], parameters=['{tmp_path}/mux.yaml']"
    text = MUX.format(given) + COMMANDS
    (found,) = reported(tmp_path, "LAU032", "a.launch.py", text, {"mux.yaml": yaml})
    assert found.help == "remap /cmd_vel_x to /drive/cmd_vel"


@pytest.mark.parametrize(
    ("out", "nodes", "count"),
    [
        ("", COMMANDS, 1),
        ("cmd_vel", COMMANDS, 1),
        ("drive/cmd_vel", COMMANDS, 0),
        ("", COMMANDS.replace("/drive/cmd_vel@", "/cmd_vel@"), 0),
        ("", COMMANDS + NODE.format("nav2_velocity_smoother", "velocity_smoother", ""), 0),
        ("", COMMANDS + NODE.format("arm", "driver", ""), 0),
        ("", "", 0),  # nothing reads any
    ],
)
def test_commands_of_an_included_navigation(
    tmp_path: Path, out: str, nodes: str, count: int
) -> None:
    files = {"nav2.yaml": OUT.format(out) if out else "amcl: {ros__parameters: {alpha1: 0.2}}\n"}
    found = reported(tmp_path, "LAU032", "a.launch.py", NAVIGATION.format(tmp_path) + nodes, files)
    messages = [one.message for one in found if "navigation_launch.py" in one.message]
    expected = naming("navigation_launch.py", "/cmd_vel", "nothing reads", "/drive/cmd_vel")
    assert messages == [expected] * count


@pytest.mark.parametrize(
    ("action", "count"),
    [
        ("PushRosNamespace('drive')", 0),
        ("PushRosNamespace(LaunchConfiguration('other'))", 0),
        ("PushRosNamespace('')", 1),
        ("PushRosNamespace(LaunchConfiguration('ns'))", 1),
        ("PushROSNamespace(condition=IfCondition('false'), namespace='drive')", 1),
        ("SetRemap('/cmd_vel', '/drive/cmd_vel')", 0),
        ("SetRemap('/cmd_vel', '/drive/cmd_vel', condition=IfCondition('false'))", 1),
    ],
)
def test_namespaces_and_remappings_of_several_nodes(
    tmp_path: Path, action: str, count: int
) -> None:
    text = f"DeclareLaunchArgument('ns', default_value='')\n{action}\n"
    text += TELEOP.format("") + COMMANDS
    assert len(reported(tmp_path, "LAU032", "a.launch.py", text)) == count


@pytest.mark.parametrize(
    ("group", "count"),
    [
        ('<group ns="drive">', 0),
        ('<group ns="$(var ns)">', 1),
        ('<group><push-ros-namespace namespace="drive"/>', 0),
        ('<group><push-ros-namespace namespace="$(var ns)"/>', 1),
        ('<group><set_remap from="/cmd_vel" to="/drive/cmd_vel"/>', 0),
    ],
)
def test_groups_of_xml(tmp_path: Path, group: str, count: int) -> None:
    text = f"""<arg name="ns" default=""/>{group}
    <node pkg="teleop_twist_joy" exec="teleop_node"/>
    <node pkg="ros_gz_bridge" exec="parameter_bridge"
          args="/drive/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"/>
    </group>"""
    assert len(reported(tmp_path, "LAU032", "a.launch.xml", text)) == count


def test_a_navigation_with_a_namespace(tmp_path: Path) -> None:
    text = NAVIGATION.replace("{{'params", "{{'namespace': 'drive', 'params").format(tmp_path)
    files = {"nav2.yaml": "amcl: {ros__parameters: {alpha1: 0.2}}\n"}
    assert not reported(tmp_path, "LAU032", "a.launch.py", text + COMMANDS, files)


SMOOTHER = """
Node(package='nav2_velocity_smoother', executable='velocity_smoother', name='velocity_smoother',
     remappings=[('cmd_vel', 'cmd_vel_raw')]{})
Node(package='nav2_collision_monitor', executable='collision_monitor', name='collision_monitor',
     parameters=['{}/nav2.yaml'])
"""
PARAMETERS = """collision_monitor:
  ros__parameters: {{cmd_vel_in_topic: cmd_vel_smoothed, cmd_vel_out_topic: {}, x: 1}}
"""
NAV_MUX = "mux: {ros__parameters: {use_stamped: false, topics: {nav: {topic: cmd_vel_nav}}}}\n"


@pytest.mark.parametrize(
    ("topic", "namespace", "count"),
    [
        ("cmd_vel_nav", "", 0),
        ("cmd_vel_raw", "", 0),  # the smoother reads it
        ("cmd_vel", "", 1),
        ("cmd_vel", ", namespace=name", 0),  # what it reads is unknown
    ],
)
def test_output_next_to_remapped_smoothers(
    tmp_path: Path, topic: str, namespace: str, count: int
) -> None:
    given = f"remappings=[('cmd_vel_out', '/drive/cmd_vel')], parameters=['{tmp_path}/mux.yaml']"
    text = SMOOTHER.format(namespace, tmp_path) + COMMANDS + MUX.format(given)
    files = {"nav2.yaml": PARAMETERS.format(topic), "mux.yaml": NAV_MUX}
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [one.help for one in found if "collision_monitor" in one.message] == [
        "write cmd_vel_nav"
    ] * count


@pytest.mark.parametrize(
    ("remapped", "more", "lost"),
    [
        ("('cmd_vel', 'cmd_vel_nav'), ('cmd_vel_smoothed', 'drive/cmd_vel')", "", ""),
        ("('cmd_vel', 'cmd_vel_nav')", "", "/cmd_vel_smoothed"),
        ("('cmd_vel', 'cmd_vel_nav'), ('cmd_vel_smoothed', 'cmd_vel')", "", "/cmd_vel"),
        (
            "('cmd_vel', 'cmd_vel_nav')",
            NODE.format("nav2_collision_monitor", "collision_monitor", ""),
            "",
        ),
    ],
)
def test_a_smoother_that_nothing_reads(tmp_path: Path, remapped: str, more: str, lost: str) -> None:
    smoother = f"name='velocity_smoother', remappings=[{remapped}]"
    text = NODE.format("nav2_velocity_smoother", "velocity_smoother", smoother) + COMMANDS + more
    found = reported(tmp_path, "LAU032", "a.launch.py", text)
    expected = [naming("velocity_smoother", lost, "/drive/cmd_vel")] if lost else []
    assert [one.message for one in found] == expected


@pytest.mark.parametrize(("stamped", "who"), [("true", "twist_mux"), ("false", "teleop_node")])
def test_a_mux_with_the_wrong_type(tmp_path: Path, stamped: str, who: str) -> None:
    """Its inputs have the type of its output: only the mux, or only its input, is to be changed."""
    yaml = "mux: {{ros__parameters: {{use_stamped: {}, topics: {{nav: {{topic: joy}}}}}}}}\n"
    given = f"remappings=[('cmd_vel_out', '/drive/cmd_vel')], parameters=['{tmp_path}/mux.yaml']"
    plain = "'publish_stamped_twist': " + ("False" if stamped == "true" else "True")
    teleop = TELEOP.format(f"remappings=[('cmd_vel', 'joy')], parameters=[{{{plain}}}]")
    files = {"mux.yaml": yaml.format(stamped)}
    text = MUX.format(given) + COMMANDS + teleop
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [one.message.split("'")[1] for one in found] == [who]


@pytest.mark.parametrize(
    ("stamped", "read", "message"),
    [
        (
            "true",
            "Twist",
            naming("collision_monitor", "TwistStamped", "/cmd_vel", "where Twist is"),
        ),
        ("false", "Twist", ""),
        ("", "Twist", ""),
        ("false", "TwistStamped", naming("collision_monitor", "Twist", "/cmd_vel", "TwistStamped")),
        (
            "",
            "TwistStamped",
            naming("collision_monitor", "up to Jazzy", "Twist", "/cmd_vel", "TwistStamped"),
        ),
        ("$(var stamped)", "TwistStamped", ""),
    ],
)
def test_stamps_of_nav2(tmp_path: Path, stamped: str, read: str, message: str) -> None:
    own = f", enable_stamped_cmd_vel: {stamped}" if stamped else ""
    files = {"n.yaml": f"collision_monitor: {{ros__parameters: {{use_sim_time: true{own}}}}}\n"}
    monitor = NODE.format(
        "nav2_collision_monitor", "collision_monitor", f"parameters=['{tmp_path}/n.yaml']"
    )
    drive = COMMANDS.replace("/drive/cmd_vel", "/cmd_vel").replace("msg/Twist]", f"msg/{read}]")
    found = reported(tmp_path, "LAU032", "a.launch.py", monitor + drive, files)
    assert [one.message for one in found] == [message] * bool(message)
