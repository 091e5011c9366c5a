"""GAZ042: see the rule."""

import pytest

from tests.sensing import findings


def test_the_nearest_name_is_told():
    (finding,) = findings("GAZ042", "imu", "<updaterate>1</updaterate>")
    assert finding.message == (
        "sensor 's': unknown element <updaterate> in <sensor> (ignored); "
        "did you mean 'update_rate'?"
    )
    assert finding.span.line == 10


@pytest.mark.parametrize("tag", ["update_rate", "ray", "camera", "plugin", "gz_frame_id", "my:tag"])
def test_what_sensors_have_is_calm(tag):
    assert findings("GAZ042", "ray", f"<{tag}/>") == []


def test_a_slip_deep_in_the_settings_is_told_where_it_is():
    inner = "<camera><image>\n<widht>640</widht></image></camera>"
    (finding,) = findings("GAZ042", "camera", inner)
    assert (
        finding.message
        == "sensor 's': unknown element <widht> in <image> (ignored); did you mean 'width'?"
    )
    assert (finding.span.line, finding.span.text) == (11, "<widht>")
    assert finding.fix


def test_what_is_in_an_unknown_tag_is_not_told_as_well():
    inner = "<camera><imaeg><widht>640</widht></imaeg></camera>"
    assert len(findings("GAZ042", "camera", inner)) == 1


@pytest.mark.parametrize(
    "inner",
    [
        "<camera><noise><type>gaussian</type><mean>0</mean><stddev>1</stddev></noise></camera>",
        "<ray><scan><vertical><samples>16</samples></vertical></scan></ray>",
        (
            "<imu><angular_velocity><x><noise type='none'><bias_mean>0</bias_mean></noise></x>"
            "</angular_velocity></imu>"
        ),
    ],
)
def test_what_sdf_knows_is_calm(inner):
    assert findings("GAZ042", "camera", inner) == []


@pytest.mark.parametrize(("tag", "instead"), [("origin", "<pose>"), ("noise", "<ray>")])
def test_what_belongs_elsewhere_is_told_so(tag, instead):
    (finding,) = findings("GAZ042", "ray", f"<{tag}/>")
    assert finding.message == f"sensor 's': unknown element <{tag}> in <sensor> (ignored)"
    assert instead in finding.help
