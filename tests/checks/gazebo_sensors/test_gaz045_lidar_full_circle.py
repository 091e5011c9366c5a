"""GAZ045: see the rule."""

import re
from math import pi

import pytest

from tests.naming import naming
from tests.sensing import findings, scan


def test_the_last_angle_is_the_place_and_the_better_one_is_reported():
    (finding,) = findings("GAZ045", "ray", scan(-3.1415926, 3.1415926, 720))
    assert finding.span.text.startswith("<max_angle>")
    assert finding.span.line == 11
    assert "720 beams" in finding.message
    assert finding.help == "write 3.13287"


@pytest.mark.parametrize("samples", [10, 360, 720, 3600])
def test_one_step_less_than_the_circle_is_calm(samples):
    last = -pi + 2 * pi * (1 - 1 / samples)
    assert findings("GAZ045", "ray", scan(-pi, last, samples)) == []
    assert len(findings("GAZ045", "ray", scan(-pi, pi, samples))) == 1


def test_a_half_circle_is_calm():
    assert findings("GAZ045", "ray", scan(-pi / 2, pi / 2)) == []


@pytest.mark.parametrize(("first", "last", "count"), [(-4, 4, 1), (0, 6.283, 1), (-180, 180, 0)])
def test_more_than_a_circle(first, last, count):
    found = findings("GAZ045", "ray", scan(first, last))
    assert len(found) == count  # of degrees GAZ047 tells


def test_one_beam_points_one_way():
    assert findings("GAZ045", "ray", scan(-4, 4, 1)) == []


def test_the_finding_tells_whether_beams_coincide_or_repeat():
    said = [findings("GAZ045", "ray", scan(-pi, last))[0].message for last in (pi, pi + 0.1)]
    assert said[0] == naming("s", "360", "6.28319 rad")
    assert "repeat" in said[1]


@pytest.mark.parametrize("tag", ["min_angle", "max_angle", "samples"])
def test_without_a_number_nothing_is_known(tag):
    text = re.sub(f"<{tag}>.*</{tag}>", "", scan(-4, 4))
    assert f"<{tag}>" not in text
    assert findings("GAZ045", "ray", text) == []
