"""LAU022: see the rule."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import CONTROLLERS, MANAGER, NODE, SPAWNER, STATE, messages
from tests.jointed import joint, robot
from tests.launched import reported
from tests.naming import naming


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (STATE.format("") + SPAWNER.format(["arm"]), 1),
        (STATE.format("") + SPAWNER.format(["states", "arm"]), 0),
        (STATE.format("") + SPAWNER.format(["arm"]) + SPAWNER.format(["states"]), 0),
        (STATE.format("") + SPAWNER.format(["other"]), 0),  # unknown type
        (SPAWNER.format(["arm"]), 0),
        (STATE.format(""), 0),
        (
            STATE.format("")
            + SPAWNER.format(["arm"])
            + NODE.format("joint_state_publisher", "joint_state_publisher", ""),
            0,
        ),
        (
            STATE.format("")
            + SPAWNER.format(["arm"])
            + NODE.format(
                "ros_gz_bridge",
                "parameter_bridge",
                "arguments=['/j@sensor_msgs/msg/JointState[gz.msgs.Model']",
            ),
            0,
        ),
        (STATE.format("") + SPAWNER.format(["arm"]) + "IncludeLaunchDescription(x)\n", 1),
        (
            STATE.format(", condition=IfCondition(LaunchConfiguration('x'))")
            + SPAWNER.format(["arm"]),
            0,
        ),
    ],
)
def test_joint_states(tmp_path: Path, text: str, count: int) -> None:
    found = messages(tmp_path, "LAU022", text)
    assert len(found) == count
    assert all("joint states" in one for one in found)


@pytest.mark.parametrize(
    ("listed", "kind", "count"),
    [
        ("joints: [swing], interfaces: [position]", "revolute", 1),
        ("joints: [swing, slide], interfaces: [position]", "revolute", 0),
        ("joints: [swing], extra_joints: [slide], interfaces: [position]", "revolute", 0),
        ("joints: [swing]", "revolute", 0),  # needs both lists
        ("joints: [swing], interfaces: [position]", "fixed", 0),
        ("use_local_topics: true", "revolute", 0),
    ],
)
def test_joints_that_the_broadcaster_leaves_out(
    tmp_path: Path, listed: str, kind: str, count: int
) -> None:
    """From moveit/moveit2#3312."""
    text = (
        f"robot = open('{tmp_path}/r.urdf').read()\n"
        + MANAGER.format(tmp_path, "")
        + STATE.format(", parameters=[{'robot_description': robot}]")
        + SPAWNER.format(["arm", "states"])
    )
    yaml = f"{CONTROLLERS}\narm: {{ros__parameters: {{joints: [swing, slide]}}}}\n"
    files = {
        "r.urdf": f"<robot name='r'>{robot(joint('swing', kind), joint('slide', kind))}</robot>",
        "c.yaml": f"{yaml}states: {{ros__parameters: {{{listed}}}}}\n",
    }
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert [one.span.text for one in found] == ["swing"] * count


@pytest.mark.parametrize(
    ("command", "count"),
    [
        ("cmd=['ros2', 'run', 'controller_manager', 'spawner', 'states']", 0),
        ("cmd=['ros2 run controller_manager spawner ', 'states'], shell=True", 0),
        ("cmd=[['ros2 run controller_manager spawner ', 'states']], shell=True", 0),
        ("cmd=['ros2', 'run', 'controller_manager', 'spawner', 'arm']", 1),
        ("cmd=['ros2', 'run', 'rviz2', 'rviz2']", 1),
    ],
)
def test_a_spawner_that_ros2_run_starts(tmp_path: Path, command: str, count: int) -> None:
    text = STATE.format("") + SPAWNER.format(["arm"]) + f"ExecuteProcess({command})\n"
    assert len(messages(tmp_path, "LAU022", text)) == count


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("continuous", 1)])
def test_joint_states_of_a_sensor(tmp_path: Path, kind: str, count: int) -> None:
    """rq_fts_ros2_driver: the force-torque sensor has no joint that moves."""
    sensor = robot(joint("measuring", kind))
    (tmp_path / "ft.urdf").write_text(f'<robot name="ft">{sensor}</robot>')
    described = f", parameters=[{{'robot_description': Command(['xacro {tmp_path}/ft.urdf'])}}]"
    assert (
        len(messages(tmp_path, "LAU022", STATE.format(described) + SPAWNER.format(["arm"])))
        == count
    )


