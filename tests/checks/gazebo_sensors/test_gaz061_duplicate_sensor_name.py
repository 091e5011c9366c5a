"""GAZ061: see the rule."""

from tests.gazebos import BASE, BODY, child, sensor
from tests.reported import messages

FIXED = BASE + child("tip", "fixed", inside=BODY)


def test_two_on_one_link() -> None:
    assert messages("GAZ061", BASE + sensor("imu", "") + sensor("camera", "")) == [
        "sensor 's' on 'base' has the name of another one there"
    ]


def test_two_on_links_that_gazebo_merges() -> None:
    assert messages("GAZ061", FIXED + sensor("imu", "") + sensor("imu", "", "tip")) == [
        "sensor 's' on 'tip', which Gazebo makes part of 'base' has the name of another one there"
    ]


def test_other_names_and_other_links_are_calm() -> None:
    other = sensor("imu", "").replace('"s"', '"t"')
    assert messages("GAZ061", BASE + sensor("imu", "") + other) == []
    apart = BASE + child("tip", inside=BODY) + sensor("imu", "") + sensor("imu", "", "tip")
    assert messages("GAZ061", apart) == []
