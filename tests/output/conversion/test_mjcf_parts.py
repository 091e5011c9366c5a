"""What MJCF gets of meshes, materials, sensors, SRDFs, and fixed links."""

import io
import re
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from urdfkit import convert, read
from urdfkit.errors import UrdfkitError
from urdfkit.text.source import Source

mujoco = pytest.importorskip("mujoco")
np = pytest.importorskip("numpy")
pytest.importorskip("pinocchio")
pytest.importorskip("trimesh")
Image = pytest.importorskip("PIL.Image")

from tests.output.conversion.test_mjcf import INERTIAL, LIMIT, arm, loaded
from tests.own_robots import PICKER
from tests.physics.dynamics.test_against_pinocchio import robots
from urdfkit.output.conversion import mjcf_inputs

#: Two triangles with an image, a part without, which is red, and a triangle that is blue.
OBJ = """\
mtllib m.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 1 1 0
v 1 1 1
vt 0 0
vt 1 0
vt 0 1
usemtl image
f 1/1 2/2 3/3
f 1/1 2/2 4/3
f 2/1 5/2 3/3
usemtl red
f 3 5 6
f 2 5 6
f 1 5 6
usemtl blue
f 1 2 6
"""
MTL = "newmtl image\nmap_Kd {image}\nnewmtl red\nKd 1 0 0\nd 0.5\nnewmtl blue\nKd 0 0 1\n"


def image(kind: str) -> bytes:
    """An image of 2 by 2 pixels: the upper left one is red, the others are black."""
    file = io.BytesIO()
    pixels = np.zeros((2, 2, 3), dtype=np.uint8)
    pixels[0, 0, 0] = 255
    Image.fromarray(pixels).save(file, kind)
    return file.getvalue()


def meshed(directory: Path, more: str = "", *, kind: str = "png") -> Path:
    """A robot with the mesh above as a visual."""
    (directory / f"i.{kind}").write_bytes(image(kind))
    (directory / "m.obj").write_text(OBJ)
    (directory / "m.mtl").write_text(MTL.format(image=f"i.{kind}"))
    shape = '<geometry><mesh filename="m.obj" scale="1 1 2"/></geometry>'
    tip = f"{INERTIAL}<visual>{shape}{more}</visual><collision>{shape}</collision>"
    path = directory / "r.urdf"
    path.write_bytes(arm(LIMIT, tip=tip).data)
    return path


@pytest.mark.parametrize("kind", ["png", "bmp"])
def test_each_material_of_a_mesh_is_a_geom(kind: str, tmp_path: Path) -> None:
    model, parts = loaded(meshed(tmp_path, kind=kind), tmp_path / "o")
    seen = [number for number in range(model.ngeom) if not model.geom_contype[number]]
    assert len(seen) == 2, "a single triangle is no mesh for MuJoCo"
    assert model.geom_matid[seen].tolist() == [0, -1]
    assert model.geom_rgba[seen[1]].tolist() == [1, 0, 0, 0.5]
    assert model.tex_data[:12].tolist() == [255] + [0] * 11
    assert sorted(path.name for path in (tmp_path / "o").rglob("*.*")) == [
        "arm.xml",
        "conversion.json",
        "i.png",
        "m.obj",
        "m_material_1.obj",
        "m_material_2.obj",
    ]
    at = "link/tip/visual/geometry/mesh"
    assert parts[at] == "kept: visual geom for each of its 2 materials"


def test_a_material_of_the_robot_replaces_mesh_materials(tmp_path: Path) -> None:
    more = '<material name="g"><color rgba="0 1 0 1"/></material>'
    model, parts = loaded(meshed(tmp_path, more), tmp_path / "o")
    assert model.geom_contype.tolist() == [0, 1]
    assert model.geom_rgba[0].tolist() == [0, 1, 0, 1]
    assert parts["link/tip/visual/material/g/color"] == "kept: rgba of the geom"


