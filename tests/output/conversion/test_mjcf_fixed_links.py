"""Fixed links in MJCF: merged, or bodies of their own."""

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from tests.output.conversion.test_mjcf import INERTIAL, LIMIT, arm, loaded
from tests.physics.dynamics.test_against_pinocchio import robots
from urdfkit import convert, read
from urdfkit.text.source import Source

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
