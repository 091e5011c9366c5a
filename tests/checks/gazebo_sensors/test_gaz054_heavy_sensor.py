"""GAZ054: see the rule."""

import pytest

from tests.sensing import findings


@pytest.mark.parametrize(
    ("width", "height", "rate", "count"),
    [(1920, 1080, 60, 1), (1920, 1080, 30, 0), (640, 480, 100, 0), (3840, 2160, 15, 1)],
)
def test_pixels_a_second(width, height, rate, count):
    image = f"<image><width>{width}</width><height>{height}</height></image>"
    inner = f"<update_rate>{rate}</update_rate><camera>{image}</camera>"
    assert len(findings("GAZ054", "camera", inner)) == count


def test_beams_a_second():
    scan = "<horizontal><samples>2000</samples></horizontal><vertical><samples>128</samples>"
    inner = f"<update_rate>{{}}</update_rate><ray><scan>{scan}</vertical></scan></ray>"
    assert findings("GAZ054", "ray", inner.format(20)) == []
    (finding,) = findings("GAZ054", "ray", inner.format(400))
    assert finding.message == (
        "sensor 's': 256000 values 400 times a second are 102.4 million a second, more than 100"
    )
