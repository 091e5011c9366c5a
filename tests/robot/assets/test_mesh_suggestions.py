import os
from pathlib import Path

import pytest

from tests.workspaces import add_file, mesh_link
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.robot.assets import mesh_suggestions as module
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.assets.mesh_suggestions import MeshSuggestions, Suggestion
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


def of_missing(
    package: Path, *references: str
) -> tuple[tuple[MeshReference, ...], MeshSuggestions]:
    text = whole_robot(mesh_link(*references)).encode()
    files = Context(
        Source(str(package / "urdf" / "arm.urdf"), text), Resolver(environment={})
    ).files
    return files.missing, MeshSuggestions(files)


def nearest(package: Path, *references: str) -> list[Suggestion | None]:
    """What is suggested for each reference that is missing."""
    missing, suggestions = of_missing(package, *references)
    return list(map(suggestions.nearest, missing))


def test_the_case_on_disk(package: Path) -> None:
    add_file(package / "meshes" / "Arm.STL")
    references = "package://arm/Meshes/arm.stl", "../MESHES/arm.stl", "x.stl"
    missing, suggestions = of_missing(package, *references, f"file://{package}/meshes/ARM.stl")
    assert list(map(suggestions.spelling_on_disk, missing)) == [
        Suggestion("package://arm/meshes/Arm.STL", sure=True),
        Suggestion("../meshes/Arm.STL", sure=True),
        None,
        Suggestion("package://arm/meshes/Arm.STL", sure=True),
    ]


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


def test_a_file_of_the_same_name_in_the_directory_of_another_robot_is_not_sure(
    package: Path,
) -> None:
    """UR10 and UR10e have meshes of the same names."""
    add_file(package / "meshes" / "ur10" / "visual" / "base.stl")
    add_file(package / "meshes" / "ur10e" / "visual" / "forearm.stl")
    found = Suggestion("package://arm/meshes/ur10e/visual/forearm.stl", sure=False)
    assert nearest(package, "package://arm/meshes/ur10/visual/forearm.stl") == [found]
    moved = found._replace(sure=True)  # the directory was renamed
    assert nearest(package, "package://arm/meshes/old/visual/forearm.stl") == [moved]


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
