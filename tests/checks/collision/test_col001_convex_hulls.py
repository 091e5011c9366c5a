"""COL001 for programs that collide convex hulls, beside MuJoCo itself."""

from pathlib import Path

import pytest

from tests.naming import naming
from urdfkit import check
from urdfkit.mesh import samples
from urdfkit.text.diagnostic import Diagnostic

pytest.importorskip("coal")
INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
)
#: Two walls on a floor: its hull fills the gap between them.
CHANNEL = [
    *samples.box((0, 0, 0), (0.5, 0.3, 0.02)),
    *samples.box((0, 0, 0), (0.5, 0.02, 0.3)),
    *samples.box((0, 0.28, 0), (0.5, 0.3, 0.3)),
]
#: The axle is in the gap, 0.1 m below the upper edge of the walls.
AXLE = '<geometry><cylinder radius="0.03" length="0.4"/></geometry>'


def robot(directory: Path, *, foot: str = "fixed", between: str = "") -> Path:
    """A channel, on a foot, and an axle in it; ``between`` may hold a link between the two."""
    (directory / "channel.stl").write_bytes(samples.stl(CHANNEL))
    parent = "middle" if between else "channel"
    path = directory / "r.urdf"
    path.write_text(
        f'<robot name="r"><link name="foot">{INERTIAL}</link>'
        f'<link name="channel">{INERTIAL}<collision><geometry>'
        f'<mesh filename="channel.stl"/></geometry></collision></link>'
        f'<link name="axle">{INERTIAL}<collision><origin rpy="0 1.5707963267948966 0"/>{AXLE}'
        f"</collision></link>{between}"
        f'<joint name="stand" type="{foot}"><parent link="foot"/><child link="channel"/></joint>'
        f'<joint name="turn" type="continuous"><parent link="{parent}"/><child link="axle"/>'
        '<origin xyz="0.25 0.15 0.2"/><axis xyz="1 0 0"/></joint></robot>'
    )
    return path


def found(path: Path, target: str) -> list[Diagnostic]:
    return [
        one
        for one in check(path, select=["COL001"], targets=[target]).diagnostics
        if "convex hulls" in one.message
    ]


def depth_in_mujoco(path: Path) -> float:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return -min((contact.dist for contact in data.contact), default=0.0)


MIDDLE = (
    f'<link name="middle">{INERTIAL}</link><joint name="slide" type="prismatic">'
    '<parent link="channel"/><child link="middle"/><axis xyz="1 0 0"/>'
    '<limit lower="-0.1" upper="0.1" effort="1" velocity="1"/></joint>'
)


@pytest.mark.parametrize(
    ("foot", "between"),
    [("fixed", ""), ("fixed", MIDDLE), ("continuous", MIDDLE)],
)
def test_the_depth_is_that_of_mujoco(tmp_path: Path, foot: str, between: str) -> None:
    path = robot(tmp_path, foot=foot, between=between)
    (one,) = found(path, "mujoco")
    depth = depth_in_mujoco(path)
    assert depth == pytest.approx(0.13, abs=1e-3)
    assert one.message == naming("channel", "axle", "MuJoCo", "130 mm")
    assert one.help == naming("channel", "<collision>", "--split", "-o")


def test_convex_pieces_do_not_collide(tmp_path: Path) -> None:
    path = robot(tmp_path)
    boxes = [CHANNEL[start : start + 12] for start in (0, 12, 24)]
    mesh = '<collision><geometry><mesh filename="channel.stl"/></geometry></collision>'
    for number, piece in enumerate(boxes):
        (tmp_path / f"channel_{number}.stl").write_bytes(samples.stl(piece))
    pieces = [mesh.replace("channel", f"channel_{number}") for number in range(3)]
    path.write_text(path.read_text().replace(mesh, "".join(pieces)))
    assert found(path, "mujoco") == []
    assert depth_in_mujoco(path) == 0


def test_pieces_do_not_help_where_the_shapes_overlap(tmp_path: Path) -> None:
    path = robot(tmp_path)
    path.write_text(path.read_text().replace('"0.25 0.15 0.2"', '"0.25 0.04 0.2"'))
    (one,) = found(path, "mujoco")
    assert one.help.startswith("the shapes overlap")


def test_a_link_does_not_collide_with_the_one_that_carries_it(tmp_path: Path) -> None:
    path = robot(tmp_path, foot="continuous")
    assert found(path, "mujoco") == []
    assert depth_in_mujoco(path) == 0


@pytest.mark.parametrize("target", ["isaac", "pybullet"])
def test_others_ignore_neighbours_of_a_welded_base_too(tmp_path: Path, target: str) -> None:
    assert found(robot(tmp_path), target) == []
    assert len(found(robot(tmp_path, between=MIDDLE), target)) == 1


@pytest.mark.parametrize("between", ["", MIDDLE])
def test_pybullet_collides_hulls(tmp_path: Path, between: str) -> None:
    """PyBullet adds a margin of 1 mm to each shape."""
    pybullet = pytest.importorskip("pybullet")
    path = robot(tmp_path, between=between)
    pybullet.connect(pybullet.DIRECT)
    flags = pybullet.URDF_USE_SELF_COLLISION
    body = pybullet.loadURDF(str(path), useFixedBase=True, flags=flags)
    pybullet.stepSimulation()
    depth = -min((contact[8] for contact in pybullet.getContactPoints(body, body)), default=0.0)
    pybullet.disconnect()
    assert depth == pytest.approx(0.13 if between else 0, abs=3e-3)


def test_others_collide_the_triangles(tmp_path: Path) -> None:
    assert found(robot(tmp_path), "moveit") == []
