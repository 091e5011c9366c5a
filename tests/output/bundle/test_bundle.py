"""Bundles load where nothing of this machine is, in the programs that they are for."""

import hashlib
import json
import os
import re
import zipfile
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import pytest

from tests.conftest import MISSION, CorpusRobot, manifest, model_id, needs_corpus
from tests.mesh.made import ascii_stl
from tests.workspaces import add_file, add_package
from urdfkit import bundle, check, read
from urdfkit.core import temporary
from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.mesh import samples

np = pytest.importorskip("numpy")
trimesh = pytest.importorskip("trimesh")

TRIANGLES = samples.box((0, 0, 0), (0.1, 0.2, 0.3))
BOX = trimesh.creation.box((0.1, 0.2, 0.3))
PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de"
    "0000000c49444154789c63606060000000040001f61738550000000049454e44ae426082"
)
FACES = ((1, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4))
INERTIAL = (
    '<inertial><mass value="2"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
)
ROBOT = f"""<?xml version="1.0" encoding="iso-8859-1"?>
<robot name="Arm 1 é">
  <link name="base">
    {INERTIAL}
    <visual>
      <geometry><mesh filename="package://arm/meshes/visual/body.dae"/></geometry>
      <material name="wood"><texture filename="package://arm/images/wood.png"/></material>
    </visual>
    <collision><geometry><mesh filename="package://arm/meshes/collision/body.stl"/></geometry></collision>
  </link>
  <link name="tip">
    {INERTIAL}
    <visual><geometry><mesh filename="../meshes/visual/tip.obj" scale="1 2 1"/></geometry></visual>
    <visual><geometry><mesh filename="package://arm/meshes/tip.glb"/></geometry></visual>
  </link>
  <joint name="turn" type="continuous">
    <parent link="base"/><child link="tip"/><origin xyz="0 0.1 0.5" rpy="0.1 0.2 0.3"/>
    <axis xyz="0 0 1"/>
  </joint>
</robot>
"""


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """A robot with a mesh of each kind that some program cannot read."""
    package = add_package(tmp_path / "src" / "arm", "arm")
    add_file(package / "meshes" / "visual" / "body.dae", BOX.export(file_type="dae"))
    add_file(package / "meshes" / "collision" / "body.stl", ascii_stl(TRIANGLES))
    add_file(
        package / "meshes" / "visual" / "tip.obj",
        b"mtllib ../tip.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
        b"vt 0 0\nf 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/1 4/1 3/1\nf 2/1 3/1 4/1\n",
    )
    add_file(package / "meshes" / "tip.mtl", b"newmtl wood\nKd 1 0 0\nmap_Kd ../images/wood.png\n")
    add_file(package / "meshes" / "images" / "wood.png", PNG)
    (package / "meshes" / "tip.glb").write_bytes(BOX.export(file_type="glb"))
    add_file(package / "images" / "wood.png", PNG)
    return add_file(package / "urdf" / "arm.urdf", ROBOT.encode("latin-1"))


def contents(out: Path) -> dict[str, bytes]:
    files = (path for path in sorted(out.rglob("*")) if path.is_file())
    return {path.relative_to(out).as_posix(): path.read_bytes() for path in files}


def names(out: Path) -> list[str]:
    return [name for name in contents(out) if name != "bundle.json"]


def test_meshes_have_unique_names_and_their_files(robot: Path, tmp_path: Path) -> None:
    made, rejected = bundle(robot, tmp_path / "out")
    assert rejected == ()
    assert names(tmp_path / "out") == [
        "arm_1.urdf",
        "meshes/body.dae",
        "meshes/collision_body.stl",
        "meshes/meshes_tip.glb",
        "meshes/tip/tip.mtl",
        "meshes/tip/tip.obj",
        "meshes/tip/wood.png",
        "textures/wood.png",
    ]
    assert made.outside == ()


