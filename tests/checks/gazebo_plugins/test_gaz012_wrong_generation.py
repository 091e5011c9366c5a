import pytest

from tests.gazebos import BASE, plugin, sensor
from tests.naming import naming
from tests.reported import reported
from urdfkit.text.diagnostic import Diagnostic, Severity

MESSAGE = naming(
    "p", "libgazebo_ros_laser.so", "Gazebo", "Classic", "ROS 1", "Gazebo", "Classic", "ROS 2"
)
HELP = naming("libgazebo_ros_ray_sensor.so", "output_type", "sensor_msgs/LaserScan")
LASER = BASE + sensor("ray", '<plugin name="p" filename="libgazebo_ros_laser.so"/>')


def heard(text: str, *targets: str) -> list[tuple[str, str, str]]:
    found = reported("GAZ012", text, targets=targets)
    return [(one.severity.value, one.message, one.help) for one in found]


def test_a_library_that_ros2_no_longer_has() -> None:
    assert heard(LASER, "classic-ros2") == [
        (
            "error",
            MESSAGE,
            HELP,
        )
    ]
    assert heard(LASER, "classic-ros1") == []
    assert heard(LASER, "classic-ros1", "classic-ros2") == []


@pytest.mark.parametrize("target", ["gz-fortress", "gz-harmonic", "gz-jetty"])
def test_the_successor_of_the_successor(target: str) -> None:
    ((severity, _, help),) = heard(BASE + plugin("libgazebo_ros_skid_steer_drive.so"), target)
    assert severity == "error"
    assert help == naming("gz-sim-diff-drive-system", "tags")


def test_gz_sim_in_classic() -> None:
    text = BASE + plugin("gz-sim-diff-drive-system", name="gz::sim::systems::DiffDrive")
    assert [help for _, _, help in heard(text, "classic-ros1")] == [naming("successor")]
    assert heard(text, "gz-harmonic") == []


def test_the_classes_of_gz_sim_in_fortress() -> None:
    text = BASE + plugin("gz-sim-diff-drive-system", name="gz::sim::systems::DiffDrive")
    assert [help for _, _, help in heard(text, "gz-fortress")] == [
        naming("Fortress", "ignition::gazebo::systems")
    ]
    old = plugin("ignition-gazebo-diff-drive-system", name="ignition::gazebo::systems::DiffDrive")
    assert heard(BASE + old, "gz-fortress") == []


def test_without_a_gazebo_among_the_targets_nothing_is_wrong() -> None:
    assert heard(LASER, "ros2", "moveit") == []
    assert heard(LASER) == [], "the plugin itself tells the generation"


def test_a_plugin_without_ros_runs_with_both() -> None:
    text = BASE + plugin("libLiftDragPlugin.so")
    assert heard(text, "classic-ros1") == []
    assert heard(text, "classic-ros2") == []
    assert len(heard(text, "gz-jetty")) == 1


def test_of_a_vendors_plugin_there_may_be_a_port() -> None:
    text = BASE + plugin("libhector_gazebo_ros_imu.so")
    assert heard(text, "classic-ros2") == []
    assert len(heard(text, "gz-harmonic")) == 1


def test_an_unknown_plugin_is_of_no_generation() -> None:
    assert heard(BASE + plugin("libvendor.so"), "gz-harmonic") == []


def test_the_names_of_fortress_are_a_pure_rename() -> None:
    text = BASE + plugin("gz-sim-diff-drive-system", name="gz::sim::systems::DiffDrive")
    (found,) = reported("GAZ012", text, targets=("gz-fortress",))
    assert found.fix is not None
    assert [edit.text for edit in found.fix.edits] == [
        "ignition-gazebo-diff-drive-system",
        "ignition::gazebo::systems::DiffDrive",
    ]
    (found,) = reported("GAZ012", LASER, targets=("classic-ros2",))
    assert found.fix is None


OLD, NEW = plugin("libgazebo_ros_laser.so"), plugin("libgazebo_ros_ray_sensor.so")
BOTH, GZ = plugin("libgazebo_ros_p3d.so"), plugin("gz-sim-diff-drive-system")
BARE = plugin("libLiftDragPlugin.so")


def mixed(text: str, *targets: str) -> list[Diagnostic]:
    found = reported("GAZ012", BASE + text, targets=targets)
    return [one for one in found if one.severity is Severity.WARNING]


@pytest.mark.parametrize("pair", [OLD + NEW, OLD + GZ, BOTH + GZ, OLD + BOTH + NEW])
def test_no_gazebo_loads_both(pair: str) -> None:
    (found,) = mixed(pair)
    assert [note.span.line for note in found.related] == [4], "the first plugin"


@pytest.mark.parametrize("pair", [OLD + BOTH, NEW + BOTH, BARE + OLD, BARE + NEW, GZ + GZ, ""])
def test_one_gazebo_loads_all(pair: str) -> None:
    assert reported("GAZ012", BASE + pair) == []


def test_a_mixture_has_one_finding() -> None:
    assert len(reported("GAZ012", BASE + BARE + GZ)) == 1


def test_unknown_plugins_do_not_count() -> None:
    assert reported("GAZ012", BASE + OLD + plugin("libvendor.so")) == []


def test_a_given_target_decides() -> None:
    assert mixed(OLD + GZ, "gz-harmonic") == []
    assert len(mixed(OLD + GZ, "gz-harmonic", "classic-ros1")) == 1


def test_the_message() -> None:
    (found,) = reported("GAZ012", BASE + BOTH + GZ)
    assert found.message == naming(
        "p",
        "gz-sim-diff-drive-system",
        "p",
        "libgazebo_ros_p3d.so",
        "Gazebo",
        "Classic",
        "ROS 1",
        "Gazebo",
        "Classic",
        "ROS 2",
    )
