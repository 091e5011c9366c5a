"""LAU039: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import (
    CONTROLLER,
    COSTMAP,
    DWB,
    PLAIN_MPPI,
    PROGRAM,
    SERVER,
    WATCH,
    messages,
)
from tests.launched import reported
from tests.naming import naming


@pytest.mark.parametrize(
    ("plugins", "section", "count"),
    [
        ("[obstacle_layer]", "obstacle_layer: {plugin: a::B}", 0),
        ("[voxel_layer]", "obstacle_layer: {plugin: a::B}", 1),
        ("[obstacle_layer]", "obstacle_layer: {enabled: true}", 1),
        ("[obstacle_layer]", "obstacle_layer.plugin: a::B", 0),
        ("[static_layer, obstacle_layer, inflation_layer]", "static_layer: {enabled: true}", 0),
        ("[static_layer, obstacle_layer, inflation_layer]", "rate: 1.0", 0),  # the defaults
    ],
)
def test_plugins_of_a_costmap(tmp_path: Path, plugins: str, section: str, count: int) -> None:
    yaml = (
        "local_costmap:\n  local_costmap:\n    ros__parameters:\n"
        f"      plugins: {plugins}\n      {section}\n"
    )
    found = messages("LAU039", tmp_path, yaml)
    lost = ("no parameters for", "has no plugin")
    assert len([one for one in found if any(words in one for words in lost)]) == count


LAYER = "layer: {{plugin: {}, observation_sources: scan, scan: {{data_type: {}}}}}"


@pytest.mark.parametrize(
    ("plugin", "data", "message"),
    [
        ("nav2_costmap_2d::ObstacleLayer", "LaserScan", ""),
        ("nav2_costmap_2d::VoxelLayer", "PointCloud2", ""),
        (
            "nav2_costmap_2d::VoxelLayers",
            "PointCloud2",
            "did you mean 'nav2_costmap_2d::Vox",
        ),
        ("nav2_costmap_2d/VoxelLayer", "PointCloud2", "did you mean 'nav2_costmap_2d::Vox"),
        ("costmap_2d::VoxelLayer", "PointCloud2", "did you mean 'nav2_costmap_2d::Vox"),
        ("nav2_costmap_2d::SemanticLayer", "PointCloud2", ""),  # of a newer Nav2, perhaps
        ("my_layers::ObstacleLayer", "Image", ""),
        ("nav2_costmap_2d::ObstacleLayer", "laserscan", "data_type 'laserscan', which stops"),
    ],
)
def test_layers(tmp_path: Path, plugin: str, data: str, message: str) -> None:
    yaml = COSTMAP.format(LAYER.format(f'"{plugin}"', data))
    found = messages("LAU039", tmp_path, yaml)
    assert [message in one for one in found] == [True] * bool(message)


@pytest.mark.parametrize(
    ("name", "values", "words"),
    [
        ("laser", "filter1: {type: laser_filters/LaserScanBoxFilter}", ""),
        ("laser", "filter1: {type: laser_filters/LaserScanBoxFilters}", "LaserScanBoxFilter'?"),
        ("laser", "filter1: {type: laser_filters/Own}", ""),
        ("laser", "filter1: {type: own/LaserScanBoxFilters}", ""),
        ("docking_server", "{dock_plugins: [a], a: {plugin: b}, docks: [c], c: {type: a}}", ""),
        ("docking_server", "{dock_plugins: [a], a: {plugin: b}, docks: [c], c: {type: d}}", "'d'"),
        ("docking_server", "{docks: [c], c: {type: d}}", ""),
    ],
)
def test_types_of_filters_and_docks(tmp_path: Path, name: str, values: str, words: str) -> None:
    found = messages("LAU039", tmp_path, f"{name}:\n  ros__parameters:\n    {values}\n")
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("server", "plugin", "help"),
    [
        ("planner_server", "nav2_navfn_planner/NavfnPlanner", ""),
        ("planner_server", "nav2_navfn_planner::NavfnPlanner", ""),
        (
            "planner_server",
            "nav2_navfn_planner/NavfnPlaner",
            "write nav2_navfn_planner/NavfnPlanner",
        ),
        ("controller_server", "dwb_core::DWBLocalPlaner", "write dwb_core::DWBLocalPlanner"),
        ("controller_server", "my_planner::Own", ""),
    ],
)
def test_plugins_of_servers(tmp_path: Path, server: str, plugin: str, help: str) -> None:
    yaml = f"{server}:\n  ros__parameters:\n    mine:\n      plugin: {plugin}\n"
    node = CONTROLLER.replace("controller_server", server)
    text = PROGRAM.format(node, f'"{server}"')
    found = reported(tmp_path / "arm", "LAU039", "a.launch.py", text, {"a.yaml": yaml})
    assert [one.help for one in found] == [help] * bool(help)


SHIM = "'nav2_rotation_shim_controller::RotationShimController'"
TRIES = "waypoint_follower: {{ros__parameters: {{waypoint_task_executor_plugin: {}}}}}\n"


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (SERVER.format(DWB), "DWBLocalPlanner requires critics"),
        (SERVER.format(f"{DWB}, critics: [GoalDist, BaseObstacleCritic]"), ""),
        (SERVER.format(f"{DWB}, critics: [GoalDists]"), "mean 'GoalDist'?"),
        (SERVER.format(f"{DWB}, critics: [Goals], Goals: {{class: a::B}}"), ""),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [ObstacleCritic]"), "mean 'ObstaclesCritic'?"),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [OwnCritic]"), ""),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [mppi_critics/GoalCritic]"), "mean 'GoalCritic'?"),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [GoalCritic], GoalCritics: {{a: 1}}"), "not read"),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [GoalCritic], Own: {{a: 1}}"), ""),
        (SERVER.format("'nav2_controller::MyController'"), "plugin 'nav2_controller::MyCon"),
        (SERVER.format("'my_controller::MyController'"), ""),
        (SERVER.format(SHIM), "requires primary_controller"),
        (SERVER.format(f"{SHIM}, primary_controller: a::B"), ""),
        (SERVER.format(f"{SHIM}, primary_controller: {{plugin: a::B}}"), ""),
        (TRIES.format("wait_at_waypoint"), ""),
        (TRIES.format("take_photo"), "parameters for 'take_photo'"),
        (TRIES.format("take_photo, take_photo: {plugin: a::B}"), ""),
        (WATCH.format("near", "circle"), ""),
        (WATCH.format("far", "circle"), "'far' of polygons"),
    ],
)
def test_plugins_of_nav2(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages("LAU039", tmp_path, yaml)
    found = [one for one in found if "model_dt" not in one]
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("navigator", "count"),
    [
        ("nav2_bt_navigator::NavigateToPoseNavigator", 0),
        ("nav2_bt_navigator/NavigateToPoseNavigator", 1),
    ],
)
def test_navigators_of_another_release(tmp_path: Path, navigator: str, count: int) -> None:
    section = "{}: {{ros__parameters: {{a: {{plugin: {}}}}}}}\n".format
    yaml = section("bt_navigator", navigator)
    yaml += section("planner_server", "nav2_navfn_planner::NavfnPlanner")
    yaml += section("behavior_server", "nav2_behaviors::Spin")
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    found = reported(tmp_path / "arm", "LAU039", "a.launch.py", text, {"a.yaml": yaml})
    expected = ["write nav2_bt_navigator::NavigateToPoseNavigator"] * count
    assert [one.help for one in found] == expected


@pytest.mark.parametrize(("server", "count"), [("behavior_server", 1), ("recoveries_server", 0)])
def test_the_former_package_of_behaviors(tmp_path: Path, server: str, count: int) -> None:
    """It was renamed in Humble, as the server was."""
    yaml = f"{server}:\n  ros__parameters:\n    spin: {{plugin: nav2_recoveries/Spin}}\n"
    found = [one for one in messages("LAU039", tmp_path, yaml) if "nav2_recoveries" in one]
    assert found == [naming("nav2_recoveries/Spin", "nav2_recoveries")] * count
