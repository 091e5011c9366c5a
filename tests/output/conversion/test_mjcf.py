"""What MuJoCo loads is the robot: masses, frames and dynamics equal those of Pinocchio."""

import json
import re
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.output.conversion.converted import assert_whole, of_corpus, results
from tests.own_robots import ROVER, own_robots
from urdfkit import convert, read
from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.text.source import Source

mujoco = pytest.importorskip("mujoco")
np = pytest.importorskip("numpy")
pytest.importorskip("pinocchio")
pytest.importorskip("trimesh")

from tests.physics.dynamics.test_against_pinocchio import robots
from urdfkit.core.spatial import IDENTITY
from urdfkit.output.conversion.mjcf_geoms import Geoms
from urdfkit.output.conversion.mjcf_proof import MAX_ERROR, MAX_OFFSET, prove
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.output.conversion.result import REPORT, proven

#: Each tree is converted, loaded and compared in 100 poses, which takes 0.1 s.
FEWER = settings(max_examples=settings().max_examples // 3)

#: Of what a conversion is refused for.
PLACE_AND_REMEDY = r"\w+\.urdf:\d+:\d+: .+; [^;]+"

BOX = '<geometry><box size="0.2 0.4 0.6"/></geometry>'
INERTIAL = (
    '<inertial><mass value="2"/>'
    '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
)


def arm(joint: str = "", tip: str = INERTIAL, more: str = "", kind: str = "revolute") -> Source:
    """Two links on a joint."""
    text = (
        f'<robot name="arm">\n<link name="base">{INERTIAL}</link>\n'
        f'<link name="tip">{tip}</link>\n'
        f'<joint name="turn" type="{kind}"><parent link="base"/><child link="tip"/>'
        f'<origin xyz="0 0 0.5"/>{joint}</joint>\n{more}</robot>'
    )
    return Source("arm.urdf", text.encode())


LIMIT = '<limit lower="-1" upper="2" effort="7" velocity="3"/>'


def loaded(robot: Source | Path, out: Path, **options: Any) -> tuple[Any, dict[str, str]]:
    """The model that MuJoCo loads, and what became of each part."""
    found = convert(read(robot), out, **options)
    model = mujoco.MjModel.from_xml_path(str(out / found.file))
    return model, results(found)


@own_robots
def test_robots_of_the_project(path: Path, tmp_path: Path) -> None:
    convert(path, tmp_path / "out")
    proof = json.loads((tmp_path / "out" / REPORT).read_text())["proof"]
    assert proof["frames"] < MAX_OFFSET / 1e3
    assert proof["mass_matrix"] < MAX_ERROR / 1e3
    assert proof["holds"] is True


@needs_corpus
@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_robots_of_the_corpus(entry: CorpusRobot, tmp_path: Path) -> None:
    assert_complete(of_corpus(entry, tmp_path / "o", "mjcf"))


def assert_complete(found: Any) -> None:
    """Every part has one entry, and those that are lost or approximated have a reason."""
    assert max(Counter((one.part, one.span) for one in found.entries).values()) == 1
    assert all(one.note for one in found.entries)


@settings(FEWER, suppress_health_check=list(HealthCheck), derandomize=True)
@given(robots())
def test_random_trees(tmp_path_factory: pytest.TempPathFactory, text: str) -> None:
    robot = read(Source("r.urdf", text.encode()))
    found = convert(robot, tmp_path_factory.mktemp("tree") / "out")
    assert_whole(robot, found)


def test_the_proof_fails_for_a_wrong_model(tmp_path: Path) -> None:
    robot = read(arm(LIMIT))
    file = tmp_path / "o" / convert(robot, tmp_path / "o").file
    model = mujoco.MjModel.from_xml_path(str(file))
    assert prove(model, robot, {}).holds
    model.body("tip").mass += 0.001
    assert not prove(model, robot, {}).holds
    model = mujoco.MjModel.from_xml_path(str(file))
    model.body("tip").pos += 1e-8
    found = prove(model, robot, {})
    assert not found.holds
    with pytest.raises(UrdfkitError, match=PLACE_AND_REMEDY) as raised:
        proven(found, robot)
    assert str(raised.value).startswith("arm.urdf:3:1: MuJoCo and Pinocchio do not agree")


def test_contacts_are_not_computed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Thousands of overlapping shapes exceed the memory of MuJoCo."""
    flags: list[int] = []
    forward = mujoco.mj_forward

    def noted(model: Any, data: Any) -> None:
        flags.append(model.opt.disableflags)
        forward(model, data)

    monkeypatch.setattr(mujoco, "mj_forward", noted)
    convert(read(arm()), tmp_path / "arm", to="mjcf")
    assert flags
    assert all(flag & mujoco.mjtDisableBit.mjDSBL_CONTACT for flag in flags)


def test_the_proof_fails_for_different_dynamics(tmp_path: Path) -> None:
    """A joint with a vertical axis bears nothing, unless gravity points another way."""
    outwards = INERTIAL.replace("<inertial>", '<inertial><origin xyz="0.3 0 0"/>')
    robot = read(arm('<axis xyz="0 0 1"/>' + LIMIT, tip=outwards))
    file = tmp_path / "o" / convert(robot, tmp_path / "o").file
    model = mujoco.MjModel.from_xml_path(str(file))
    assert prove(model, robot, {}).differences["gravity"] == 0
    model.opt.gravity = (0, -9.81, 0)
    assert (
        prove(model, robot, {}).differences["mass_matrix"]
        < MAX_ERROR
        < prove(model, robot, {}).differences["gravity"]
    )
    model.body("tip").inertia *= 1.0001
    assert prove(model, robot, {}).differences["mass_matrix"] > MAX_ERROR


#: A robot with one of each, and errors in the writer: a method, the body or joint, what it sets.
WHOLE = arm(
    LIMIT + '<dynamics damping="0.5" friction="0.2"/>',
    tip=f'{INERTIAL}<visual>{BOX}</visual><collision><origin xyz="0 0 1"/>{BOX}</collision>',
    more=f'<link name="drone">{INERTIAL}</link><joint name="flies" type="floating">'
    '<parent link="tip"/><child link="drone"/></joint>'
    f'<link name="finger">{INERTIAL}</link><joint name="follow" type="revolute">'
    f'<parent link="tip"/><child link="finger"/>{LIMIT}<mimic joint="turn" offset="1"/></joint>',
)
ERRORS = [
    (MjcfRobot, "_inertial", "base", {"ipos": (0.1, 0, 0)}),
    (MjcfRobot, "_inertial", "base", {"inertia": (0.1, 0.1, 0.101)}),
    (MjcfRobot, "_inertial", "drone", {"ipos": (1e-4, 0, 0)}),
    (MjcfRobot, "_limits", "turn", {"range": (-9, 9)}),
    (MjcfRobot, "_limits", "turn", {"limited": False}),
    (MjcfRobot, "_limits", "turn", {"actfrcrange": (-1, 1)}),
    (MjcfRobot, "_damping", "turn", {"damping": (9, 0, 0)}),
    (MjcfRobot, "_damping", "turn", {"frictionloss": 0}),
    (Geoms, "_placed", "tip", {"pos": (1, 1, 1)}),
    (Geoms, "_placed", "tip", {"size": (0.1, 0.2, 0.4)}),
    (Geoms, "_placed", "tip", {"group": 0}),
    (Geoms, "_placed", "tip", {"type": mujoco.mjtGeom.mjGEOM_ELLIPSOID}),
]


@pytest.mark.parametrize(("owner", "method", "part", "fields"), ERRORS)
def test_errors_of_the_writer(
    owner: type,
    method: str,
    part: str,
    fields: dict[str, Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    write = getattr(owner, method)

    def wrong(self: Any, made: Any, *more: Any) -> Any:
        result = write(self, made, *more)
        for name, value in fields.items() if made.name == part else ():
            setattr(result or made, name, value)
        return result

    convert(read(WHOLE), tmp_path / "right", base="free")
    monkeypatch.setattr(owner, method, wrong)
    with pytest.raises(UrdfkitError, match="do not agree on the robot"):
        convert(read(WHOLE), tmp_path / "wrong", base="free")


@pytest.mark.parametrize("offset", [None, 1.1])
def test_missing_or_wrong_equalities(
    offset: float | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    couple = MjcfRobot._couple

    def wrong(self: MjcfRobot, tree: Any) -> None:
        if offset is not None:
            couple(self, tree)
            self.spec.equalities[0].data[0] = offset

    monkeypatch.setattr(MjcfRobot, "_couple", wrong)
    with pytest.raises(UrdfkitError, match=r"joints 0?\.?1"):
        convert(read(WHOLE), tmp_path / "o")


def test_an_error_of_urdfkits_parser(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pinocchio reads the text, whatever urdfkit makes of it."""
    monkeypatch.setattr("urdfkit.robot.origin._rotation", lambda _: IDENTITY)
    turned = arm(LIMIT).data.replace(b'0 0 0.5"', b'0 0 0.5" rpy="0 1 0"')
    with pytest.raises(UrdfkitError, match="do not agree on the robot"):
        convert(read(Source("arm.urdf", turned)), tmp_path / "o")


def test_a_robot_that_pinocchio_rejects(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    proof = convert(read(arm()), tmp_path / "o").proof
    assert proof.holds
    assert "of the URDF as urdfkit reads it" in proof.agreed
    assert capfd.readouterr().err == ""


def test_joints_have_their_limits_friction_and_actuators(tmp_path: Path) -> None:
    model, parts = loaded(arm(LIMIT + '<dynamics damping="0.5" friction="0.2"/>'), tmp_path / "o")
    turn = model.joint("turn")
    assert turn.range.tolist() == [-1, 2]
    assert (turn.damping[0], turn.frictionloss[0]) == (0.5, 0.2)
    assert model.jnt_actfrcrange[turn.id].tolist() == [-7, 7]
    assert model.actuator("turn").ctrlrange.tolist() == [-7, 7]
    assert parts["joint/turn/limit@velocity"].startswith("lost: ")
    assert parts["joint/turn/limit@effort"] == "kept: actuatorfrcrange"
    assert parts["joint/turn/dynamics@damping"] == "kept: damping"


def test_zero_damping_is_kept_and_invalid_damping_is_lost(tmp_path: Path) -> None:
    _, parts = loaded(arm(LIMIT + '<dynamics damping="0" friction="-1"/>'), tmp_path / "o")
    assert parts["joint/turn/dynamics@damping"] == "kept: damping"
    why = "lost: a friction must be a number of at least 0"
    assert parts["joint/turn/dynamics@friction"] == why


def test_equal_limits_lock_the_joint(tmp_path: Path) -> None:
    model, parts = loaded(arm(LIMIT.replace('"2"', '"-1"')), tmp_path / "o")
    assert model.joint("turn").range.tolist() == pytest.approx([-1, -1], abs=2e-6)
    assert parts["joint/turn/limit"].startswith("approximated: ")


@pytest.mark.parametrize(
    ("interface", "gain", "range_"),
    [("position", 70, [-1, 2]), ("velocity", 7, [-3, 3]), ("effort", 1, [-7, 7])],
)
def test_actuators_are_those_of_ros2_control(
    interface: str, gain: float, range_: list[float], tmp_path: Path
) -> None:
    block = (
        '<ros2_control name="c" type="system"><joint name="turn">'
        f'<command_interface name="{interface}"/></joint></ros2_control>'
    )
    model, parts = loaded(arm(LIMIT, more=block), tmp_path / "o")
    actuator = model.actuator("turn")
    assert actuator.gainprm[0] == pytest.approx(gain)
    assert actuator.ctrlrange.tolist() == range_
    at = f"ros2_control/c/joint/turn/command_interface/{interface}"
    assert parts[at] == f"kept: actuator for {interface}"
    assert parts["ros2_control/c"].startswith("approximated: ")


def test_mimic_joints_follow(tmp_path: Path) -> None:
    follower = (
        f'<link name="finger">{INERTIAL}</link><joint name="follow" type="revolute">'
        f'<parent link="tip"/><child link="finger"/>{LIMIT}'
        '<mimic joint="turn" multiplier="-0.5" offset="0.1"/></joint>'
    )
    model, parts = loaded(arm(LIMIT, more=follower), tmp_path / "o")
    assert model.eq_data[0][:2].tolist() == [0.1, -0.5]
    assert [model.joint(model.eq_obj1id[0]).name, model.joint(model.eq_obj2id[0]).name] == [
        "follow",
        "turn",
    ]
    assert model.nu == 1
    assert parts["joint/follow/mimic@offset"] == "kept: equality"


def test_mimics_of_a_planar_joint_are_lost(tmp_path: Path) -> None:
    follower = (
        f'<link name="finger">{INERTIAL}</link><joint name="follow" type="revolute">'
        f'<parent link="tip"/><child link="finger"/>{LIMIT}<mimic joint="turn"/></joint>'
    )
    model, parts = loaded(arm(kind="planar", more=follower), tmp_path / "o")
    assert model.neq == 0
    assert parts["joint/follow/mimic"].startswith("lost: ")


def test_visuals_and_collisions(tmp_path: Path) -> None:
    content = (
        f'{INERTIAL}<visual><origin xyz="0 0 1"/>{BOX}'
        '<material name="red"><color rgba="1 0 0 0.5"/></material></visual>'
        f'<collision name="c">{BOX}</collision><collision name="c">{BOX}</collision>'
    )
    friction = '<gazebo reference="tip"><mu1 value="0.3"/><mu2>0.4</mu2></gazebo>'
    model, parts = loaded(arm(LIMIT, tip=content, more=friction), tmp_path / "o")
    visual, collision = 0, 1
    assert model.geom_contype.tolist() == [0, 1, 1]
    assert model.geom_size.tolist() == [[0.1, 0.2, 0.3]] * 3
    assert [model.geom(number).name for number in range(3)] == ["", "c", "c_2"]
    assert parts["link/tip/collision/c@name"] == "kept: name of the geom"
    assert model.geom_pos[visual].tolist() == [0, 0, 1]
    assert model.geom_rgba[visual].tolist() == [1, 0, 0, 0.5]
    assert parts["link/tip/visual/material/red"] == "kept: rgba of the geom"
    assert model.geom_friction[collision][0] == 0.3
    assert parts["gazebo/tip/mu1"] == "kept: friction"
    assert parts["gazebo/tip/mu2"].startswith("lost: ")


def test_sensors_have_the_poses_of_gazebo(tmp_path: Path) -> None:
    tags = (
        '<gazebo reference="tip"><sensor name="eye" type="camera"><pose>1 0 0 0 0 0</pose>'
        "<camera><horizontal_fov>1.5707963267948966</horizontal_fov>"
        "<image><width>200</width><height>100</height></image></camera></sensor>"
        '<sensor name="imu" type="imu"><pose>0 2 0 0 0 1.5707963267948966</pose></sensor>'
        '<sensor name="scan" type="gpu_lidar"/></gazebo>'
    )
    model, parts = loaded(arm(LIMIT, more=tags), tmp_path / "o")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    forward, up = (
        -data.cam("eye").xmat.reshape(3, 3)[:, 2],
        data.cam("eye").xmat.reshape(3, 3)[:, 1],
    )
    assert np.allclose(data.cam("eye").xpos, [1, 0, 0.5])
    assert np.allclose([forward, up], [[1, 0, 0], [0, 0, 1]])
    assert model.cam("eye").fovy[0] == pytest.approx(np.degrees(2 * np.arctan(0.5)))
    assert np.allclose(data.site("imu").xpos, [0, 2, 0.5])
    assert np.allclose(data.site("imu").xmat.reshape(3, 3)[:, 0], [0, 1, 0])
    assert data.sensor("imu_linear_acceleration").data == pytest.approx([0, 0, 9.81])
    assert parts["gazebo/tip/sensor/scan"].startswith("lost: ")


def test_a_material_without_a_colour_is_lost(tmp_path: Path) -> None:
    named = f'{INERTIAL}<visual>{BOX}<material name="red"/></visual>'
    image = (
        f'{INERTIAL}<visual>{BOX}<material name="w"><texture filename="w.png"/></material></visual>'
    )
    assert loaded(arm(tip=named), tmp_path / "n")[1]["link/tip/visual/material/red"].startswith(
        "lost"
    )
    (tmp_path / "w.png").write_bytes(b"")
    text = arm(tip=image).data
    (tmp_path / "r.urdf").write_bytes(text)
    parts = loaded(tmp_path / "r.urdf", tmp_path / "i")[1]
    assert (
        parts["link/tip/visual/material/w/texture"] == "lost: the shape has no texture coordinates"
    )


@pytest.mark.parametrize(("base", "joints"), [("fixed", 1), ("free", 2), ("auto", 1)])
def test_options_of_the_base(base: str, joints: int, tmp_path: Path) -> None:
    assert loaded(arm(LIMIT), tmp_path / "o", base=base)[0].njnt == joints


def test_a_robot_on_wheels_floats(tmp_path: Path) -> None:
    assert loaded(ROVER, tmp_path / "o")[0].jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE


def test_a_root_named_world_is_the_world(tmp_path: Path) -> None:
    text = arm(LIMIT).data.replace(b'"base"', b'"world"')
    model, parts = loaded(Source("arm.urdf", text), tmp_path / "o")
    assert model.nbody == 2
    assert parts["link/world/inertial"] == "lost: the world does not move"


@pytest.mark.parametrize(
    ("robot", "reason"),
    [
        (arm(LIMIT, tip=""), "arm.urdf:3:1: MuJoCo rejects the robot: mass and inertia"),
        (arm(LIMIT.replace('"2"', '"-3"')), "joint 'turn': its lower limit is above the upper"),
        (arm(LIMIT.replace('"2"', '"inf"')), "joint 'turn': upper of <limit> is 'inf'; write a"),
        (arm('<axis xyz="0 0 0"/>' + LIMIT), "joint 'turn': its axis is 0 0 0"),
        (arm(LIMIT, tip=INERTIAL.replace('"2"', '"2 kg"')), "value of <mass> is '2 kg'"),
        (arm(LIMIT, kind="hinge"), "joint 'turn': its type is 'hinge'"),
        (arm(LIMIT, more='<link name="other"/>'), "do not form one tree"),
        (Source("r.urdf", b'<robot name="r"/>'), "it has no link"),
        (arm(LIMIT, tip=INERTIAL + "<collision><geometry><sphere/></geometry></collision>"),
         "<sphere> of link 'tip' has no size above 0"),
        (Source("r.urdf", arm(LIMIT).data.replace(b'"tip"', b'"world"')),
         "r.urdf:3:1: MuJoCo rejects the robot: repeated name 'world'"),
    ],
)  # fmt: skip
def test_an_unconvertible_robot_writes_nothing(robot: Source, reason: str, tmp_path: Path) -> None:
    with pytest.raises(UrdfkitError) as raised:
        convert(read(robot), tmp_path / "o")
    assert reason in str(raised.value)
    assert re.match(PLACE_AND_REMEDY, str(raised.value))
    assert list(tmp_path.iterdir()) == []


def test_only_a_conversion_is_replaced(tmp_path: Path) -> None:
    convert(read(arm(LIMIT)), tmp_path / "o")
    with pytest.raises(UnwritableFile, match="--force replaces it"):
        convert(read(arm(LIMIT)), tmp_path / "o")
    convert(read(arm(LIMIT)), tmp_path / "o", force=True)
    (tmp_path / "o" / REPORT).unlink()
    with pytest.raises(UnwritableFile):
        convert(read(arm(LIMIT)), tmp_path / "o", force=True)
