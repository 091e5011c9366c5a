"""Inertia of links from their shapes: against trimesh, closed forms, and what is written."""

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.conftest import MISSION
from tests.mesh.shapes_made import as_mesh
from urdfkit.core.installation import install_command
from urdfkit.lint.loading import read
from urdfkit.mesh.writers import write
from urdfkit.robot.inertia import MassProperties
from urdfkit.robot.inertials.proposals import InertiaProposal, propose, rewrites
from urdfkit.robot.model import UnknownLink
from urdfkit.text.editing import rewriting

INERTIAL = """<inertial>
      <origin xyz="0 0 1" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>"""


def robot(directory: Path, shapes: str, inertial: str = INERTIAL, more: str = "") -> Path:
    file = directory / "robot.urdf"
    link = f'  <link name="a">\n    {inertial}\n    {shapes}\n  </link>{more}'
    text = f'<robot name="r">\n{link}\n</robot>\n'
    file.write_text(text, encoding="utf-8", newline="")
    return file


def collision(shape: str, origin: str = "") -> str:
    return f"<collision>{origin}<geometry>{shape}</geometry></collision>"


def only(file: Path, **options: object) -> InertiaProposal:
    (one,) = propose(read(file), **options)  # type: ignore[arg-type]
    return one


def tensor(properties: MassProperties | None) -> np.ndarray:
    assert properties is not None
    a, b, c, d, e, f = properties.tensor
    return np.array([[a, b, c], [b, d, e], [c, e, f]])


def test_the_mission_says_what_its_shapes_give() -> None:
    found = {one.link.name: one for one in propose(read(MISSION))}
    wheel = found["wheel_1"]
    assert wheel.computed is not None
    assert np.diag(tensor(wheel.computed)) == pytest.approx([5.5417e-4, 5.5417e-4, 9e-4], rel=1e-4)
    assert wheel.verdict == "differs"
    base = found["base_link"]
    assert np.diag(tensor(base.computed)) == pytest.approx([0.0683, 0.0342, 0.0888], rel=1e-3)
    assert base.verdict == "near"
    laser = found["laser_frame"]
    assert np.diag(tensor(laser.computed)) == pytest.approx([4.1667e-6] * 3, rel=1e-4)
    assert "dummy" not in found, "it has neither shape nor inertia"


@pytest.mark.parametrize("source", ["auto", "collision"])
def test_a_mesh_that_is_stretched_turned_and_moved(source: str, tmp_path: Path) -> None:
    shape = trimesh.creation.cone(0.3, 0.5).apply_translation((0.1, 0.2, 0.3))
    write(as_mesh(shape), tmp_path / "cone.stl")
    origin = '<origin xyz="1 -2 3" rpy="0.3 -0.4 0.5"/>'
    mesh = '<mesh filename="cone.stl" scale="2 -0.5 1.5"/>'
    one = only(robot(tmp_path, collision(mesh, origin)), source=source)
    oracle = shape.copy()
    oracle.apply_transform(np.diag([2, -0.5, 1.5, 1]))
    placed = trimesh.transformations.euler_matrix(0.3, -0.4, 0.5, "sxyz")
    placed[:3, 3] = (1, -2, 3)
    oracle.apply_transform(placed)
    oracle.density = 2.0 / oracle.volume
    assert one.computed is not None
    assert one.computed.mass == 2.0
    assert one.computed.center == pytest.approx(oracle.center_mass, rel=1e-5)
    assert tensor(one.computed) == pytest.approx(oracle.moment_inertia, rel=1e-4, abs=1e-6)


def test_collada_units_count(tmp_path: Path) -> None:
    write(as_mesh(trimesh.creation.box((1, 1, 1))), tmp_path / "box.dae")
    data = (tmp_path / "box.dae").read_bytes().replace(b'meter="1"', b'meter="0.001"')
    (tmp_path / "box.dae").write_bytes(data)
    one = only(robot(tmp_path, collision('<mesh filename="box.dae"/>')))
    assert one.shape_mass is not None
    assert one.shape_mass.properties.mass == pytest.approx(1e-9)


