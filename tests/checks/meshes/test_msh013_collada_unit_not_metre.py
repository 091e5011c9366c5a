from __future__ import annotations

from pathlib import Path

import pytest

from tests.meshed import link, mesh, messages, reported
from urdfkit.mesh.samples import collada

INCH = collada('<unit name="inch" meter="0.0254"/>')
TAIL = "RViz and Gazebo multiply by it, MoveIt, Pinocchio and coal do not"


def test_a_file_in_inches_is_told_once(tmp_path: Path) -> None:
    robot = link(mesh("a.dae", "visual"), mesh("a.dae"))
    assert messages(tmp_path, "MSH013", robot, {"a.dae": INCH}) == [
        f"link 'arm': the visual mesh 'a.dae' says that its unit is 0.0254 m: {TAIL}"
    ]


@pytest.mark.parametrize(
    "asset", ["", '<unit meter="1"/>', '<unit meter="1.0000"/>', '<unit meter="0"/>', "<unit/>"]
)
def test_metres(tmp_path: Path, asset: str) -> None:
    assert messages(tmp_path, "MSH013", link(mesh("a.dae")), {"a.dae": collada(asset)}) == []


@pytest.mark.parametrize(
    ("roles", "targets", "severity"),
    [
        (["visual"], (), "info"),
        (["visual"], ("ros2", "gz-harmonic"), "info"),
        (["visual"], ("ros2", "pinocchio"), "warning"),
        (["collision"], ("ros2",), "warning"),
        (["visual", "collision"], ("ros2",), "warning"),
    ],
)
def test_what_is_only_drawn_is_an_information(
    tmp_path: Path, roles: list[str], targets: tuple[str, ...], severity: str
) -> None:
    robot = link(*(mesh("a.dae", role) for role in roles))
    (found,) = reported(tmp_path, "MSH013", robot, {"a.dae": INCH}, targets)
    assert found.severity.value == severity
