"""Meshes for missing files: what they are, where they lie, and what is left alone."""

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

import urdfkit
from tests.conftest import CORPUS, MODELS, needs_corpus
from tests.mesh.made import binary_stl
from tests.mesh.shapes_made import as_mesh, as_trimesh
from urdfkit.lint.loading import read
from urdfkit.mesh.parts import PARTS
from urdfkit.mesh.writers import SoundMesh, write
from urdfkit.robot.assets.placeholder_meshes import (
    GeneratedMesh,
    NoSuchMesh,
    NotGenerated,
    generate,
    generate_missing,
    generate_part,
)
from urdfkit.robot.assets.target_bounds import target_bounds

PARTS_BY_KEY = {part.key: part for part in PARTS}
BOX = '<box size="0.2 0.1 0.06"/>'
WHEEL = '<cylinder radius="0.1" length="0.04"/>'


def robot(
    directory: Path,
    visual: str,
    collision: str = "",
    *,
    link: str = "thing",
    origin: str = "",
    scale: str = "",
    collision_origin: str = "",
    more: str = "",
) -> Path:
    file = directory / "robot.urdf"
    scale = f' scale="{scale}"' if scale else ""
    collided = f"<collision>{collision_origin}<geometry>{collision}</geometry></collision>"
    file.write_text(
        f"""<robot name="r">
        <link name="{link}">
          <visual>{origin}<geometry><mesh filename="{visual}"{scale}/></geometry></visual>
          {collided if collision else ""}{more if more.startswith("<inertial") else ""}
        </link>{"" if more.startswith("<inertial") else more}
        </robot>""",
        encoding="utf-8",
    )
    return file


def made(file: Path) -> GeneratedMesh:
    (one,) = generate_missing(read(file)).generated
    return one


def bounds(one: GeneratedMesh) -> tuple[np.ndarray, np.ndarray]:
    return one.mesh.vertices.min(axis=0), one.mesh.vertices.max(axis=0)


def test_the_missing_lidar_of_the_mission_is_made_and_then_nothing_is_missing(
    gazebo_pkg: Path,
) -> None:
    file = gazebo_pkg / "urdf" / "waking_robot_new.xacro"
    one = made(file)
    assert one.path == str(gazebo_pkg / "meshes" / "hokuyo.dae")
    assert one.defect == "does not exist"
    assert one.reason == (
        "Hokuyo URG-04LX, 0.05 x 0.05 x 0.05 m: 'hokuyo' in the name of the file means a 2D lidar;"
        " fitted to the collision of link 'laser_frame'"
    )
    low, high = bounds(one)
    assert [*low, *high] == pytest.approx([-0.025] * 3 + [0.025] * 3, abs=1e-6)
    assert one.write() == [one.path]
    codes = {found.code for found in urdfkit.check(file, select=["MSH"]).diagnostics}
    assert not codes & {"MSH001", "MSH009"}
    assert generate_missing(read(file)) == ((), ())


def test_what_is_wrong_with_each_broken_file_is_distinguished() -> None:
    found = generate_missing(read(MODELS / "bad" / "broken_meshes.urdf"))
    defects = {Path(one.path).name: one.defect for one in found.generated}
    assert defects["empty.dae"] == "is empty"
    assert "before any triangle" in defects["bot.dae"]
    assert defects["web_page.dae"].startswith("is a web page")
    (pointer,) = found.not_generated
    assert Path(pointer.path).name == "lfs_pointer.stl"
    assert "git lfs pull" in pointer.reason


def test_nothing_is_written_before_it_is_asked_for(tmp_path: Path) -> None:
    file = robot(tmp_path, "a/b.stl", BOX)
    one = made(file)
    assert [path.name for path in tmp_path.iterdir()] == ["robot.urdf"]
    one.write()
    assert trimesh.load_mesh(tmp_path / "a" / "b.stl").volume == pytest.approx(0.0012)


def test_the_shape_of_the_collision_lies_where_the_collision_is(tmp_path: Path) -> None:
    file = robot(
        tmp_path,
        "b.stl",
        BOX,
        origin='<origin xyz="1 2 3" rpy="0 0 1.5707963267948966"/>',
        collision_origin='<origin xyz="1 2 4" rpy="0 0 1.5707963267948966"/>',
        scale="0.001 0.001 0.001",
    )
    low, high = bounds(made(file))
    assert low == pytest.approx([-100, -50, 970])
    assert high == pytest.approx([100, 50, 1030])


