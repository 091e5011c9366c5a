"""USD: what the stage holds is the robot, and warnings stand at the lines of the robot."""

import json
import re
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.output.conversion.converted import assert_whole, of_corpus, results
from tests.output.conversion.test_mjcf import BOX, FEWER, INERTIAL, LIMIT, PLACE_AND_REMEDY, arm
from tests.own_robots import own_robots
from urdfkit import convert, read
from urdfkit.errors import UrdfkitError
from urdfkit.text.source import Source

np = pytest.importorskip("numpy")
Image = pytest.importorskip("PIL.Image")
pytest.importorskip("trimesh")
pytest.importorskip("pinocchio")
pytest.importorskip("urdf_usd_converter")

from pxr import Gf, Usd, UsdGeom

from tests.physics.dynamics.test_against_pinocchio import robots
from urdfkit.output.conversion.result import REPORT
from urdfkit.output.conversion.usd_proof import prove
from urdfkit.output.conversion.usd_stage import Stage


def loaded(robot: Source | Path, out: Path) -> tuple[Any, dict[str, str]]:
    """The stage, and what became of each part."""
    found = convert(read(robot), out, to="usd")
    return Usd.Stage.Open(str(out / found.file)), results(found)


@own_robots
def test_robots_of_the_project(path: Path, tmp_path: Path) -> None:
    convert(path, tmp_path / "out", to="usd")
    facts = json.loads((tmp_path / "out" / REPORT).read_text())
    assert facts["proof"]["holds"] is True
    assert facts["to"] == "usd"


@needs_corpus
@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_robots_of_the_corpus(entry: CorpusRobot, tmp_path: Path) -> None:
    found = of_corpus(entry, tmp_path / "o", "usd")
    assert all(one.note for one in found.entries)


@settings(FEWER, suppress_health_check=list(HealthCheck), derandomize=True)
@given(robots())
def test_random_trees(tmp_path_factory: pytest.TempPathFactory, text: str) -> None:
    robot = read(Source("r.urdf", text.encode()))
    found = convert(robot, tmp_path_factory.mktemp("tree") / "out", to="usd")
    assert_whole(robot, found)


def test_the_proof_fails_for_a_wrong_stage(tmp_path: Path) -> None:
    joint = f'<axis xyz="0 0 1"/>{LIMIT}<dynamics damping="0.5" friction="0.2"/>'
    more = (
        f'<link name="finger">{INERTIAL}</link><joint name="follow" type="revolute">'
        f'<parent link="tip"/><child link="finger"/>{LIMIT}<mimic joint="turn" offset="1"/></joint>'
    )
    robot = read(arm(joint, tip=f"{INERTIAL}<visual>{BOX}</visual>", more=more))
    found = convert(robot, tmp_path / "o", to="usd")

    def holds(path: str, attribute: str, value: Any) -> bool:
        stage = Usd.Stage.Open(str(tmp_path / "o" / found.file))
        stage.GetPrimAtPath(path).GetAttribute(attribute).Set(value)
        result = prove(Stage(stage, robot), robot).holds
        stage.Reload()
        return result

    tip, turn = "/arm/Geometry/base/tip", "/arm/Physics/turn"
    assert holds(tip, "physics:mass", 2.0)
    assert not holds(tip, "physics:mass", 2.001)
    assert not holds(tip, "physics:diagonalInertia", (0.1, 0.1, 0.11))
    assert not holds(tip, "physics:diagonalInertia", (float("inf"), 0.1, 0.1))
    assert not holds(tip, "physics:centerOfMass", (0, 0, 0.001))
    assert not holds(tip, "xformOp:translate", (0, 0, 0.501))
    assert not holds(turn, "physics:upperLimit", 100.0)
    assert not holds(turn, "physics:axis", "X")
    assert not holds(turn, "physics:localRot0", Gf.Quatf(1, 1e-4, 0, 0))
    assert not holds(turn, "physics:localPos0", (0, 0, 0.501))
    assert not holds(turn, "newton:velocityLimit", 3.0)
    assert not holds(turn, "newton:damping", 0.5)
    assert not holds(f"{tip}/box", "xformOp:orient", Gf.Quatd(1, 1e-4, 0, 0).GetNormalized())
    assert not holds(f"{tip}/box", "xformOp:scale", (0.2, 0.4, 0.601))
    assert not holds("/arm/Physics/follow", "newton:mimicCoef0", 1.0)


