from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import box, stl


def at(x: float) -> bytes:
    """A cube with edges of 0.2 m, a distance away."""
    return stl(box((x, -0.1, -0.1), (x + 0.2, 0.1, 0.1)))


def test_a_part_in_the_coordinates_of_an_assembly(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH032", link(mesh("a.stl")), {"a.stl": at(2)}) == [
        (
            "link 'arm': the collision mesh 'a.stl' is 0.2 m long and begins 2 m away from the "
            "origin of the link"
        )
    ]


@pytest.mark.parametrize(
    ("x", "is_reported"), [(0.59, False), (0.61, True), (-0.79, False), (-0.81, True)]
)
def test_three_times_its_length(tmp_path: Path, x: float, is_reported: bool) -> None:
    found = messages(tmp_path, "MSH032", link(mesh("a.stl")), {"a.stl": at(x)})
    assert bool(found) is is_reported


def test_the_origin_counts(tmp_path: Path) -> None:
    back = '<origin xyz="0 0 -2" rpy="0 -1.5707963267948966 0"/>'
    robot = link(mesh("a.stl", origin=back))
    assert messages(tmp_path, "MSH032", robot, {"a.stl": at(2)}) == []


def test_a_collision_that_is_away_from_the_same_visual_is_told_by_geo004(tmp_path: Path) -> None:
    away = '<origin xyz="0 3 0"/>'
    robot = link(mesh("a.stl", "visual"), mesh("a.stl", origin=away))
    assert messages(tmp_path, "MSH032", robot, {"a.stl": at(0)}) == []
    assert (
        len(messages(tmp_path, "MSH032", link(mesh("a.stl", origin=away)), {"a.stl": at(0)})) == 1
    )


@pytest.mark.parametrize(("end", "is_reported"), [(1.95, False), (1.5, True)])
def test_the_end_of_a_long_part_is_where_it_should_be(
    tmp_path: Path, end: float, is_reported: bool
) -> None:
    arm = stl(box((0, -0.1, -0.1), (end, 0.1, 0.1)))
    robot = link(mesh("arm.stl", "visual"), mesh("a.stl", "visual"))
    found = messages(tmp_path, "MSH032", robot, {"arm.stl": arm, "a.stl": at(2)})
    assert bool(found) is is_reported
