from pathlib import Path

import pytest

from tests.naming import naming, values
from tests.reported import fixed, messages, places, reported
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.lint.grouping import grouped
from urdfkit.text.diagnostic import Severity

CODE = "MSH001"


@pytest.fixture
def robot(tmp_path: Path) -> str:
    """Path of a robot in a package; so deep that it has no neighbours."""
    package = add_package(tmp_path / "a" / "b" / "c" / "d" / "arm", "arm")
    add_file(package / "meshes" / "forearm.stl")
    return str(package / "urdf" / "arm.urdf")


def test_the_message_names_package_and_paths(robot: str) -> None:
    package = Path(robot).parents[1]
    (found,) = reported(CODE, mesh_link("package://arm/meshes/hokuyo.dae"), robot)
    assert found.severity is Severity.ERROR
    assert found.span.text == "package://arm/meshes/hokuyo.dae"
    assert found.message == naming(
        "arm", "visual", "package://arm/meshes/hokuyo.dae", "arm", package / "meshes" / "hokuyo.dae"
    )
    assert found.help == naming("--model", "ROBOT")
    assert found.fix is None


def test_a_file_without_package(robot: str) -> None:
    (message,) = messages(CODE, mesh_link("hand%20le.stl"), robot)
    directory = Path(robot).parent
    assert message.endswith(f" {directory / 'hand%20le.stl'}, {directory / 'hand le.stl'}")


@pytest.mark.parametrize("written", ["package://arm.stl", "package:///parts/arm.stl"])
def test_a_file_beside_the_robot_that_pybullet_finds(robot: str, written: str) -> None:
    right = written.removeprefix("package://").lstrip("/")
    add_file(Path(robot).parent / right)
    (found,) = reported(CODE, mesh_link(written), robot)
    assert found.severity is Severity.WARNING
    assert found.help == f"write {right}, or package://PACKAGE/..."
    assert f'filename="{right}"' in fixed(CODE, mesh_link(written), robot)


@pytest.mark.parametrize("start", ["package:/", "package:", "package//"])
def test_a_scheme_without_a_slash_or_the_colon(robot: str, start: str) -> None:
    text = mesh_link(f"{start}arm/meshes/forearm.stl")
    (found,) = reported(CODE, text, robot)
    assert found.message.endswith(f" '{start}', not with 'package://'")
    assert 'filename="package://arm/meshes/forearm.stl"' in fixed(CODE, text, robot)


def test_the_nearest_name_is_offered_and_fixed(robot: str) -> None:
    text = mesh_link("package://arm/meshes/forarm.stl")
    (found,) = reported(CODE, text, robot)
    assert found.help == naming("package://arm/meshes/forearm.stl")
    assert found.fix is not None
    assert not found.fix.safe
    assert "meshes/forearm.stl" in fixed(CODE, text, robot)
    assert reported(CODE, fixed(CODE, text, robot), robot) == []


def test_a_name_that_is_only_alike_is_offered_but_not_fixed(robot: str) -> None:
    text = mesh_link("package://arm/meshes/forearm_cad.stl")
    (found,) = reported(CODE, text, robot)
    assert found.help == naming("package://arm/meshes/forearm.stl")
    assert found.fix is None


def test_the_absolute_path_of_another_machine(robot: str) -> None:
    text = mesh_link("file:///home/somebody/arm/meshes/forearm.stl")
    (found,) = reported(CODE, text, robot)
    assert found.help == naming("package://arm/meshes/forearm.stl")
    assert reported(CODE, fixed(CODE, text, robot), robot) == []


def test_the_absolute_path_of_a_package_that_is_elsewhere(robot: str) -> None:
    """FloriBot: ``file:///ws/src/floribot_gz_description/...``, of a container."""
    (found,) = reported(CODE, mesh_link("file:///ws/src/wagon/meshes/front.stl"), robot)
    assert ("package://PACKAGE/" in found.help, found.fix) == (True, None)


