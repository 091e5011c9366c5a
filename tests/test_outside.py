"""What a model names outside of its workspace is neither read nor changed: readers x ways out.

A new reader belongs into READERS. That reads pass `urdfkit.core.disk` is checked elsewhere; here it
is checked that they keep to the workspace.
"""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import urdfkit
from tests.meshed import SOUND
from tests.xacros import HEAD
from urdfkit.cli import main
from urdfkit.errors import UrdfkitError
from urdfkit.output import formats

SECRET = "sesame_5261"
#: What lies outside, by suffix: all of it is what its reader looks for.
CONTENTS = {
    ".urdf": f'{HEAD}<link name="{SECRET}"/><link name="{SECRET}"/></robot>',
    ".xacro": f'{HEAD}<link name="{SECRET}"/></robot>',
    ".srdf": f'<robot name="r"><group name="{SECRET}"><link name="{SECRET}"/></group></robot>',
    ".launch": f'<launch><param name="{SECRET}" value="$(find {SECRET})"/></launch>',
    ".yaml": f"{SECRET}: {{type: {SECRET}}}\n",
    ".sdf": f'<sdf><world name="{SECRET}"><plugin filename="gz-sim-{SECRET}"/></world></sdf>',
    ".mtl": f"newmtl {SECRET}\nKd 1 0 0\n",
    ".png": f"\x89PNG{SECRET}",
    ".bin": SECRET * 10,
    ".toml": f"ignore = ['{SECRET}']\n",
}
OBJ = (
    "mtllib {}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl a\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
)
COLLADA = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_images><image id="i"><init_from>{}</init_from></image></library_images></COLLADA>
"""


def mesh(name: str) -> str:
    visual = f'<visual><geometry><mesh filename="{name}"/></geometry></visual>'
    return f'{HEAD}<link name="a">{visual}</link></robot>'


def gltf(**named: object) -> str:
    return json.dumps({"asset": {"version": "2.0"}, "scenes": [{}]} | named)


Files = dict[str, str]

#: What names a file: its suffix, and files of a workspace for a reference to it.
READERS: dict[str, tuple[str, Callable[[str], Files]]] = {
    "xacro:include": (
        ".xacro",
        lambda at: {"r.urdf.xacro": f'{HEAD}<xacro:include filename="{at}"/></robot>'},
    ),
    "load_yaml": (
        ".yaml",
        lambda at: {
            "r.urdf.xacro": f"{HEAD}<xacro:property name='p' "
            f"value=\"${{xacro.load_yaml('{at}')}}\"/><link name='a${{p}}'/></robot>"
        },
    ),
    "mesh": (".bin", lambda at: {"r.urdf": mesh(at)}),
    "texture": (
        ".png",
        lambda at: {
            "r.urdf": f'{HEAD}<link name="a"><visual><geometry><box size="1 1 1"/></geometry>'
            f'<material name="m"><texture filename="{at}"/></material></visual></link></robot>'
        },
    ),
    "mtllib": (".mtl", lambda at: {"r.urdf": mesh("a.obj"), "a.obj": OBJ.format(at)}),
    "map_Kd": (
        ".png",
        lambda at: {
            "r.urdf": mesh("a.obj"),
            "a.obj": OBJ.format("a.mtl"),
            "a.mtl": f"newmtl a\nmap_Kd {at}\n",
        },
    ),
    "glTF buffer": (
        ".bin",
        lambda at: {
            "r.urdf": mesh("a.gltf"),
            "a.gltf": gltf(buffers=[{"uri": at, "byteLength": 36}]),
        },
    ),
    "glTF image": (
        ".png",
        lambda at: {"r.urdf": mesh("a.gltf"), "a.gltf": gltf(images=[{"uri": at}])},
    ),
    "COLLADA image": (
        ".png",
        lambda at: {"r.urdf": mesh("a.dae"), "a.dae": COLLADA.format(at)},
    ),
    "textfile": (
        ".urdf",
        lambda at: {
            "r.launch": f'<launch><param name="robot_description" textfile="{at}"/></launch>'
        },
    ),
    "xacro command": (
        ".xacro",
        lambda at: {
            "r.launch": f'<launch><param name="robot_description" command="xacro {at}"/></launch>'
        },
    ),
    "launch include": (
        ".launch",
        lambda at: {"r.launch": f'<launch><include file="{at}"/></launch>'},
    ),
    "rosparam": (
        ".yaml",
        lambda at: {"r.launch": f'<launch><rosparam file="{at}" command="load"/></launch>'},
    ),
    "world": (
        ".sdf",
        lambda at: {"r.launch": f'<launch><executable cmd="gz sim -r {at}"/></launch>'},
    ),
    "control parameters": (
        ".yaml",
        lambda at: {
            "r.urdf": f'{HEAD}<link name="a"/><gazebo><plugin name="gazebo_ros2_control" '
            f'filename="libgazebo_ros2_control.so"><parameters>{at}</parameters></plugin></gazebo>'
            "</robot>"
        },
    ),
    "configured robot": (".urdf", lambda at: {"urdfkit.toml": f"[[robot]]\nfile = '{at}'\n"}),
}

#: Files that are found by their names, so that only a link leads out.
FOUND = {
    "robot": (".urdf", "other.urdf"),
    "xacro": (".xacro", "other.urdf.xacro"),
    "launch file": (".launch", "other.launch"),
    "SRDF": (".srdf", "config/r.srdf"),
    "Gazebo starter": (".launch", "launch/gazebo.launch"),
    "unusual robot": (".urdf", "other.model"),
    "joint limits": (".yaml", "config/joint_limits.yaml"),
}

WAYS = ("..", "absolute", "file://", "link")

_opened: list[str] = []


def _note(event: str, values: tuple[object, ...]) -> None:
    if event == "open" and isinstance(values[0], str) and values[1] in ("r", "rb"):
        _opened.append(os.path.realpath(values[0]))


sys.addaudithook(_note)


@pytest.fixture
def opened() -> list[str]:
    """The files that this process opens."""
    _opened.clear()
    return _opened


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """An empty one, next to which lies what is none of its business."""
    directory = tmp_path / "ws"
    directory.mkdir()
    (directory / "LICENSE").touch()
    (directory / "package.xml").write_text("<package><name>r</name></package>")
    (tmp_path / "outside").mkdir()
    return directory


def secret(workspace: Path, suffix: str) -> Path:
    path = workspace.parent / "outside" / f"secret{suffix}"
    path.write_text(CONTENTS[suffix], encoding="latin-1")
    return path


def write(workspace: Path, files: Files) -> None:
    for name, text in files.items():
        (workspace / name).parent.mkdir(exist_ok=True)
        (workspace / name).write_text(text)


def reported(workspace: Path) -> str:
    """What a check says in all formats, or why it cannot be done."""
    try:
        report = urdfkit.check(workspace)
    except UrdfkitError as error:
        return str(error)
    assert not report.crashed, report.crashed[0].traceback
    return "\n".join(formats.get(name)(report) for name in formats.names())


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("reader", READERS)
def test_what_is_named_outside_is_not_read(
    workspace: Path, opened: list[str], reader: str, way: str
) -> None:
    suffix, files = READERS[reader]
    path = secret(workspace, suffix)
    at = {
        "..": f"../outside/{path.name}",
        "absolute": str(path),
        "file://": f"file://{path}",
        "link": f"link{suffix}",
    }[way]
    if way == "link":
        (workspace / at).symlink_to(path)
        if reader == "control parameters":  # which must be absolute
            at = str(workspace / at)
    elif reader == "control parameters" and way == "..":
        at = f"{workspace}/{at}"
    write(workspace, files(at))
    out = reported(workspace)
    assert str(path.resolve()) not in opened
    assert SECRET not in out


@pytest.mark.parametrize("found", FOUND)
def test_a_link_to_outside_is_not_read(workspace: Path, opened: list[str], found: str) -> None:
    suffix, name = FOUND[found]
    path = secret(workspace, suffix)
    write(workspace, {"r.urdf": f'{HEAD}<link name="a"/></robot>'})
    (workspace / name).parent.mkdir(exist_ok=True)
    (workspace / name).symlink_to(path)
    out = reported(workspace)
    assert str(path.resolve()) not in opened
    assert SECRET not in out


@pytest.mark.parametrize(
    "command", [["fix"], ["fix", "--unsafe-fixes"], ["format"], ["check", "--fix"]]
)
def test_a_link_to_outside_is_not_written_through(
    workspace: Path, command: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = secret(workspace, ".urdf")
    before = '<robot name="r"><link   name="a" ></link><joint name="j" type="fixd"/></robot>'
    path.write_text(before)
    write(workspace, {"r.urdf": f'{HEAD}<link name="a"/></robot>'})
    write(workspace, {"r.launch": READERS["textfile"][1](str(path))["r.launch"]})
    (workspace / "other.urdf").symlink_to(path)
    monkeypatch.chdir(workspace)
    main([*command, "."])
    main([*command, "r.launch"])
    assert path.read_text() == before


def test_the_finding_names_the_reference(workspace: Path) -> None:
    path = secret(workspace, ".bin")
    path.write_bytes(SOUND)
    write(workspace, {"r.urdf": mesh(f"file://{path}")})
    (found,) = urdfkit.check(workspace, select=["MSH001"]).diagnostics
    assert f"file://{path}" in found.message
    assert "outside the workspace" in found.message
    assert found.severity.value == "warning"


def test_what_the_user_names_is_read(workspace: Path, opened: list[str]) -> None:
    path = secret(workspace, ".bin")
    path.write_bytes(SOUND)
    write(workspace, {"r.urdf": mesh(f"file://{path}")})
    assert not urdfkit.check(workspace, select=["MSH001"], trust=True).diagnostics
    (path.parent / "package.xml").write_text("<package><name>other</name></package>")
    write(workspace, {"r.urdf": mesh(f"package://other/{path.name}")})
    packages = {"other": str(path.parent)}
    assert not urdfkit.check(workspace, select=["MSH001"], packages=packages).diagnostics
    assert str(path) in opened


@pytest.mark.parametrize("text", ["packages.r = '/'", "packages.r = '../outside'"])
def test_a_configuration_does_not_widen_the_workspace(
    workspace: Path, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    write(workspace, {"urdfkit.toml": text, "r.urdf": f'{HEAD}<link name="a"/></robot>'})
    assert main(["check", str(workspace)]) == 2
    assert "outside the workspace" in capsys.readouterr().err
    assert main(["check", str(workspace), "--config", str(workspace / "urdfkit.toml")]) == 0


def test_a_configuration_may_name_packages_of_its_workspace(workspace: Path) -> None:
    write(
        workspace, {"urdfkit.toml": "packages.r = '.'", "r.urdf": f'{HEAD}<link name="a"/></robot>'}
    )
    assert main(["check", str(workspace)]) == 0


@pytest.mark.parametrize("name", ["ROS_TOKEN", "GZ_PASSWORD", "HOME", "ROBOT_SECRET"])
def test_a_variable_that_is_not_listed_is_not_read(
    workspace: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(name, SECRET)
    write(workspace, {"r.urdf.xacro": f'{HEAD}<link name="$(env {name})"/></robot>'})
    assert SECRET not in reported(workspace)


@pytest.mark.skipif(shutil.which("git") is None, reason="git is not installed")
@pytest.mark.parametrize("words", [["check", "r.urdf"], ["diff", "HEAD:r.urdf", "r.urdf"]])
def test_the_configuration_of_a_repository_names_no_program_to_run(
    workspace: Path, words: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    write(workspace, {"r.urdf": f'{HEAD}<link name="a"/></robot>', ".gitignore": "*.txt\n"})
    monkeypatch.chdir(workspace)
    for line in ("init -q", "add .", "-c user.name=a -c user.email=a@b commit -qm a"):
        subprocess.run(["git", *line.split()], check=True)
    program = workspace / ".git" / "run"
    program.write_text(f"#!/bin/sh\ntouch {workspace}/ran\n")
    program.chmod(0o755)
    subprocess.run(["git", "config", "core.fsmonitor", str(program)], check=True)
    subprocess.run(["git", "status"], check=True, capture_output=True)
    assert (workspace / "ran").exists(), "git itself does run it"
    (workspace / "ran").unlink()
    assert main(words) in (0, 1)
    assert not (workspace / "ran").exists()
