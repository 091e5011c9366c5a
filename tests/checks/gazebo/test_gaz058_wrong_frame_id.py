import pytest

from tests.gazebos import BASE, child, plugin, sensor
from tests.naming import naming
from tests.reported import fixed, messages, reported
from tests.sensing import findings
from urdfkit.text.diagnostic import Severity

IMU = "libgazebo_ros_imu_sensor.so"
LASER = '<plugin name="p" filename="libgazebo_ros_laser.so"><frameName>{}</frameName></plugin>'


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        ("basis", "a link of the robot"),
        ("robot/lidar", "a link of the robot"),
        ("/base", ""),
        ("/basis", "a link of the robot"),
    ],
)
def test_frames_without_a_link(frame: str, message: str) -> None:
    """A laser of ROS 1, whose frame tf::resolve changes: it takes the slash away."""
    found = messages("GAZ058", BASE + sensor("ray", LASER.format(frame)))
    assert [frame.lstrip("/") in one for one in found] == [True] * bool(message)
    assert all(one.endswith(message) for one in found)


@pytest.mark.parametrize(
    ("kind", "tag", "file", "count"),
    [
        ("imu", "frameName", IMU, 1),  # it does not call tf::resolve
        ("ray", "frame_name", "libgazebo_ros_ray_sensor.so", 1),
        ("ray", "frameName", "libgazebo_ros_laser.so", 0),
    ],
)
def test_the_slash_of_a_frame(kind: str, tag: str, file: str, count: int) -> None:
    inside = f'<plugin name="p" filename="{file}"><{tag}>/base</{tag}></plugin>'
    found = messages("GAZ058", BASE + sensor(kind, inside))
    assert [one.endswith("which tf2 rejects") for one in found] == [True] * count


def test_a_link_with_a_slash_is_not_suggested() -> None:
    """my_ros2_robot_gazebo: the prefix of the links, $(arg ns)/, is empty by default."""
    (found,) = reported(
        "GAZ058", BASE.replace('"base"', '"/base"') + sensor("ray", LASER.format("bas"), "/base")
    )
    assert found.help == "name a link of the robot"


def test_the_frame_of_a_sensor_of_gz() -> None:
    (message_of_all,) = messages("GAZ058", BASE + sensor("imu", "<gz_frame_id>imu</gz_frame_id>"))
    assert message_of_all == naming("s", "frame_id", "imu")


def test_a_typo_is_fixed() -> None:
    text = BASE.replace('"base"', '"laser"') + sensor("ray", LASER.format("lasser"), "laser")
    assert "<frameName>laser<" in fixed("GAZ058", text)


@pytest.mark.parametrize("frame", ["base", "robot/base", "map", "odom_frame", "$(arg x)", ""])
def test_links_and_frames_of_the_world_are_not_reported(frame: str) -> None:
    assert messages("GAZ058", BASE + sensor("ray", LASER.format(frame))) == []


def test_a_link_whose_name_has_a_slash() -> None:
    text = BASE.replace('"base"', '"rov/imu"')
    tag = "<gz_frame_id>rov/imu</gz_frame_id>"
    assert messages("GAZ058", text + sensor("imu", tag, "rov/imu")) == []


def test_the_frame_of_odometry_comes_from_elsewhere() -> None:
    tags = "<odometryFrame>start</odometryFrame><robotBaseFrame>base</robotBaseFrame>"
    assert messages("GAZ058", BASE + plugin("libgazebo_ros_planar_move.so", tags)) == []


@pytest.mark.parametrize(
    ("frame", "drive", "count"),
    [
        ("base_sim", "", 1),
        ("base_sim", "gz-sim-diff-drive-system", 0),
        ("footprnt", "gz-sim-diff-drive-system", 1),
    ],
)
def test_the_frame_of_the_true_pose(frame: str, drive: str, count: int) -> None:
    """A robot with a drive, whose odometry drifts, and a publisher of its pose in the world."""
    robot = BASE + child("footprint", "fixed")
    robot += plugin(
        "gz-sim-odometry-publisher-system", f"<robot_base_frame>{frame}</robot_base_frame>"
    )
    assert len(messages("GAZ058", robot + (plugin(drive) if drive else ""))) == count


@pytest.mark.parametrize(
    ("file", "tag", "count"),
    [
        ("gz-sim-odometry-publisher-system", "odom_frame", 1),
        ("libgazebo_ros_planar_move.so", "odometry_frame", 1),
        ("libgazebo_ros_planar_move.so", "odometryFrame", 0),  # ROS 1 takes the slash away
    ],
)
def test_the_slash_of_the_frame_of_odometry(file: str, tag: str, count: int) -> None:
    robot = BASE + plugin(file, f"<{tag}>/odom</{tag}>")
    assert len(messages("GAZ058", robot)) == count