@pytest.mark.parametrize(
    ("consumer", "suffixes"),
    [
        ("mujoco", {".obj", ".stl"}),
        ("pybullet", {".dae", ".obj", ".stl"}),
        ("web", {".dae", ".stl"}),
        ("isaac", {".dae", ".obj", ".stl"}),
        ("ros", {".dae", ".obj", ".stl", ".glb"}),
    ],
)
def test_meshes_are_converted_to_supported_formats(
    robot: Path, tmp_path: Path, consumer: str, suffixes: set[str]
) -> None:
    made, _ = bundle(robot, tmp_path / "out", consumer=consumer)
    meshes = [one.new for one in made.renamed if "/textures/" not in f"/{one.new}"]
    assert {os.path.splitext(name)[1] for name in meshes} == suffixes
    report = check(tmp_path / "out" / made.urdf, select=["MSH001", "MSH007", "MSH009", "XAC011"])
    assert report.diagnostics == ()


def test_the_manifest_lists_sources(robot: Path, tmp_path: Path) -> None:
    bundle(robot, tmp_path / "out", consumer="mujoco")
    files = contents(tmp_path / "out")
    told = json.loads(files.pop("bundle.json"))
    assert {one["path"]: (one["size"], one["sha256"]) for one in told["files"]} == {
        name: (len(data), hashlib.sha256(data).hexdigest()) for name, data in files.items()
    }
    changes = {one["source"]: one["change"] for one in told["files"] if one["change"]}
    assert changes["arm/meshes/visual/body.dae"] == "COLLADA written as OBJ"
    assert changes["arm/meshes/collision/body.stl"] == "ASCII STL written as STL"
    (tip,) = (one for one in told["references"] if one["old"].endswith("tip.glb"))
    assert (tip["element"], tip["file"]) == (
        "link/tip/visual[2]/geometry/mesh@filename",
        "arm/urdf/arm.urdf",
    )
    assert tip["line"] == ROBOT[: ROBOT.index("tip.glb")].count("\n") + 1
    assert str(tmp_path) not in json.dumps(told)


def frames_and_masses(pin: Any, urdf: str | Path) -> tuple[Any, ...]:
    model = pin.buildModelFromUrdf(str(urdf))
    data = model.createData()
    pin.framesForwardKinematics(model, data, pin.neutral(model))
    return [frame.homogeneous for frame in data.oMf], [one.mass for one in model.inertias], model


def test_other_programs_load_the_bundle_alone(robot: Path, tmp_path: Path) -> None:
    pin, yourdfpy = pytest.importorskip("pinocchio"), pytest.importorskip("yourdfpy")
    out = tmp_path / "elsewhere" / "out"
    made, _ = bundle(robot, out, consumer="mujoco")
    os.rename(tmp_path / "src", tmp_path / "gone")
    loaded = yourdfpy.URDF.load(str(out / made.urdf), load_collision_meshes=True)
    assert len(loaded.scene.geometry) == 3
    frames, masses, model = frames_and_masses(pin, out / made.urdf)
    expected_frames, expected_masses, _ = frames_and_masses(
        pin, tmp_path / "gone" / "arm" / "urdf" / "arm.urdf"
    )
    assert np.array_equal(frames, expected_frames)
    assert masses == expected_masses
    for kind in (pin.VISUAL, pin.COLLISION):
        pin.buildGeomFromUrdf(model, str(out / made.urdf), kind, package_dirs=[str(out)])


@pytest.mark.parametrize(
    "written",
    [
        "",
        "<mujoco/>",
        "<mujoco><compiler/></mujoco>",
        '<mujoco><compiler meshdir="../meshes" discardvisual="false"/></mujoco>',
        '<mujoco><compiler strippath="true" discardvisual="false"/></mujoco>',
    ],
)
def test_mujoco_loads_it(robot: Path, tmp_path: Path, written: str) -> None:
    mujoco = pytest.importorskip("mujoco")
    robot.write_bytes(robot.read_bytes().replace(b"</robot>", f"{written}</robot>".encode()))
    made, rejected = bundle(robot, tmp_path / "out", consumer="mujoco")
    assert rejected == ()
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "out" / made.urdf))
    assert model.nmesh == (4 if "discardvisual" in written else 1)
    assert model.body_mass[1:].sum() == pytest.approx(2)  # MuJoCo welds the root


