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