def test_a_texture_of_the_robot(tmp_path: Path) -> None:
    more = '<material name="i"><texture filename="i.png"/></material>'
    path = meshed(tmp_path, more)
    whole = OBJ.replace("f 3 5 6", "f 3/1 5/2 6/3").split("f 2 5 6")[0]
    (tmp_path / "m.obj").write_text(whole)
    model, parts = loaded(path, tmp_path / "o")
    assert model.geom_matid[0] == 0
    assert parts["link/tip/visual/material/i/texture@filename"] == "kept: texture"
    (tmp_path / "i.png").write_bytes(b"no image")
    model, parts = loaded(path, tmp_path / "p")
    assert model.ntex == 0
    assert parts["link/tip/visual/material/i/texture"] == "lost: the image cannot be read"


def test_the_gazebo_material_of_a_link(tmp_path: Path) -> None:
    visual = f'{INERTIAL}<visual><geometry><sphere radius="1"/></geometry></visual>'
    tag = '<gazebo reference="tip"><material>Gazebo/Red</material></gazebo>'
    model, parts = loaded(arm(LIMIT, tip=visual, more=tag), tmp_path / "o")
    assert model.geom_rgba[0].tolist() == [1, 0, 0, 1]
    assert parts["gazebo/tip/material"] == "kept: rgba of the geom"


@pytest.mark.parametrize("collision", ["hull", "decompose"])
def test_collision_meshes(collision: str, tmp_path: Path) -> None:
    model, parts = loaded(meshed(tmp_path), tmp_path / "o", collision=collision)
    collides = np.flatnonzero(model.geom_contype)
    assert (len(collides) > 1) == (collision == "decompose")
    assert (model.geom_type[collides] == mujoco.mjtGeom.mjGEOM_MESH).all()
    assert parts["link/tip/collision/geometry/mesh"].endswith("mm outside the mesh")


def test_a_box_shaped_mesh_collides_as_a_box(tmp_path: Path) -> None:
    path = meshed(tmp_path)
    corners = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)]
    quads = ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6")
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {quad}" for quad in quads]
    (tmp_path / "m.obj").write_text("\n".join(lines))
    model, parts = loaded(path, tmp_path / "o", collision="primitives")
    box = int(np.flatnonzero(model.geom_contype)[0])
    assert model.geom_type[box] == mujoco.mjtGeom.mjGEOM_BOX
    assert sorted(model.geom_size[box]) == pytest.approx([0.5, 1, 3], abs=1e-6)
    assert model.geom_pos[box] == pytest.approx([0.5, 1, 3], abs=1e-6)
    assert parts["link/tip/collision/geometry/mesh"].startswith("approximated: box, up to ")


def test_lidars_measure(tmp_path: Path) -> None:
    wall = (
        '<collision><origin xyz="2 0 -0.5"/><geometry><box size="0.2 9 9"/></geometry></collision>'
    )
    tag = (
        '<gazebo reference="base"><sensor name="scan" type="gpu_lidar"><lidar><scan><horizontal>'
        "<samples>3</samples><min_angle>-0.5</min_angle><max_angle>0.5</max_angle></horizontal>"
        "</scan><range><min>0.1</min><max>30</max></range></lidar></sensor></gazebo>"
    )
    model, parts = loaded(arm(LIMIT, tip=INERTIAL + wall, more=tag), tmp_path / "o")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert data.sensordata == pytest.approx([1.9 / np.cos(0.5), 1.9, 1.9 / np.cos(0.5)])
    assert model.sensor_cutoff.tolist() == [30] * 3
    at = "gazebo/base/sensor/scan"
    assert parts[at] == "kept: rangefinders"
    assert parts[f"{at}/lidar/range/max"] == "kept: cutoff"
    assert parts[f"{at}/lidar/range/min"].startswith("lost: ")


def test_rays_of_a_lidar_are_limited(tmp_path: Path) -> None:
    tag = (
        '<gazebo reference="base"><sensor name="scan" type="ray"><ray><scan><horizontal>'
        "<samples>1000000000</samples><min_angle>0</min_angle><max_angle>6</max_angle></horizontal>"
        "<vertical><samples>32</samples><min_angle>0</min_angle><max_angle>1</max_angle></vertical>"
        "</scan></ray></sensor></gazebo>"
    )
    model, parts = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert model.nsensor == 352
    at = "gazebo/base/sensor/scan/ray/scan/vertical/samples"
    assert parts[at] == "approximated: 352 rangefinders for 32000000000 rays"


