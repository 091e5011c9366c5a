"""GAZ053: see the rule."""

import pytest

from tests.sensing import findings
from urdfkit.text.diagnostic import Severity


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
    found = findings("GAZ053", "imu", targets=targets)
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
    found = findings("GAZ053", "imu", f"<{tag}>base</{tag}>", targets=(target,))
    reported = [] if tag in read else [f"sensor 's' names its frame by <{tag}> only"]
    assert [one.message for one in found] == reported


@pytest.mark.parametrize("tag", ["gz_frame_id", "frame_id", "ignition_frame_id"])
def test_without_a_known_target_any_name_will_do(tag):
    assert findings("GAZ053", "imu", f"<{tag}>base</{tag}>") == []


def test_one_of_several_targets_may_suffer():
    both = ("gz-harmonic", "gz-jetty")
    assert len(findings("GAZ053", "imu", "<frame_id>base</frame_id>", targets=both)) == 1


def test_a_model_is_told_once():
    beside = '<sensor name="first" type="imu"/>'
    (found,) = findings("GAZ053", "imu", beside=beside, targets=("gz-harmonic",))
    assert found.message == ("sensor 'first' has no <gz_frame_id> (and 1 more like this)")


def test_a_contact_sensor_needs_no_frame():
    assert findings("GAZ053", "contact", targets=("gz-harmonic",)) == []
