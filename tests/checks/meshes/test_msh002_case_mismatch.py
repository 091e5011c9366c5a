from __future__ import annotations

from pathlib import Path

import pytest

from tests.reported import fixed, reported
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.text.diagnostic import Severity

CODE = "MSH002"


@pytest.fixture
def robot(tmp_path: Path) -> str:
    package = add_package(tmp_path / "arm", "arm")
    add_file(package / "meshes" / "Forearm.STL")
    return str(package / "urdf" / "arm.urdf")


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("package://arm/meshes/forearm.stl", "package://arm/meshes/Forearm.STL"),
        ("package://arm/Meshes/Forearm.STL", "package://arm/meshes/Forearm.STL"),
        ("model://arm/meshes/forearm.STL", "model://arm/meshes/Forearm.STL"),
        ("../MESHES/Forearm.stl", "../meshes/Forearm.STL"),
    ],
)
def test_case(robot: str, wrong: str, right: str) -> None:
    text = mesh_link(wrong)
    (found,) = reported(CODE, text, robot)
    assert found.severity is Severity.ERROR
    assert found.message == (
        f"link 'arm': the visual mesh '{wrong}' is called '{right}' on disk: Linux does not find it"
    )
    assert fixed(CODE, text, robot) == fixed(CODE, mesh_link(right), robot)


@pytest.mark.parametrize(
    "reference",
    ["package://arm/meshes/Forearm.STL", "package://arm/meshes/fore.stl", "package://x/a.stl"],
)
def test_other_names(robot: str, reference: str) -> None:
    assert reported(CODE, mesh_link(reference), robot) == []