SRDF = """<robot name="arm">
<group name="all"><joint name="turn"/></group>
<group name="same"><joint name="turn"/></group>
<group_state name="up" group="all"><joint name="turn" value="1.5"/></group_state>
<group_state name="home" group="all"><joint name="turn" value="0.5"/></group_state>
<group_state name="home" group="same"><joint name="turn" value="-0.5"/></group_state>
<group_state name="none" group="same"><joint name="other" value="-0.5"/></group_state>
<disable_collisions link1="base" link2="hand" reason="Never"/>
</robot>"""
HAND = (
    f'<link name="hand">{INERTIAL}</link><joint name="grip" type="revolute">'
    f'<parent link="tip"/><child link="hand"/>{LIMIT}<mimic joint="turn" multiplier="2"/></joint>'
    '<ros2_control name="c" type="system"><joint name="turn">'
    '<command_interface name="position"/></joint></ros2_control>'
)


def test_states_are_keyframes(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_bytes(arm(LIMIT, more=HAND).data)
    (tmp_path / "arm.srdf").write_text(SRDF)
    model, _ = loaded(path, tmp_path / "o")
    assert [model.key(number).name for number in range(model.nkey)] == [
        "up",
        "all home",
        "same home",
    ]
    assert model.key_qpos.tolist() == [[1.5, 3], [0.5, 1], [-0.5, -1]]
    assert model.key_ctrl.tolist() == [[1.5], [0.5], [-0.5]]
    assert "base hand" in [model.exclude(number).name for number in range(model.nexclude)]


def test_computed_exclusions(tmp_path: Path) -> None:
    pytest.importorskip("coal")
    before, _ = loaded(PICKER, tmp_path / "o")
    after, _ = loaded(PICKER, tmp_path / "p", exclude="computed")
    assert after.nexclude > before.nexclude


FIXED = (
    f'<link name="flange">{INERTIAL}<collision><origin xyz="0 0 1"/>'
    '<geometry><sphere radius="0.1"/></geometry></collision></link>'
    '<joint name="f" type="fixed"><parent link="tip"/><child link="flange"/>'
    '<origin xyz="0 2 0" rpy="1.5707963267948966 0 0"/></joint>'
    f'<link name="end">{INERTIAL}</link><joint name="last" type="continuous">'
    '<parent link="flange"/><child link="end"/><origin xyz="0 0 3"/></joint>'
)


def test_fixed_links_are_merged(tmp_path: Path) -> None:
    tags = (
        '<gazebo reference="flange"><mu1>0.7</mu1><sensor name="imu" type="imu">'
        "<pose>0 0 1 0 0 0</pose></sensor></gazebo>"
    )
    model, parts = loaded(arm(LIMIT, more=FIXED + tags), tmp_path / "o", fixed="merge")
    assert [model.body(number).name for number in range(model.nbody)] == [
        "world",
        "base",
        "tip",
        "end",
    ]
    assert model.body("tip").mass[0] == 4
    assert model.body("end").pos == pytest.approx([0, -1, 0])
    assert model.site("flange").pos == pytest.approx([0, 2, 0])
    assert model.site("imu").pos == pytest.approx([0, 1, 0])
    assert model.geom_pos[0] == pytest.approx([0, 1, 0])
    assert model.geom_friction[0][0] == 0.7
    assert parts["link/flange"] == "kept: site of 'tip'"
    assert parts["joint/f"] == "kept: merged into body 'tip'"
    assert parts["link/flange/inertial/mass"] == "kept: part of the inertial of body 'tip'"


def test_a_fixed_joint_with_a_sensor_is_not_merged(tmp_path: Path) -> None:
    tag = '<gazebo reference="f"><sensor name="ft" type="force_torque"/></gazebo>'
    model, parts = loaded(arm(LIMIT, more=FIXED + tag), tmp_path / "o", fixed="merge")
    assert model.body("flange").mass[0] == 2
    opposite = "approximated: MuJoCo measures the load from parent to child"
    assert parts["gazebo/f/sensor/ft"].startswith(opposite)


@pytest.mark.parametrize(
    ("pose", "position", "turn"),
    [
        ('<pose degrees="true">0.1 0 0 0 0 90</pose>', (0.1, 0, 0), 90),
        ('<pose rotation_format="quat_xyzw">0.1 0 0 0 0 1 1</pose>', (0.1, 0, 0), 90),
        ('<pose relative_to="base">0.1 0 0 0 0 0.5</pose>', (0.1, 0, -0.5), np.degrees(0.5)),
        ('<pose relative_to="turn">0.1 0 0 0 0 0</pose>', (0.1, 0, 0), 0),
    ],
)
def test_poses_of_sensors(
    pose: str, position: tuple[float, ...], turn: float, tmp_path: Path
) -> None:
    tag = f'<gazebo reference="tip"><sensor name="s" type="imu">{pose}</sensor></gazebo>'
    model, parts = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    half = np.radians(turn) / 2
    assert model.site("s").pos == pytest.approx(position)
    assert model.site("s").quat == pytest.approx([np.cos(half), 0, 0, np.sin(half)])
    assert parts["gazebo/tip/sensor/s/pose"] == "kept: pose"


@pytest.mark.parametrize(
    ("pose", "reason"),
    [
        ("<pose>1 2 3</pose>", "the pose is not 6 finite numbers"),
        ('<pose relative_to="x">1 2 3 0 0 0</pose>', "relative to 'x', which is not a link"),
    ],
)
def test_an_invalid_pose_is_lost(pose: str, reason: str, tmp_path: Path) -> None:
    tag = f'<gazebo reference="tip"><sensor name="s" type="imu">{pose}</sensor></gazebo>'
    model, parts = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert not model.site("s").pos.any()
    assert parts["gazebo/tip/sensor/s/pose"].startswith("lost")
    assert reason in parts["gazebo/tip/sensor/s/pose"]


def test_the_pose_of_a_camera_is_in_its_sensor(tmp_path: Path) -> None:
    tag = (
        '<gazebo reference="tip"><sensor name="s" type="camera"><pose>1 0 0 0 0 1.5707963267948966'
        "</pose><camera><pose>0.2 0 0 0 0 0</pose></camera></sensor></gazebo>"
    )
    model, _ = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert model.cam_pos[0] == pytest.approx([1, 0.2, 0])


@pytest.mark.parametrize(
    ("frame", "turn"), [("", 0.0), ("<frame>sensor</frame>", 1.0), ("<frame>parent</frame>", -0.5)]
)
def test_axes_and_place_of_a_force_torque_sensor(frame: str, turn: float, tmp_path: Path) -> None:
    tag = (
        '<gazebo reference="turn"><sensor name="s" type="force_torque"><pose>0.1 0 0 0 0 1</pose>'
        f"<force_torque>{frame}<measure_direction>parent_to_child</measure_direction>"
        "</force_torque></sensor></gazebo>"
    )
    text = arm(LIMIT, more=tag).data.replace(b'"0 0 0.5"', b'"0 0 0.5" rpy="0 0 0.5"')
    model, parts = loaded(Source("arm.urdf", text), tmp_path / "o")
    assert model.site("s").pos == pytest.approx([0.1, 0, 0])
    assert model.site("s").quat == pytest.approx([np.cos(turn / 2), 0, 0, np.sin(turn / 2)])
    at = "gazebo/turn/sensor/s/force_torque"
    assert parts[f"{at}/measure_direction"] == "kept: sensors"
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert data.sensordata[2] == pytest.approx(2 * 9.81)  # the parent bears the child


@settings(suppress_health_check=list(HealthCheck), derandomize=True)
@given(robots())
def test_random_trees_are_merged(tmp_path_factory: pytest.TempPathFactory, text: str) -> None:
    robot = read(Source("r.urdf", text.encode()))
    found = convert(robot, tmp_path_factory.mktemp("tree") / "out", fixed="merge")
    assert found.proof.holds


def test_a_link_without_inertial_gets_the_mass_of_invalid_children(tmp_path: Path) -> None:
    """MuJoCo rejects the tensor of the child, and its mass must not be lost."""
    tensor = INERTIAL.replace('izz="0.1"', 'izz="0.9"')
    more = (
        f'<link name="flange">{tensor}</link><joint name="f" type="fixed">'
        '<parent link="tip"/><child link="flange"/></joint>'
        f'<link name="other">{INERTIAL.replace("0.1", "10")}</link><joint name="g" type="fixed">'
        '<parent link="tip"/><child link="other"/></joint>'
    )
    robot = arm(LIMIT, tip="", more=more)
    model, _ = loaded(robot, tmp_path / "o", fixed="merge")
    assert model.body("tip").mass[0] == 4


def test_no_other_file_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """MuJoCo writes a log of its warnings into the current directory."""
    monkeypatch.chdir(tmp_path)
    loaded(meshed(tmp_path), tmp_path / "o")
    assert not (tmp_path / "MUJOCO_LOG.TXT").exists()


def test_a_fixed_link_with_a_bad_tensor_and_a_mount_without_mass(tmp_path: Path) -> None:
    """Neither has an inertia that a body can have; with what is fixed to them they do."""
    bad = INERTIAL.replace('value="2"', 'value="0.001"').replace('iyy="0.1"', 'iyy="0.3"')
    mount = (
        '<link name="mount"/><link name="antenna">' + bad.replace("0.1", "1e-9") + "</link>"
        '<joint name="a" type="fixed"><parent link="mount"/><child link="base"/></joint>'
        '<joint name="b" type="fixed"><parent link="mount"/><child link="antenna"/></joint>'
    )
    bad_source = arm(LIMIT, more=mount.replace("0.3", "3e-9"))
    model, _ = loaded(bad_source, tmp_path / "o", base="free")
    assert model.body("mount").mass[0] == pytest.approx(2.001)


def test_a_flat_mesh_collides_as_a_plate(tmp_path: Path) -> None:
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    (tmp_path / "flat.obj").write_text("\n".join([*lines, "f 1 2 3", "f 1 3 4"]))
    shape = '<geometry><mesh filename="flat.obj" scale="2 1 1"/></geometry>'
    tip = f"{INERTIAL}<collision>{shape}</collision>"
    file = tmp_path / "arm.urdf"
    file.write_bytes(arm(LIMIT, tip=tip).data)
    model, parts = loaded(file, tmp_path / "o")
    assert sorted(model.geom_aabb[0, 3:].round(6)) == [0.0005, 0.5, 1]
    note = parts["link/tip/collision/geometry/mesh"]
    assert note == "approximated: its convex hull, 1 mm thick, as the mesh is flat"


def test_a_mesh_that_mujoco_rejects_is_named_at_its_line(tmp_path: Path) -> None:
    shape = pyramid(tmp_path / "tiny.obj").replace("<mesh", '\n<mesh scale="1e-6 1e-6 1e-6"')
    file = tmp_path / "arm.urdf"
    file.write_bytes(arm(LIMIT, tip=f"{INERTIAL}<collision>{shape}</collision>").data)
    with pytest.raises(UrdfkitError, match=r"arm\.urdf:4:1: .*too small.*; correct its scale"):
        convert(read(file), tmp_path / "o")


def pyramid(path: Path, height: float = 1, faces: int = 4) -> str:
    """A mesh file; its element."""
    corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, height))
    sides = ["f 1 3 2", "f 1 2 4", "f 1 4 3", "f 2 3 4"]
    lines = [*(f"v {x} {y} {z}" for x, y, z in corners), *sides[:faces]]
    path.write_text("\n".join(lines))
    return f'<geometry><mesh filename="{path.name}"/></geometry>'


