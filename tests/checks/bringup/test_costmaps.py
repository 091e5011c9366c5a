"""LAU032, LAU026: topics of the layers and filters of a costmap."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE
from tests.checks.bringup.topics import COSTMAP, of_topics
from tests.launched import reported
from tests.naming import naming


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ("PointCloud2", ""),
        ("LaserScan", naming("local_costmap", "LaserScan", "/points", "PointCloud2")),
    ],
)
def test_message_of_an_input(tmp_path: Path, message: str, words: str) -> None:
    topics = [
        "/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked",
        "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan",
    ]
    text = NODE.format("ros_gz_bridge", "parameter_bridge", f"arguments={topics}")
    text += NODE.format(
        "nav2_controller", "controller_server", f"parameters=['{tmp_path}/nav2.yaml']"
    )
    files = {"nav2.yaml": COSTMAP.format(message)}
    assert [one.message for one in of_topics(tmp_path, text, files)] == [words] * bool(words)


@pytest.mark.parametrize(("topic", "count"), [("/map", 0), ("/hall/map", 1)])
def test_the_map_of_a_costmap(tmp_path: Path, topic: str, count: int) -> None:
    yaml = (
        "global_costmap: {global_costmap: {ros__parameters: {plugins: [fixed], fixed: "
        f"{{plugin: 'nav2_costmap_2d::StaticLayer', map_topic: {topic}}}}}}}}}\n"
    )
    text = NODE.format("nav2_map_server", "map_server", "name='map_server'") + NODE.format(
        "nav2_planner", "planner_server", f"parameters=['{tmp_path}/nav2.yaml']"
    )
    found = of_topics(tmp_path, text, {"nav2.yaml": yaml})
    assert ["on '/map'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("info", "mask", "words"),
    [
        ("/filter_info", "/mask", ""),
        ("/info", "/mask", "on '/filter_info'"),
        ("/filter_info", "/masks", "on '/mask'"),
    ],
)
def test_filters_of_a_costmap(tmp_path: Path, info: str, mask: str, words: str) -> None:
    yaml = (
        "global_costmap: {global_costmap: {ros__parameters: {filters: [keep], keep: "
        f"{{plugin: 'nav2_costmap_2d::KeepoutFilter', filter_info_topic: {info}}}}}}}}}\n"
    )
    server = f"parameters=[{{'filter_info_topic': '/filter_info', 'mask_topic': '{mask}'}}]"
    text = (
        NODE.format(
            "nav2_map_server", "map_server", "name='masks', parameters=[{'topic_name': '/mask'}]"
        )
        + NODE.format("nav2_map_server", "costmap_filter_info_server", server)
        + NODE.format("nav2_planner", "planner_server", f"parameters=['{tmp_path}/nav2.yaml']")
    )
    found = of_topics(tmp_path, text, {"nav2.yaml": yaml})
    assert [words in one.message for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("layer", "server", "count"),
    [
        ("map_subscribe_transient_local: false", "map_server", 1),
        ("map_subscribe_transient_local: false, map_topic: /map", "map_server", 1),
        ("map_subscribe_transient_local: false, map_topic: /hall/map", "map_server", 0),
        ("map_subscribe_transient_local: false, enabled: false", "map_server", 0),
        ("map_subscribe_transient_local: true", "map_server", 0),
        ("map_subscribe_transient_local: false", "map_saver_server", 0),
    ],
)
def test_a_layer_that_misses_the_map(tmp_path: Path, layer: str, server: str, count: int) -> None:
    yaml = (
        "global_costmap: {global_costmap: {ros__parameters: {plugins: [fixed], fixed: "
        f"{{plugin: 'nav2_costmap_2d::StaticLayer', {layer}}}}}}}}}\n"
    )
    text = NODE.format("nav2_map_server", server, "") + NODE.format(
        "nav2_planner", "planner_server", f"parameters=['{tmp_path}/nav2.yaml']"
    )
    found = reported(tmp_path, "LAU026", "a.launch.py", text, {"nav2.yaml": yaml})
    assert [one.message for one in found] == [naming("global_costmap", "fixed")] * count