ROLLER = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="roll" type="{}"><parent link="a"/><child link="b"/></joint>
<gazebo><plugin filename="gz-sim-{}-system" name="p"/></gazebo></robot>"""
SHOWN = (
    STATE.format(", parameters=[{'robot_description': open('../r.urdf').read()}]")
    + NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    + NODE.format("rviz2", "rviz2", "")
)
JOINTS = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock'{}]",
)


MAYBE = "condition=IfCondition(LaunchConfiguration('it')), "


@pytest.mark.parametrize(
    ("kind", "system", "more", "help"),
    [
        ("continuous", "diff-drive", JOINTS.format(""), "add gz-sim-joint-state-publisher-system"),
        ("continuous", "joint-state-publisher", JOINTS.format(""), "bridge its topic"),
        ("continuous", "pose-publisher", JOINTS.format(""), ""),
        ("fixed", "diff-drive", JOINTS.format(""), ""),
        ("continuous", "diff-drive", "", ""),  # the bridge is started elsewhere
        ("continuous", "diff-drive", JOINTS.format("") + NODE.format("arm", "states", ""), ""),
        ("continuous", "diff-drive", JOINTS.format("") + NODE.format("arm", "s", MAYBE), ""),
        (
            "continuous",
            "diff-drive",
            JOINTS.format("")
            + NODE.format("joint_state_publisher", "joint_state_publisher", MAYBE),
            "add gz-sim-joint-state-publisher-system",
        ),
        (
            "continuous",
            "joint-state-publisher",
            JOINTS.format(", '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model'"),
            "",
        ),
    ],
)
def test_joint_states_of_gazebo(
    tmp_path: Path, kind: str, system: str, more: str, help: str
) -> None:
    files = {"r.urdf": ROLLER.format(kind, system)}
    found = reported(tmp_path, "LAU022", "a.launch.py", SHOWN + more, files)
    assert [one.help.startswith(help) for one in found] == [True] * bool(help)
    assert all("of roll" in one.message for one in found)


@pytest.mark.parametrize(
    ("publisher", "spawner", "count"),
    [
        ("", "", 0),
        (", remappings=[('/tf', 'tf')]", "", 0),
        (", remappings=[('robot_description', 'arm_description')]", "", 1),
        (", remappings=[('/robot_description', '/arm_description')]", "", 1),
        (", remappings=[(x, 'arm_description')]", "", 0),
        (
            ", remappings=[('robot_description', 'arm_description')]",
            ", remappings=[('robot_description', '/arm_description')]",
            0,
        ),
    ],
)
def test_a_description_with_another_name(
    tmp_path: Path, publisher: str, spawner: str, count: int
) -> None:
    create = f"arguments=['-topic', 'robot_description']{spawner}"
    text = STATE.format(publisher) + NODE.format("ros_gz_sim", "create", create)
    found = [one for one in messages(tmp_path, "LAU022", text) if "robot_description" in one]
    expected = naming("/robot_description", "robot_state_publisher", "/arm_description")
    assert found == [expected] * count


@pytest.mark.parametrize(
    ("package", "executable", "more", "count"),
    [
        ("rviz2", "rviz2", "", 1),
        ("joint_state_publisher_gui", "joint_state_publisher_gui", "", 1),
        ("controller_manager", "spawner", "arguments=['states'], ", 1),
        ("robot_state_publisher", "robot_state_publisher", "", 0),  # may publish the topic
        ("acme_robots", "publisher", "", 0),
    ],
)
def test_a_program_that_may_not_run(
    tmp_path: Path, package: str, executable: str, more: str, count: int
) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus: display and sliders have conditions."""
    condition = f"{more}condition=IfCondition(LaunchConfiguration('x'))"
    create = NODE.format("ros_gz_sim", "create", "arguments=['-topic', '/arm_description']")
    optional = NODE.format(package, executable, condition)
    found = messages(tmp_path, "LAU022", STATE.format("") + create + optional)
    expected = naming("/arm_description", "robot_state_publisher", "/robot_description")
    assert found == [expected] * count


