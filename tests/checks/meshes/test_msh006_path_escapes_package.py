from __future__ import annotations

from pathlib import Path

import pytest

from tests.reported import reported
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.text.diagnostic import Severity

CODE = "MSH006"


@pytest.fixture
def robot(tmp_path: Path) -> str:
    package = add_package(tmp_path / "arm", "arm")
    add_file(package / "meshes" / "forearm.stl")
    add_file(add_package(tmp_path / "hand", "hand_description") / "hand.stl")
    add_file(tmp_path / "loose.stl")
    return str(package / "urdf" / "arm.urdf")


@pytest.mark.parametrize(
    ("reference", "help_"),
    [
        ("package://arm/../hand/hand.stl", "write package://hand_description/..."),
        ("package://arm/meshes/../../loose.stl", "refer to the package that holds the file"),
        ("../../hand/hand.stl", "write package://hand_description/..."),
    ],
)
def test_out_of_the_package(robot: str, reference: str, help_: str) -> None:
    (found,) = reported(CODE, mesh_link(reference), robot)
    assert found.severity is Severity.WARNING
    assert found.message == (
        f"link 'arm': the visual mesh '{reference}' leaves package 'arm': "
        "it is not found once installed"
    )
    assert found.help == help_


@pytest.mark.parametrize(
    "reference",
    [
        "package://arm/meshes/../meshes/forearm.stl",
        "../meshes/forearm.stl",
        "package://hand_description/hand.stl",
        "package://arm/../none.stl",  # MSH001
    ],
)
def test_within_a_package(robot: str, reference: str) -> None:
    assert reported(CODE, mesh_link(reference), robot) == []


def test_without_a_package_there_is_none_to_leave(tmp_path: Path) -> None:
    add_file(tmp_path / "meshes" / "a.stl")
    robot = str(tmp_path / "urdf" / "arm.urdf")
    assert reported(CODE, mesh_link("../meshes/a.stl"), robot) == []