def test_results_of_the_parts(tmp_path: Path) -> None:
    tip = (
        f'{INERTIAL}<visual name="v">{BOX}<material name="m"><color rgba="1 0 0 1"/></material>'
        f"</visual><collision>{BOX}</collision>"
    )
    dynamics = '<dynamics damping="1" friction="2"/><safety_controller k_velocity="1"/>'
    more = (
        '<link name="end"/><joint name="f" type="fixed"><parent link="tip"/><child link="end"/>'
        '</joint><gazebo reference="tip"><mu1>1</mu1></gazebo>'
    )
    stage, parts = loaded(arm(LIMIT + dynamics, tip=tip, more=more), tmp_path / "o")
    turn = stage.GetPrimAtPath("/arm/Physics/turn")
    assert turn.GetAttribute("physics:upperLimit").Get() == pytest.approx(np.degrees(2))
    assert stage.GetPrimAtPath("/arm/Geometry/base/tip/v").IsA(UsdGeom.Cube)
    stored = "stored under urdf:, which no simulator reads"
    for part, result in {
        "joint/turn/limit@lower": "kept: limits",
        "joint/turn/limit@velocity": "kept: newton:velocityLimit",
        "joint/turn/limit@effort": f"approximated: {stored}",
        "joint/turn/dynamics@damping": "kept: newton:damping",
        "joint/turn/safety_controller@k_velocity": f"approximated: {stored}",
        "joint/f": "kept: pose of the prim",
        "link/tip/visual/v/material/m/color": "kept: material",
        "gazebo/tip/mu1": f"lost: {stored}",
    }.items():
        assert parts[part] == result


def test_warnings_have_source_lines(tmp_path: Path) -> None:
    capsule = '<collision><geometry><capsule radius="1" length="2"/></geometry></collision>'
    _, parts = loaded(arm(LIMIT, tip=INERTIAL + capsule), tmp_path / "o")
    assert parts["link/tip/collision/geometry/capsule"] == "lost: Invalid geometry type"


@pytest.mark.parametrize("angle", [3e-4, 7.5e-8])
def test_a_small_rotation_is_kept(angle: float, tmp_path: Path) -> None:
    """USD makes no rotation of 3e-4 rad in single precision, and evaluates 7.5e-8 with an error."""
    text = arm(LIMIT).data.replace(b'xyz="0 0 0.5"', b'xyz="0 0 0.5" rpy="%r 0 0"' % angle)
    proof = convert(read(Source("arm.urdf", text)), tmp_path / "o", to="usd").proof
    assert proof.differences["frames"] < 1e-15


def test_the_namespace_of_a_robot_is_ignored(tmp_path: Path) -> None:
    schema = (
        b'<robot xmlns="http://a.b/urdf" xmlns:xsi="http://c.d/xsi" xsi:schemaLocation="urdf.xsd"'
    )
    text = arm(LIMIT).data.replace(b"<robot", schema)
    found = convert(read(Source("arm.urdf", text)), tmp_path / "o", to="usd")
    assert found.proof.holds
    assert not any("xmlns" in entry.part for entry in found.entries)


@pytest.mark.parametrize("kind", ["revolute", "planar"])
def test_axes_near_a_coordinate_axis_are_kept(kind: str, tmp_path: Path) -> None:
    """The converter rounds axes, and the rotations of the frames of joints."""
    text = arm(f'<axis xyz="5e-5 0 1"/>{LIMIT}', kind=kind).data
    text = text.replace(b'xyz="0 0 0.5"', b'xyz="0 0 0.5" rpy="3e-4 0 0"')
    proof = convert(read(Source("arm.urdf", text)), tmp_path / "o", to="usd").proof
    assert proof.differences["axes"] < 1e-6


def test_small_rotations_of_shapes_are_kept(tmp_path: Path) -> None:
    at = '<origin xyz="0 0 1" rpy="3e-4 0.5 0"/>'
    tip = f"{INERTIAL}<visual>{at}{BOX}</visual><collision>{at}{BOX}</collision>"
    proof = convert(read(arm(LIMIT, tip=tip)), tmp_path / "o", to="usd").proof
    assert proof.differences["shapes"] < 1e-6