def test_meshes_with_equal_names(tmp_path: Path) -> None:
    """A mesh that is a visual and a collision is two; the second one was called like a file."""
    first, second = (
        pyramid(tmp_path / name, 1 + at) for at, name in enumerate(("p.obj", "p_2.obj"))
    )
    tip = f"{INERTIAL}<visual>{first}</visual>" + "".join(
        f"<collision>{one}</collision>" for one in (first, second)
    )
    file = tmp_path / "arm.urdf"
    file.write_bytes(arm(LIMIT, tip=tip).data)
    model, _ = loaded(file, tmp_path / "o")
    assert [model.mesh(number).name for number in range(3)] == ["p", "p_2", "p_2_2"]


def test_joints_with_names_of_generated_joints(tmp_path: Path) -> None:
    hand = (
        HAND.split("<ros2_control", maxsplit=1)[0]
        .replace("grip", "turn[1]")
        .replace('<mimic joint="turn" multiplier="2"/>', "")
    )
    model, _ = loaded(arm(kind="planar", more=hand), tmp_path / "o")
    names = [model.joint(number).name for number in range(model.njnt)]
    assert names == ["turn[0]", "turn[1]_2", "turn[2]", "turn[1]"]


def test_rays_with_names_of_other_devices(tmp_path: Path) -> None:
    sensors = "".join(
        f'<sensor name="{name}" type="gpu_lidar"><lidar/></sensor>' for name in ("a", "a_0", "A")
    )
    tag = f'<gazebo reference="tip">{sensors}</gazebo>'
    model, _ = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert len({model.sensor(number).name for number in range(model.nsensor)}) == 3