def test_a_mirrored_mesh_is_made_the_other_way_round(tmp_path: Path) -> None:
    one = made(robot(tmp_path, "b.stl", BOX, scale="1 -1 1"))
    assert as_trimesh(one.mesh).volume == pytest.approx(0.0012)


@pytest.mark.parametrize("axis", ["1 0 0", "0 1 0", "0 0 1", "0 0.6 -0.8"])
def test_a_wheel_turns_about_its_joint(axis: str, tmp_path: Path) -> None:
    joint = f"""<link name="base"/><joint name="j" type="continuous">
        <parent link="base"/><child link="thing"/><axis xyz="{axis}"/></joint>"""
    vertices = made(robot(tmp_path, "wheel.stl", more=joint)).mesh.vertices
    along = vertices @ [float(word) for word in axis.split()]
    assert [along.min(), along.max()] == pytest.approx([-0.03, 0.03], abs=1e-6)
    across = np.sqrt((vertices**2).sum(axis=1) - along**2)
    assert across.max() == pytest.approx(0.065, rel=1e-3)


def test_a_wheel_has_the_outline_of_its_cylinder(tmp_path: Path) -> None:
    turned = '<origin rpy="1.5707963267948966 0 0"/>'
    one = made(robot(tmp_path, "wheel.dae", WHEEL, collision_origin=turned))
    low, high = bounds(one)
    assert [*low, *high] == pytest.approx([-0.1, -0.02, -0.1, 0.1, 0.02, 0.1], abs=1e-4)
    assert "wheel with a tyre, 0.2 x 0.2 x 0.04 m" in one.reason


def test_a_sensor_that_would_be_distorted_keeps_its_proportions_and_stands_on_the_floor(
    tmp_path: Path,
) -> None:
    one = made(robot(tmp_path, "velodyne.dae", '<box size="0.1 0.1 0.6"/>'))
    low, high = bounds(one)
    assert "in its true proportions within the collision" in one.reason
    assert (high - low)[0] == pytest.approx(0.1, abs=1e-4)
    assert (high - low)[2] == pytest.approx(0.1 * 71.7 / 103.3, abs=1e-4)
    assert low[2] == pytest.approx(-0.3, abs=1e-6)


def test_a_sensor_looks_along_its_link_however_the_visual_is_turned(tmp_path: Path) -> None:
    turned = '<origin rpy="1.5707963267948966 0 1.5707963267948966"/>'
    one = made(robot(tmp_path, "d435.dae", '<box size="0.025 0.09 0.025"/>', origin=turned))
    low, high = bounds(one)
    assert high - low == pytest.approx([0.09, 0.025, 0.025], abs=1e-4)
    assert "fitted to the collision" in one.reason


@pytest.mark.parametrize("edge", ["1e-300", "1e300"])
def test_a_shape_out_of_all_bounds_tells_no_size(edge: str, tmp_path: Path) -> None:
    one = made(robot(tmp_path, "velodyne.dae", f'<box size="{edge} 0.1 0.1"/>'))
    assert "its true size" in one.reason


def test_a_placeholder_tells_no_size(tmp_path: Path) -> None:
    inertial = """<inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>"""
    (one,) = generate_missing(read(robot(tmp_path, "b.stl", more=inertial))).not_generated
    assert "neither a type nor a size" in one.reason


def test_what_is_left_of_a_broken_file_is_kept_if_it_is_most_of_it(tmp_path: Path) -> None:
    write(as_mesh(trimesh.creation.icosphere(2, 0.1)), tmp_path / "b.dae")
    data = (tmp_path / "b.dae").read_bytes()
    end = data.index(b"<p>") + len(data[data.index(b"<p>") : data.index(b"</p>")]) * 9 // 10
    (tmp_path / "b.dae").write_bytes(data[:end])
    one = made(robot(tmp_path, "b.dae", BOX))
    assert one.reason.startswith("salvaged: ")
    assert 200 <= len(one.mesh.faces) < 320
    (tmp_path / "b.dae").write_bytes(data[: data.index(b"<p>") + 60])
    assert made(robot(tmp_path, "b.dae", BOX)).reason.startswith("the shape of the collision")


def test_an_optical_frame_looks_along_z(tmp_path: Path) -> None:
    low, high = bounds(made(robot(tmp_path, "cam.dae", link="cam_optical_frame")))
    assert high - low == pytest.approx([0.029, 0.029, 0.055], abs=1e-4)


