from __future__ import annotations

from pathlib import Path

import pytest

from tests.reported import fixed, reported
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.text.diagnostic import Severity

CODE = "MSH004"


@pytest.fixture
def robot(tmp_path: Path) -> str:
    package = add_package(tmp_path / "arm", "arm")
    add_file(package / "meshes" / "forearm.stl")
    return str(package / "urdf" / "arm.urdf")


@pytest.mark.parametrize(
    "reference",
    ["package://arm\\meshes\\forearm.stl", "..\\meshes\\forearm.stl", "package://arm/a\\b.stl"],
)
def test_backslashes(robot: str, reference: str) -> None:
    text = mesh_link(reference)
    (found,) = reported(CODE, text, robot)
    assert found.severity is Severity.ERROR
    assert found.message == (
        f"link 'arm': the visual mesh '{reference}' has backslashes: Linux does not find it"
    )
    assert fixed(CODE, text, robot) == fixed(CODE, text.replace("\\", "/"), robot)


def test_the_file_behind_the_backslashes_is_found(robot: str) -> None:
    assert reported("MSH001", mesh_link("package://arm\\meshes\\forearm.stl"), robot) == []


def test_slashes(robot: str) -> None:
    assert reported(CODE, mesh_link("package://arm/meshes/forearm.stl"), robot) == []