def test_a_visual_of_one_triangle_is_lost(tmp_path: Path) -> None:
    shape = pyramid(tmp_path / "t.obj", faces=1)
    file = tmp_path / "arm.urdf"
    tip = f"{INERTIAL}<visual>{shape}</visual><collision>{shape}</collision>"
    file.write_bytes(arm(LIMIT, tip=tip).data)
    model, parts = loaded(file, tmp_path / "o")
    assert model.ngeom == 1
    why = "lost: MuJoCo rejects meshes with fewer than 4 vertices"
    assert parts["link/tip/visual"] == why


def test_a_visual_without_size_is_lost(tmp_path: Path) -> None:
    tip = INERTIAL + '<visual><geometry><box size="0 0 0"/></geometry></visual>'
    model, parts = loaded(arm(LIMIT, tip=tip), tmp_path / "o")
    assert model.ngeom == 0
    assert parts["link/tip/visual"] == "lost: <box> of link 'tip' has no size above 0"


@pytest.mark.parametrize(("kind", "bias"), [("revolute", True), ("continuous", False)])
def test_wheels_have_velocity_actuators(kind: str, bias: bool, tmp_path: Path) -> None:
    offered = "".join(f'<command_interface name="{one}"/>' for one in ("position", "velocity"))
    control = f'<ros2_control name="c" type="system"><joint name="turn">{offered}</joint>'
    robot = arm(LIMIT, more=f"{control}</ros2_control>", kind=kind)
    model, _ = loaded(robot, tmp_path / "o")
    assert bool(model.actuator_biasprm[0, 1]) is bias  # one for positions pulls back