@pytest.mark.parametrize(
    ("condition", "spawn", "count"),
    [
        ("condition=IfCondition(LaunchConfiguration('x'))", "create", 1),
        ("condition=IfCondition(LaunchConfiguration('x'))", "", 0),  # the display of a real robot
        ("", "create", 0),
    ],
)
def test_sliders_that_may_not_run(tmp_path: Path, condition: str, spawn: str, count: int) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus without the spawner of the broadcaster."""
    sliders = NODE.format("joint_state_publisher", "joint_state_publisher", condition)
    create = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    text = STATE.format("") + SPAWNER.format(["arm"]) + sliders + (create if spawn else "")
    found = [one for one in messages(tmp_path, "LAU022", text) if "joint states" in one]
    assert len(found) == count


@pytest.mark.parametrize(
    ("package", "count"), [("nav2_amcl", 2), ("moveit_ros_move_group", 2), ("acme_robots", 0)]
)
def test_navigation_that_may_not_run(tmp_path: Path, package: str, count: int) -> None:
    """A choice of localization or planning changes neither joint states nor the manager."""
    condition = "condition=IfCondition(LaunchConfiguration('x'))"
    arguments = ["arm", "-c", "/a/controller_manager"]
    text = STATE.format("") + SPAWNER.format(arguments) + NODE.format(package, "node", condition)
    found = messages(tmp_path, "LAU022", text)
    expected = [naming("/a/controller_manager", "/controller_manager")]
    expected.append("nothing publishes the joint states: no joint_state_broadcaster is started")
    assert sorted(found, key=len, reverse=True) == expected[:count]


def test_a_spawner_that_may_not_run(tmp_path: Path) -> None:
    """Its controllers may not be started, and it may be one of another robot."""
    condition = "condition=IfCondition(LaunchConfiguration('x'))"
    spawner = NODE.format("controller_manager", "spawner", f"arguments=['arm'], {condition}")
    assert messages(tmp_path, "LAU022", STATE.format("") + spawner) == []
    other = NODE.format("controller_manager", "spawner", "arguments=['arm']")
    assert len(messages(tmp_path, "LAU022", STATE.format("") + spawner + other)) == 1
    states = spawner.replace("'arm'", "'states'")
    assert messages(tmp_path, "LAU022", STATE.format("") + states + other) == []
    elsewhere = spawner.replace("'arm'", "'states', '-c', '/robot/controller_manager'")
    assert messages(tmp_path, "LAU022", STATE.format("") + elsewhere) == []


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("name='manager'", "manager is '/manager'"),
        ("name='controller_manager'", ""),
        ("name=LaunchConfiguration('x')", ""),
        ("remappings=[('~/robot_description', '/a/robot_description')]", "the robot from '/a/robo"),
        ("remappings=[('~/robot_description', '/robot_description')]", ""),
        ("remappings=[('~/robot_description', LaunchConfiguration('x'))]", ""),
    ],
)
def test_names_of_the_controller_manager(tmp_path: Path, more: str, words: str) -> None:
    text = MANAGER.format(tmp_path, more) + STATE.format("") + SPAWNER.format(["states", "arm"])
    found = reported(tmp_path, "LAU022", "a.launch.py", text, {"c.yaml": CONTROLLERS})
    assert len(found) == bool(words)
    assert all(words in one.message for one in found)


@pytest.mark.parametrize(("topic", "count"), [("/robot_description", 0), ("/robot", 1)])
def test_the_robot_of_another_launch_file(tmp_path: Path, topic: str, count: int) -> None:
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/RobotModel\n"
        f"    Description Topic: {{Value: {topic}}}\n"
    )
    text = NODE.format("rviz2", "rviz2", f"arguments=['-d', '{tmp_path}/a.rviz']")
    files = {"a.rviz": rviz, "launch/robot.launch.py": STATE.format("")}
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert ["publishes a robot" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("parameters", "yaml", "more", "count"),
    [
        ("{'robot_description': x}, ", "use_stamped: true", "", 1),
        ("{'robot_description': x}, ", "use: true", "", 0),
        ("", "use_stamped: true", "", 0),
        ("{'robot_description': x}, ", "use_stamped: true", "generate_rsp_launch(x)\n", 0),
        ("{'robot_description': x}, ", "use_stamped: true", STATE.format(""), 0),
        ("{'robot_description': x}, ", "use_stamped: true", NODE.format("mine", "a", ""), 0),
    ],
)
def test_a_manager_without_a_robot(
    tmp_path: Path, parameters: str, yaml: str, more: str, count: int
) -> None:
    """UTNuclearRoboticsPublic/netft_utils#18: since Jazzy the robot is no parameter."""
    text = MANAGER.format(tmp_path, "").replace("parameters=[", f"parameters=[{parameters}")
    files = {"c.yaml": f"controller_manager: {{ros__parameters: {{{yaml}}}}}\n"}
    found = reported(tmp_path, "LAU022", "a.launch.py", text + more, files)
    assert sum("waits for /robot_description" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("listed", "more", "count"),
    [
        ("<joint_name>wheel</joint_name>", "", 1),
        ("<joint_name>wheel</joint_name><joint_name>swing</joint_name>", "", 0),
        ("", "", 0),  # the system publishes all
        ("<joint_name>wheel</joint_name>", SPAWNER.format(["states"]), 0),
    ],
)
def test_joints_that_the_system_of_gazebo_leaves_out(
    tmp_path: Path, listed: str, more: str, count: int
) -> None:
    """Moth-Balls/husky_kinova_sim without the spawner of the broadcaster."""
    system = "<gazebo><plugin filename='gz-sim-joint-state-publisher-system' name='p'>"
    joints = robot(joint("wheel", "continuous"), joint("swing", "continuous"))
    text = (
        f"robot = open('{tmp_path}/r.urdf').read()\n"
        + MANAGER.format(tmp_path, "")
        + STATE.format(", parameters=[{'robot_description': robot}]")
        + SPAWNER.format(["arm"])
        + NODE.format(
            "ros_gz_bridge",
            "parameter_bridge",
            "arguments=['/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model']",
        )
        + more
    )
    files = {
        "r.urdf": f"<robot name='r'>{joints}{system}{listed}</plugin></gazebo></robot>",
        "c.yaml": f"{CONTROLLERS}\narm: {{ros__parameters: {{joints: [swing]}}}}\n",
    }
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert [(one.span.text, "swing" in one.message) for one in found] == [("'arm'", True)] * count
