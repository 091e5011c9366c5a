"""GAZ040: see the rule."""

import pytest

from tests.sensing import findings


def test_the_type_is_the_place_and_the_nearest_is_named():
    (finding,) = findings("GAZ040", "gpu_lidr")
    assert finding.message == (
        "sensor 's' is of type 'gpu_lidr', which no Gazebo knows; did you mean 'gpu_lidar'?"
    )
    assert finding.span.text == "gpu_lidr"


@pytest.mark.parametrize("type", ["ray", "gpu_lidar", "camera", "imu", "contact", "force_torque"])
def test_types_of_every_gazebo_are_known(type):
    assert findings("GAZ040", type) == []


SONAR = '<plugin name="p" filename="{}"/>'


def test_a_type_that_a_foreign_plugin_brings_is_its_own_affair():
    assert findings("GAZ040", "acme_sonar", SONAR.format("libacme_sonar.so")) == []


@pytest.mark.parametrize(
    ("type", "library"),
    [
        ("acme_sonar", "libgazebo_ros_ray_sensor.so"),  # known, and it brings no type
        ("gpu_lidr", "libacme_sonar.so"),  # a slip, whatever the plugin
        ("", "libacme_sonar.so"),
    ],
)
def test_other_types_are_told_with_a_plugin_too(type, library):
    assert len(findings("GAZ040", type, SONAR.format(library))) == 1


def test_a_sensor_without_a_type():
    (finding,) = findings("GAZ040", "")
    assert finding.message == "sensor 's' is without a type, which no Gazebo knows"


@pytest.mark.parametrize(
    ("target", "suggested"), [("classic-ros1", "sonar"), ("gz-harmonic", None)]
)
def test_only_a_type_that_the_gazebo_at_hand_makes_is_meant(target, suggested):
    (finding,) = findings("GAZ040", "sonarr", targets=(target,))
    assert (finding.fix.title if finding.fix else None) == (
        f"write {suggested}" if suggested else None
    )
