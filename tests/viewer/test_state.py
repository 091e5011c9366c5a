"""The viewer looks at every file that a robot is made from."""

import json
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("numpy")
pytest.importorskip("PIL")
pytest.importorskip("jinja2")

from tests.mesh import made
from tests.mesh.made import whole_gltf
from tests.xacros import HEAD
from urdfkit.lint.options import Options
from urdfkit.mesh import samples
from urdfkit.output.report.document import ReportInput, describe
from urdfkit.viewer import state as module
from urdfkit.viewer.state import read

ROBOT = """<robot name="r"><link name="l"><visual><geometry>
<mesh filename="{}"/></geometry></visual></link></robot>"""


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    """Meshes of several files."""
    (tmp_path / "a.obj").write_bytes(made.obj())
    (tmp_path / "a.mtl").write_text("newmtl paint\nKd 1 0 0\nmap_Kd wood.png\n")
    (tmp_path / "a.dae").write_bytes(
        samples.collada(effect='<diffuse><texture texture="image" texcoord="uv"/></diffuse>')
    )
    content = json.loads(whole_gltf())
    (tmp_path / "numbers.bin").write_bytes(bytes(36))
    content["buffers"][0]["uri"] = "numbers.bin"
    (tmp_path / "a.gltf").write_text(json.dumps(content))
    return tmp_path


@pytest.mark.parametrize(
    ("mesh", "changed"),
    [
        ("a.obj", "a.obj"),
        ("a.obj", "a.mtl"),
        ("a.obj", "wood.png"),  # which is missing and comes
        ("a.dae", "wood.png"),
        ("a.gltf", "numbers.bin"),
    ],
)
def test_a_change_of_any_file_is_seen(directory: Path, mesh: str, changed: str) -> None:
    robot = directory / "robot.urdf"
    robot.write_text(ROBOT.format(mesh))
    state = read(str(robot), Options())
    assert not state.files.have_changed
    with (directory / changed).open("a") as file:
        file.write("\n")
    assert state.files.have_changed


def test_so_is_one_while_it_is_read(directory: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    robot = directory / "robot.urdf"
    robot.write_text(ROBOT.format("a.obj"))

    def described(*words: Any, **more: Any) -> ReportInput:
        reported = describe(*words, **more)
        (directory / "a.mtl").write_text("newmtl other\n")
        return reported

    monkeypatch.setattr(module, "describe", described)
    assert read(str(robot), Options()).files.have_changed


@pytest.mark.parametrize(
    ("text", "missing"),
    [
        ('<xacro:include filename="more.xacro"/>', "more.xacro"),
        ("<link name=\"${xacro.load_yaml('more.yaml')[0]}\"/>", "more.yaml"),
    ],
)
def test_a_missing_file_that_comes_is_seen(tmp_path: Path, text: str, missing: str) -> None:
    robot = tmp_path / "robot.xacro"
    robot.write_text(f"{HEAD}{text}</robot>")
    state = read(str(robot), Options())
    assert not state.files.have_changed
    (tmp_path / "of_another_program").write_text("")
    assert not state.files.have_changed
    (tmp_path / missing).write_text(f"{HEAD}</robot>")
    assert state.files.have_changed
