"""GAZ060: see the rule."""

from tests.gazebos import BASE, sensor
from tests.reported import messages, places


def test_a_sensor_without_a_name() -> None:
    for name in ("", ' name=""', ' name=" "'):
        text = BASE + sensor("imu", "").replace(' name="s"', name)
        assert messages("GAZ060", text) == [
            "a sensor of type 'imu' on 'base' has no name: Gazebo refuses the model"
        ]
        ((_, at),) = places("GAZ060", text)
        assert at.startswith("<sensor")


def test_a_sensor_with_one_is_calm() -> None:
    assert messages("GAZ060", BASE + sensor("imu", "")) == []
