from __future__ import annotations

from pathlib import Path

import pytest

from tests.meshed import SOUND, link, mesh, messages

ROBOT = link(mesh("package://arm/meshes/a.stl"))
FILES = {
    "package.xml": b"<package><name>arm</name></package>",
    "meshes/a.stl": SOUND,
    "meshes/B_2.STL": SOUND,
    "meshes/camera.dae": b"",
    "meshes/notes.txt": b"",
    "cad/d.stl": SOUND,
}


def test_what_nothing_mentions(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH030", ROBOT, FILES) == [
        "no file of the workspace mentions 'B_2.STL', 'camera.dae', beside the meshes of this robot"
    ]


def test_many_of_them(tmp_path: Path) -> None:
    files = {f"meshes/old_{number}.stl": SOUND for number in range(7)}
    (found,) = messages(tmp_path, "MSH030", ROBOT, {**FILES, **files})
    assert "'B_2.STL', 'camera.dae', 'old_0.stl', 'old_1.stl', 'old_2.stl' and 4 more, " in found


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("config/visual.yaml", b"mesh: meshes/b_2.stl\nother: Camera.dae\n"),
        ("urdf/other.urdf", b"<mesh filename='package://arm/meshes/B_2.STL'/> camera.dae"),
        ("scripts/spawn.py", b"PART = 'b_2'; OTHER = 'camera'"),
        ("urdf/parts.xacro", b'<mesh filename="package://arm/meshes/${name}.stl"/>'),
        (
            "urdf/a.xacro",
            b'<mesh filename="meshes/${name}_2.stl"/><mesh filename="$(arg x)ra.dae"/>',
        ),
        ("urdf/b.xacro", b"<a v=\"${name + '_2.stl'}\"/><a v=\"${name + 'camera.dae'}\"/>"),
        ("spawn.py", b"'meshes/%s_2.stl' % name, f'meshes/{name}ra.dae'"),
    ],
)
def test_what_another_file_may_mention(tmp_path: Path, name: str, text: bytes) -> None:
    assert messages(tmp_path, "MSH030", ROBOT, {**FILES, name: text}) == []


def test_a_name_that_is_made_otherwise_is_no_mention(tmp_path: Path) -> None:
    text = b'<mesh filename="package://arm/meshes/${name}_3.stl"/>'
    (found,) = messages(tmp_path, "MSH030", ROBOT, {**FILES, "urdf/parts.xacro": text})
    assert "'B_2.STL', 'camera.dae', beside" in found


def test_one_name_in_two_folders_is_told_with_them(tmp_path: Path) -> None:
    robot = link(mesh("package://arm/meshes/a.stl") + mesh("package://arm/collision/c.stl"))
    files = {**FILES, "collision/c.stl": SOUND, "collision/B_2.STL": SOUND}
    (found,) = messages(tmp_path, "MSH030", robot, files)
    assert "'collision/B_2.STL', 'meshes/B_2.STL', 'camera.dae', beside" in found


def test_outside_of_a_package(tmp_path: Path) -> None:
    files = {"a.stl": SOUND, "b.stl": SOUND}
    assert messages(tmp_path, "MSH030", link(mesh("a.stl")), files) == []