FOLLOWER = (
    f'<link name="finger">{INERTIAL}</link>'
    '<joint name="follow" type="{kind}"><parent link="tip"/><child link="finger"/>'
    '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1" jerk="2"/>'
    '<dynamics damping="1"/>{mimic}</joint>'
)


@pytest.mark.parametrize(
    ("kind", "leader", "reason"),
    [
        ("revolute", "x", "no independent joint leads it: the joint moves freely"),
        ("revolute", "follow", "no independent joint leads it"),
        ("planar", "turn", "a planar joint cannot follow another joint"),
        ("fixed", "turn", "a fixed joint does not move"),
    ],
)
def test_reasons_of_lost_mimics(kind: str, leader: str, reason: str, tmp_path: Path) -> None:
    follower = FOLLOWER.format(kind=kind, mimic=f'<mimic joint="{leader}"/>')
    _, parts = loaded(arm(LIMIT, more=follower), tmp_path / "o")
    assert parts["joint/follow/mimic"].startswith(f"lost: {reason}")


@pytest.mark.parametrize(
    ("kind", "part", "reason"),
    [
        ("planar", "limit", "a planar joint has three motions"),
        ("planar", "dynamics@damping", "a planar joint has three motions"),
        ("floating", "axis", "a floating joint has none"),
        ("revolute", "limit@jerk", "MuJoCo does not limit jerk"),
    ],
)
def test_reasons_of_lost_joint_parts(kind: str, part: str, reason: str, tmp_path: Path) -> None:
    _, parts = loaded(arm(LIMIT, more=FOLLOWER.format(kind=kind, mimic="")), tmp_path / "o")
    assert parts[f"joint/follow/{part}"].startswith(f"lost: {reason}")


