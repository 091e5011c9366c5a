"""GAZ048: see the rule."""

import pytest

from tests.sensing import findings


@pytest.mark.parametrize(("near", "far", "count"), [(1, 0.5, 1), (1, 1, 1), (0.02, 300, 0)])
def test_near_must_be_below_far(near, far, count):
    clip = f"<camera><clip><near>{near}</near><far>{far}</far></clip></camera>"
    found = findings("GAZ048", "camera", clip)
    assert len(found) == count
    assert all(finding.span.text == "<near>" for finding in found)


@pytest.mark.parametrize("near", [0, -0.05])
def test_near_must_be_above_zero(near):
    (finding,) = findings("GAZ048", "camera", f"<camera><clip><near>{near}</near></clip></camera>")
    assert finding.message == f"sensor 's': near is {near:g} m, and must be above 0"
