"""The mesh of the mission's own model: missing at first, then made in ways that do not work."""

import shutil
from pathlib import Path

import pytest

from tests.conftest import MODELS
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Diagnostic

BAD = MODELS / "bad" / "meshes"


def only_finding(package: Path) -> Diagnostic:
    report = engine.check(package / "urdf" / "waking_robot_new.xacro", select=["MSH"])
    assert report.crashed == ()
    (found,) = report.diagnostics
    assert found.span.text == "package://gazebo_pkg/meshes/hokuyo.dae"
    assert found.element == "link/laser_frame/visual/geometry/mesh@filename"
    return found


def test_missing(gazebo_pkg: Path) -> None:
    found = only_finding(gazebo_pkg)
    assert found.code == "MSH001"
    assert found.message.endswith(
        f"does not exist in package 'gazebo_pkg'; tried {gazebo_pkg / 'meshes' / 'hokuyo.dae'}"
    )


@pytest.mark.parametrize(
    ("mesh", "code", "reason"),
    [
        ("empty.dae", "MSH009", "is empty"),
        ("bot.dae", "MSH009", "ends inside <instance_geometry> in <node>, before any triangle"),
        ("web_page.dae", "MSH009", "is a web page: 'hokuyo.dae'"),
        ("lfs_pointer.stl", "MSH009", "is a Git LFS pointer: the mesh of 684 bytes itself"),
    ],
)
def test_made_in_a_way_that_does_not_work(
    gazebo_pkg: Path, mesh: str, code: str, reason: str
) -> None:
    (gazebo_pkg / "meshes").mkdir()
    shutil.copyfile(BAD / mesh, gazebo_pkg / "meshes" / "hokuyo.dae")
    found = only_finding(gazebo_pkg)
    assert found.code == code
    assert f"hokuyo.dae' {reason}" in found.message