def test_an_open_mesh_counts_with_its_hull_and_that_is_said(tmp_path: Path) -> None:
    box = trimesh.creation.box((1, 2, 3))
    box.update_faces(np.arange(12) > 0)
    write(as_mesh(box), tmp_path / "open.stl")
    one = only(robot(tmp_path, collision('<mesh filename="open.stl"/>')))
    assert one.shape_mass is not None
    assert one.shape_mass.properties.mass == pytest.approx(6)
    assert one.shape_mass.source == "the hull of the collision"
    assert one.shape_mass.notes == ("a mesh does not enclose a solid; its convex hull is used",)


def test_the_hull_of_a_solid_is_taken_where_asked_for(tmp_path: Path) -> None:
    ring = trimesh.creation.annulus(0.5, 1.0, 1.0)
    write(as_mesh(ring), tmp_path / "ring.stl")
    file = robot(tmp_path, collision('<mesh filename="ring.stl"/>'))
    hull, solid = only(file, source="hull").shape_mass, only(file).shape_mass
    assert hull is not None
    assert solid is not None
    assert hull.properties.mass == pytest.approx(ring.convex_hull.volume, rel=1e-6)
    assert solid.properties.mass == pytest.approx(ring.volume, rel=1e-6)


def test_where_the_mass_comes_from(tmp_path: Path) -> None:
    file = robot(tmp_path, collision('<box size="1 1 1"/>'))
    masses = [
        only(file, **options).computed for options in ({}, {"mass": 5.0}, {"density": 1240.0})
    ]
    assert [one.mass for one in masses if one] == [2.0, 5.0, 1240.0]
    bare = robot(tmp_path, collision('<box size="1 1 1"/>'), "")
    assert only(bare).reason.startswith("no mass")
    assert only(bare, density=1.0).verdict == "missing"


def test_links_on_fixed_joints_as_one_body(tmp_path: Path) -> None:
    shape = collision('<box size="1 1 1"/>')
    more = f"""<link name="b">{shape}{INERTIAL}</link><joint name="j" type="fixed">
        <parent link="a"/><child link="b"/><origin xyz="0 0 1"/></joint>"""
    one = only(robot(tmp_path, shape, more=more), lump=True)
    assert one.links == ("a", "b")
    assert one.computed is not None
    # A box of 1 x 1 x 2 m and 4 kg, half a metre above the first link.
    assert one.computed.center == pytest.approx((0, 0, 0.5))
    assert np.diag(tensor(one.computed)) == pytest.approx([5 / 3, 5 / 3, 2 / 3])
    _, left = rewrites([one])
    assert "several links" in left["a"]


def test_writing_makes_declared_what_was_computed_and_changes_nothing_else(tmp_path: Path) -> None:
    shape = collision('<box size="1 2 3"/>', '<origin xyz="0.5 0 0"/>')
    file = robot(tmp_path, f"<!-- kept -->\r\n    {shape}")
    before = file.read_bytes()
    files, left = rewrites(propose(read(file)))
    assert left == {}
    assert file.read_bytes() == before
    rewriting.write(files)
    assert only(file).verdict == "agrees"
    after = file.read_bytes()
    assert b"<!-- kept -->\r\n" in after
    assert after.count(b"\n") == before.count(b"\n")
    assert b'<origin xyz="0.5 0 0" rpy="0 0 0"/>' in after
    assert rewrites(propose(read(file)))[0] == ()


def test_a_quaternion_is_replaced_with_the_tensor(tmp_path: Path) -> None:
    turned = INERTIAL.replace('rpy="0 0 0"', 'quat_xyzw="0 1 0 1"')
    file = robot(tmp_path, collision('<box size="1 2 3"/>'), turned)
    file.write_text(file.read_text().replace('name="r"', 'name="r" version="1.1"'))
    rewriting.write(rewrites(propose(read(file)))[0])
    assert only(file).verdict == "agrees"
    assert '<origin xyz="0 0 0" quat_xyzw="0 0 0 1"/>' in file.read_text()


