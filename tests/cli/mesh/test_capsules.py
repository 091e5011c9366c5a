"""The command about capsules: its formats, and who reads them."""

import json
from pathlib import Path

import pytest

pytest.importorskip("trimesh", reason="meshes need the extra meshes")

import numpy as np

from tests.shipped import ARM
from urdfkit import load
from urdfkit.cli import main
from urdfkit.robot.link import Shape

pytestmark = pytest.mark.usefixtures("rough_meshes")

#: A capsule and a sphere, which are exact, and a box.
ROBOT = """<robot name="r" version="1.1"><link name="base">
<collision><origin xyz="0 0 1" rpy="0 1.5707963 0"/><geometry><capsule radius="0.1" length="0.4"/>
</geometry></collision><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
<link name="arm"><collision><geometry><box size="0.02 0.02 0.2"/></geometry></collision></link>
<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint></robot>"""


def shapes(path: Path | str) -> dict[str, list[Shape]]:
    return {
        link.name: [body.shape for body in link.collisions if body.shape]
        for link in load(str(path)).links
    }


@pytest.fixture
def robot(tmp_path: Path) -> str:
    file = tmp_path / "robot.urdf"
    file.write_text(ROBOT)
    return str(file)


def test_urdf_has_a_capsule_for_each_link(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "arm.urdf"
    assert main(["mesh", "capsules", ARM, "-o", str(out), "--margin", "0.5"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[:2] for line in lines[1:5]] == [
        ["base", "1"],
        ["upper_arm", "1"],
        ["forearm", "1"],
        ["total", "3"],
    ]
    assert {len(found) for found in shapes(out).values()} <= {0, 1}
    assert {shape.kind for found in shapes(out).values() for shape in found} == {"capsule"}
    assert 'version="1.1"' in out.read_text()
    joints = [joint.name for joint in load(ARM).joints]
    assert [joint.name for joint in load(str(out)).joints] == joints


def test_urdf_1_0_has_a_cylinder_and_two_spheres(tmp_path: Path) -> None:
    out, with_capsules = tmp_path / "arm.urdf", tmp_path / "capsules.urdf"
    options = ["--margin", "0.5", "-o"]
    assert main(["mesh", "capsules", ARM, "--format", "urdf-1.0", *options, str(out)]) == 0
    assert main(["mesh", "capsules", ARM, *options, str(with_capsules)]) == 0
    assert "version" not in out.read_text().split("<robot", 1)[1].split(">", 1)[0]
    for link, (capsule,) in ((a, b) for a, b in shapes(with_capsules).items() if b):
        sphere, cylinder, other = shapes(out)[link]
        kinds = (sphere.kind, cylinder.kind, other.kind)
        assert kinds == ("sphere", "cylinder", "sphere")
        assert {sphere.radius, cylinder.radius, other.radius} == {capsule.radius}
        assert cylinder.length == capsule.length


def test_mujoco_has_the_same_capsules(robot: str, tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    out = tmp_path / "capsules.urdf"
    assert main(["mesh", "capsules", robot, "-o", str(out)]) == 0
    model = mujoco.MjModel.from_xml_path(str(out))
    kinds = [mujoco.mjtGeom(kind).name for kind in model.geom_type]
    assert kinds == ["mjGEOM_CAPSULE", "mjGEOM_SPHERE", "mjGEOM_CAPSULE"]
    assert model.geom_size[:2] == pytest.approx(np.array([[0.1, 0.2, 0], [0.2, 0, 0]]))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    axis = data.geom_xmat[0].reshape(3, 3)[:, 2]
    assert np.abs(axis) == pytest.approx([1, 0, 0], abs=1e-6)
    assert data.geom_xpos[0] == pytest.approx([0, 0, 1])


def test_json_has_exact_shapes_as_they_are(robot: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh", "capsules", robot, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    base, arm = found["links"]
    assert base["radii"] == [0.1, 0.2]
    (start, end), (center, same) = base["segments"]
    assert [start, end] == [pytest.approx([-0.2, 0, 1]), pytest.approx([0.2, 0, 1])]
    assert center == same == [0, 0, 0]
    assert (arm["number"], found["total"]["number"]) == (1, 3)
    assert arm["coverage"] > 0.95


def test_omitted_geometry_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "gone.urdf"
    file.write_text(ROBOT.replace('<box size="0.02 0.02 0.2"/>', '<mesh filename="gone.stl"/>'))
    assert main(["mesh", "capsules", str(file), "--format", "json"]) == 1
    left_out = json.loads(capsys.readouterr().out)["left_out"]
    assert left_out == ["collision 1 of link 'arm' is left out: the file is missing"]
    assert main(["mesh", "capsules", str(file), "--visual"]) == 2
