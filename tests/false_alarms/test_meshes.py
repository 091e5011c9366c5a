"""Meshes that are right."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, mesh_link
from urdfkit.core.spatial import Vector
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh.samples import BOX, box, stl

OUTER = box((0, 0, 0), (1, 1, 1))


@pytest.mark.parametrize(
    ("around", "count"),
    [(OUTER, 0), (OUTER[1:], 0), (box((2, 0, 0), (3, 1, 1)), 1)],
    ids=["closed", "with a gap", "elsewhere"],
)
def test_a_cavity_faces_inwards(tmp_path: Path, around: list[list[Vector]], count: int) -> None:
    """Doosan's arms: a housing with open edges, and the hollow in it."""
    hollow = box((0.3, 0.3, 0.3), (0.7, 0.7, 0.7), (face[::-1] for face in BOX))
    add_file(tmp_path / "arm.stl", stl([*around, *hollow]))
    robot = add_file(tmp_path / "arm.urdf", whole_robot(mesh_link("arm.stl")).encode())
    assert len(engine.check(robot, select=["MSH015"]).diagnostics) == count


def test_millimetres_are_reported_once(tmp_path: Path) -> None:
    """Advika's base: its chassis is in millimetres, and so larger than the box that collides."""
    add_file(tmp_path / "base.stl", stl(box((0, 0, 0), (200, 150, 100))))
    collision = '<collision><geometry><box size="0.2 0.15 0.1"/></geometry></collision>'
    link = mesh_link("base.stl", link="base").replace("</link>", f"{collision}</link>")
    arm = '<link name="arm"/><joint name="j" type="fixed"><origin xyz="0 0 0.2"/>'
    arm += '<parent link="base"/><child link="arm"/></joint>'
    robot = add_file(tmp_path / "base.urdf", whole_robot(link + arm).encode())
    found = engine.check(robot, select=["GEO004", "MSH012"]).diagnostics
    assert [one.code for one in found] == ["MSH012"]


def test_a_scale_of_one_number(tmp_path: Path) -> None:
    """Drake's quadrotor: URD005 reports the scale, and it is the scale that is compared."""
    add_file(tmp_path / "body.stl", stl(box((-100, -75, -50), (100, 75, 50))))
    collision = '<collision><geometry><box size="0.2 0.15 0.1"/></geometry></collision>'
    link = mesh_link("body.stl").replace("</link>", f"{collision}</link>")
    link = link.replace('.stl"', '.stl" scale="0.001"')
    robot = add_file(tmp_path / "body.urdf", whole_robot(link).encode())
    found = engine.check(robot, select=["GEO004", "MSH012", "URD005"], targets=["ros2"]).diagnostics
    assert [one.code for one in found] == ["URD005"]
