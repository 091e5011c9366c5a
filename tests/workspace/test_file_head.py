"""No file of a workspace keeps us waiting, whatever it is."""

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package, mesh_link
from urdfkit import check
from urdfkit.lint.config import Config
from urdfkit.lint.discovery import discover
from urdfkit.mesh import samples
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.resolve import Resolver

if not hasattr(os, "mkfifo"):
    pytest.skip("pipes have no names here", allow_module_level=True)


@pytest.fixture(autouse=True)
def alarm() -> Iterator[None]:
    """A pipe without a writer would be waited for until the end of days."""
    signal.alarm(30)
    yield
    signal.alarm(0)


def test_what_is_no_file_is_empty(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    add_file(tmp_path / "file", b"abc")
    names = ("pipe", "file", ".", "none", "\0")
    assert [read_head(str(tmp_path / name), 2) for name in names] == [b"", b"ab", b"", b"", b""]


@pytest.mark.parametrize(
    "name",
    [
        ".gitignore",
        "CMakeLists.txt",
        "setup.py",
        "config/arm.srdf",
        "config/arm.yaml",
        "launch/arm.launch",
        "launch/arm.launch.py",
        "urdf/more.xacro",
        "urdfkit.toml",
    ],
)
def test_pipes_around_a_robot(name: str, tmp_path: Path) -> None:
    package = add_package(tmp_path / "arm", "arm")
    (package / ".git").mkdir()
    add_file(package / "meshes" / "arm.stl", samples.stl(samples.box((0, 0, 0), (1, 1, 1))))
    add_file(package / "meshes" / "more.stl", samples.stl(samples.box((0, 0, 0), (1, 2, 1))))
    text = f"<robot name='arm'>{mesh_link('package://arm/meshes/arm.stl')}</robot>"
    robot = add_file(package / "urdf" / "arm.urdf", text.encode())
    (package / name).parent.mkdir(exist_ok=True)
    os.mkfifo(package / name)
    assert check(robot).crashed == ()
    found = discover(str(package), Config(), Resolver())
    assert [one.file for one in found.robots] == [str(robot)]
