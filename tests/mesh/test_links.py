"""What mesh commands write follows no link out of the workspace, and no path of a model does."""

from pathlib import Path

import pytest

from tests.conftest import MODELS
from urdfkit.cli import main

pytest.importorskip("manifold3d")

MESH = MODELS / "good" / "two_link_arm" / "meshes" / "forearm.stl"
LINK = '<robot name="r"><link name="lidar"><visual><geometry><mesh filename="{}"/></geometry>{}'
ROBOT = LINK.format("{}", "</visual></link></robot>")


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository with a mesh; next to it lies what is not in it."""
    (tmp_path / "outside").mkdir()
    repository = tmp_path / "repository"
    (repository / ".git").mkdir(parents=True)
    (repository / "meshes").mkdir()
    (repository / "meshes" / "a.stl").write_bytes(MESH.read_bytes())
    monkeypatch.chdir(repository)
    return repository


def files_outside(workspace: Path) -> list[Path]:
    return [*(workspace.parent / "outside").iterdir()]


COMMANDS = [
    "convert meshes/a.stl -o OUT",
    "repair meshes/a.stl -o OUT",
    "simplify meshes/a.stl --triangles 100 -o OUT",
    "hull meshes/a.stl -o OUT",
    "decompose meshes/a.stl -o OUT",
    "generate OUT --part rplidar_a2",
]


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("out", ["link.obj", "away/out.obj"])
def test_an_output_that_a_link_leads_away(
    command: str, out: str, workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (workspace / "link.obj").symlink_to(workspace.parent / "outside" / "out.obj")
    (workspace / "away").symlink_to(workspace.parent / "outside")
    assert main(["mesh", *command.replace("OUT", out).split()]) == 2
    assert "a link leads to" in capsys.readouterr().err
    assert files_outside(workspace) == []


def test_the_file_itself(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = workspace.parent / "outside" / "b.stl"
    target.write_bytes(MESH.read_bytes())
    (workspace / "b.stl").symlink_to(target)
    assert main(["mesh", "hull", "b.stl", "--write"]) == 2
    assert target.read_bytes() == MESH.read_bytes()


def test_a_file_next_to_the_output(workspace: Path) -> None:
    target = workspace.parent / "outside" / "rc"
    target.write_text("mine")
    (workspace / "lidar.mtl").symlink_to(target)
    assert main(["mesh", "generate", "lidar.obj", "--part", "rplidar_a2"]) == 2
    assert target.read_text() == "mine"
    assert not (workspace / "lidar.obj").exists()


def test_a_link_within_the_workspace(workspace: Path) -> None:
    (workspace / "out.stl").symlink_to(workspace / "meshes" / "b.stl")
    assert main(["mesh", "hull", "meshes/a.stl", "-o", "out.stl"]) == 0
    assert (workspace / "meshes" / "b.stl").is_file()


@pytest.mark.parametrize("reference", ["../outside/rplidar.dae", "lidar.dae", "away/lidar.dae"])
def test_a_mesh_that_a_model_places_outside(
    reference: str, workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (workspace / "lidar.dae").symlink_to(workspace.parent / "outside" / "rplidar.dae")
    (workspace / "away").symlink_to(workspace.parent / "outside")
    (workspace / "r.urdf").write_text(ROBOT.format(reference))
    assert main(["mesh", "generate", "--model", "r.urdf"]) == 1
    assert "is outside the workspace" in " ".join(capsys.readouterr().out.split())
    assert main(["fix", "r.urdf", "--unsafe-fixes"]) in (0, 1)
    assert files_outside(workspace) == []


def test_a_collision_that_a_link_leads_away(
    workspace: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from urdfkit.mesh import solids
    from urdfkit.mesh.writers import write

    angle = solids.box((1.0, 0.1, 0.1)) + solids.box((0.1, 1.0, 0.1)).translate((0.5, 0.5, 0))
    write(solids.as_mesh(angle), workspace / "meshes" / "l.stl")
    for number in range(9):
        end = f"_{number}" if number else ""
        link = workspace / "meshes" / f"l_collision{end}.stl"
        link.symlink_to(workspace.parent / "outside" / f"{number}.stl")
    (workspace / "r.urdf").write_text(ROBOT.format("meshes/l.stl"))
    assert main(["mesh", "collision", "r.urdf", "--write", "--error", "0.01"]) == 1
    assert "is outside the workspace" in " ".join(capsys.readouterr().out.split())
    assert files_outside(workspace) == []


def test_a_texture_names_no_other_kind_of_file(workspace: Path) -> None:
    (workspace / "in").mkdir()
    (workspace / "out").mkdir()
    (workspace / "out" / "Makefile").write_text("mine")
    (workspace / "in" / "Makefile").write_text("theirs")
    (workspace / "in" / "a.mtl").write_text("newmtl a\nmap_Kd Makefile\n")
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\n"
    faces = "f 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/1 4/1 3/1\nf 2/1 3/1 4/1\n"
    (workspace / "in" / "a.obj").write_text(f"mtllib a.mtl\n{corners}usemtl a\n{faces}")
    assert main(["mesh", "convert", "in/a.obj", "-o", "out/b.obj"]) == 0
    assert (workspace / "out" / "Makefile").read_text() == "mine"
