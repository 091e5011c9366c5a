"""LAU042, and what other rules read in the configurations of Cartographer."""

from pathlib import Path

import pytest

from tests.launched import reported

LUA = """include "map_builder.lua"
include "trajectory_builder.lua" -- options = {}
options = {
  map_builder = MAP_BUILDER,
  trajectory_builder = TRAJECTORY_BUILDER,
  map_frame = "map",
  tracking_frame = "base_link",
  published_frame = "odom",
  odom_frame = "odom",
  provide_odom_frame = false,
  publish_frame_projected_to_2d = true,
  use_odometry = true,
  use_nav_sat = false,
  use_landmarks = false,
  num_laser_scans = 1,
  num_multi_echo_laser_scans = 0,
  num_subdivisions_per_laser_scan = 1,
  num_point_clouds = 0,
  imu_correction = {0., 0., 0.},
  lookup_transform_timeout_sec = 0.2,
  submap_publish_period_sec = 0.3,
  pose_publish_period_sec = 5e-3,
  trajectory_publish_period_sec = 30e-3,
  rangefinder_sampling_ratio = 1.,
  odometry_sampling_ratio = 1.,
  fixed_frame_pose_sampling_ratio = 1.,
  imu_sampling_ratio = 1.,
  landmarks_sampling_ratio = 1.,
}
MAP_BUILDER.use_trajectory_builder_2d = true
return options
"""
TEXT = """
<node pkg="cartographer_ros" exec="cartographer_node" name="slam"
  args="-configuration_directory {} -configuration_basename {}"/>
<node pkg="tf2_ros" exec="static_transform_publisher"
  args="--frame-id base_link --child-frame-id lidar"/>
{}
"""
FILTER = """<node pkg="laser_filters" exec="scan_to_scan_filter_chain"/>
<node pkg="rplidar_ros" exec="rplidar_composition"/>"""


ROBOT = """<robot name="r"><link name="base_link"/></robot>"""
PUBLISHER = """<node pkg="robot_state_publisher" exec="robot_state_publisher">
<param name="robot_description" value="$(command 'cat {}/r.urdf')"/></node>"""


def messages(
    directory: Path, code: str, lua: str, name: str = "a.lua", more: str = ""
) -> list[str]:
    text = TEXT.format(directory / "arm", name, more)
    files = {"a.lua": lua, "r.urdf": ROBOT}
    found = reported(directory / "arm", code, "a.launch.xml", text, files)
    return [one.message for one in found]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("", "", ""),
        ("  num_laser_scans = 1,\n", "", "the options lack num_laser_scans"),
        ("num_laser_scans", "num_laser_scan", "has no option 'num_laser_scan'; did you mean"),
        ("num_laser_scans = 1", "num_laser_scans = 0", "has no input"),
        ("  use_odometry = true,\n", "  use_odometry = true,\n  own = 1,\n", "no option 'own'"),
        ("  use_odometry = true,\n", "  publish_to_tf = true,\n", "the options lack use_odometry"),
    ],
)
def test_options(tmp_path: Path, old: str, new: str, words: str) -> None:
    found = messages(tmp_path, "LAU042", LUA.replace(old, new, 1))
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    "lua",
    [
        LUA.replace("map_builder.lua", "own.lua").replace("  use_odometry = true,\n", ""),
        LUA.replace("  use_odometry = true,\n", "").replace(
            "return", "options.use_odometry = true\nreturn"
        ),
        'include "own.lua"\nreturn options\n',
        "options = {",
    ],
)
def test_options_of_other_files(tmp_path: Path, lua: str) -> None:
    assert messages(tmp_path, "LAU042", lua) == []


def test_a_file_that_does_not_exist(tmp_path: Path) -> None:
    (message,) = messages(tmp_path, "LAU042", LUA, "b.lua")
    assert "'b.lua' does not exist" in message
    assert messages(tmp_path, "LAU042", LUA, "$(var file)") == []


@pytest.mark.parametrize(("frame", "count"), [("base_link", 0), ("lidar", 0), ("base", 1)])
def test_frames(tmp_path: Path, frame: str, count: int) -> None:
    robot = PUBLISHER.format(tmp_path / "arm")
    found = messages(tmp_path, "LAU023", LUA.replace("base_link", frame), more=robot)
    assert ["tracking_frame 'base'" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("lua", "topics"),
    [
        (LUA, []),
        (LUA.replace("num_laser_scans = 1", "num_laser_scans = 2"), ["/scan_1", "/scan_2"]),
    ],
)
def test_inputs(tmp_path: Path, lua: str, topics: list[str]) -> None:
    found = messages(tmp_path, "LAU032", lua, more=FILTER)
    assert [one.split("'")[3] for one in found if "scan_" in one] == topics
