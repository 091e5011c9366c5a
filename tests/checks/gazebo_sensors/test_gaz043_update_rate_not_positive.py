"""GAZ043: see the rule."""

import pytest

from tests.sensing import findings


@pytest.mark.parametrize(
    ("type", "rate", "count"),
    [("camera", 0, 1), ("imu", 0, 0), ("imu", -1, 1), ("camera", 30, 0), ("depth", 0, 1)],
)
def test_zero_harms_what_is_rendered_and_below_zero_all(type, rate, count):
    found = findings("GAZ043", type, f"<update_rate>{rate}</update_rate>")
    assert len(found) == count


@pytest.mark.parametrize(("type", "count"), [("camera", 1), ("gpu_lidar", 1), ("imu", 0)])
def test_without_a_rate_it_is_zero(type, count):
    assert len(findings("GAZ043", type)) == count


def test_the_rate_of_a_plugin_is_another_thing():
    inner = "<update_rate>30</update_rate><plugin><updateRate>0.0</updateRate></plugin>"
    assert findings("GAZ043", "camera", inner) == []
