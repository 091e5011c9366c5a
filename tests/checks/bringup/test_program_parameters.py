"""Parameters of programs of any name, in the launch file itself or below another name."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.workspaces import add_package

CODES = "LAU024 LAU025 LAU039 LAU045 LAU046"
NODE = """from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

RATE = "2"
nodes = [Node({}, parameters=[{}])]
"""
CAMERA = 'package="usb_cam", executable="usb_cam_node_exe"'
REALSENSE = 'package="realsense2_camera", executable="realsense2_camera_node"'
RTABMAP = 'package="rtabmap_slam", executable="rtabmap"'
JOY = 'package="joy", executable="joy_node"'
EKF = 'package="robot_localization", executable="ekf_node"'
MADGWICK = 'package="imu_filter_madgwick", executable="imu_filter_madgwick_node"'
MERGER = 'package="dual_laser_merger", executable="dual_laser_merger_node"'
VELODYNE = 'package="velodyne_pointcloud", executable="velodyne_transform_node"'


def found(directory: Path, node: str, given: str, yaml: str = "") -> list[str]:
    files = {"a.yaml": yaml} if yaml else {}
    text = NODE.format(node, given)
    return [one.message for one in reported(directory / "arm", CODES, "a.launch.py", text, files)]


@pytest.mark.parametrize(
    ("node", "given", "words"),
    [
        (CAMERA, '{"framerate": 30}', "must be a number with a decimal point"),
        (CAMERA, '{"framerate": "30"}', "must be a number with a decimal point"),
        (CAMERA, '{"image_width": 640.0}', "must be an integer"),
        (CAMERA, '{"pixel_format": "YUV"}', "unknown pixel_format 'YUV'"),
        (CAMERA, '{"framrate": 30.0}', "did you mean 'framerate'"),
        (CAMERA, '{"camera_frame_id": "camera"}', "it is 'frame_id'"),
        (REALSENSE, '{"enable_pointcloud": True}', "it is 'pointcloud.enable'"),
        (RTABMAP, '{"Rtabmap/DetectionRate": 2.0}', "must be a string"),
        (RTABMAP, '{"subscribe_depth": 1}', "must be true or false"),
        (RTABMAP, '{"subscribe_depth": "true"}', "must be true or false"),
        (JOY, '{"dev": "/dev/input/js1"}', "it is 'device_id'"),
        (JOY, '{"device_name": "/dev/input/js0"}', "is a name, not a path"),
        (EKF, '{"frequency": 30.0}', "has no inputs"),
        (REALSENSE, '{"decimation_filter,enable": True}', "contains a comma"),
        (MADGWICK, '{"_use_mag": False}', "did you mean 'use_mag'"),
        (CAMERA, '{"camera_info_url": "/home/a/front.yaml"}', "which is no URL"),
        (CAMERA, '{"camera_info_url": "file://home/a/front.yaml"}', "which is no URL"),
        (MERGER, '{"merged_topic": "/scan"}', "it is 'merged_scan_topic'"),
        (VELODYNE, '{"model": "VLP16"}', "'calibration' is not given"),
    ],
)
def test_in_the_launch_file(tmp_path: Path, node: str, given: str, words: str) -> None:
    (message,) = found(tmp_path, node, given)
    assert words in message


@pytest.mark.parametrize(
    ("node", "given"),
    [
        (CAMERA, '{"framerate": 30.0, "image_width": 640, "pixel_format": "yuyv2rgb"}'),
        (CAMERA, '{"framerate": ParameterValue(30, value_type=float)}'),
        (CAMERA, '{"framerate": LaunchConfiguration("rate")}'),
        (CAMERA, '{"own": 30}'),
        (CAMERA, '{"camera_info_url": "file:///home/a/front.yaml"}'),
        (CAMERA, '{"camera_info_url": "package://arm/front.yaml"}'),
        (VELODYNE, '{"calibration": "/a.yaml"}'),
        (VELODYNE, "own()"),
        (REALSENSE, '{"pointcloud.enable": True, "enable_pointcloud": True}'),
        (REALSENSE, '{"align_depth": {"enable": True}}'),
        (JOY, '{"device_id": 1}'),
        (RTABMAP, "{'Rtabmap/DetectionRate': '2', 'Reg/Force3DoF': \"true\"}"),
        (RTABMAP, '{"Rtabmap/DetectionRate": RATE}'),
        (EKF, '{"odom0": "odom", "odom0_config": [True] * 15}'),
        ('package="own", executable="usb_cam_node_exe"', '{"framerate": 30}'),
    ],
)
def test_sound_parameters(tmp_path: Path, node: str, given: str) -> None:
    assert found(tmp_path, node, given) == []


@pytest.mark.parametrize(
    ("name", "key", "count"),
    [("front", "front", 1), ("front", "/**", 1), ("front", "/**/front", 1), ("", "/**", 1)],
)
def test_below_another_name(tmp_path: Path, name: str, key: str, count: int) -> None:
    node = f'{CAMERA}, name="{name}"' if name else CAMERA
    yaml = f"{key}:\n  ros__parameters:\n    framerate: 30\n"
    assert len(found(tmp_path, node, '"../a.yaml"', yaml)) == count


def test_a_file_of_several_nodes(tmp_path: Path) -> None:
    """What is below /** may be for the other node."""
    text = (
        f'nodes = [Node({CAMERA}, parameters=["../a.yaml"]), Node({JOY}, parameters=["../a.yaml"])]'
    )
    text = f"from launch_ros.actions import Node\n{text}\n"
    yaml = "/**:\n  ros__parameters:\n    framerate: 30\n"
    assert reported(tmp_path / "arm", CODES, "a.launch.py", text, {"a.yaml": yaml}) == []


@pytest.mark.parametrize(("value", "count"), [("true", 0), ('"true"', 1), ("$(var time)", 0)])
def test_the_type_that_all_nodes_know(tmp_path: Path, value: str, count: int) -> None:
    yaml = f"own:\n  ros__parameters:\n    use_sim_time: {value}\n"
    node = 'package="own", executable="own", name="own"'
    found_here = found(tmp_path, node, '"../a.yaml"', yaml)
    assert ["must be true or false" in one for one in found_here] == [True] * count


@pytest.mark.parametrize(
    ("node", "yaml", "words"),
    [
        ("slam_toolbox", "map_start_pose: [0.0, 0.0]", "has 2 numbers, must have 3"),
        ("slam_toolbox", "map_start_pose: [0.0, 0.0, 0.0]", ""),
        ("docking_server", "docks: [a]\n    a: {id: 1, pose: [0.0, 0.0, 0.0]}", "must be a string"),
        ("docking_server", "docks: [a]\n    a: {id: '1', pose: [0.0, 0.0]}", "must have 3"),
        ("docking_server", "docks: [a]\n    a: {id: '1', pose: [0.0, 0.0, 0.0]}", ""),
        (
            "laser",
            "filter: {name: a, type: laser_filters/LaserScanRangeFilter}",
            "filter1, filter2",
        ),
        ("laser", "filter1: {name: a, type: laser_filters/LaserScanRangeFilter}", ""),
        (
            "laser",
            "filter2: {name: a, type: laser_filters/LaserScanRangeFilter}",
            "filter1, filter2",
        ),
    ],
)
def test_of_nodes(tmp_path: Path, node: str, yaml: str, words: str) -> None:
    text = f"{node}:\n  ros__parameters:\n    {yaml}\n"
    program = f'package="own", executable="own", name="{node}"'
    assert [words in one for one in found(tmp_path, program, '"../a.yaml"', text)] == [True] * bool(
        words
    )


LAYER = """local_costmap:
  local_costmap:
    ros__parameters:
      plugins: [layer]
      layer:
        plugin: {}
        observation_sources: a b
        {}: 3.0
        a: {{data_type: PointCloud2, {}: 3.0}}
        b: {{data_type: PointCloud2{}}}
"""
STVL = "spatio_temporal_voxel_layer/SpatioTemporalVoxelLayer"


@pytest.mark.parametrize(
    ("plugin", "key", "of_second", "count"),
    [
        (STVL, "obstacle_range", "", 1),
        (STVL, "obstacle_range", ", obstacle_range: 3.0", 0),
        (STVL, "voxel_decay", "", 0),
        ("nav2_costmap_2d::ObstacleLayer", "obstacle_max_range", "", 1),
        ("nav2_costmap_2d::ObstacleLayer", "max_obstacle_height", "", 0),
        ("own::Layer", "obstacle_range", "", 0),
    ],
)
def test_parameters_of_sources(
    tmp_path: Path, plugin: str, key: str, of_second: str, count: int
) -> None:
    yaml = LAYER.format(plugin, key, key, of_second)
    program = 'package="own", executable="own", name="own"'
    messages = found(tmp_path, program, '"../a.yaml"', yaml)
    assert [f"reads {key} of each source" in one for one in messages] == [True] * count


SAVER = 'package="nav2_map_server", executable="map_saver_server"'


def test_a_program_whose_source_is_in_the_workspace(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    add_package(tmp_path / "navigation2" / "nav2_map_server", "nav2_map_server")
    assert found(tmp_path, SAVER, '{"save_map_timeout": 2000}') == []
