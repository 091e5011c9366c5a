"""LAU021, LAU032: what a robot in Gazebo Classic publishes."""

from pathlib import Path

import pytest

from tests.launched import reported

ROBOT = """<robot name="cart"><link name="base"/>
<gazebo reference="base"><sensor name="laser" type="ray">
<plugin name="p" filename="libgazebo_ros_ray_sensor.so">
<ros>{}</ros><output_type>sensor_msgs/LaserScan</output_type></plugin></sensor></gazebo>
<gazebo><plugin name="drive" filename="libgazebo_ros_diff_drive.so">
<left_joint>l</left_joint><right_joint>r</right_joint>
<publish_odom>true</publish_odom>{}</plugin></gazebo>
</robot>"""
TEXT = """from launch_ros.actions import Node

nodes = [
    Node(package="robot_state_publisher", executable="robot_state_publisher",
         parameters=[{{"robot_description": open("../r.urdf").read()}}]),
    Node(package="gazebo_ros", executable="spawn_entity.py",
         arguments=["-entity", "cart", "-topic", "robot_description"{}]),
    Node(package="robot_localization", executable="ekf_node", name="ekf", parameters=["../e.yaml"]),
    Node(package="nav2_amcl", executable="amcl", name="amcl", parameters=["../a.yaml"]),
]
"""
FILES = {
    "a.yaml": "amcl:\n  ros__parameters: {scan_topic: scan}\n",
    "e.yaml": "ekf:\n  ros__parameters:\n    odom0: odom\n"
    f"    odom0_config: [{', '.join(['true'] * 15)}]\n",
}
SCAN = "<remapping>~/out:=scan</remapping>"


def messages(directory: Path, code: str, ros: str, drive: str = "", spawn: str = "") -> list[str]:
    files = {**FILES, "r.urdf": ROBOT.format(ros, drive)}
    found = reported(directory / "arm", code, "a.launch.py", TEXT.format(spawn), files)
    return [one.message for one in found]


@pytest.mark.parametrize(
    ("ros", "spawn", "topic"),
    [
        (SCAN, "", ""),
        ("", "", "/p/out"),
        (f"<namespace>cart</namespace>{SCAN}", "", "/cart/scan"),
        (SCAN, ', "-robot_namespace", "cart"', "/cart/scan"),
        ("<namespace>cart</namespace><remapping>~/out:=/scan</remapping>", "", ""),
        ("<argument>~/out:=scan2</argument>", "", ""),  # whose effect depends on the release
    ],
)
def test_topics(tmp_path: Path, ros: str, spawn: str, topic: str) -> None:
    found = [one for one in messages(tmp_path, "LAU032", ros, "", spawn) if "LaserScan" in one]
    assert [topic in one for one in found] == [True] * bool(topic)


@pytest.mark.parametrize(
    ("drive", "count"),
    [
        ("<publish_odom_tf>true</publish_odom_tf>", 1),
        ("<publish_odom_tf>false</publish_odom_tf>", 0),
        ("", 0),
        ("<publish_odom_tf>true</publish_odom_tf><odometry_frame>w</odometry_frame>", 0),
    ],
)
def test_odometry(tmp_path: Path, drive: str, count: int) -> None:
    found = messages(tmp_path, "LAU021", SCAN, drive)
    assert ["the transform of 'odom' is published twice" in one for one in found] == [True] * count
