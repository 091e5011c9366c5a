"""GAZ047: see the rule."""

import pytest

from tests.sensing import findings, scan


@pytest.mark.parametrize(
    ("first", "last", "count"), [(-90, 90, 2), (-6.28, 6.28, 0), (0, 360, 1), (-3.2, 3.2, 0)]
)
def test_more_than_a_turn_is_taken_for_degrees(first, last, count):
    assert len(findings("GAZ047", "ray", scan(first, last))) == count


def test_the_angle_in_radians_is_told():
    (finding,) = findings("GAZ047", "ray", scan(0, 180))
    assert finding.help == "if degrees were meant, write 3.14159"


@pytest.mark.parametrize(
    ("pose", "right"),
    [
        ("<pose>0 0 0.1 0 0 90</pose>", "0 0 0.1 0 0 1.5708"),
        ("<pose>0 0 0.1 -90 0 -90</pose>", "0 0 0.1 -1.5708 0 -1.5708"),
        ("<pose>0 0 90 0 0 1.57</pose>", None),
        ('<pose degrees="true">0 0 0.1 0 0 90</pose>', None),
        ("<pose>0 0 90</pose>", None),
    ],
)
def test_a_sensor_turned_by_degrees(pose, right):
    found = findings("GAZ047", "camera", pose)
    expected = [f"if degrees were meant, write {right}"] if right else []
    assert [finding.help for finding in found] == expected
