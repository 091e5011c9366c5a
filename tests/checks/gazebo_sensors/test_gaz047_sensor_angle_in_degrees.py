import pytest

from tests.naming import naming
from tests.sensing import findings, scan


@pytest.mark.parametrize(
    ("first", "last", "count"), [(-90, 90, 2), (-6.28, 6.28, 0), (0, 360, 1), (-3.2, 3.2, 0)]
)
def test_more_than_a_turn_is_taken_for_degrees(first, last, count):
    assert len(findings("GAZ047", "ray", scan(first, last))) == count


def test_the_angle_in_radians_is_shown():
    (finding,) = findings("GAZ047", "ray", scan(0, 180))
    assert finding.help == naming("degrees", "3.14159")


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
    expected = [f"if it is in degrees, write {right}"] if right else []
    assert [finding.help for finding in found] == expected


@pytest.mark.parametrize(
    ("angle", "count"), [(80, 1), (0, 1), (-1, 1), (1.39, 0), (6.28, 0), (0.5, 0)]
)
def test_the_field_of_view_is_an_angle_in_radians(angle, count):
    inner = f"<camera><horizontal_fov>{angle}</horizontal_fov></camera>"
    assert len(findings("GAZ047", "camera", inner)) == count


def test_the_angle_in_radians_is_shown_56():
    inner = "<camera><horizontal_fov>90</horizontal_fov></camera>"
    (finding,) = findings("GAZ047", "camera", inner)
    assert finding.help == naming("degrees", "1.5708")


@pytest.mark.parametrize("angle", [0, -1])
def test_what_is_no_angle_in_degrees_either_has_no_fix(angle):
    inner = f"<camera><horizontal_fov>{angle}</horizontal_fov></camera>"
    (finding,) = findings("GAZ047", "camera", inner)
    assert finding.fix is None
    assert "degrees" not in finding.help


def test_a_narrow_angle_in_degrees():
    inner = "<camera><horizontal_fov>6.5</horizontal_fov></camera>"
    (finding,) = findings("GAZ047", "camera", inner)
    assert finding.fix is not None
    assert [edit.text for edit in finding.fix.edits] == ["0.113446"]