def test_quaternions_of_urdf_1_1(tmp_path: Path) -> None:
    quaternion = 'xyz="0 0 0.5" quat_xyzw="0.1 0.2 0.3 0.9"'
    inertial = INERTIAL.replace('iyy="0.1"', 'iyy="0.12"')
    inertial = inertial.replace("<inertial>", f"<inertial><origin {quaternion}/>")
    robot = arm(LIMIT, tip=f"{inertial}<visual><origin {quaternion}/>{BOX}</visual>").data
    robot = robot.replace(b'name="arm"', b'name="arm" version="1.1"')
    robot = robot.replace(b'xyz="0 0 0.5"/>', quaternion.encode() + b"/>")
    _, parts = loaded(Source("arm.urdf", robot), tmp_path / "o")
    assert parts["link/tip/visual/origin@quat_xyzw"] == "kept: geometry"


def test_a_general_warning_loses_no_part(tmp_path: Path) -> None:
    """A texture makes the converter warn of a function of its own that is deprecated."""
    Image.new("RGB", (2, 2)).save(tmp_path / "t.png")
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
    material = '<material name="m"><texture filename="t.png"/></material>'
    mesh = f'<visual><geometry><mesh filename="m.obj"/></geometry>{material}</visual>'
    robot = tmp_path / "arm.urdf"
    robot.write_bytes(arm(LIMIT, tip=f"{INERTIAL}{mesh}<visual>{BOX}{material}</visual>").data)
    _, parts = loaded(robot, tmp_path / "o")
    assert parts["robot"].startswith("kept")
    assert parts["link/tip/visual"].startswith("kept")
    note = "approximated: Textures are not projection mapped for Cube, Sphere, and Cylinder"
    assert parts["link/tip/visual[2]"].startswith(note)


@pytest.mark.parametrize(
    ("robot", "reason"),
    [
        (arm(LIMIT, more='<link name="other"/>'), "do not form one tree"),
        (
            Source("r.urdf", arm().data.replace(b"0 0 0.5", b"0 0.5")),
            "xyz of <origin> is '0 0.5'; write 3 finite",
        ),
        (
            Source("r.urdf", arm(LIMIT).data.replace(b' iyz="0"', b"")),
            "link 'base': <inertia> has no iyz; write all six moments",
        ),
        (arm(LIMIT + '<mimic joint="m"/>'), "arm.urdf:4:152: urdf-usd-converter rejects the robot"),
        (Source("r.urdf", arm(LIMIT).data.replace(b' name="arm"', b"")), "<robot> has no name"),
    ],
)
def test_an_unconvertible_robot_writes_nothing(robot: Source, reason: str, tmp_path: Path) -> None:
    with pytest.raises(UrdfkitError) as raised:
        convert(read(robot), tmp_path / "o", to="usd")
    assert reason in str(raised.value)
    assert re.match(PLACE_AND_REMEDY, str(raised.value))
    assert list(tmp_path.iterdir()) == []


def test_a_robot_name_with_slashes_is_not_a_path(tmp_path: Path) -> None:
    text = arm(LIMIT).data.replace(b'name="arm"', b'name="../../arm"')
    found = convert(read(Source("arm.urdf", text)), tmp_path / "o" / "o", to="usd")
    assert found.file == "arm.usda"
    assert [path.name for path in tmp_path.iterdir()] == ["o"]


def test_options_of_mjcf_are_an_error(tmp_path: Path) -> None:
    with pytest.raises(UrdfkitError, match="'usd' does not support base"):
        convert(read(arm(LIMIT)), tmp_path / "o", to="usd", base="free")


def test_a_conversion_can_be_pickled(tmp_path: Path) -> None:
    """As docs/security.md shows, for those who want to survive a crash."""
    robot = tmp_path / "arm.urdf"
    robot.write_bytes(arm(LIMIT).data)
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        found = pool.submit(convert, robot, tmp_path / "o", to="usd").result()
    assert found.proof.holds
    assert (tmp_path / "o" / found.file).is_file()