def test_every_place_is_reported(robot: str) -> None:
    text = mesh_link("a.stl", "a.stl", "../meshes/forearm.stl")
    assert [place for place, _ in places(CODE, text, robot)] == [3, 4]


@pytest.mark.parametrize(
    "reference",
    [
        "package://arm/meshes/forearm.stl",
        "package://no_such_package/meshes/a.stl",  # XAC011
        "https://example.org/a.stl",
        "model://arm/meshes/forearm.stl",
        "package://arm/meshes/${name}.stl",  # XAC003
    ],
)
def test_what_another_rule_reports(robot: str, reference: str) -> None:
    assert reported(CODE, mesh_link(reference), robot) == []


def test_no_file_name_at_all(robot: str) -> None:
    assert len(reported(CODE, mesh_link("", "package://arm"), robot)) == 2


def test_the_calls_of_a_macro_are_one_finding(robot: str) -> None:
    text = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name">
    <link name="${name}">
      <visual><geometry><mesh filename="package://arm/meshes/${name}.dae"/></geometry></visual>
    </link>
  </xacro:macro>
  <xacro:part name="wheel_1"/>
  <xacro:part name="wheel_2"/>
  <xacro:part name="wheel_3"/>
</robot>
"""
    (found,) = reported(CODE, text, robot.replace(".urdf", ".xacro"))
    assert found.span.text == "package://arm/meshes/${name}.dae"
    assert [call.element for call in found.calls] == [
        f"link/wheel_{number}/visual/geometry/mesh@filename" for number in (1, 2, 3)
    ]
    assert "wheel_3.dae' does not exist" in found.calls[2].message
    assert found.fix is None


def test_what_one_lost_directory_takes_along_is_one_finding_for_people(robot: str) -> None:
    """A URDF that another machine has made: all is below a home that is not here."""
    home = "file:///home/somebody/ws/install"
    paths = ["ur/visual/a.dae", "ur/collision/a.stl", "gripper/meshes/b.stl"]
    found = reported(CODE, mesh_link(*(f"{home}/{path}" for path in paths)), robot)
    assert len(found) == 3
    (seen,) = grouped(found)
    assert seen.message == naming("arm", "visual", f"{home}/ur/visual/a.dae", "2")


def test_offers_are_gathered_with_their_fixes(robot: str) -> None:
    directory = Path(robot).parents[1] / "meshes"
    for name in ("hand.stl", "foot.stl"):
        add_file(directory / name)
    names = ("forearm", "hand", "foot")
    text = mesh_link(*(f"file:///home/somebody/arm/meshes/{name}.stl" for name in names))
    (seen,) = grouped(reported(CODE, text, robot))
    assert seen.help == naming("package://arm/meshes/forearm.stl")
    assert [note.message.rpartition(": ")[2] for note in seen.related] == [
        naming(f"package://arm/meshes/{name}.stl") for name in names[1:]
    ]
    assert seen.fix is not None
    assert len(seen.fix.edits) == 3


def test_a_file_of_another_part_is_not_offered(robot: str) -> None:
    """The names of meshes end alike: of ``lidar_link.stl`` no ``base_link.stl`` is made."""
    add_file(Path(robot).parents[1] / "meshes" / "lidar_link.stl")
    (found,) = reported(CODE, mesh_link("package://arm/meshes/base_link.stl"), robot)
    assert "did you mean" not in found.help


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("package://arm/meshes/Forearm.stl", "package://arm/meshes/forearm.stl"),
        ("package://arm/Meshes/forearm.STL", "package://arm/meshes/forearm.stl"),
        ("model://arm/meshes/forearm.STL", "model://arm/meshes/forearm.stl"),
        ("../MESHES/Forearm.stl", "../meshes/forearm.stl"),
    ],
)
def test_another_case(robot: str, wrong: str, right: str) -> None:
    (found,) = reported(CODE, mesh_link(wrong), robot)
    assert values(found.message)[1:] == [wrong, right]
    assert fixed(CODE, mesh_link(wrong), robot) == fixed(CODE, mesh_link(right), robot)


@pytest.mark.parametrize(
    "reference",
    ["package://arm\\meshes\\forearm.stl", "..\\meshes\\forearm.stl", "package://arm/a\\b.stl"],
)
def test_backslashes(robot: str, reference: str) -> None:
    text = mesh_link(reference)
    (found,) = reported(CODE, text, robot)
    assert "has backslashes" in found.message
    assert fixed(CODE, text, robot) == fixed(CODE, text.replace("\\", "/"), robot)


@pytest.mark.parametrize(
    ("reference", "help"),
    [
        # a drone of PyBullet, and VISPA
        ("C:\\Users\\me\\arm\\forearm.stl", naming("package://arm/meshes/forearm.stl")),
        ("file:///D:/robots/forearm.stl", naming("package://arm/meshes/forearm.stl")),
        ("C:/robots/lid.obj", naming("package://PACKAGE")),
        ("package://STLs\\forearm.stl", "write / instead"),
        ("package://arm/cad\\forearm.stl", naming("package://arm/meshes/forearm.stl")),
    ],
)
def test_paths_of_windows(robot: str, reference: str, help: str) -> None:
    (found,) = reported(CODE, mesh_link(reference), robot)
    assert found.help == help
    is_on_drive = not reference.startswith("package")
    assert ("Windows" in found.message) is is_on_drive


@pytest.mark.parametrize("scheme", ["packge", "Package"])
def test_an_unknown_scheme(robot: str, scheme: str) -> None:
    text = mesh_link(f"{scheme}://arm/meshes/forearm.stl")
    (found,) = reported(CODE, text, robot)
    assert found.message.endswith(f" scheme '{scheme}://'")
    assert 'filename="package://arm/meshes/forearm.stl"' in fixed(CODE, text, robot)


def test_a_scheme_that_resembles_none(robot: str) -> None:
    (found,) = reported(CODE, mesh_link("s3://bucket/arm.stl"), robot)
    assert found.fix is None


def test_a_slash_too_many(robot: str) -> None:
    text = mesh_link("package:///arm/meshes/forearm.stl")
    (found,) = reported(CODE, text, robot)
    assert found.message == naming(
        "arm", "visual", "package:///arm/meshes/forearm.stl", "package://", "/"
    )
    right = mesh_link("package://arm/meshes/forearm.stl")
    assert fixed(CODE, text, robot) == fixed(CODE, right, robot)
    (found,) = reported(CODE, mesh_link("package:///no/such.stl"), robot)
    assert found.fix is None


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("file:///home/me/install/hand/share/hand/meshes/palm.stl", "package://hand/meshes/palm"),
        ("file:///home/me/install/hand/share/hand/meshes/forearm.stl", "package://arm/meshes/fore"),
        ("file:///home/me/ws/src/arm/meshes/forearm.stl", "package://arm/meshes/forearm.stl"),
    ],
)
def test_a_file_of_an_installed_package_of_another_computer(
    robot: str, path: str, expected: str
) -> None:
    """Collaborative-Robotic-Arms/dual_arms: a file of the same name is another robot's."""
    add_file(Path(robot).parents[1] / "other" / "palm.stl")
    (found,) = reported(CODE, mesh_link(path), robot)
    assert expected in found.help


def test_the_file_at_the_same_place_of_the_own_package(robot: str) -> None:
    """acflemos/ros2_ws: the URDF was copied with its meshes, into a package of another name."""
    (Path(robot).parents[2] / ".git").mkdir()
    other = add_package(Path(robot).parents[2] / "old", "old")
    add_file(other / "setup.py", "setup(name='old')")
    add_file(other / "nested" / "meshes" / "forearm.stl")
    (found,) = reported(CODE, mesh_link("package://old/meshes/forearm.stl"), robot)
    assert found.help == "did you mean 'package://arm/meshes/forearm.stl'?"
