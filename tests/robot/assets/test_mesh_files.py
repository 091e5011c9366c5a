from pathlib import Path

import pytest

from tests.mesh import made
from tests.workspaces import add_file, mesh_link
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh.io import sniff
from urdfkit.mesh.io.facts import MeshFacts
from urdfkit.robot.assets.mesh_files import MeshFiles
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


def files(package: Path, text: str, path: str = "urdf/arm.urdf") -> MeshFiles:
    source = Source(str(package / path), whole_robot(text).encode())
    return Context(source, Resolver(environment={})).files


def test_every_reference_of_the_robot(package: Path) -> None:
    add_file(package / "meshes" / "a.stl", made.binary_stl())
    found = files(
        package,
        """\
<link name="one">
  <visual><geometry><mesh filename="package://arm/meshes/a.stl"/></geometry></visual>
  <collision><geometry><mesh filename="../meshes/a.stl"/></geometry></collision>
  <collision><geometry><box size="1 1 1"/></geometry></collision>
  <collision><geometry><mesh/></geometry></collision>
</link>
<link name="two">
  <visual><geometry><mesh filename="package://arm/${x}.stl"/></geometry></visual>
  <visual><geometry><mesh filename="$(find arm)/x.stl"/></geometry></visual>
  <visual><geometry><mesh filename="none.stl"/></geometry></visual>
  <visual><geometry><mesh filename="package://hand/x.stl"/></geometry></visual>
  <visual><geometry><mesh filename="https://example.org/x.stl"/></geometry></visual>
</link>""",
    )
    assert [(mesh.link.name, mesh.role, mesh.at.value) for mesh in found.meshes] == [
        ("one", "visual", "package://arm/meshes/a.stl"),
        ("one", "collision", "../meshes/a.stl"),
        ("two", "visual", "none.stl"),
        ("two", "visual", "package://hand/x.stl"),
        ("two", "visual", "https://example.org/x.stl"),
    ]
    assert [mesh.at.value for mesh in found.missing] == ["none.stl"]
    assert {name: len(meshes) for name, meshes in found.without_package.items()} == {"hand": 1}
    assert found.meshes[0].facts is found.meshes[1].facts
    assert [mesh.facts and mesh.facts.format for mesh in found.meshes] == [
        "binary STL",
        "binary STL",
        None,
        None,
        None,
    ]
    assert found.meshes[1].who == "link 'one': the collision mesh '../meshes/a.stl'"


def test_every_file_is_read_once(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    add_file(package / "meshes" / "a.stl", made.binary_stl())
    read: list[str] = []
    original = sniff.sniff_file

    def recording(path: str) -> MeshFacts:
        read.append(path)
        return original(path)

    monkeypatch.setattr(sniff, "sniff_file", recording)
    found = files(package, mesh_link(*["package://arm/meshes/a.stl"] * 50, "../meshes/a.stl"))
    assert len(found.meshes) == 51
    assert read == [str(package / "meshes" / "a.stl")]
