import os
from pathlib import Path

import pytest

from tests.mesh import made
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh.io import sniff
from urdfkit.mesh.io.facts import MeshFacts
from urdfkit.robot.assets import mesh_files as module
from urdfkit.robot.assets.file_names import is_mistyped
from urdfkit.robot.assets.mesh_files import MeshFiles, Suggestion
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package; so deep that the neighbours of one test are not those of another."""
    return add_package(tmp_path / "a" / "b" / "c" / "d" / "arm_description", "arm")


def files(package: Path, text: str, path: str = "urdf/arm.urdf") -> MeshFiles:
    source = Source(str(package / path), whole_robot(text).encode())
    return Context(source, Resolver(environment={})).files


def nearest(package: Path, *references: str) -> list[Suggestion | None]:
    """What is suggested for each reference that is missing."""
    found = files(package, mesh_link(*references))
    return [found.nearest(mesh) for mesh in found.missing]


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


def test_the_case_on_disk(package: Path) -> None:
    add_file(package / "meshes" / "Arm.STL")
    found = files(package, mesh_link("package://arm/Meshes/arm.stl", "../MESHES/arm.stl", "x.stl"))
    assert [found.spelling_on_disk(mesh) for mesh in found.missing] == [
        Suggestion("package://arm/meshes/Arm.STL", sure=True),
        Suggestion("../meshes/Arm.STL", sure=True),
        None,
    ]
    absolute = files(package, mesh_link(f"file://{package}/meshes/ARM.stl"))
    assert absolute.spelling_on_disk(absolute.missing[0]) == Suggestion(
        "package://arm/meshes/Arm.STL", sure=True
    )


def test_a_similar_name_in_the_same_directory(package: Path) -> None:
    add_file(package / "meshes" / "forearm.stl")
    add_file(package / "meshes" / "forarn.txt")
    expected = Suggestion("package://arm/meshes/forearm.stl", sure=True)
    assert nearest(package, "package://arm/meshes/forarm.stl") == [expected]
    assert nearest(package, "../meshes/forarm.stl") == [
        expected._replace(reference="../meshes/forearm.stl")
    ]
    assert nearest(package, f"{package}/meshes/forarm.stl") == [expected]
    # Another link has it already.
    assert nearest(package, "../meshes/forarm.stl", "../meshes/forearm.stl") == [
        Suggestion("../meshes/forearm.stl", sure=False)
    ]
    assert nearest(package, "package://arm/meshes/wheel.stl") == [None]


def test_few_names_are_compared(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """5,000 missing files and 2,000 others took more than a minute."""
    add_file(package / "meshes" / "forearm.stl")
    add_file(package / "meshes" / "shoulder.stl")
    missing = ("../meshes/forarm.stl", "../meshes/sholder.stl")
    monkeypatch.setattr(module, "MAX_COMPARED", 4)
    assert nearest(package, *missing) == [
        Suggestion("../meshes/forearm.stl", sure=True),
        Suggestion("../meshes/shoulder.stl", sure=True),
    ]
    monkeypatch.setattr(module, "MAX_COMPARED", 3)
    assert nearest(package, *missing) == [None, None]


def test_the_same_name_elsewhere_in_the_package(package: Path) -> None:
    add_file(package / "meshes" / "visual" / "forearm.stl")
    expected = Suggestion("package://arm/meshes/visual/forearm.stl", sure=True)
    assert nearest(package, "package://arm/meshes/forearm.stl") == [expected]
    assert nearest(package, "package://arm/mesh/Forearm.STL") == [expected]
    assert nearest(package, "forearm.stl") == [
        expected._replace(reference="../meshes/visual/forearm.stl")
    ]
    assert nearest(package, "/home/somebody/ws/src/arm/forearm.stl") == [expected]
    add_file(package / "meshes" / "collision" / "forearm.stl")
    assert nearest(package, "package://arm/meshes/forearm.stl") == [None]


def test_the_part_of_another_model_is_not_what_was_meant(package: Path) -> None:
    add_file(package / "meshes" / "ur5" / "base.stl")
    add_file(package / "meshes" / "link_2.stl")
    assert nearest(package, "package://arm/meshes/ur3/base.stl") == [None]
    assert nearest(package, "package://arm/meshes/link_1.stl") == [None]
    assert nearest(package, "package://arm/mesh/ur5/base.stl") != [None]


def test_the_search_for_names_is_bounded(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(10):
        add_file(package / f"directory{number}" / "x" / "forearm.stl")
    monkeypatch.setattr(module, "MAX_DIRECTORIES", 5)
    assert nearest(package, "package://arm/meshes/forearm.stl") == [None]


def test_without_a_package_its_own_directory_is_searched(tmp_path: Path) -> None:
    directory = tmp_path / "a" / "b" / "c" / "d"
    add_file(directory / "shapes" / "forearm.stl")
    assert nearest(directory, "forearm.stl") == [None]  # above the directory of the robot
    inside = str(add_file(directory / "urdf" / "parts" / "forearm.stl"))
    assert nearest(directory, "forearm.stl") == [Suggestion("parts/forearm.stl", sure=True)]
    add_file(directory / ".git" / "HEAD")
    os.remove(inside)
    assert nearest(directory, "forearm.stl") == [Suggestion("../shapes/forearm.stl", sure=True)]


def test_without_a_package_the_meshes_next_to_its_own_directory_are_searched(
    tmp_path: Path,
) -> None:
    directory = tmp_path / "arm"
    add_file(directory / "meshes" / "visual" / "forearm.stl")
    reference = "../meshes/visual/forearm.stl"
    assert nearest(directory, "forearm.stl") == [Suggestion(reference, sure=True)]


@pytest.mark.parametrize(
    ("wrong", "right", "mistake"),
    [
        ("forarm.stl", "forearm.stl", True),
        ("fore-arm.stl", "forearm.stl", True),
        ("Left Arm.STL", "left_arm.stl", True),
        ("left_arm.stl", "right_arm.stl", False),
        ("l_arm.stl", "r_arm.stl", False),
        ("upper_arm.stl", "lower_arm.stl", False),
        ("link_1.stl", "link_2.stl", False),
        ("link1.stl", "link_1.stl", True),
        ("arm.stl", "arm.dae", False),
        ("arm.stl", "arms_and_legs.stl", False),
        ("pr2_description", "ur_description", False),
        ("arm_descripton", "arm_description", True),
    ],
)
def test_typos(wrong: str, right: str, mistake: bool) -> None:
    assert is_mistyped(wrong, right) is mistake