def test_rejections_are_reported_at_the_original_source(robot: Path, tmp_path: Path) -> None:
    robot.write_bytes(robot.read_bytes().replace(b'izz="1"', b'izz="3"', 1))
    _, (rejection,) = bundle(robot, tmp_path / "out", consumer="mujoco")
    assert (rejection.code, rejection.span.source.path) == ("INE003", str(robot))


@pytest.mark.parametrize(
    ("joint_child", "more", "rejecting"),
    [
        ("tip", "", []),
        ("tip", '<link name="loose"/>', ["pybullet", "ros"]),  # a second root
        ("nothing", '<link name="tip"/>', ["any", "mujoco", "pybullet", "ros", "web"]),
    ],
)
def test_every_bundle_is_checked(
    tmp_path: Path, joint_child: str, more: str, rejecting: list[str]
) -> None:
    text = (
        f'<robot name="r"><link name="base">{INERTIAL}</link><link name="tip">{INERTIAL}</link>'
        f'{more}<joint name="j" type="continuous"><parent link="base"/>'
        f'<child link="{joint_child}"/></joint></robot>'
    )
    path = add_file(tmp_path / "robot.urdf", text.encode())
    found = [
        consumer
        for consumer in ("any", "mujoco", "pybullet", "ros", "web")
        if bundle(path, tmp_path / consumer, consumer=consumer)[1]
    ]
    assert found == rejecting