def test_only_written_parts_are_kept(tmp_path: Path) -> None:
    shapes = '<geometry><box size="1 1 1"/><sphere radius="1"/></geometry>'
    tip = f"{INERTIAL}{INERTIAL}<collision>{shapes}</collision>"
    tags = (
        '<gazebo reference="tip"><mu1>1</mu1></gazebo><gazebo reference="tip"><mu1>2</mu1></gazebo>'
        '<gazebo reference="base"><mu1>1</mu1><sensor name="gps" type="navsat"/></gazebo>'
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
        '<joint name="turn"><hardwareInterface>PositionJointInterface</hardwareInterface></joint>'
        "</transmission>"
    )
    robot = read(arm(LIMIT, tip=tip, more=tags))
    found = convert(robot, tmp_path / "o")
    notes = [(one.part, f"{one.result.value}: {one.note}") for one in found.entries]
    parts = dict(notes)
    assert parts["link/tip/inertial[2]"] == "lost: only the first <inertial> is read"
    only = "lost: only the first shape in <geometry> is read"
    assert parts["link/tip/collision/geometry/sphere"] == only
    assert [note for part, note in notes if part == "gazebo/tip/mu1"] == [
        "lost: a later <gazebo> sets the friction",
        "kept: friction",
    ]
    assert parts["gazebo/base/mu1"] == "lost: the link has no collision"
    assert parts["gazebo/base/sensor/gps"] == ("lost: no MuJoCo sensor for type 'navsat'")
    assert parts["transmission/t"] == "kept: actuator for position"
    assert parts["transmission/t@name"] == "lost: urdfkit does not convert it"


def test_distance_of_a_convex_hull_from_its_mesh(tmp_path: Path) -> None:
    """A corner of three plates, and a tetrahedron."""
    corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\n"
    (tmp_path / "corner.obj").write_text(corner)
    (tmp_path / "tetrahedron.obj").write_text(f"{corner}f 2 3 4\n")
    collisions = "".join(
        f'<collision><geometry><mesh filename="{name}.obj"/></geometry></collision>'
        for name in ("corner", "tetrahedron")
    )
    (tmp_path / "arm.urdf").write_bytes(arm(LIMIT, tip=INERTIAL + collisions).data)
    _, parts = loaded(tmp_path / "arm.urdf", tmp_path / "o")
    note = parts["link/tip/collision/geometry/mesh"]
    far = re.fullmatch(
        r"approximated: link 'tip' collides as the convex hull of corner.obj, "
        r"about (\d+) mm outside the mesh",
        note,
    )
    assert far is not None
    assert 300 < int(far[1]) <= 334  # the middle of the open face is a third from each plate
    whole = "kept: collides as its convex hull, which equals the mesh"
    assert parts["link/tip/collision[2]/geometry/mesh"] == whole


