"""LAU020: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from urdfkit.text.diagnostic import Diagnostic, Severity

NODE = "Node(package='ros_gz_bridge', executable='parameter_bridge', {})\n"
ROBOT = """<robot name="r"><link name="base"/><gazebo reference="base">
<sensor name="front" type="gpu_lidar"><topic>scan</topic></sensor></gazebo></robot>"""


def of_words(directory: Path, *words: str, files: dict[str, str] | None = None) -> list[Diagnostic]:
    text = NODE.format(f"arguments={[*words]!r}")
    if files:
        text = f"x = open(__file__ + '/../../urdf/r.urdf')\nopen('{directory}/r.urdf')\n{text}"
    return reported(directory, "LAU020", "a.launch.py", text, files)


@pytest.mark.parametrize(
    "word",
    [
        "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock",
        "/clock@rosgraph_msgs/msg/Clock[ignition.msgs.Clock",
        "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist",
        "/odom@nav_msgs/msg/Odometry@gz.msgs.Odometry",
        "/a@sensor_msgs/msg/Imu[gz.msgs.IMU@/b",
        "/range@sensor_msgs/msg/Range[gz.msgs.LaserScan",  # of a later release
        "/world/default/control@ros_gz_interfaces/srv/ControlWorld",
        "/image@own_msgs/msg/Image[gz.msgs.Image",
        "__node:=bridge",
    ],
)
def test_valid_bridge(tmp_path: Path, word: str) -> None:
    assert of_words(tmp_path, word) == []


@pytest.mark.parametrize(
    ("word", "help"),
    [
        ("/imu@sensor_msgs/msg/Imu[gz.msgs.Pose", "write gz.msgs.IMU"),
        ("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock]", "write gz.msgs.Clock"),
        ("/imu@sensor_msgs/msg/Imu[gz.msgs.Imu", "write gz.msgs.IMU"),
        ("/imu@sensor_msgs/msg/Imu[gazebo.msgs.IMU", "write gz.msgs.IMU"),
        ("/js@sensor_msgs/msg/JointState[gz.msgs.JointState", "write gz.msgs.Model"),
        ("/imu@sensor_msgs/Imu[gz.msgs.IMU", "write sensor_msgs/msg/Imu"),
        ("/image@std_msgs/msg/Image[gz.msgs.Image", "write sensor_msgs/msg/Image"),
        ("/imu@sensor_msgs/msg/Imu", "write topic@package/msg/Name[gz.msgs.Name"),
    ],
)
def test_invalid_bridge(tmp_path: Path, word: str, help: str) -> None:
    (found,) = of_words(tmp_path, word)
    assert found.severity is Severity.ERROR
    assert found.help.startswith(help)
    assert found.span.text == repr(word)


@pytest.mark.parametrize(
    ("entry", "place", "severity"),
    [
        ("ros_type_name: sensor_msgs/msg/Imu, gz_type_name: gz.msgs.IMU", None, None),
        ("ros_type_name: sensor_msgs/msg/Imu, gz_type_name: gz.msgs.Pose", "gz.msgs.Pose", "error"),
        ("ros_type_name: sensor_msgs/msg/Imu", "sensor_msgs", "error"),
        (
            "ros_type_name: sensor_msgs/msg/Imu, gz_type_name: gz.msgs.IMU, direction: GZ_2_ROS",
            "GZ_2_ROS",
            "error",
        ),
        (
            "ros_type_name: sensor_msgs/msg/Imu, gz_type_name: gz.msgs.IMU, diretion: GZ_TO_ROS",
            "GZ_TO",
            "warning",
        ),
    ],
)
def test_entries_of_a_file(
    tmp_path: Path, entry: str, place: str | None, severity: str | None
) -> None:
    path = tmp_path / "config" / "bridge.yaml"
    text = NODE.format(f"parameters=[{{'config_file': '{path}'}}]")
    files = {"config/bridge.yaml": f"- {{topic_name: imu, {entry}}}\n"}
    found = reported(tmp_path, "LAU020", "a.launch.py", text, files)
    findings = [
        (one.span.source.path, one.severity.value, one.span.text[: len(place or "")])
        for one in found
    ]
    assert findings == ([(str(path), severity, place)] if place else [])


@pytest.mark.parametrize(("link", "count"), [("base", 0), ("r", 1)])
def test_the_link_in_a_default_topic(tmp_path: Path, link: str, count: int) -> None:
    topic = f"/world/hall/model/r/link/{link}/sensor/front/scan"
    robot = ROBOT.replace("<topic>scan</topic>", "")
    word = f"{topic}@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"
    found = of_words(tmp_path, word, files={"r.urdf": robot})
    assert [f"names link '{link}'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("words", "count"),
    [
        (["/lidar@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"], 1),
        (["/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"], 0),
        (["/imu@sensor_msgs/msg/Imu[gz.msgs.IMU"], 0),
        (
            [
                "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan",
                "/world_lidar@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan",
            ],
            0,
        ),
    ],
)
def test_a_sensor_on_another_topic(tmp_path: Path, words: list[str], count: int) -> None:
    found = of_words(tmp_path, *words, files={"r.urdf": ROBOT})
    assert [one.severity for one in found] == [Severity.WARNING] * count
    assert all(one.help == "write /scan" for one in found)


@pytest.mark.parametrize(
    ("topic", "right"), [("camera/points", "/depth/points"), ("scan/pints", "/scan/points")]
)
def test_points_are_of_the_sensor_that_is_not_bridged(
    tmp_path: Path, topic: str, right: str
) -> None:
    camera = '<sensor name="eye" type="rgbd_camera"><topic>depth</topic></sensor></gazebo></robot>'
    robot = ROBOT.replace("</gazebo></robot>", camera)
    scan = "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"
    points = f"/{topic}@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked"
    (found,) = of_words(tmp_path, scan, points, files={"r.urdf": robot})
    assert found.help == f"write {right}"


@pytest.mark.parametrize(("kind", "count"), [("depth", 0), ("depth_camera", 0), ("camera", 1)])
def test_the_type_of_a_sensor_that_gz_sim_also_reads(tmp_path: Path, kind: str, count: int) -> None:
    """`depth` is `depth_camera` of gz-sim, which publishes points."""
    camera = f'<sensor name="eye" type="{kind}"><topic>depth</topic></sensor></gazebo></robot>'
    points = "/depth/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked"
    robot = ROBOT.replace("</gazebo></robot>", camera)
    assert len(of_words(tmp_path, points, files={"r.urdf": robot})) == count


def test_quotes_are_part_of_a_topic(tmp_path: Path) -> None:
    quoted = ROBOT.replace("<topic>scan<", "<topic>'scan'<")
    word = "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"
    (found,) = of_words(tmp_path, word, files={"r.urdf": quoted})
    assert "quotes" in found.message
    assert found.help == naming("<topic>")


WORLD = """<sdf version="1.9"><world name="hall">{}</world></sdf>"""
STARTED = (
    "ExecuteProcess(cmd=['gz', 'sim', '-r', '{0}/w.sdf'])\n"
    "Node(package='robot_state_publisher', executable='robot_state_publisher', "
    "parameters=[{{'robot_description': open('{0}/r.urdf').read()}}])\n"
)


@pytest.mark.parametrize(
    ("word", "robot", "world", "count"),
    [
        ("/x@sensor_msgs/msg/Imu[gz.msgs.IMU", ROBOT, "", 1),
        ("/x@sensor_msgs/msg/Imu[gz.msgs.IMU", ROBOT, "<include><uri>model://x</uri></include>", 0),
        ("/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist", ROBOT, "", 1),
        (
            "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist",
            ROBOT.replace("</robot>", '<gazebo><plugin filename="own" name="o"/></gazebo></robot>'),
            "",
            0,
        ),
        (
            "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock",
            ROBOT,
            "",
            0,
        ),
    ],
)
def test_unknown_topic(tmp_path: Path, word: str, robot: str, world: str, count: int) -> None:
    (tmp_path / "r.urdf").write_text(robot)
    (tmp_path / "w.sdf").write_text(WORLD.format(world))
    text = STARTED.format(tmp_path) + NODE.format(f"arguments=[{word!r}]")
    found = reported(tmp_path, "LAU020", "a.launch.py", text)
    assert [one.severity for one in found] == [Severity.WARNING] * count
    assert all("no system with" in one.message for one in found)


def test_a_system_on_its_default_topic(tmp_path: Path) -> None:
    tags = "<gazebo><plugin filename='gz-sim-odometry-publisher-system' name='odom'/></gazebo>"
    robot = ROBOT.replace("</robot>", f"{tags}</robot>")
    (found,) = of_words(
        tmp_path, "/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry", files={"r.urdf": robot}
    )
    assert found.help == naming("<odom_topic>/odom</odom_topic>")


@pytest.mark.parametrize(
    ("topic", "help"),
    [
        (
            "pose_static",
            naming(
                "gz::sim::systems::PosePublisher",
                "<static_publisher>true</static_publisher>",
                "robot_state_publisher",
            ),
        ),
        ("poses", naming("<tf_topic>/model/r/poses</tf_topic>")),
    ],
)
def test_transforms_that_do_not_change(tmp_path: Path, topic: str, help: object) -> None:
    """OriginBot: those of odometry are no static ones."""
    plugin = "<plugin filename='gz-sim-diff-drive-system' name='gz::sim::systems::DiffDrive'/>"
    robot = ROBOT.replace("</robot>", f"<gazebo>{plugin}</gazebo></robot>")
    word = f"/model/r/{topic}@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V"
    (found,) = of_words(tmp_path, word, files={"r.urdf": robot})
    assert found.message.startswith(
        f"no sensor or system of the robot has the topic '/model/r/{topic}'"
    )
    assert found.help == help


@pytest.mark.parametrize(
    ("content", "topic", "help"),
    [
        ("", "/model/r/joint/swing/0/cmd_pos", None),
        ("", "/model/r/joint/swing/cmd_pos", "write <topic>/model/r/joint/swing/cmd_pos</topic>"),
        ("<topic>swing</topic>", "/swing", None),
        ("<topic>swing</topic>", "/swing_cmd", "write /swing"),
        ("<sub_topic>swing</sub_topic>", "/model/r/swing", None),
        ("<sub_topic>swing</sub_topic>", "/swing", "write <topic>/swing</topic>"),
        ("<use_actuator_msg>true</use_actuator_msg>", "/swing", None),
    ],
)
def test_commands_of_a_joint(tmp_path: Path, content: str, topic: str, help: str | None) -> None:
    name = "gz-sim-joint-position-controller-system"
    tags = f"<gazebo><plugin filename='{name}' name='p'>{content}</plugin></gazebo>"
    files = {"r.urdf": ROBOT.replace("</robot>", f"{tags}</robot>")}
    config = (
        f"- {{ros_topic_name: /swing, gz_topic_name: {topic}, ros_type_name: std_msgs/msg/Float64, "
        "gz_type_name: gz.msgs.Double, direction: ROS_TO_GZ}\n"
    )
    (tmp_path / "b.yaml").write_text(config)
    found = of_words(tmp_path, "--ros-args", "-p", f"config_file:={tmp_path}/b.yaml", files=files)
    assert [one.help.partition(" into")[0] for one in found] == [help] * (help is not None)


@pytest.mark.parametrize(
    ("topic", "sign", "count"),
    [
        ("/drive/cmd_vel", "]", 0),
        ("/drive/cmd_vel", "[", 1),
        ("/model/r/link/base/cmd_vel", "]", 0),  # of a <link_name>
        ("/cmd_vel", "]", 1),
    ],
)
def test_a_robot_that_velocity_control_moves(
    tmp_path: Path, topic: str, sign: str, count: int
) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus."""
    plugin = "<plugin filename='gz-sim-velocity-control-system' name='v'>{}</plugin>"
    tags = f"<gazebo>{plugin.format('<topic>drive/cmd_vel</topic>')}</gazebo>"
    files = {"r.urdf": ROBOT.replace("</robot>", f"{tags}</robot>")}
    found = of_words(tmp_path, f"{topic}@geometry_msgs/msg/Twist{sign}gz.msgs.Twist", files=files)
    assert len(found) == count