def test_a_part_of_a_robot_is_not_bundled(tmp_path: Path) -> None:
    text = '<robot><xacro:camera name="c"/><link name="mount"/></robot>'
    path = add_file(tmp_path / "extras.urdf", text.encode())
    with pytest.raises(UrdfkitError, match=r"extras\.urdf: is only a part"):
        bundle(path, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_package_for_ros_is_found_by_its_name(robot: Path, tmp_path: Path) -> None:
    made, _ = bundle(robot, tmp_path / "ws" / "arm_1", consumer="ros")
    assert made.urdf == "urdf/arm_1.urdf"
    written = read(tmp_path / "ws" / "arm_1" / made.urdf)
    assert all(mesh.at.value.startswith("package://arm_1/meshes/") for mesh in written.files.meshes)
    assert written.files.missing == ()
    report = check(tmp_path / "ws" / "arm_1", select=["PKG"])
    assert report.diagnostics == ()


@pytest.mark.parametrize("file", ["package://arm/c.yaml", "/home/me/my ws/arm/c.yaml"])
def test_remaining_outside_references_are_reported(robot: Path, tmp_path: Path, file: str) -> None:
    plugin = f'<gazebo><plugin name="p"><parameters>{file}</parameters></plugin></gazebo></robot>'
    robot.write_bytes(robot.read_bytes().replace(b"</robot>", plugin.encode()))
    made, _ = bundle(robot, tmp_path / "out")
    assert made.outside == (("gazebo/plugin/p/parameters", file),)


def test_a_missing_mesh_is_an_error_at_its_location(tmp_path: Path) -> None:
    with pytest.raises(
        UrdfkitError, match=r"xacro:266:25: 'package://gazebo_pkg/meshes/hokuyo.dae' does"
    ):
        bundle(MISSION, tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_files_outside_the_workspace_are_not_bundled(robot: Path, tmp_path: Path) -> None:
    (tmp_path / "src" / ".git").mkdir()
    secret = add_file(tmp_path / "secret.png", PNG + b"secret")
    image = robot.parents[1] / "meshes" / "visual" / "wood.png"
    for outside in ("wood.png", "../../../../secret.png", str(secret)):
        image.unlink(missing_ok=True)
        image.symlink_to(secret)
        library = f"newmtl wood\nKd 1 0 0\nmap_Kd {outside}\n".encode()
        (image.parent.parent / "tip.mtl").write_bytes(library)
        (image.parent / "tip.mtl").write_bytes(library)
        obj = image.parent / "tip.obj"
        for path in ("tip.mtl", "../tip.mtl"):
            obj.write_bytes(re.sub(rb"mtllib .*", f"mtllib {path}".encode(), obj.read_bytes()))
            for consumer in ("any", "web"):
                bundle(robot, tmp_path / "out", consumer=consumer, force=True)
                assert not [n for n, d in contents(tmp_path / "out").items() if b"secret" in d]


def test_a_file_outside_the_workspace_is_not_reported_as_missing(
    robot: Path, tmp_path: Path
) -> None:
    (tmp_path / "src" / ".git").mkdir()
    add_file(tmp_path / "body.stl", ascii_stl(TRIANGLES))
    text = robot.read_text("latin-1")
    robot.write_text(re.sub(r"[^\"]*body.dae", "../../../body.stl", text), "latin-1")
    with pytest.raises(
        UrdfkitError, match=r":\d+: '\.\./\.\./\.\./body.*' is outside the workspace; see "
    ):
        bundle(robot, tmp_path / "out")


def test_a_self_referencing_mesh_is_bundled_once(robot: Path, tmp_path: Path) -> None:
    obj = robot.parents[1] / "meshes" / "visual" / "tip.obj"
    obj.write_bytes(re.sub(rb"mtllib .*", b"mtllib tip.obj", obj.read_bytes()))
    bundle(robot, tmp_path / "out")
    assert "meshes/tip.obj" in contents(tmp_path / "out")


@pytest.mark.parametrize(
    "name", ["a & b's <1>.stl", 'quote".stl', "\u540d \u00e9.stl", "tab\t.stl"]
)
def test_names_are_escaped(tmp_path: Path, name: str) -> None:
    add_file(tmp_path / name, samples.stl(TRIANGLES))
    mesh = f"<mesh filename={quoteattr(name)}/>"
    link = f'<link name="a"><visual><geometry>{mesh}</geometry></visual></link>'
    robot = add_file(tmp_path / "r.urdf", f'<robot name="r">{link}</robot>'.encode())
    made, _ = bundle(robot, tmp_path / "out")
    (written,) = read(tmp_path / "out" / made.urdf).files.meshes
    assert (written.at.value, written.located.path) == (
        f"meshes/{name}",
        str(tmp_path / "out" / "meshes" / name),
    )


def test_an_unknown_program(robot: Path, tmp_path: Path) -> None:
    with pytest.raises(UrdfkitError, match="no program 'mujco'; did you mean 'mujoco'"):
        bundle(robot, tmp_path / "out", consumer="mujco")


def test_a_broken_mesh_writes_nothing(robot: Path, tmp_path: Path) -> None:
    mesh = robot.parents[1] / "meshes" / "collision" / "body.stl"
    mesh.write_bytes(b"")
    with pytest.raises(
        UrdfkitError, match=r"\.urdf.*:\d+:\d+: .*body\.stl: .*; see 'urdfkit check"
    ):
        bundle(robot, tmp_path / "made" / "out")
    assert list((tmp_path / "made").iterdir()) == []


@pytest.mark.parametrize("is_killed", [True, False])
def test_an_interrupted_replacement_is_restored(
    is_killed: bool, robot: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    bundle(robot, out)
    before = contents(out)
    if is_killed:  # between the renames
        with temporary.workshop(str(out)) as workshop:
            pass
        os.mkdir(workshop)
        out.rename(os.path.join(workshop, "old"))
        with pytest.raises(UnwritableFile, match="--force"):
            bundle(robot, out, consumer="web")
    else:

        def stop(old: str, new: str) -> None:
            if Path(old).name == "bundle":
                raise KeyboardInterrupt
            os.rename(old, new)

        with monkeypatch.context() as patch:
            patch.setattr(os, "replace", stop)
            with pytest.raises(KeyboardInterrupt):
                bundle(robot, out, consumer="web", force=True)
    assert contents(out) == before
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".")] == []


def test_only_a_bundle_is_replaced_and_only_on_request(robot: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    bundle(robot, out)
    before = contents(out)
    with pytest.raises(UnwritableFile, match="--force"):
        bundle(robot, out, consumer="web")
    assert contents(out) == before
    bundle(robot, out, consumer="web", force=True)
    assert "meshes/meshes_tip.dae" in contents(out)
    text, archive, pipe = (tmp_path / name for name in ("text.zip", "archive.zip", "pipe.zip"))
    text.write_text("not a zip")
    with zipfile.ZipFile(archive, "w") as written:
        written.writestr("thesis.tex", "my own")
    os.mkfifo(pipe)
    for other in (tmp_path, robot, text, archive, pipe):
        with pytest.raises(UnwritableFile, match="is a"):
            bundle(robot, other, force=True)
    assert text.read_text() == "not a zip"
    for force in (False, True):
        bundle(robot, tmp_path / "new.zip", force=force)


def test_equal_bundles_have_equal_zips(robot: Path, tmp_path: Path) -> None:
    for name in ("a.zip", "b.zip"):
        bundle(robot, tmp_path / name)
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    bundle(robot, tmp_path / "out")
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        assert {name: archive.read(name) for name in archive.namelist()} == contents(
            tmp_path / "out"
        )


@needs_corpus
@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_robots_of_the_corpus_load_from_their_bundles(entry: CorpusRobot, tmp_path: Path) -> None:
    pin = pytest.importorskip("pinocchio")
    try:
        robot = entry.read()
        made, _ = bundle(robot, tmp_path / "out", consumer="mujoco")
    except UrdfkitError as error:
        pytest.skip(str(error))
    try:
        expected = pin.buildModelFromXML(robot.text.decode())
    except ValueError as error:
        pytest.skip(f"Pinocchio rejects the robot itself: {error}")
    frames, masses, loaded = frames_and_masses(pin, tmp_path / "out" / made.urdf)
    data = expected.createData()
    pin.framesForwardKinematics(expected, data, pin.neutral(expected))
    assert np.allclose(frames, [one.homogeneous for one in data.oMf], atol=1e-12)
    assert masses == [one.mass for one in expected.inertias]
    for kind in (pin.VISUAL, pin.COLLISION):
        pin.buildGeomFromUrdf(
            loaded, str(tmp_path / "out" / made.urdf), kind, package_dirs=[str(tmp_path / "out")]
        )


def test_mujoco_gets_all_objects_of_an_obj(tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    mesh = "".join(
        f"o part_{k}\nv {k} 0 0\nv {k + 0.5} 0 0\nv {k} 1 0\nv {k} 0 1\n"
        + "".join(f"f {4 * k + a} {4 * k + b} {4 * k + c}\n" for a, b, c in FACES)
        for k in range(2)
    )
    add_file(tmp_path / "two.obj", mesh.encode())
    collision = '<collision><geometry><mesh filename="two.obj"/></geometry></collision>'
    robot = add_file(
        tmp_path / "r.urdf",
        f'<robot name="r"><link name="base">{INERTIAL}{collision}</link></robot>'.encode(),
    )
    (found,) = check(robot, select=["MSH007"], targets=["mujoco"]).diagnostics
    assert "contains 2 objects, of which MuJoCo loads the first" in found.message
    made, _ = bundle(robot, tmp_path / "out", consumer="mujoco")
    urdf = str(tmp_path / "out" / made.urdf)
    assert mujoco.MjModel.from_xml_path(urdf).mesh_facenum.tolist() == [8]
    assert check(urdf, select=["MSH007"], targets=["mujoco"]).diagnostics == ()
