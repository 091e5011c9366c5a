"""LAU032: sensors of Gazebo that no bridge publishes."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, STATE
from tests.checks.bringup.topics import BRIDGE, COSTMAP, SCAN
from tests.launched import reported
from tests.naming import values

LIDAR = (
    '<robot name="r"><link name="l"/><gazebo reference="l"><sensor name="s" type="gpu_lidar">'
    "{}</sensor></gazebo></robot>"
)


@pytest.mark.parametrize(
    ("tags", "bridge", "more", "words"),
    [
        ("<topic>scan</topic>", SCAN.format("/scan"), "", ""),
        (
            "<topic>scan</topic>",
            BRIDGE.format("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"),
            "",
            "'/scan' of sensor 's'",
        ),
        ("<topic>scan</topic>", "", "", ""),  # another simulator
        (
            "<topic>scan</topic>",
            BRIDGE.format("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"),
            NODE.format("sllidar_ros2", "sllidar_node", ""),
            "",
        ),
        (
            "<topic>scan</topic>",
            SCAN.format("/rear"),
            "",
            "'/scan' of sensor 's'",
        ),
        ("<topic>front</topic>", SCAN.format("/rear"), "", "on '/rear'"),
    ],
)
def test_a_sensor_that_is_not_bridged(
    tmp_path: Path, tags: str, bridge: str, more: str, words: str
) -> None:
    text = (
        STATE.format(
            f", parameters=[{{'robot_description': open('{tmp_path}/r.urdf').read(), "
            "'use_sim_time': True}]"
        )
        + bridge
        + more
        + NODE.format(
            "nav2_amcl", "amcl", "parameters=[{'scan_topic': 'scan', 'use_sim_time': True}]"
        )
        + NODE.format(
            "slam_toolbox", "async_slam_toolbox_node", f"parameters=['{tmp_path}/slam.yaml']"
        )
    )
    slam = "slam_toolbox: {ros__parameters: {scan_topic: /scan, use_sim_time: true}}\n"
    files = {"r.urdf": LIDAR.format(tags), "slam.yaml": slam}
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    found = [one for one in found if "waits for" in one.message]
    assert [words in one.message for one in found] == [True] * bool(words)


@pytest.mark.parametrize("topic", ["/camera/points", "/camera/cloud"])
def test_the_nearest_sensor_that_is_not_bridged(tmp_path: Path, topic: str) -> None:
    camera = '<sensor name="eye" type="rgbd_camera"><topic>camera</topic></sensor>'
    model = LIDAR.format("<topic>scan</topic>").replace("</gazebo>", f"{camera}</gazebo>")
    text = (
        STATE.format(f", parameters=[{{'robot_description': open('{tmp_path}/r.urdf').read()}}]")
        + SCAN.format("/scan")
        + NODE.format(
            "nav2_controller", "controller_server", f"parameters=['{tmp_path}/nav2.yaml']"
        )
    )
    nav2 = COSTMAP.format("PointCloud2").replace("/points", topic)
    files = {"r.urdf": model, "nav2.yaml": nav2}
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [values(one.message)[-2:] for one in found if topic in one.message] == [
        ["/camera/points", "eye"]
    ]
