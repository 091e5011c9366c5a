"""GAZ042: see the rule."""

import pytest

from tests.sensing import findings


def test_the_nearest_name_is_told():
    (finding,) = findings("GAZ042", "imu", "<updaterate>1</updaterate>")
    assert finding.message == (
        "sensor 's': a sensor has no <updaterate>; did you mean 'update_rate'?"
    )
    assert finding.span.line == 10


@pytest.mark.parametrize("tag", ["update_rate", "ray", "camera", "plugin", "gz_frame_id", "my:tag"])
def test_what_sensors_have_is_calm(tag):
    assert findings("GAZ042", "ray", f"<{tag}/>") == []
