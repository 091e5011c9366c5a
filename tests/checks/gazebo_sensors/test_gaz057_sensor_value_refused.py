"""GAZ057: see the rule."""

import pytest

from tests.sensing import findings

CAMERA = "<camera><image><width>{}</width><height>480</height><format>{}</format></image></camera>"


@pytest.mark.parametrize(
    ("type", "inner", "wanted"),
    [
        (
            "imu",
            "<update_rate>often</update_rate>",
            "<update_rate> is 'often', and must be a number",
        ),
        ("imu", "<update_rate>0,5</update_rate>", "<update_rate> is '0,5', and must be a number"),
        ("imu", "<always_on>yes</always_on>", "<always_on> is 'yes', and must be true or false"),
        (
            "imu",
            "<pose>0 0 1</pose>",
            "<pose> is '0 0 1', and must be 6 numbers with spaces between them",
        ),
        (
            "camera",
            "<camera><clip><near>near</near></clip></camera>",
            "<near> is 'near', and must be a number",
        ),
        (
            "camera",
            "<camera><clip><far>50 cm</far></clip></camera>",
            "<far> is '50 cm', and Gazebo reads 50 and ignores 'cm'",
        ),
        (
            "camera",
            "<camera><horizontal_fov>1,2</horizontal_fov></camera>",
            "<horizontal_fov> is '1,2', and must be a number",
        ),
        (
            "camera",
            "<camera><save enabled='yes'><path>/tmp</path></save></camera>",
            "attribute enabled is 'yes', and must be true or false",
        ),
        (
            "camera",
            CAMERA.format("1e3", "L8"),
            "<width> is '1e3', and Gazebo reads 1 and ignores 'e3'",
        ),
        (
            "imu",
            "<imu><linear_acceleration><z><noise type='normal'/></z></linear_acceleration></imu>",
            "attribute type is 'normal', and must be gaussian, gaussian_quantized, none",
        ),
        ("camera", CAMERA.format(0, "L8"), "<width> is '0', and must be 1 or more"),
        (
            "camera",
            CAMERA.format(640, "r8g8b8"),
            "<format> is 'r8g8b8', and must be one of SDF's words; did you mean 'R8G8B8'?",
        ),
        (
            "ray",
            "<ray><noise><type>normal</type></noise></ray>",
            "<type> is 'normal', and must be gaussian, gaussian_quantized, none",
        ),
        (
            "imu",
            (
                "<imu><angular_velocity><x><noise type='gaussian'><stddev>-1</stddev></noise></x>"
                "</angular_velocity></imu>"
            ),
            "<stddev> is '-1', and must be 0 or more",
        ),
    ],
)
def test_what_gazebo_refuses(type: str, inner: str, wanted: str) -> None:
    (finding,) = findings("GAZ057", type, inner)
    assert finding.message == f"sensor 's': {wanted}"
    assert finding.span.line == 10


@pytest.mark.parametrize(
    "inner",
    [
        "<update_rate> 30 Hz </update_rate>",  # read as 30
        "<always_on>TRUE</always_on>",
        "<camera><horizontal_fov>60</horizontal_fov></camera>",  # GAZ047
        "<pose>0 0 0 0 0 0</pose>",
        "<ray><range><min>0.1</min><max>inf</max></range></ray>",
        CAMERA.format(640, "R8G8B8"),
        CAMERA.format("640.0", "R8G8B8"),
    ],
)
def test_what_is_read_or_told_elsewhere(inner: str) -> None:
    assert findings("GAZ057", "camera", inner) == []


def test_beams_that_a_quotient_left_are_cut_to_a_whole_number():
    text = "<ray><scan><horizontal><samples>{}</samples></horizontal></scan></ray>"
    assert findings("GAZ057", "ray", text.format("666.518518519")) == []
    assert len(findings("GAZ057", "ray", text.format("6.6e2"))) == 1
