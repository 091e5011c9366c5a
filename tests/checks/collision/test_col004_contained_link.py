"""COL004: see the rule."""

from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.naming import naming
from tests.physics.collision.robots import box, cube, cylinder, joint, link, mesh, revolute, sphere
from tests.reported import messages

CHASSIS = link("chassis", box(0.6, 0.4, 0.3))


def wheel(shape: str, origin: str, kind: str = "continuous") -> str:
    return CHASSIS + link("wheel", shape) + joint("chassis", "wheel", kind, origin)


@pytest.mark.parametrize("shape", [sphere(0.05), cylinder(0.05, 0.1), box(0.1, 0.1, 0.1)])
def test_within_and_reaching_out(shape: str) -> None:
    assert messages("COL004", wheel(shape, "0.2 0.1 0.05")) == [
        naming("wheel", "inside", "collision", "chassis")
    ]
    assert messages("COL004", wheel(shape, "0.2 0.1 0.11")) == []


def test_a_sensor_that_is_fixed_inside_is_no_matter() -> None:
    assert messages("COL004", wheel(sphere(0.05), "0 0 0", "fixed")) == []


def test_a_part_that_reaches_out_saves_the_link() -> None:
    parts = link("wheel", sphere(0.05), f"{sphere(0.05)}@0 0 0.5")
    assert messages("COL004", CHASSIS + parts + joint("chassis", "wheel", "continuous")) == []


@pytest.mark.parametrize(("away", "reported"), [("0.3 0 0", 0), ("0.05 0 0", 1)])
def test_a_rotor_in_its_motor_turns_what_is_fixed_to_it(away: str, reported: int) -> None:
    rotor = wheel(sphere(0.05), "0 0 0") + link("horn", sphere(0.02))
    assert len(messages("COL004", rotor + joint("wheel", "horn", "fixed", away))) == reported


def test_meshes(tmp_path: Path) -> None:
    here = str(tmp_path / "robot.urdf")
    small = mesh(cube(tmp_path / "small.stl", 0.05))
    assert len(messages("COL004", wheel(small, "0 0 0"), here)) == 1
    assert messages("COL004", wheel(small, "0 0 0.13"), here) == []
    hollow = link("chassis", mesh(cube(tmp_path / "hollow.stl", 0.3, 5)))
    joints = joint("chassis", "wheel", "continuous")
    assert messages("COL004", hollow + link("wheel", small) + joints, here) == []


def test_links_that_are_no_neighbours_count_too() -> None:
    arm = link("arm", f"{sphere(0.05)}@0 0 1") + link("tip", sphere(0.05))
    joints = joint("chassis", "arm", "revolute", more=revolute(-1, 1)) + joint(
        "arm", "tip", "revolute", more=revolute(-1, 1)
    )
    (message,) = messages("COL004", CHASSIS + arm + joints)
    assert message == naming("tip", "inside", "collision", "chassis")
    assert messages("COL001", CHASSIS + arm + joints) == []


@pytest.mark.parametrize(("reach", "reported"), [(0.1, 1), (0.9, 0)])
def test_a_part_that_comes_out_is_not_swallowed(reach: float, reported: int) -> None:
    slide = joint("chassis", "wheel", "prismatic", more=revolute(0, reach))
    assert len(messages("COL004", CHASSIS + link("wheel", sphere(0.05)) + slide)) == reported


def test_what_holds_several_is_reported_once() -> None:
    balls = [f"ball_{n}" for n in range(7)]
    parts = [link(name, sphere(0.02)) for name in balls]
    joints = [
        joint("chassis", name, "continuous", f"{n * 0.05 - 0.15} 0 0")
        for n, name in enumerate(balls)
    ]
    assert messages("COL004", "".join((CHASSIS, *parts, *joints))) == [
        naming("collision", "chassis", "7", "ball_0", "ball_1", "ball_2", "ball_3", "ball_4", "2")
    ]
