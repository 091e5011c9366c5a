import pytest

from tests.gazebos import BASE, BODY, child, sensor
from tests.naming import naming
from tests.reported import messages, reported
from tests.sensing import findings
from urdfkit.text.diagnostic import Severity


def test_the_type_is_the_place_and_the_nearest_is_named():
    (finding,) = findings("GAZ040", "gpu_lidr")
    assert finding.message == naming("s", "unknown", "gpu_lidr", "rejects", "gpu_lidar")
    assert finding.span.text == "gpu_lidr"


@pytest.mark.parametrize("type", ["gpu_lidar", "camera", "imu", "contact"])
def test_types_of_every_gazebo_are_known(type):
    assert findings("GAZ040", type) == []


SONAR = '<plugin name="p" filename="{}"/>'


def test_a_type_that_a_foreign_plugin_brings_is_its_own_affair():
    assert findings("GAZ040", "acme_sonar", SONAR.format("libacme_sonar.so")) == []


@pytest.mark.parametrize(
    ("type", "library"),
    [
        ("acme_sonar", "libgazebo_ros_ray_sensor.so"),  # known, and it brings no type
        ("gpu_lidr", "libacme_sonar.so"),  # a typo, whatever the plugin
        ("", "libacme_sonar.so"),
    ],
)
def test_other_types_are_reported_with_a_plugin_too(type, library):
    assert len(findings("GAZ040", type, SONAR.format(library))) == 1


def test_a_sensor_without_a_type():
    (finding,) = findings("GAZ040", "")
    assert finding.message == naming("s", "rejects")


@pytest.mark.parametrize(
    ("target", "suggested"), [("classic-ros1", "sonar"), ("gz-harmonic", None)]
)
def test_only_a_type_that_the_gazebo_at_hand_makes_is_meant(target, suggested):
    (finding,) = findings("GAZ040", "sonarr", targets=(target,))
    assert (finding.fix and finding.fix.title) == (suggested and f'write type="{suggested}"')


@pytest.mark.parametrize(
    ("type", "targets", "severity"),
    [
        ("ray", ("gz-harmonic",), Severity.ERROR),
        ("gpu_ray", ("gz-harmonic",), None),
        ("ray", ("classic-ros1",), None),
        ("gpu_lidar", ("classic-ros2",), Severity.ERROR),
        ("depth_camera", ("classic-ros1",), Severity.ERROR),
        ("ray", ("moveit",), Severity.INFO),
        ("ray", ("ros1",), None),
        ("ray", ("ros2",), Severity.INFO),
        ("imu", ("gz-jetty",), None),
    ],
)
def test_each_gazebo_has_its_own_types(type, targets, severity):
    found = findings("GAZ040", type, targets=targets)
    assert [finding.severity for finding in found] == ([severity] if severity else [])


@pytest.mark.parametrize(("frame", "severity"), [("gz_frame_id", "info"), ("frame", "error")])
def test_a_sensor_of_gz_next_to_a_plugin_of_classic(frame: str, severity: str) -> None:
    """The bases of match_mobile_robotics_jazzy still have an old plugin of their IMU."""
    old = '<plugin name="imu" filename="libgazebo_ros_imu_sensor.so"/>'
    (found,) = findings("GAZ040", "gpu_lidar", f"<{frame}>base</{frame}>", beside=old)
    assert found.severity.value == severity


def test_the_name_in_the_target():
    (finding,) = findings("GAZ040", "ray", targets=("gz-harmonic",))
    assert finding.help == "write type 'gpu_lidar'"
    assert finding.targets == ("gz-harmonic",)


ROBOT = BASE + child("tip", inside=BODY)


def test_forces_are_measured_in_a_joint() -> None:
    (found,) = reported("GAZ040", ROBOT + sensor("force_torque", "", "tip"))
    assert found.message == naming("s", "force_torque", "tip")
    assert found.help == 'write reference="tip_joint"'


def test_images_are_taken_from_a_link() -> None:
    assert messages("GAZ040", ROBOT + sensor("camera", "", "tip_joint")) == [
        naming("s", "camera", "tip_joint")
    ]


def test_where_they_belong_they_are_not_reported() -> None:
    assert messages("GAZ040", ROBOT + sensor("force_torque", "", "tip_joint")) == []
    assert messages("GAZ040", ROBOT + sensor("camera", "", "tip")) == []


def axis(noise: str) -> str:
    return f"<imu><angular_velocity><x>\n{noise}\n</x></angular_velocity></imu>"


def test_the_noise_of_a_lidar_in_an_imu():
    noise = "<noise><type>none</type><mean>0</mean></noise>"
    (finding,) = findings("GAZ040", "imu", axis(noise))
    assert finding.message == naming("s", "<noise>", "Gazebo", "rejects")
    assert (finding.span.line, finding.span.text) == (11, "<noise>")
    assert finding.fix
    assert finding.fix.title == 'write <noise type="none">'


@pytest.mark.parametrize(
    ("type", "inner", "count"),
    [
        ("imu", axis('<noise type="gaussian"/>'), 0),
        ("imu", axis("<noise/>"), 1),
        ("gps", "<gps><position_sensing><vertical><noise/></vertical></position_sensing></gps>", 1),
        ("gpu_lidar", "<ray><noise><type>gaussian</type></noise></ray>", 0),
        ("camera", "<camera><noise/></camera>", 0),
    ],
)
def test_only_single_quantities_have_it_as_an_attribute(type, inner, count):
    assert len(findings("GAZ040", type, inner)) == count
