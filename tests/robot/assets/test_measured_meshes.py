"""Meshes as solids of links, and the inertia rules that look at them."""

from math import pi
from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from tests.naming import naming
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh.measure_cache import Store
from urdfkit.mesh.samples import BOX, box, collada, stl
from urdfkit.robot import inertia
from urdfkit.robot.assets.measured_meshes import MeasuredMeshes
from urdfkit.robot.shapes import MeshSolid, solid
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

#: A block with edges of 2, 4 and 6 about the origin.
BLOCK = stl(box((-1, -2, -3), (1, 2, 3)))
INERTIAL = (
    '<inertial><origin xyz="{}"/><mass value="{}"/>'
    '<inertia ixx="{}" ixy="0" ixz="0" iyy="{}" iyz="0" izz="{}"/></inertial>'
)


def measured(directory: Path, robot: str, **files: bytes) -> MeasuredMeshes:
    for name, data in files.items():
        (directory / name.replace("_", ".")).write_bytes(data)
    source = Source(str(directory / "robot.urdf"), whole_robot(robot).encode())
    context = Context(source, Resolver(environment={}))
    return MeasuredMeshes(context.model, context.files, Store(None))


def mesh_solid(directory: Path, part: str, data: bytes = BLOCK) -> MeshSolid:
    (use,) = measured(directory, link(part), a_stl=data).uses
    found = use.solid
    assert found is not None
    return found


def test_a_block(tmp_path: Path) -> None:
    found = mesh_solid(tmp_path, mesh("a.stl"))
    assert (found.name, found.is_closed) == ("a.stl", True)
    assert (found.volume, found.hull) == pytest.approx((48, 48))
    mass, center, tensor = found.properties(12)
    assert mass == 12
    assert center == pytest.approx((0, 0, 0), abs=1e-6)
    assert tensor == pytest.approx(inertia.box(12, (2, 4, 6)), abs=1e-5)
    assert found.longest == pytest.approx(6)
    assert found.farthest((0, 0, 0)) == pytest.approx(14**0.5)
    assert found.reach((0, 1, 0)) == pytest.approx(2)


@pytest.mark.parametrize(
    ("more", "origin", "size", "center"),
    [
        (' scale="2 1 0.5"', "", (4, 4, 3), (0, 0, 0)),
        (' scale="-1 1 1"', "", (2, 4, 6), (0, 0, 0)),
        ("", '<origin xyz="1 2 3"/>', (2, 4, 6), (1, 2, 3)),
        ("", f'<origin xyz="0 0 7" rpy="{pi / 2} 0 0"/>', (2, 6, 4), (0, 0, 7)),
    ],
)
def test_scale_and_origin(
    tmp_path: Path,
    more: str,
    origin: str,
    size: tuple[float, float, float],
    center: tuple[float, float, float],
) -> None:
    found = mesh_solid(tmp_path, mesh("a.stl", more=more, origin=origin))
    assert found.volume == pytest.approx(size[0] * size[1] * size[2])
    _, middle, tensor = found.properties(5)
    assert middle == pytest.approx(center, abs=1e-6)
    assert tensor == pytest.approx(inertia.box(5, size), abs=1e-5)


def test_without_measures_a_mesh_is_no_solid(tmp_path: Path) -> None:
    (arm,) = measured(tmp_path, link(mesh("a.stl")), a_stl=BLOCK).model.links
    assert solid(arm.collisions) is None


def test_a_turned_scale_agrees_with_a_mesh_that_was_stretched(tmp_path: Path) -> None:
    """A tetrahedron, whose products of inertia are not zero."""
    corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    plain = stl([[corners[i] for i in face] for face in faces])
    stretched = [(2 * x, 3 * y, z) for x, y, z in corners]
    long = stl([[stretched[i] for i in face] for face in faces])
    by_scale = mesh_solid(tmp_path, mesh("a.stl", more=' scale="2 3 1"'), plain).properties(1)
    by_vertices = mesh_solid(tmp_path, mesh("a.stl"), long).properties(1)
    assert by_scale.center == pytest.approx(by_vertices.center)
    assert by_scale.tensor == pytest.approx(by_vertices.tensor, rel=1e-5)


