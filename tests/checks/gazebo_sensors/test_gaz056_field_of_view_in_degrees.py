"""GAZ056: see the rule."""

import pytest

from tests.sensing import findings


@pytest.mark.parametrize(
    ("angle", "count"), [(80, 1), (0, 1), (-1, 1), (1.39, 0), (6.28, 0), (0.5, 0)]
)
def test_the_field_of_view_is_an_angle_in_radians(angle, count):
    inner = f"<camera><horizontal_fov>{angle}</horizontal_fov></camera>"
    assert len(findings("GAZ056", "camera", inner)) == count


def test_the_angle_in_radians_is_told():
    inner = "<camera><horizontal_fov>90</horizontal_fov></camera>"
    (finding,) = findings("GAZ056", "camera", inner)
    assert finding.help == "if degrees were meant, write 1.5708"


@pytest.mark.parametrize("angle", [0, -1])
def test_what_is_no_angle_in_degrees_either_has_no_fix(angle):
    inner = f"<camera><horizontal_fov>{angle}</horizontal_fov></camera>"
    (finding,) = findings("GAZ056", "camera", inner)
    assert finding.fix is None
    assert "degrees" not in finding.help


def test_a_narrow_angle_in_degrees():
    inner = "<camera><horizontal_fov>6.5</horizontal_fov></camera>"
    (finding,) = findings("GAZ056", "camera", inner)
    assert finding.fix is not None
    assert [edit.text for edit in finding.fix.edits] == ["0.113446"]
