"""GAZ072: the minimum range of a lidar is inside the collision geometry of its link."""

import pytest

from tests.sensing import findings, scan


def inside(kind: str, inner: str) -> int:
    """The findings about the link of the lidar; another link blocks its view, too."""
    found = findings("GAZ072", kind, inner)
    return sum("link 'base'" in one.message for one in found)


@pytest.mark.parametrize(("least", "count"), [(0.5, 1), (0.99, 1), (1.0, 0), (1.5, 0)])
def test_the_least_range_must_reach_out_of_the_sphere(least: float, count: int) -> None:
    assert inside("ray", scan(-1, 1, least=least)) == count


def test_a_lidar_that_renders_sees_no_collisions() -> None:
    assert inside("gpu_ray", scan(-1, 1, least=0.1)) == 0


def test_a_sensor_that_is_moved_out_is_not_judged() -> None:
    assert inside("ray", scan(-1, 1) + "<pose>0 0 2 0 0 0</pose>") == 0
