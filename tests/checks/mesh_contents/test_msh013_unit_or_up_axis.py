from pathlib import Path

import pytest

from tests.mesh.made import glb, whole_gltf
from tests.meshed import link, mesh, messages, reported
from tests.naming import naming, values
from urdfkit.mesh.samples import collada

INCH = collada('<unit name="inch" meter="0.0254"/>')
BY_IT = ("RViz", "Gazebo", "MoveIt", "Pinocchio", "coal")


def test_a_file_in_inches_is_reported_once(tmp_path: Path) -> None:
    robot = link(mesh("a.dae", "visual"), mesh("a.dae"))
    assert messages(tmp_path, "MSH013", robot, {"a.dae": INCH}) == [
        naming("arm", "visual", "a.dae", "0.0254 m", *BY_IT)
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
def test_a_visual_is_an_info(
    tmp_path: Path, roles: list[str], targets: tuple[str, ...], severity: str
) -> None:
    robot = link(*(mesh("a.dae", role) for role in roles))
    (found,) = reported(tmp_path, "MSH013", robot, {"a.dae": INCH}, targets)
    assert found.severity.value == severity


@pytest.mark.parametrize("axis", ["X_UP", "Y_UP"])
def test_another_up_axis_is_reported_once(tmp_path: Path, axis: str) -> None:
    other = collada(f"<up_axis>{axis}</up_axis>")
    robot = link(mesh("c.dae"), mesh("a.dae"), mesh("b.dae"), mesh("a.dae"))
    files = {"a.dae": other, "b.dae": other, "c.dae": collada("<up_axis>Z_UP</up_axis>")}
    (found,) = reported(tmp_path, "MSH013", robot, files)
    assert found.severity.value == "info"
    assert found.message == naming(
        "arm",
        "collision",
        "a.dae",
        axis,
        "1",
        *("Bullet", "90", "RViz", "Gazebo", "MoveIt", "Pinocchio"),
    )


@pytest.mark.parametrize("asset", ["", "<up_axis>Z_UP</up_axis>", "<up_axis>up</up_axis>"])
def test_z_up(tmp_path: Path, asset: str) -> None:
    assert messages(tmp_path, "MSH013", link(mesh("a.dae")), {"a.dae": collada(asset)}) == []


def test_gltf_is_reported_once(tmp_path: Path) -> None:
    robot = link(mesh("c.dae"), mesh("a.gltf"), mesh("b.glb"), mesh("a.gltf"))
    files = {"a.gltf": whole_gltf(), "b.glb": glb(), "c.dae": collada()}
    (found,) = reported(tmp_path, "MSH013", robot, files)
    assert found.severity.value == "info"
    assert values(found.message)[:4] == ["arm", "a.gltf", "glTF", "1"]


def test_a_broken_gltf_is_not_reported(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH013", link(mesh("a.glb")), {"a.glb": glb()[:-1]}) == []


@pytest.mark.parametrize("role", ["visual", "collision"])
@pytest.mark.parametrize(
    ("name", "data", "targets", "count"),
    [
        ("a.dae", INCH, ("mujoco",), 0),
        ("a.dae", INCH, ("drake",), 0),
        ("a.dae", INCH, ("mujoco", "pinocchio"), 1),
        ("a.dae", collada("<up_axis>Y_UP</up_axis>"), ("mujoco",), 0),
        ("a.glb", glb(), ("mujoco",), 0),
        ("a.glb", glb(), ("ros2",), 1),
    ],
)
def test_a_file_that_no_target_loads(
    tmp_path: Path, role: str, name: str, data: bytes, targets: tuple[str, ...], count: int
) -> None:
    robot = link(mesh(name, role))
    assert len(reported(tmp_path, "MSH013", robot, {name: data}, targets)) == count
