import pytest

from tests.gazebos import BASE, plugin
from tests.naming import naming
from tests.reported import fixed, places, reported
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.catalog import plugins
from urdfkit.text.diagnostic import Severity

DRIVE = "libgazebo_ros_diff_drive.so"
POSES = "gz-sim-pose-publisher-system"


def severities(text: str) -> list[Severity]:
    return [found.severity for found in reported("GAZ011", text)]


def test_a_vendors_library_is_reported_once() -> None:
    text = BASE + plugin("libvendor.so") + plugin("libvendor.so") + plugin("libother.so")
    assert places("GAZ011", text) == [(4, "libvendor.so"), (10, "libother.so")]
    assert severities(text) == [Severity.INFO] * 2


def test_filename_and_name_swapped() -> None:
    swapped = f'<plugin filename="gz::sim::systems::PosePublisher" name="{POSES}"/>'
    (found,) = reported("GAZ011", f"{BASE}<gazebo>{swapped}</gazebo>")
    assert found.help == f'write filename="{POSES}" name="gz::sim::systems::PosePublisher"'


@pytest.mark.parametrize(
    ("file", "severity"),
    [
        ("libros_gz_sim_joint_state_publisher-system.so", Severity.WARNING),
        ("libown_joints.so", Severity.INFO),
    ],
)
def test_a_class_of_gz_sim(file: str, severity: Severity) -> None:
    text = plugin(file, name="gz::sim::systems::JointStatePublisher")
    (found,) = reported("GAZ011", BASE + text)
    assert found.severity == severity


def test_every_library_of_the_catalogue_is_known() -> None:
    found = reported("GAZ011", BASE + "".join(plugin(file) for file in plugins.files()))
    assert {one.severity for one in found} == {Severity.ERROR}, "the class only"


@pytest.mark.parametrize(
    ("file", "suggested"),
    [
        ("libgazebo_ros_diffdrive.so", DRIVE),
        ("libgazebo_ros_diff_drvie.so", DRIVE),
        ("libgazebo_ros_diff_driver.so", DRIVE),
        ("libgazebo_ros_diff-drive.so", DRIVE),
        ("gazebo_ros_diff_drive", DRIVE),
        ("libgazebo_ros2_controll.so", "libgazebo_ros2_control.so"),
        ("gz-sim-imu-sytem", "gz-sim-imu-system"),
    ],
)
def test_a_typo_is_fixed(file: str, suggested: str) -> None:
    text = BASE + plugin(file)
    (found,) = reported("GAZ011", text)
    assert (found.severity, found.help) == (Severity.WARNING, naming(suggested))
    assert fixed("GAZ011", text) == whole_robot(BASE + plugin(suggested))


@pytest.mark.parametrize(
    "file",
    [
        "libgazebo_ros_diff_drive2.so",
        "libgazebo_ros_srp.so",
        "libroboticsgroup_gazebo_disable_link_plugin.so",
    ],
)
def test_a_library_of_a_vendor_is_no_typo(file: str) -> None:
    assert severities(BASE + plugin(file)) == [Severity.INFO]


@pytest.mark.parametrize(
    ("file", "known"),
    [
        (POSES, "gz::sim::systems::PosePublisher"),
        (f"lib{POSES}.so", "gz::sim::systems::PosePublisher"),
        ("ignition-gazebo-pose-publisher-system", "ignition::gazebo::systems::PosePublisher"),
    ],
)
@pytest.mark.parametrize("name", ["poses", "gz::sim::PosePublisher", "GZ::sim::systems::Poses"])
def test_a_name_that_is_no_class(name: str, file: str, known: str) -> None:
    text = BASE + plugin(file, name=name)
    (found,) = reported("GAZ011", text)
    assert found.severity is Severity.ERROR
    assert places("GAZ011", text) == [(4, name)]
    assert f'<plugin name="{known}"' in fixed("GAZ011", text)
    assert found.fix
    assert not found.fix.safe


@pytest.mark.parametrize(
    ("file", "name"),
    [
        (POSES, "gz::sim::systems::PosePublisher"),
        (POSES, "gz::sim::v8::systems::PosePublisher"),
        ("ignition-gazebo-pose-publisher-system", "ignition::gazebo::systems::PosePublisher"),
        (POSES, ""),  # GAZ010
        ("", "anything"),  # GAZ010
        ("gz_ros2_control-system", "gz_ros2_control::GazeboSimROS2ControlPlugin"),
        ("ign_ros2_control-system", "ign_ros2_control::IgnitionROS2ControlPlugin"),
        ("libgazebo_ros_planar_move.so", "anything"),  # a label, in Gazebo Classic
    ],
)
def test_no_finding(file: str, name: str) -> None:
    assert reported("GAZ011", BASE + plugin(file, name=name)) == []


@pytest.mark.parametrize(
    ("file", "system"),
    [
        ("libgz_diff_drive.so", "gz-sim-diff-drive-system"),
        ("libignition-gazebo-imu.so", "gz-sim-imu-system"),
        ("libgz_ray_sensor.so", None),
        ("libdiff_drive_system.so", None),
    ],
)
def test_a_library_that_is_called_like_a_system(file: str, system: str | None) -> None:
    """Names that Gazebo never had; the class is another one, too."""
    (found,) = reported("GAZ011", BASE + plugin(file))
    assert found.severity is (Severity.WARNING if system else Severity.INFO)
    assert found.fix is None
    assert system is None or found.help == naming(system)


@pytest.mark.parametrize(
    ("tags", "is_fixed"), [("", True), ("<publish_odom/>", True), ("<a/>", False)]
)
def test_a_library_whose_tags_are_others_may_be_a_vendors(tags: str, is_fixed: bool) -> None:
    (found,) = reported("GAZ011", BASE + plugin("libgazebo_ros_diff_drvie.so", tags))
    assert (found.fix is not None) == is_fixed


@pytest.mark.parametrize(
    ("tags", "fixed_as"),
    [
        ("", None),
        ("<left_joint>l</left_joint>", 'filename="gz-sim-diff-drive-system"'),
        ("<publish_link_pose>true</publish_link_pose>", 'name="gz::sim::systems::PosePublisher"'),
    ],
)
def test_of_a_library_and_the_class_of_another_one_the_tags_show_which_is_wrong(
    tags: str, fixed_as: str | None
) -> None:
    (found,) = reported("GAZ011", BASE + plugin(POSES, tags, "gz::sim::systems::DiffDrive"))
    assert found.help == naming(
        'name="gz::sim::systems::PosePublisher"', 'filename="gz-sim-diff-drive-system"'
    )
    assert (found.fix and found.fix.title) == (fixed_as and f"write {fixed_as}")