def test_the_other_mesh_of_the_link_is_better_than_any_part(tmp_path: Path) -> None:
    (tmp_path / "c.stl").write_bytes(binary_stl())
    one = made(robot(tmp_path, "wheel.stl", '<mesh filename="c.stl" scale="2 2 2"/>'))
    assert one.reason == "the shape of the collision of link 'thing'"
    assert as_trimesh(one.mesh).volume == pytest.approx(8 / 6)


def test_mass_and_inertia_give_a_block(tmp_path: Path) -> None:
    # A box of 0.3 x 0.2 x 0.1 m and 6 kg.
    inertial = """<inertial><origin xyz="0 0 1"/><mass value="6"/>
        <inertia ixx="0.025" iyy="0.05" izz="0.065" ixy="0" ixz="0" iyz="0"/></inertial>"""
    low, high = bounds(made(robot(tmp_path, "b.stl", more=inertial)))
    assert [*low, *high] == pytest.approx([-0.15, -0.1, 0.95, 0.15, 0.1, 1.05])


@pytest.mark.parametrize(
    ("visual", "reason"),
    [
        ("b.stl", "its name and its link define neither"),
        ("b.step", "only .dae, .stl"),
        ("package://not_there/b.stl", "package 'not_there' not found"),
        ("http://example.org/b.stl", "'http://' is not a file URI"),
    ],
)
def test_what_cannot_be_made_is_said(visual: str, reason: str, tmp_path: Path) -> None:
    absurd = """<inertial><mass value="0.0001"/>
        <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>"""
    (one,) = generate_missing(read(robot(tmp_path, visual, more=absurd))).not_generated
    assert reason in one.reason


def test_a_file_that_several_links_name_is_made_once(tmp_path: Path) -> None:
    other = f"""<link name="b"><visual><geometry><mesh filename="b.stl"/></geometry></visual>
        <collision><geometry>{BOX}</geometry></collision></link>"""
    found = generate_missing(read(robot(tmp_path, "b.stl", BOX, more=other)))
    assert [len(one.references) for one in found.generated] == [2]


def test_one_mesh_by_its_reference(tmp_path: Path) -> None:
    (tmp_path / "good.stl").write_bytes(binary_stl())
    context = read(robot(tmp_path, "good.stl", BOX))
    with pytest.raises(SoundMesh, match=r"good\.stl is a valid mesh"):
        generate(context, "good.stl")
    with pytest.raises(NoSuchMesh, match=r"'god\.stl'; did you mean 'good\.stl'\?"):
        generate(context, "god.stl")
    one = generate(context, "good.stl", size=(0.1, 0.2, 0.3), force=True)
    assert isinstance(one, GeneratedMesh)
    assert one.mesh.vertices.max(axis=0) == pytest.approx([0.05, 0.1, 0.15])
    camera = generate(context, "good.stl", part=PARTS_BY_KEY["camera"], force=True)
    assert isinstance(camera, GeneratedMesh)
    assert camera.reason.startswith("industrial camera")
    assert not isinstance(camera, NotGenerated)


def test_a_part_for_a_new_file(tmp_path: Path) -> None:
    path = tmp_path / "imu.glb"
    one = generate_part(str(path), PARTS_BY_KEY["xsens_mti"])
    one.write()
    with pytest.raises(SoundMesh):
        generate_part(str(path), PARTS_BY_KEY["xsens_mti"])
    path.write_bytes(b"")
    assert generate_part(str(path), PARTS_BY_KEY["xsens_mti"]).defect == "is empty"


@needs_corpus
def test_the_inertia_of_a_real_arm_tells_the_size_of_its_links() -> None:
    """For want of anything else a block stands in, of the extent that mass and moments give."""
    directory = CORPUS / "Universal_Robots_ROS2_Description"
    context = read(
        directory / "urdf" / "ur.urdf.xacro", arguments={"ur_type": "ur5e", "name": "ur"}
    )
    ratios = []
    for link in context.model.links:
        for body in link.collisions:
            true = context.meshes.vertices(body.shape) if body.shape else None
            block = target_bounds(context, link._replace(visuals=()), body)
            if true is None or block is None:
                continue
            ratios += [*(np.ptp(true, axis=0) / block.size)]
    assert len(ratios) >= 3 * 6
    assert min(ratios) > 1 / 3
    assert max(ratios) < 3
