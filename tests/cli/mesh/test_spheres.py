"""The command about spheres: its formats, what it prints, and its exit codes."""

import json
from pathlib import Path

import pytest
import yaml

pytest.importorskip("trimesh", reason="meshes need the extra meshes")

from tests.shipped import ARM
from urdfkit import load
from urdfkit.cli import main

pytestmark = pytest.mark.usefixtures("rough_meshes")

BALLS = """<robot name="balls"><link name="base"><collision><origin xyz="0 0 1"/><geometry>
<sphere radius="0.1"/></geometry></collision></link>
<link name="arm"><collision><geometry><box size="0.02 0.02 0.02"/></geometry></collision></link>
<link name="tip"/>
<joint name="turn" type="continuous"><parent link="base"/><child link="arm"/>
<axis xyz="0 0 1"/></joint>
<joint name="end" type="fixed"><parent link="arm"/><child link="tip"/></joint></robot>"""


@pytest.fixture
def balls(tmp_path: Path) -> str:
    file = tmp_path / "balls.urdf"
    file.write_text(BALLS)
    return str(file)


def test_spheres_of_curobo(balls: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("coal")
    out = tmp_path / "balls.yml"
    assert main(["mesh", "spheres", balls, "-o", str(out)]) == 0
    kinematics = yaml.safe_load(out.read_text())["robot_cfg"]["kinematics"]
    assert kinematics["base_link"] == "base"
    assert kinematics["collision_link_names"] == ["base", "arm"]
    assert kinematics["self_collision_ignore"] == {"base": ["arm"]}
    (ball,) = kinematics["collision_spheres"]["base"]
    assert ball == {"center": [0, 0, 1], "radius": 0.1}
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[:2] for line in lines[1:4]] == [
        ["base", "1"],
        ["arm", "1"],
        ["total", "2"],
    ]


def test_xrdf(balls: str, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("coal")
    assert main(["mesh", "spheres", balls, "--format", "xrdf"]) == 0
    found = yaml.safe_load(capsys.readouterr().out)
    assert (found["format"], found["format_version"]) == ("xrdf", 1.0)
    assert found["cspace"]["joint_names"] == ["turn"]
    assert found["tool_frames"] == ["tip"]
    assert found["self_collision"]["ignore"] == {"base": ["arm"]}
    name = found["collision"]["geometry"]
    assert list(found["geometry"][name]["spheres"]) == ["base", "arm"]


def test_urdf_has_spheres_for_collisions(tmp_path: Path) -> None:
    out = tmp_path / "arm.urdf"
    assert main(["mesh", "spheres", ARM, "--format", "urdf", "-o", str(out), "--most", "9"]) == 0
    before, after = load(ARM), load(str(out))
    assert [joint.name for joint in after.joints] == [joint.name for joint in before.joints]
    shapes = [body.shape for link in after.links for body in link.collisions]
    assert {shape.kind for shape in shapes if shape} == {"sphere"}
    assert len(shapes) <= 9
    visuals = [len(link.visuals) for link in before.links]
    assert [len(link.visuals) for link in after.links] == visuals


def test_json_and_omitted_geometry(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "gone.urdf"
    gone = '<collision><geometry><mesh filename="gone.stl"/></geometry></collision>'
    file.write_text(BALLS.replace('<link name="tip"/>', f'<link name="tip">{gone}</link>'))
    assert main(["mesh", "spheres", str(file), "--format", "json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["left_out"] == ["collision 1 of link 'tip' is left out: the file is missing"]
    assert found["total"]["number"] == 2
    assert found["links"][0]["radii"] == [0.1]
    assert found["links"][0]["coverage"] == 1


def test_visual_geometry(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "seen.urdf"
    file.write_text(BALLS.replace("collision", "visual"))
    assert main(["mesh", "spheres", str(file), "--visual", "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["total"]["number"] == 2


def test_without_geometry(balls: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh", "spheres", balls, "--visual"]) == 2
    error = capsys.readouterr().err
    assert "no link has geometry to cover" in error
    assert "--visual" not in error


def test_visual_geometry_only_suggests_the_option(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "seen.urdf"
    file.write_text(BALLS.replace("collision", "visual"))
    assert main(["mesh", "spheres", str(file)]) == 2
    error = capsys.readouterr().err
    assert "no link has geometry to cover; only visual geometry" in error
    assert "--visual" in error


@pytest.mark.parametrize(
    ("shape", "why"),
    [
        ('<box size="1 1 1e-9"/>', "its <box> has no size, or an implausible one"),
        ('<mesh filename="no.stl"/>', "the file is missing"),
    ],
)
def test_a_reason_is_given(shape: str, why: str, tmp_path: Path, capsys) -> None:
    file = tmp_path / "r.urdf"
    file.write_text(
        f'<robot name="r"><link name="a"><collision><geometry>{shape}</geometry></collision>'
        "</link></robot>"
    )
    assert main(["mesh", "spheres", str(file)]) == 2
    assert f"collision 1 of link 'a' is left out: {why}" in capsys.readouterr().err


def test_a_robot_of_spheres(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "ball.urdf"
    file.write_text(
        '<robot name="ball"><link name="base"><collision><geometry><sphere radius="0.02"/>'
        "</geometry></collision></link></robot>"
    )
    assert main(["mesh", "spheres", str(file), "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["links"][0]["radii"] == [0.02]