def test_options_of_mujoco_in_the_urdf(tmp_path: Path) -> None:
    """Gravity does not point along the axis of the joint, and flags change what is computed."""
    block = (
        '<mujoco><compiler balanceinertia="true" autolimits="true"/>'
        '<option timestep="0.004" gravity="0 -3 1"><flag contact="disable" gravity="disable"/>'
        '</option><size memory="10M" nuserdata="3"/></mujoco><mujoco_inputs><raw_inputs>'
        '<option integrator="implicitfast"/><sensor/></raw_inputs></mujoco_inputs>'
    )
    outwards = INERTIAL.replace("<inertial>", '<inertial><origin xyz="0.3 0 0"/>')
    model, parts = loaded(
        arm('<axis xyz="0 1 0"/>' + LIMIT, tip=outwards, more=block), tmp_path / "o"
    )
    assert model.opt.gravity.tolist() == [0, -3, 1]
    assert (model.opt.timestep, model.narena) == (0.004, 10 * 2**20)
    assert model.opt.integrator == mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    assert model.opt.disableflags == (
        mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_GRAVITY
    )
    masses = "lost: the conversion writes the masses of the robot"
    assert parts["mujoco/compiler@balanceinertia"] == masses
    assert parts["mujoco/compiler@autolimits"] == "lost: urdfkit does not convert it"
    assert parts["mujoco/option@gravity"] == "kept: option"
    assert parts["mujoco/size@nuserdata"] == "lost: urdfkit does not convert it"
    assert parts["mujoco_inputs/raw_inputs/option"] == "kept: option"
    merged = "lost: mujoco_ros2_control merges it into the MJCF; urdfkit does not"
    assert parts["mujoco_inputs/raw_inputs/sensor"] == merged


def inputs(actuators: str) -> str:
    return (
        f"<mujoco_inputs><raw_inputs><actuator>{actuators}</actuator></raw_inputs></mujoco_inputs>"
    )


def test_actuators_of_mujoco_in_the_urdf(tmp_path: Path) -> None:
    """They are those that MuJoCo itself reads from the same text, and replace our own."""
    text = (
        '<position joint="turn" kp="30" dampratio="1" ctrlrange="-1 1" forcerange="-5 5"/>'
        '<velocity joint="turn" kv="2"/><general tendon="t"/>'
    )
    model, parts = loaded(arm(LIMIT, more=inputs(text)), tmp_path / "o")
    expected = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><joint name="turn"/><geom size="1"/></body></worldbody>'
        f"<actuator>{text.partition('<general')[0]}</actuator></mujoco>"
    )
    assert [model.actuator(number).name for number in range(model.nu)] == ["turn", "turn_velocity"]
    for field in "gainprm gaintype biastype ctrlrange forcerange ctrllimited gear".split():
        ours, theirs = (getattr(one, f"actuator_{field}") for one in (model, expected))
        assert ours.tolist() == theirs.tolist()
    assert model.actuator("turn").biasprm[1] == -30
    block = "mujoco_inputs/raw_inputs/actuator"
    assert parts[f"{block}/position@kp"] == "kept: position"
    assert parts[f"{block}/general"].startswith("lost: only actuators of joints")


def test_all_fields_of_an_actuator_are_copied() -> None:
    """But what belongs to its specification, and what actuators of joints do not use."""
    own = "classname compiler id info name plugin signature target trntype type userdata".split()
    of_sites = ["refsite", "slidersite"]
    actuator = mujoco.MjSpec().add_actuator()
    fields = {name for name in dir(actuator) if not name.startswith("_")}
    values = {name for name in fields if not callable(getattr(actuator, name))}
    assert values - {*own, *of_sites} == set(mjcf_inputs._ACTUATOR_FIELDS)


@pytest.mark.parametrize(
    ("actuator", "message"),
    [
        ('<position joint="trun"/>', "<position> is for an unknown joint 'trun'; correct it"),
        ('<position joint="turn" kpp="1"/>', "unrecognized attribute: 'kpp'; correct it"),
        ('<servo joint="turn"/>', "MuJoCo rejects <servo>"),
    ],
)
def test_a_wrong_actuator_of_mujoco_is_an_error(
    actuator: str, message: str, tmp_path: Path
) -> None:
    with pytest.raises(UrdfkitError, match=message):
        convert(read(arm(LIMIT, more=inputs(actuator))), tmp_path / "o")


def test_an_option_that_mujoco_rejects_is_an_error(tmp_path: Path) -> None:
    block = '<mujoco><option step="1"/></mujoco>'
    with pytest.raises(UrdfkitError, match="unrecognized attribute: 'step'; correct it"):
        convert(read(arm(LIMIT, more=block)), tmp_path / "o")