def test_an_open_mesh_is_taken_for_its_hull(tmp_path: Path) -> None:
    found = mesh_solid(tmp_path, mesh("a.stl"), stl(box((0, 0, 0), (1, 1, 1), BOX[2:])))
    assert not found.is_closed
    assert found.volume == pytest.approx(1)
    assert str(found) == naming("a.stl", "1 m³")


def test_what_is_flat_is_no_solid(tmp_path: Path) -> None:
    flat = stl(box((0, 0, 0), (1, 1, 1), BOX[:2]))
    (use,) = measured(tmp_path, link(mesh("a.stl")), a_stl=flat).uses
    assert use.solid is None


def test_the_unit_of_collada_counts(tmp_path: Path) -> None:
    robot = link(mesh("a.dae", more=' scale="2 2 2"'))
    (use,) = measured(tmp_path, robot, a_dae=collada('<unit meter="0.01"/>')).uses
    assert use.edges == pytest.approx((0.02, 0.02, 0))


class TestInertiaRules:
    def test_a_tensor_that_the_mesh_cannot_have(self, tmp_path: Path) -> None:
        robot = link(mesh("a.stl"), INERTIAL.format("0 0 0", 2, 50, 50, 50))
        assert messages(tmp_path, "INE006", robot, {"a.stl": BLOCK}) == []
        robot = link(mesh("a.stl"), INERTIAL.format("0 0 0", 2, 60, 60, 60))
        (found,) = messages(tmp_path, "INE006", robot, {"a.stl": BLOCK})
        assert found == naming(
            "arm", "60 kg·m²", "2.14", "2 kg", "3.74 m", "a.stl", "48 m³", "8.67, 6.67, 3.33 kg·m²"
        )

    def test_a_hollow_mesh_may_hold_motors(self, tmp_path: Path) -> None:
        """The shell alone would make 37 000 kg/m³, the hull 500."""
        shell = stl([
            *box((0, 0, 0), (1, 1, 1)),
            *box((0.0023, 0.0023, 0.0023), (0.9977, 0.9977, 0.9977), (f[::-1] for f in BOX)),
        ])  # fmt: skip
        robot = link(mesh("a.stl"), INERTIAL.format("0.5 0.5 0.5", 500, 83, 83, 83))
        assert messages(tmp_path, "INE010", robot, {"a.stl": shell}) == []

    def test_too_heavy_even_for_the_hull(self, tmp_path: Path) -> None:
        robot = link(mesh("a.stl"), INERTIAL.format("0 0 0", 48 * 20_000, 1e6, 1e6, 1e6))
        (found,) = messages(tmp_path, "INE010", robot, {"a.stl": BLOCK})
        assert found == naming("arm", "960000 kg", "a.stl", "48 m³", "2e+04 kg/m³", "20", "12000")

    def test_a_light_frame_is_not_judged_by_its_hull(self, tmp_path: Path) -> None:
        opened = stl(box((0, 0, 0), (1, 1, 1), BOX[2:]))
        robot = link(mesh("a.stl"), INERTIAL.format("0.5 0.5 0.5", 1, 0.1, 0.1, 0.1))
        assert messages(tmp_path, "INE010", robot, {"a.stl": opened}) == []
        closed = stl(box((0, 0, 0), (1, 1, 1)))
        (found,) = messages(tmp_path, "INE010", robot, {"a.stl": closed})
        assert "make 1 kg/m³" in found

    def test_a_centre_of_mass_far_outside(self, tmp_path: Path) -> None:
        far = INERTIAL.format("0 0 9.1", 2, 1, 1, 1)
        near = INERTIAL.format("0 0 8.9", 2, 1, 1, 1)
        assert len(messages(tmp_path, "INE011", link(mesh("a.stl"), far), {"a.stl": BLOCK})) == 1
        assert messages(tmp_path, "INE011", link(mesh("a.stl"), near), {"a.stl": BLOCK}) == []