@pytest.mark.parametrize(
    ("targets", "severities"),
    [
        (("ros2", "gz-harmonic"), [Severity.WARNING]),
        (("gz-harmonic",), [Severity.INFO]),  # without ROS there is no TF
        (("classic-ros1",), []),
        (("ros1", "classic-ros1", "gz-jetty"), [Severity.WARNING]),
    ],
)
def test_it_matters_in_gz_sim_only(targets, severities):
    found = findings("GAZ058", "imu", targets=targets)
    assert [finding.severity for finding in found] == severities


@pytest.mark.parametrize(
    ("target", "read"),
    [
        ("gz-fortress", {"gz_frame_id", "ignition_frame_id"}),
        ("gz-harmonic", {"gz_frame_id"}),
        ("gz-jetty", {"gz_frame_id", "frame_id"}),
    ],
)
@pytest.mark.parametrize("tag", ["gz_frame_id", "frame_id", "ignition_frame_id"])
def test_each_gazebo_reads_its_own_tags(tag, target, read):
    found = findings("GAZ058", "imu", f"<{tag}>base</{tag}>", targets=(target,))
    reported = [] if tag in read else [naming("s", "only", f"<{tag}>")]
    assert [one.message for one in found] == reported


@pytest.mark.parametrize("tag", ["gz_frame_id", "frame_id", "ignition_frame_id"])
def test_without_a_known_target_any_name_will_do(tag):
    assert findings("GAZ058", "imu", f"<{tag}>base</{tag}>") == []


def test_one_of_several_targets_may_suffer():
    both = ("gz-harmonic", "gz-jetty")
    assert len(findings("GAZ058", "imu", "<frame_id>base</frame_id>", targets=both)) == 1


def test_a_model_has_one_finding():
    beside = '<sensor name="first" type="imu"/>'
    (found,) = findings("GAZ058", "imu", beside=beside, targets=("gz-harmonic",))
    assert found.message == naming("first", "<gz_frame_id>", "1")


@pytest.mark.parametrize(("value", "severity"), [("true", "INFO"), ("false", "WARNING")])
def test_a_publisher_of_the_poses_of_sensors(value: str, severity: str) -> None:
    """VRX turns them into transforms, so that TF has Gazebo's own names."""
    publisher = '<plugin name="gz::sim::systems::PosePublisher" '
    publisher += 'filename="gz-sim-pose-publisher-system">'
    publisher += f"<publish_sensor_pose>{value}</publish_sensor_pose></plugin>"
    robot = BASE + f'<gazebo>{publisher}</gazebo><gazebo reference="base">'
    robot += '<sensor name="s" type="imu"/></gazebo>'
    (found,) = reported("GAZ058", robot, targets=("ros2", "gz-harmonic"))
    assert found.severity is Severity[severity]


def test_a_contact_sensor_needs_no_frame():
    assert findings("GAZ058", "contact", targets=("gz-harmonic",)) == []


@pytest.mark.parametrize(
    ("kind", "count"), [("", 0), ('gz:type="odometer"', 0), ('gz:type="dvl"', 1)]
)
def test_the_plugin_of_a_custom_sensor_knows_its_frame(kind: str, count: int) -> None:
    """giacomotambe/traquad_gazebo: a lidar of RGL, whose plugin has a <frame>."""
    robot = BASE + f'<gazebo reference="base"><sensor name="s" type="custom" {kind}/></gazebo>'
    assert len(reported("GAZ058", robot, targets=("ros2", "gz-harmonic"))) == count


@pytest.mark.parametrize(
    ("frame", "count"), [("camera/left", 0), ("left", 0), ("amera/left", 1), ("camera/right", 1)]
)
def test_a_namespace_in_front_of_a_frame(frame: str, count: int) -> None:
    """RotorS's stereo camera: a plugin of ROS 1 puts the name of the model in front."""
    robot = BASE + '<link name="uav/camera/left"/>' + sensor("ray", LASER.format(frame))
    assert len(messages("GAZ058", robot)) == count


@pytest.mark.parametrize(("reference", "count"), [("base", 2), ("arm_joint", 2), ("camera", 0)])
def test_a_sensor_of_a_dropped_block(reference: str, count: int) -> None:
    """Kinova's Gen3 without its camera: GAZ001 reports the block."""
    content = "<gz_frame_id>camera</gz_frame_id>" + LASER.format("camera")
    block = (
        f'<gazebo reference="{reference}"><sensor name="s" type="ray">{content}</sensor></gazebo>'
    )
    found = messages("GAZ058", BASE + child("arm") + block)
    assert len([one for one in found if "not a link" in one]) == count