@pytest.mark.parametrize(("other", "count"), [("odom", 0), ("odometry", 1)])
def test_a_file_of_topics_for_two_robots(tmp_path: Path, other: str, count: int) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus: one of its robots has the odometry, one none."""
    plugin = "<plugin filename='gz-sim-odometry-publisher-system' name='o'>{}</plugin>"
    tags = f"<gazebo>{plugin.format(f'<odom_topic>{other}</odom_topic>')}</gazebo>"
    entry = "ros_type_name: nav_msgs/msg/Odometry, gz_type_name: gz.msgs.Odometry"
    own = STARTED.format(tmp_path)
    files = {
        "w.sdf": WORLD.format(""),
        "r.urdf": ROBOT,
        "other.urdf": ROBOT.replace("</robot>", f"{tags}</robot>"),
        "b.yaml": f"- {{topic_name: odom, {entry}}}\n",
        "launch/b.launch.py": own.replace("r.urdf", "other.urdf"),
    }
    text = own + NODE.format(f"parameters=[{{'config_file': '{tmp_path}/b.yaml'}}]")
    found = reported(tmp_path, "LAU020", "a.launch.py", text, files)
    assert [one.span.text for one in found] == ["odom"] * count


def test_one_topic_serves_images_and_their_calibration(tmp_path: Path) -> None:
    camera = ROBOT.replace("gpu_lidar", "camera").replace("<topic>scan</topic>", "")
    words = (
        "/eye/image@sensor_msgs/msg/Image[gz.msgs.Image",
        "/eye/camera_info@sensor_msgs/msg/CameraInfo[gz.msgs.CameraInfo",
    )
    (found,) = of_words(tmp_path, *words, files={"r.urdf": camera})
    assert found.help == naming("<topic>/eye/image</topic>")
    (found,) = of_words(tmp_path, words[1], files={"r.urdf": camera})
    assert found.help == naming("<topic>/eye/image</topic>")


def test_either_side_of_a_pair_may_be_wrong(tmp_path: Path) -> None:
    (found,) = of_words(tmp_path, "/lift@std_msgs/msg/Float32]gz.msgs.Double")
    either = "gz.msgs.Float for std_msgs/msg/Float32 or std_msgs/msg/Float64 for gz.msgs.Double"
    assert found.help == f"write {either}"


@pytest.mark.parametrize(("sign", "count"), [("[", 0), ("@", 0), ("]", 1)])
def test_the_clock_comes_from_gazebo(tmp_path: Path, sign: str, count: int) -> None:
    found = of_words(tmp_path, f"/clock@rosgraph_msgs/msg/Clock{sign}gz.msgs.Clock")
    assert [one.help for one in found] == ["write ["] * count


@pytest.mark.parametrize(
    ("name", "count"), [("clock", 0), ("/world/w/clock", 0), ("/cloc", 1), ("/robot/clock", 1)]
)
def test_the_topics_of_the_clock(tmp_path: Path, name: str, count: int) -> None:
    found = of_words(tmp_path, f"{name}@rosgraph_msgs/msg/Clock[gz.msgs.Clock")
    assert [one.message for one in found] == [naming(name)] * count


@pytest.mark.parametrize(
    ("word", "count"), [("/front", 0), ("front", 0), ("/front/image_raw", 1), ("--ros-args", 0)]
)
def test_images_of_ros_gz_image(tmp_path: Path, word: str, count: int) -> None:
    files = {"r.urdf": ROBOT.replace("gpu_lidar", "camera").replace("scan", "front")}
    text = f"open('{tmp_path}/r.urdf')\n" + NODE.format(f"arguments=[{word!r}]").replace(
        "bridge', executable='parameter", "image', executable='image"
    )
    found = reported(tmp_path, "LAU020", "a.launch.py", text, files)
    assert [one.help for one in found] == ["write /front"] * count


@pytest.mark.parametrize(
    ("ros", "gz", "words"),
    [
        ("image", "depth_image", "both published on 'image'"),
        ("depth", "depth_image", ""),
        ("image", "image", "is bridged twice"),
    ],
)
def test_two_topics_on_one(tmp_path: Path, ros: str, gz: str, words: str) -> None:
    rest = "ros_type_name: sensor_msgs/msg/Image, gz_type_name: gz.msgs.Image"
    rest += ", direction: GZ_TO_ROS"
    names = (("image", "image"), (ros, gz))
    yaml = "".join(f"- {{ros_topic_name: {a}, gz_topic_name: {b}, {rest}}}\n" for a, b in names)
    text = NODE.format(f"parameters=[{{'config_file': '{tmp_path}/b.yaml'}}]")
    found = reported(tmp_path, "LAU020", "a.launch.py", text, {"b.yaml": yaml})
    assert [words in one.message for one in found] == [True] * bool(words)


CLOCK = "arguments=['/clock@rosgraph_msgs/msg/Clock{}gz.msgs.Clock']"


@pytest.mark.parametrize(
    ("sign", "more", "count"),
    [
        ("[", "", 1),
        ("]", "", 0),
        ("[", ", remappings=[('/clock', '/other')]", 0),
        ("[", ", namespace='bot'", 1),  # the name is absolute
        ("[", ", condition=IfCondition(unknown)", 0),
    ],
)
def test_the_clock_of_two_bridges(tmp_path: Path, sign: str, more: str, count: int) -> None:
    text = NODE.format(CLOCK.format("[")) + NODE.format(CLOCK.format(sign) + more)
    found = reported(tmp_path, "LAU020", "a.launch.py", text)
    twice = [one for one in found if "is bridged twice" in one.message]
    assert [one.span.line for one in twice] == [2] * count


@pytest.mark.parametrize(("condition", "count"), [("", 1), (", condition=IfCondition(unknown)", 0)])
def test_a_bridge_of_a_file_included_twice(tmp_path: Path, condition: str, count: int) -> None:
    path = "get_package_share_directory('arm') + '/launch/bridge.launch.py'"
    include = f"IncludeLaunchDescription(PythonLaunchDescriptionSource({path}){condition})\n"
    files = {"launch/bridge.launch.py": NODE.format(CLOCK.format("["))}
    found = reported(tmp_path, "LAU020", "a.launch.py", include * 2, files)
    assert sum("is bridged twice" in one.message for one in found) == count


@pytest.mark.parametrize(("topic", "count"), [("scan", 0), ("/scan", 1)])
def test_a_relative_topic_of_robots_in_namespaces(tmp_path: Path, topic: str, count: int) -> None:
    bridge = f"arguments=['{topic}@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan']"
    text = NODE.format(bridge) * 2 + "PushRosNamespace('one')\n"
    found = reported(tmp_path, "LAU020", "a.launch.py", text)
    assert [one.span.line for one in found if "is bridged twice" in one.message] == [2] * count


@pytest.mark.parametrize(
    ("contents", "count"),
    [
        ("parameters=[{'config': 'b.yaml', 'use_sim_time': True}]", 1),
        ("parameters=[{'config_file': 'b.yaml'}]", 0),
        ("parameters=[{'bridge_names': ['a']}]", 0),
        ("parameters=['bridge.yaml']", 0),
        ("parameters=[settings()]", 0),
        ("parameters=[{'lazy': True}], arguments=['/a@std_msgs/msg/Bool@gz.msgs.Boolean']", 0),
        ("parameters=[{'lazy': True}], arguments=words()", 0),
    ],
)
def test_a_bridge_without_topics(tmp_path: Path, contents: str, count: int) -> None:
    found = reported(tmp_path, "LAU020", "a.launch.py", NODE.format(contents))
    assert ["has no topics" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ('ros_topic_name: "imu"\n  gz_topic_name: "imu"\n', 2),
        ("- topic_name: imu\n\tdirection: GZ_TO_ROS\n", 2),
        ("- {topic_name: imu, ros_type_name: sensor_msgs/msg/Imu, gz_type_name: gz.msgs.IMU}\n", 0),
    ],
)
def test_a_file_that_is_not_yaml(tmp_path: Path, text: str, line: int) -> None:
    node = NODE.format(f"parameters=[{{'config_file': '{tmp_path}/b.yaml'}}]")
    found = reported(tmp_path, "LAU020", "a.launch.py", node, {"b.yaml": text})
    assert [(one.span.line, "YAML" in one.message) for one in found] == [(line, True)] * (line > 0)


ENTRY = """- ros_topic_name: {0}
  gz_topic_name: {0}
  ros_type_name: sensor_msgs/msg/Imu
  gz_type_name:
    gz.msgs.IMU
"""


@pytest.mark.parametrize(("dash", "count"), [("-", 0), (" ", 1)])
def test_two_entries_without_a_dash(tmp_path: Path, dash: str, count: int) -> None:
    node = NODE.format(f"parameters=[{{'config_file': '{tmp_path}/b.yaml'}}]")
    text = ENTRY.format("a") + ENTRY.format("b").replace("-", dash, 1)
    found = reported(tmp_path, "LAU020", "a.launch.py", node, {"b.yaml": text})
    assert [(one.span.line, one.span.text) for one in found] == [(6, "b")] * count