def test_a_missing_inertial_is_put_in(tmp_path: Path) -> None:
    file = robot(tmp_path, collision('<sphere radius="0.1"/>'), "")
    rewriting.write(rewrites(propose(read(file), density=1000.0))[0])
    link = read(file).model.links_by_name["a"]
    assert link.mass == pytest.approx(4.18879, rel=1e-5)
    assert only(file).verdict == "agrees"


@pytest.mark.parametrize(
    ("inertial", "reason"),
    [
        (INERTIAL.replace('"2"', '"${1 + 1}"').replace('ixx="1"', 'ixx="${3}"'), "expressions"),
        ("<xacro:i/>", "a macro creates it"),
    ],
)
def test_what_is_not_written_as_numbers_is_left_alone(
    inertial: str, reason: str, tmp_path: Path
) -> None:
    file = tmp_path / "robot.urdf.xacro"
    file.write_text(
        f"""<robot name="r" xmlns:xacro="http://wiki.ros.org/xacro">
        <xacro:macro name="i">{INERTIAL}</xacro:macro>
        <link name="a">{inertial}{collision('<box size="1 2 3"/>')}</link></robot>""",
        encoding="utf-8",
    )
    files, left = rewrites(propose(read(file)))
    assert files == ()
    assert reason in left["a"]


def test_only_some_links_of_the_mission_can_be_written(gazebo_pkg: Path) -> None:
    file = gazebo_pkg / "urdf" / MISSION.name
    doubtful = [one for one in propose(read(file)) if one.is_doubtful]
    files, left = rewrites(doubtful)
    assert set(left) == {"base_footprint", "wheel_1", "wheel_2", "wheel_3", "wheel_4"}
    rewriting.write(files)
    verdicts = {one.link.name: one.verdict for one in propose(read(file))}
    assert {verdicts[name] for name in ("imu_link", "camera_link", "laser_frame")} == {"agrees"}


def test_one_link_and_none_of_that_name(tmp_path: Path) -> None:
    context = read(MISSION)
    assert [one.link.name for one in propose(context, links=["wheel_2"])] == ["wheel_2"]
    with pytest.raises(UnknownLink, match="no link 'wheel_5'"):
        propose(context, links=["wheel_5"])


def test_impossible_tensors_are_distinguished(tmp_path: Path) -> None:
    shape = collision('<box size="1 1 1"/>')
    for wrong in ('izz="3"', 'izz="-1"'):
        one = only(robot(tmp_path, shape, INERTIAL.replace('izz="1"', wrong)))
        assert one.verdict == "impossible"


@pytest.mark.parametrize(
    ("numbers", "verdict"),
    [
        ((0.13, 0.1, 0.05), "agrees"),
        ((0.13, 0.05, 0.1), "rotated"),
        ((0.1301, 0.1, 0.05), "agrees"),
    ],
)
def test_the_right_moments_at_the_wrong_axes(
    numbers: tuple[float, ...], verdict: str, tmp_path: Path
) -> None:
    """12 kg in a box of 0.1 x 0.2 x 0.3 m: x*x + y*y and so on, in kg·m²."""
    xx, yy, zz = numbers
    inertial = (
        f'<inertial><mass value="12"/><inertia ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" '
        f'izz="{zz}"/></inertial>'
    )
    one = only(robot(tmp_path, collision('<box size="0.1 0.2 0.3"/>'), inertial))
    assert one.verdict == verdict
    assert one.is_doubtful is (verdict == "rotated")


def test_without_the_libraries_meshes_are_not_known_and_that_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(as_mesh(trimesh.creation.box()), tmp_path / "m.stl")
    monkeypatch.setattr("urdfkit.core.libraries.missing_for_meshes", lambda: "numpy")
    one = only(robot(tmp_path, collision('<mesh filename="m.stl"/>')))
    assert one.reason.endswith(f"without numpy: {install_command('meshes')}")
