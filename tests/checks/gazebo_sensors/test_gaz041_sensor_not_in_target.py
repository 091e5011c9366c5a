"""GAZ041: see the rule."""

import pytest

from tests.sensing import findings
from urdfkit.text.diagnostic import Severity


@pytest.mark.parametrize(
    ("type", "targets", "severity"),
    [
        ("ray", ("gz-harmonic",), Severity.ERROR),
        ("gpu_ray", ("gz-harmonic",), None),
        ("ray", ("classic-ros1",), None),
        ("gpu_lidar", ("classic-ros2",), Severity.ERROR),
        ("depth_camera", ("classic-ros1",), Severity.ERROR),
        ("ray", ("moveit",), Severity.INFO),
        ("imu", ("gz-jetty",), None),
    ],
)
def test_each_gazebo_has_its_own_types(type, targets, severity):
    found = findings("GAZ041", type, targets=targets)
    assert [finding.severity for finding in found] == ([severity] if severity else [])


def test_the_name_in_the_target_is_told():
    (finding,) = findings("GAZ041", "ray", targets=("gz-harmonic",))
    assert finding.message.endswith("there it is 'gpu_lidar'")
    assert finding.targets == ("gz-harmonic",)
