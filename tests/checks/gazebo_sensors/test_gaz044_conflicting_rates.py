"""GAZ044: see the rule."""

import pytest

from tests.sensing import findings


@pytest.mark.parametrize(
    ("sensor", "plugin", "count"), [(10, 30, 1), (30, 30, 0), (30, 10, 0), (30, 0.0, 0), (0, 30, 0)]
)
def test_a_plugin_cannot_be_faster_than_its_sensor(sensor, plugin, count):
    inner = f"<update_rate>{sensor}</update_rate><plugin><updateRate>{plugin}</updateRate></plugin>"
    found = findings("GAZ044", "camera", inner)
    assert len(found) == count
    assert all(finding.span.text == "<updateRate>" for finding in found)
