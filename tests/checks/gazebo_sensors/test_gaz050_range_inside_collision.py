"""GAZ050: see the rule."""

import pytest

from tests.sensing import findings, scan


@pytest.mark.parametrize(("least", "count"), [(0.5, 1), (0.99, 1), (1.0, 0), (1.5, 0)])
def test_the_least_range_must_reach_out_of_the_sphere(least, count):
    assert len(findings("GAZ050", "ray", scan(-1, 1, least=least))) == count


def test_a_lidar_that_renders_sees_no_collisions():
    assert findings("GAZ050", "gpu_ray", scan(-1, 1, least=0.1)) == []


def test_a_sensor_that_is_moved_out_is_not_judged():
    assert findings("GAZ050", "ray", scan(-1, 1) + "<pose>0 0 2 0 0 0</pose>") == []
