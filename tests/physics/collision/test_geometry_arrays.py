"""What reaches coal, and what does not."""

from pathlib import Path

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

from tests.physics.collision.robots import box, cube, cylinder, link, mesh, robot, sphere, stl
from urdfkit.lint.context import Context
from urdfkit.physics.collision.bodies import MAX_COORDINATE, THINNEST
from urdfkit.physics.collision.collision_geometry import build_geometry
from urdfkit.physics.collision.geometry_arrays import (
    CollisionArrays,
    OmittedCollision,
    collision_arrays,
)


def made(context: Context) -> tuple[tuple[CollisionArrays, ...], tuple[OmittedCollision, ...]]:
    return collision_arrays(context.model, context.meshes)


@pytest.mark.parametrize(
    ("shape", "kind", "size"),
    [
        (box(1, 2, 3), "box", (1, 2, 3)),
        (sphere(0.5), "sphere", (0.5,)),
        (cylinder(0.1, 0.2), "cylinder", (0.1, 0.2)),
        ('<capsule radius="0.1" length="0.2"/>', "capsule", (0.1, 0.2)),
        (box(1, 1, 0), "box", (1, 1, THINNEST)),
        (sphere(0), "sphere", (THINNEST,)),
    ],
)
def test_primitives_stay_exact(shape: str, kind: str, size: tuple[float, ...]) -> None:
    (one,), omitted = made(robot(link("a", shape)))
    assert (one.kind, one.size) == (kind, size)
    assert omitted == ()
    build_geometry(one)


@pytest.mark.parametrize(
    ("shape", "reason"),
    [
        (box(1, 1, -1), "a size is negative"),
        ('<box size="1 1"/>', "a size is missing or cannot be read"),
        ('<cylinder radius="1"/>', "a size is missing or cannot be read"),
        ('<sphere radius="nan"/>', "a size is missing or cannot be read"),
        (box(1e12, 1, 1), f"it is larger than {MAX_COORDINATE:g} m"),
        ("<cone/>", "<cone> is not a URDF shape"),
        ("", "it has no geometry"),
        (f"{box(1, 1, 1)}@1e12 0 0", f"it is more than {MAX_COORDINATE:g} m from its link"),
        ('<mesh filename="file:///no/such.stl"/>', "the file is missing"),
    ],
)
def test_what_cannot_be_used_is_left_out_with_the_reason(shape: str, reason: str) -> None:
    found, omitted = made(robot(link("a", shape, box(1, 1, 1))))
    assert [one.number for one in found] == [1]
    assert omitted == (OmittedCollision("a", 0, reason),)


FLAT = [
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
]


def test_a_flat_mesh_has_no_hull_and_does_no_harm(tmp_path: Path) -> None:
    """coal's hull of it ends the process."""
    (one,), _ = made(robot(link("a", mesh(stl(tmp_path / "flat.stl", FLAT)))))
    flat = build_geometry(one)
    assert flat.half.tolist() == [0.5, 0.5, 0]
    assert flat.exact.num_tris == 2


def test_triangles_without_area_or_finite_corners_are_dropped(tmp_path: Path) -> None:
    """coal would end the process, or loop."""
    text = cube(tmp_path / "cube.stl", 0.5).read_text()
    bad = (
        "facet normal 0 0 0\nouter loop\nvertex 1 1 1\nvertex 1 1 1\nvertex 2 2 2\n"
        "endloop\nendfacet\n"
    )
    (tmp_path / "cube.stl").write_text(text.replace("endsolid", bad + "endsolid"))
    (one,), _ = made(robot(link("a", mesh(tmp_path / "cube.stl"))))
    assert len(one.faces) == 12
    assert np.abs(one.vertices).max() == 0.5


def test_a_mesh_without_any_area_is_left_out(tmp_path: Path) -> None:
    line = [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]]
    _, omitted = made(robot(link("a", mesh(stl(tmp_path / "line.stl", line)))))
    assert omitted == (OmittedCollision("a", 0, "none of its triangles has an area"),)
    _, omitted = made(robot(link("a", mesh(cube(tmp_path / "c.stl", 0.5), "0 0 0"))))
    assert omitted == (OmittedCollision("a", 0, "none of its triangles has an area"),)


def test_a_huge_mesh_is_left_out(tmp_path: Path) -> None:
    _, omitted = made(robot(link("a", mesh(cube(tmp_path / "c.stl", 0.5), "1e12 1 1"))))
    assert omitted == (OmittedCollision("a", 0, f"it is larger than {MAX_COORDINATE:g} m"),)


def test_a_cube_of_triangles_is_convex_and_an_open_one_is_not(tmp_path: Path) -> None:
    (closed, opened), _ = made(
        robot(
            link("a", mesh(cube(tmp_path / "a.stl", 0.5)), mesh(cube(tmp_path / "b.stl", 0.5, 5)))
        )
    )
    assert build_geometry(closed).is_convex
    assert build_geometry(closed).hull.computeVolume() == pytest.approx(1)
    assert not build_geometry(opened).is_convex
    assert build_geometry(opened).hull.num_points == 8


DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit meter="0.01"/><up_axis>Z_UP</up_axis></asset>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
   <technique_common><accessor source="#pa" count="4" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
   </accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
   <p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
"""


def test_the_unit_of_a_collada_file_is_applied_or_not(tmp_path: Path) -> None:
    (tmp_path / "m.dae").write_text(DAE)
    context = robot(link("a", mesh(tmp_path / "m.dae")))
    (applied,), _ = collision_arrays(context.model, context.meshes, unit=True)
    (ignored,), _ = collision_arrays(context.model, context.meshes, unit=False)
    assert applied.vertices.max() == pytest.approx(0.01)
    assert ignored.vertices.max() == pytest.approx(1)


def test_a_mesh_of_next_to_nothing_is_left_out(tmp_path: Path) -> None:
    """coal's hull of it would end the process."""
    tiny = mesh(cube(tmp_path / "c.stl", 0.5), "1e-80 1e-80 1e-80")
    _, omitted = made(robot(link("a", tiny)))
    assert omitted == (OmittedCollision("a", 0, f"it is smaller than {THINNEST:g} m"),)
    (small,), _ = made(robot(link("a", mesh(tmp_path / "c.stl", "2e-6 2e-6 2e-6"))))
    build_geometry(small)


def test_a_triangle_of_three_points_in_a_row_has_no_area(tmp_path: Path) -> None:
    row = [[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [3.0, 1.0, 0.0]]
    good = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 1.0]]
    (one,), _ = made(robot(link("a", mesh(stl(tmp_path / "a.stl", [row, good])))))
    assert len(one.faces) == 1
    assert sorted(map(tuple, one.vertices.tolist())) == sorted(map(tuple, good))
