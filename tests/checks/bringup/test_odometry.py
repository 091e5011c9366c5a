"""LAU032: who publishes the odometry that a filter or navigation reads."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, SPAWNER
from tests.checks.bringup.topics import BRIDGE
from tests.launched import reported

DRIVE = """
controller_manager: {ros__parameters: {base: {type: diff_drive_controller/DiffDriveController}}}
base: {ros__parameters: {left_wheel_names: [l], right_wheel_names: [r]}}
"""
FIXED = NODE.format(
    "tf2_ros",
    "static_transform_publisher",
    "arguments=['--frame-id', '{}', '--child-frame-id', '{}']",
)


@pytest.mark.parametrize(("topic", "count"), [("base/odom", 0), ("wheel/odom", 1)])
def test_odometry_of_another_launch_file(tmp_path: Path, topic: str, count: int) -> None:
    control = NODE.format(
        "controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']"
    ) + SPAWNER.format(["base"])
    files = {
        "launch/control.launch.py": control,
        "c.yaml": DRIVE,
        "ekf.yaml": f"ekf: {{ros__parameters: {{odom0: {topic}, odom0_config: [true]}}}}\n",
    }
    text = NODE.format(
        "robot_localization", "ekf_node", f"name='ekf', parameters=['{tmp_path}/ekf.yaml']"
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert ["on '/base/odom'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("of_filter", "of_drive", "more", "count"),
    [
        ("false", "false", "", 1),
        ("true", "false", "", 0),
        ("true, world_frame: map", "false", "", 1),
        ("true, world_frame: map, odom_frame: map", "false", "", 0),
        ("true, world_frame: map", "true", "", 0),
        ("false", "true", "", 0),
        ("false", "false", NODE.format("rf2o_laser_odometry", "rf2o", ""), 0),
        ("false", "false", NODE.format("watching", "watch", ""), 1),
        ("false", "false", NODE.format("sending", "send", ""), 0),
        ("false", "false", FIXED.format("map", "odom"), 1),
        ("false", "false", FIXED.format("odom", "base_link"), 0),
        ("false", "false", FIXED.format("map", "base_link"), 0),
        (
            "false",
            "false",
            BRIDGE.format("/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V"),
            0,
        ),
    ],
)
def test_nothing_publishes_odometry(
    tmp_path: Path, of_filter: str, of_drive: str, more: str, count: int
) -> None:
    drive = DRIVE.replace("right_wheel", f"enable_odom_tf: {of_drive}, right_wheel")
    files = {
        "c.yaml": drive,
        "ekf.yaml": f"ekf: {{ros__parameters: {{publish_tf: {of_filter}, "
        "odom0: base/odom, odom0_config: [true]}}\n",
        "src/watching/package.xml": "<package><name>watching</name></package>",
        "src/watching/watch.py": "rate = 5\n",
        "src/sending/package.xml": "<package><name>sending</name></package>",
        "src/sending/send.py": "sender = TransformBroadcaster(node)\n",
    }
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + SPAWNER.format(["base"])
        + NODE.format(
            "robot_localization", "ekf_node", f"name='ekf', parameters=['{tmp_path}/ekf.yaml']"
        )
        + more
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    help = f"write {'world_frame: odom' if 'world' in of_filter else 'publish_tf: true'}"
    assert [one.help for one in found if "odometry" in one.message] == [help] * count


@pytest.mark.parametrize(
    ("of_drive", "package", "more", "count"),
    [
        ("false", "nav2_controller", "", 1),
        ("true", "nav2_controller", "", 0),
        ("false", "rviz2", "", 0),
        ("false", "nav2_controller", NODE.format("topic_tools", "relay", ""), 1),
        ("false", "nav2_controller", NODE.format("rf2o_laser_odometry", "rf2o", ""), 0),
        ("false", "nav2_controller", NODE.format("robot_localization", "ekf_node", ""), 0),
    ],
)
def test_nothing_publishes_the_odometry_of_navigation(
    tmp_path: Path, of_drive: str, package: str, more: str, count: int
) -> None:
    drive = DRIVE.replace("right_wheel", f"enable_odom_tf: {of_drive}, right_wheel")
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + SPAWNER.format(["base"])
        + NODE.format(package, "server", "")
        + more
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, {"c.yaml": drive})
    help = "write enable_odom_tf: true"
    assert [one.help for one in found if "odometry" in one.message] == [help] * count


@pytest.mark.parametrize(
    ("switch", "more", "count"),
    [
        ("false", "", 1),
        ("true", "", 0),
        ("false", FIXED.format("map", "odom"), 0),
        ("false", FIXED.format("base_link", "laser"), 1),
        ("false", NODE.format("slam_toolbox", "async_slam_toolbox_node", ""), 0),
        ("false", NODE.format("sending", "send", ""), 0),
        ("false", NODE.format("own_localization", "locate", ""), 0),
    ],
)
def test_nothing_publishes_the_map(tmp_path: Path, switch: str, more: str, count: int) -> None:
    given = f"name='amcl', parameters=['{tmp_path}/amcl.yaml']"
    files = {
        "amcl.yaml": f"amcl: {{ros__parameters: {{tf_broadcast: {switch}}}}}\n",
        "src/sending/package.xml": "<package><name>sending</name></package>",
        "src/sending/send.py": "sender = TransformBroadcaster(node)\n",
    }
    text = NODE.format("nav2_amcl", "amcl", given) + more
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [one.help for one in found] == ["write tf_broadcast: true"] * count


ROBOT = """<robot name="r"><link name="base"/><gazebo>
<plugin filename="{}" name="{}"/></gazebo></robot>"""
GZ = ("gz-sim-odometry-publisher-system", "gz::sim::systems::OdometryPublisher")
AMCL = NODE.format("nav2_amcl", "amcl", "")


@pytest.mark.parametrize(
    ("publish", "plugin", "more", "count"),
    [
        ("false", GZ, AMCL, 1),
        ("true", GZ, AMCL, 0),
        ("false", GZ, "", 0),  # nothing needs the transform
        ("false", ("libother_drive.so", "drive"), AMCL, 0),  # may publish it in ROS
        ("false", GZ, AMCL + BRIDGE.format("/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V"), 0),
        ("false", GZ, AMCL + NODE.format("rf2o_laser_odometry", "rf2o", ""), 0),
    ],
)
def test_a_drive_of_gazebo_publishes_no_transform_in_ros(
    tmp_path: Path, publish: str, plugin: tuple[str, str], more: str, count: int
) -> None:
    text = (
        NODE.format(
            "robot_state_publisher",
            "robot_state_publisher",
            "parameters=[{'robot_description': open('../r.urdf').read()}]",
        )
        + NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
        + BRIDGE.format("/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry")
        + NODE.format("robot_localization", "ekf_node", "name='ekf', parameters=['../ekf.yaml']")
        + more
    )
    ekf = f"publish_tf: {publish}, odom0: odom, odom0_config: [true]"
    files = {
        "r.urdf": ROBOT.format(*plugin),
        "ekf.yaml": f"ekf: {{ros__parameters: {{{ekf}}}}}\n",
    }
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [one.span.text for one in found if "transform" in one.message] == ["false"] * count


def test_navigation_reads_the_odometry_of_the_filter(tmp_path: Path) -> None:
    text = (
        BRIDGE.format("/wheel/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry")
        + NODE.format("robot_localization", "ekf_node", "name='ekf', parameters=['../nav.yaml']")
        + NODE.format("nav2_bt_navigator", "bt_navigator", "parameters=['../nav.yaml']")
    )
    files = {
        "nav.yaml": "ekf: {ros__parameters: {odom0: wheel/odom, odom0_config: [true]}}\n"
        "bt_navigator: {ros__parameters: {odom_topic: /odom}}\n"
    }
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [one.help for one in found] == ["write /odometry/filtered or /wheel/odom"]
