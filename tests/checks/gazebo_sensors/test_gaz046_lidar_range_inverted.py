"""GAZ046: see the rule."""

import pytest

from tests.sensing import findings, scan


@pytest.mark.parametrize(
    ("least", "most", "count"), [(10, 0.1, 1), (1, 1, 1), (0.1, 10, 0), (0, 0.5, 0)]
)
def test_the_least_must_be_below_the_greatest(least, most, count):
    found = findings("GAZ046", "ray", scan(-1, 1, least=least, most=most))
    assert len(found) == count
    assert all(finding.span.text == "<min>" for finding in found)


@pytest.mark.parametrize(
    ("first", "last", "samples", "count"),
    [(2, -2, 360, 1), (2, 2, 360, 1), (0, 0, 1, 0), (-2, 2, 360, 0)],
)
def test_the_first_beam_must_be_before_the_last(first, last, samples, count):
    found = findings("GAZ046", "ray", scan(first, last, samples))
    assert len(found) == count
    assert all(finding.span.text == "<min_angle>" for finding in found)


def test_without_a_range_nothing_is_seen():
    (finding,) = findings("GAZ046", "ray", "<ray><scan/></ray>")
    assert finding.message == "sensor 's' has no <range>: the least and the greatest are both 0 m"


@pytest.mark.parametrize(
    ("kind", "targets", "count"),
    [
        ("ray", ("classic-ros1",), 0),
        ("gpu_ray", ("classic-ros1",), 1),
        ("ray", ("classic-ros2", "gz-harmonic"), 1),
    ],
)
def test_rays_of_classic_may_sweep_backwards(kind, targets, count):
    assert len(findings("GAZ046", kind, scan(2, -2), targets=targets)) == count


def test_no_beam_is_shorter_than_nothing():
    (finding,) = findings("GAZ046", "ray", scan(-1, 1, least=-0.1))
    assert finding.message == "sensor 's': the least range is -0.1 m, and no beam is so short"
