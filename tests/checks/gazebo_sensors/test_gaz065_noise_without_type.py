"""GAZ065: see the rule."""

import pytest

from tests.sensing import findings


def axis(noise: str) -> str:
    return f"<imu><angular_velocity><x>\n{noise}\n</x></angular_velocity></imu>"


def test_the_noise_of_a_lidar_in_an_imu():
    noise = "<noise><type>none</type><mean>0</mean></noise>"
    (finding,) = findings("GAZ065", "imu", axis(noise))
    assert finding.message == (
        "sensor 's': <noise> has no attribute type: Gazebo rejects the model, and ignores its "
        "<type>"
    )
    assert (finding.span.line, finding.span.text) == (11, "<noise>")
    assert finding.fix
    assert finding.fix.title == 'write <noise type="none">'


@pytest.mark.parametrize(
    ("type", "inner", "count"),
    [
        ("imu", axis('<noise type="gaussian"/>'), 0),
        ("imu", axis("<noise/>"), 1),
        ("gps", "<gps><position_sensing><vertical><noise/></vertical></position_sensing></gps>", 1),
        ("ray", "<ray><noise><type>gaussian</type></noise></ray>", 0),
        ("camera", "<camera><noise/></camera>", 0),
    ],
)
def test_only_single_quantities_have_it_as_an_attribute(type, inner, count):
    assert len(findings("GAZ065", type, inner)) == count
