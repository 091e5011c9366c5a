import pytest

from tests.gazebos import BASE, block, plugin, sensor
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

DRIVE = '<plugin name="p" filename="libgazebo_ros_planar_move.so"/>'
LASER = '<plugin name="p" filename="libgazebo_ros_laser.so"/>'
VENDOR = '<plugin name="p" filename="libvendor.so"/>'
SHADER = '<plugin name="p" filename="gz-sim-shader-param-system"/>'


@pytest.mark.parametrize(
    ("text", "file", "place"),
    [
        (
            block(DRIVE),
            "gazebo_ros_planar_move",
            ["<gazebo>", "base", "never"],
        ),
        (block(VENDOR), "vendor", ["<gazebo>", "base", "never"]),
        (block(LASER, ""), "gazebo_ros_laser", ["<gazebo>", "a sensor plugin"]),
        (sensor("ray", DRIVE), "gazebo_ros_planar_move", ["<sensor>", "a model plugin"]),
        (
            plugin("libgazebo_ros_init.so"),
            "gazebo_ros_init",
            ["<gazebo>", "a system plugin"],
        ),
        (
            block(f"<visual>{LASER}</visual>"),
            "gazebo_ros_laser",
            ["<visual>", "a sensor plugin"],
        ),
    ],
)
def test_the_wrong_place(text: str, file: str, place: list[str]) -> None:
    heard = naming("p", f"lib{file}.so", *place)
    assert messages("GAZ014", BASE + text) == [heard]


@pytest.mark.parametrize(
    "text",
    [
        block(DRIVE, ""),
        sensor("ray", LASER),
        sensor("ray", VENDOR),
        block(VENDOR, ""),
        block(f"<visual>{SHADER}</visual>"),
        block(DRIVE, "nothing"),  # the whole block is lost
    ],
)
def test_the_right_place(text: str) -> None:
    assert reported("GAZ014", BASE + text) == []


@pytest.mark.parametrize(
    ("kind", "file", "wanted"),
    [
        ("gpu_ray", "libgazebo_ros_laser.so", "ray"),
        ("ray", "libgazebo_ros_gpu_laser.so", "gpu_ray"),
        ("camera", "libgazebo_ros_openni_kinect.so", "depth"),
        ("imu", "libgazebo_ros_bumper.so", "contact"),
    ],
)
def test_the_wrong_sensor(kind: str, file: str, wanted: str) -> None:
    text = BASE + sensor(kind, f'<plugin name="p" filename="{file}"/>')
    message = naming("p", file, wanted, kind)
    assert messages("GAZ014", text) == [message]
    assert places("GAZ014", text) == [(4, kind)]


@pytest.mark.parametrize(
    ("kind", "file"),
    [
        ("ray", "libgazebo_ros_laser.so"),
        ("lidar", "libgazebo_ros_laser.so"),
        ("gpu_lidar", "libgazebo_ros_gpu_laser.so"),
        ("depth", "libgazebo_ros_camera.so"),
        ("depth_camera", "libgazebo_ros_openni_kinect.so"),
        ("wideanglecamera", "libgazebo_ros_camera.so"),
        ("wide_angle_camera", "libgazebo_ros_camera.so"),
        ("navsat", "libgazebo_ros_gps_sensor.so"),
        ("imu", "libvendor.so"),
        ("thermal", "gz-sim-thermal-sensor-system"),
    ],
)
def test_the_right_sensor(kind: str, file: str) -> None:
    assert reported("GAZ014", BASE + sensor(kind, f'<plugin name="p" filename="{file}"/>')) == []


def test_a_sensor_without_a_type() -> None:
    plugin = '<plugin name="p" filename="libgazebo_ros_laser.so"/>'
    text = f'{BASE}<gazebo reference="base"><sensor name="s">{plugin}</sensor></gazebo>'
    assert reported("GAZ014", text) == []


@pytest.mark.parametrize(
    "text",
    [
        plugin("gz-sim-sensors-system"),
        plugin("libgz-sim8-physics-system.so"),
        sensor("imu", '<plugin name="p" filename="gz-sim-imu-system"/>'),
    ],
)
def test_a_world_system_of_gz_runs_in_a_model_too(text: str) -> None:
    (found,) = reported("GAZ014", BASE + text)
    assert (found.severity, found.help) == (Severity.INFO, naming("world"))


@pytest.mark.parametrize(
    "file",
    ["gz-sim-diff-drive-system", "gz-sim-triggered-publisher-system"],  # of either
)
def test_no_world_system(file: str) -> None:
    assert reported("GAZ014", BASE + plugin(file)) == []
