"""Files that are there: under another directory, in another one of the repository, or elsewhere."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.meshed import SOUND
from tests.naming import naming, values
from tests.workspaces import add_file, add_files, add_package
from urdfkit import check
from urdfkit.lint.grouping import grouped
from urdfkit.text.diagnostic import Diagnostic, Severity

URDF = """\
<robot name="r"><link name="a"><visual><geometry><mesh filename="{file}"/></geometry></visual>
</link></robot>
"""


def package(directory: Path, name: str, *meshes: str) -> None:
    put(add_package(directory, name), *meshes)


def put(directory: Path, *meshes: str) -> None:
    add_files(directory, dict.fromkeys(meshes, SOUND))


def robot(path: Path, file: str) -> tuple[Diagnostic, ...]:
    add_file(path, URDF.format(file=file))
    return tuple(check(path, select=["MSH001"]).diagnostics)


@pytest.mark.parametrize(
    ("wanted", "suggested"),
    [
        # kortex: the path of the author's installation; each arm has its own base_link
        ("file:///root/c3_ws/install/arm/share/arm/gen3/7dof/base.stl", "gen3/7dof/base.stl"),
        # a number in the name of the file says nothing about its directory
        ("/home/me/arm/CADv0.1/XL430.stl", "CADv0.1/XL430.stl"),
        ("package://arm/meshes/lid.stl", "cad/lid.obj"),
        # Robotiq: the visual is a .dae, the collision the .stl
        ("package://arm/visual/palm.stl", "visual/palm.dae"),
        ("package://arm/ur10/visual/elbow.stl", None),
    ],
)
def test_a_file_elsewhere_in_the_package(
    tmp_path: Path, wanted: str, suggested: str | None
) -> None:
    meshes = ("gen3/7dof/base.stl", "gen3/6dof/base.stl", "CADv0.1/XL430.stl", "cad/lid.obj")
    package(
        tmp_path, "arm", *meshes, "collision/palm.stl", "ur5/visual/elbow.stl", "visual/palm.dae"
    )
    (found,) = robot(tmp_path / "urdf" / "r.urdf", wanted)
    offer = naming(f"package://arm/{suggested}")
    assert found.help == offer if suggested else "generate" in found.help


@pytest.mark.parametrize(
    ("there", "help"), [("link.3ds", "link.3ds"), ("LINK.SLDPRT", "LINK.SLDPRT"), ("l.step", "")]
)
def test_the_model_of_which_a_missing_file_is_an_export(
    tmp_path: Path, there: str, help: str
) -> None:
    """AUBO's arms: the meshes of another one are no replacement."""
    package(tmp_path, "arm", f"i10H_B0/{there}", "i10_A0/link.dae")
    (found,) = robot(tmp_path / "urdf" / "r.urdf", "package://arm/i10H_B0/link.dae")
    assert (help or "package://arm/i10_A0/link.dae") in found.help


def test_a_package_that_the_build_copies_from_several_directories(tmp_path: Path) -> None:
    """iCub: `package.xml` lies in one of three directories that become one package."""
    (tmp_path / ".git").mkdir()
    package(tmp_path / "arm_manual", "arm", "meshes/a.stl")
    put(tmp_path / "arm", "meshes/b.stl")
    put(tmp_path / "arm_made", "meshes_made/c.stl")
    for directory in ("arm_made", "arm_manual"):
        assert robot(tmp_path / directory / "robots" / "r.urdf", "package://arm/meshes/b.stl") == ()
    assert robot(tmp_path / "arm_made/robots/r.urdf", "package://arm/meshes_made/c.stl") == ()
    assert robot(tmp_path / "arm_made/robots/r.urdf", "package://arm/meshes_made/d.stl")
    # Another package that lacks the file is not that build.
    package(tmp_path / "other", "other", "meshes/e.stl")
    assert robot(tmp_path / "other/urdf/r.urdf", "package://arm/meshes/e.stl")


def test_of_several_files_the_nearest_is_suggested(tmp_path: Path) -> None:
    """auto-robotics-design: each of its applications has the meshes of another mechanism."""
    (tmp_path / ".git").mkdir()
    put(tmp_path, "mesh/G.stl", "apps/one/mesh/G.stl", "apps/two/mesh/G.stl")
    (found,) = robot(tmp_path / "r.urdf", "/home/me/robotics/mesh/G.stl")
    assert (found.help, found.fix) == (naming("mesh/G.stl"), None)


def test_an_absolute_path_in_another_package(tmp_path: Path) -> None:
    """uuv_simulator: `file://$(find uuv_descriptions)/mesh`, but the directory is `meshes`."""
    package(tmp_path / "boat_description", "boat_description", "meshes/prop.dae")
    package(tmp_path / "boat_plugins", "boat_plugins")
    wanted = f"file://{tmp_path}/boat_description/mesh/prop.dae"
    (found,) = robot(tmp_path / "boat_plugins" / "r.urdf", wanted)
    assert found.help == naming("package://boat_description/meshes/prop.dae")


def test_a_mesh_that_the_build_unpacks(tmp_path: Path) -> None:
    """ben_description: the repository has models/meshes/BEN_shell.dae.gz."""
    package(tmp_path, "boat")
    unpack = "execute_process(COMMAND gunzip -k ${PROJECT_SOURCE_DIR}/meshes/hull.dae.gz)\n"
    (tmp_path / "CMakeLists.txt").write_text(f"project(boat)\n{unpack}")
    (found,) = robot(tmp_path / "urdf" / "r.urdf", "package://boat/meshes/hull.dae")
    assert (found.severity, found.help) == (Severity.INFO, "build the workspace")
    (lost,) = robot(tmp_path / "urdf" / "r.urdf", "package://boat/meshes/keel.dae")
    assert lost.severity is Severity.ERROR


def test_a_missing_package_is_one_finding_for_people(tmp_path: Path) -> None:
    for name in "ab":
        robot(tmp_path / f"{name}.urdf", "package://lost/a.stl")
    found = check(tmp_path, select=["XAC011"]).diagnostics
    assert len(found) == 2
    assert values(found[0].message)[:3] == ["a", "lost", "1"]
    (one,) = grouped(found)
    assert one.message.endswith("(and 1 more like this)")
    assert [note.span.source.path.rpartition("/")[2] for note in one.related] == ["b.urdf"]


@pytest.mark.parametrize(
    ("name", "severity"),
    [("r.urdf.xacro", "info"), ("r.urdf", "warning"), ("a/b/c/r.xacro", "error")],
)
def test_a_relative_path_from_a_directory_above(tmp_path: Path, name: str, severity: str) -> None:
    """Stretch: RE1V0/xacro/*.xacro, expanded to RE1V0, name ./meshes/*.STL; fairo: PyBullet."""
    put(tmp_path, "RE1/meshes/base.stl")
    (found,) = robot(tmp_path / "RE1" / "xacro" / name, "./meshes/base.stl")
    assert found.severity.value == severity
    assert ("URDF is written" in found.message) == (severity == "info")
    assert ("PyBullet" in found.message) == (severity == "warning")


@pytest.mark.parametrize(("name", "severity"), [("r.urdf", "warning"), ("r.xacro", "error")])
def test_a_path_that_is_absolute_by_mistake(tmp_path: Path, name: str, severity: str) -> None:
    """PyBullet_Industrial_Robotics_Gym: PyBullet looks next to the URDF, too."""
    put(tmp_path, "meshes/base.stl")
    (found,) = robot(tmp_path / name, "/meshes/base.stl")
    assert (found.severity.value, found.help) == (severity, naming("slash"))
    assert ("PyBullet" in found.message) == (severity == "warning")


@pytest.mark.parametrize(
    ("directory", "severity"), [("../meshes", "info"), ("../mesh", "error"), ("", "error")]
)
def test_a_directory_of_meshes_that_mujoco_is_reported(
    tmp_path: Path, directory: str, severity: str
) -> None:
    """Fetch's Freight for MuJoCo: the URDF says where its meshes are."""
    put(tmp_path, "meshes/base.stl")
    file = 'base.stl"/></geometry></visual></link><mujoco><compiler meshdir="{}"/></mujoco>'
    text = URDF.partition("</geometry>")[0].replace('{file}"/>', file.format(directory))
    (tmp_path / "urdf").mkdir()
    (tmp_path / "urdf/r.urdf").write_text(text + "\n</robot>\n")
    (found,) = check(tmp_path / "urdf/r.urdf", select=["MSH001"]).diagnostics
    assert found.severity.value == severity


def test_files_without_a_package_are_one_finding(tmp_path: Path) -> None:
    """onshape-to-robot writes package://part.stl: no part is a package."""
    names = ("package://a.stl", "package://b.stl", "package:///c.stl")
    links = "".join(
        f'<visual><geometry><mesh filename="{name}"/></geometry></visual>' for name in names
    )
    robot = tmp_path / "r.urdf"
    robot.write_text(f'<robot name="r"><link name="a">{links}</link></robot>')
    found = check(robot, select=["MSH001", "XAC011"]).diagnostics
    assert [one.code for one in found] == ["MSH001"] * 3
    assert len(grouped(found)) == 1


def test_a_directory_is_no_package_to_declare(tmp_path: Path) -> None:
    package(tmp_path, "biped", "urdf/assets/part.stl")
    path = tmp_path / "urdf/r.urdf"
    path.write_text(URDF.format(file="package://assets/part.stl"))
    assert check(path, select=["PKG001"]).diagnostics == ()


@pytest.mark.parametrize(("link", "offered"), [("a", True), ("b", False)])
def test_a_file_that_two_missing_ones_are_like(tmp_path: Path, link: str, offered: bool) -> None:
    """quadruped_drone: motors and rotors of each leg, of which only the leg is there."""
    package(tmp_path, "arm", "meshes/leg_left.stl")
    mesh = '<visual><geometry><mesh filename="package://arm/meshes/{}"/></geometry></visual>'
    text = '<link name="a">' + mesh.format("leg_motor_left.stl")
    text += "" if link == "a" else f'</link><link name="{link}">'
    text += mesh.format("leg_rotor_left.stl") + "</link>"
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{text}</robot>')
    found = check(tmp_path / "r.urdf", select=["MSH001"]).diagnostics
    assert ["leg_left.stl" in one.help for one in found] == [offered] * 2


def test_a_path_of_another_machine_does_not_become_one_of_this(tmp_path: Path) -> None:
    """auto-robotics-design: no package, and every mesh by its path in the author's home."""
    put(tmp_path, "mesh/arm.stl")
    (found,) = robot(tmp_path / "r.urdf", "/home/somebody/robots/mesh/arm.stl")
    assert found.help == naming("mesh/arm.stl")


@pytest.mark.parametrize(("name", "is_known"), [("gripper", True), ("camera", False)])
def test_an_installed_mesh_of_another_package(tmp_path: Path, name: str, is_known: bool) -> None:
    """A UR5e that Isaac Sim wrote: its gripper is in another package of the repository."""
    package(tmp_path / "setup", "setup")
    package(tmp_path / "gripper", "gripper", "meshes/finger.stl")
    installed = f"file:///home/me/ws/install/{name}/share/{name}/meshes/finger.stl"
    (found,) = robot(tmp_path / "setup" / "urdf" / "arm.urdf", installed)
    assert (found.help == naming("package://gripper/meshes/finger.stl")) is is_known
    assert (found.fix is not None) is is_known


@pytest.mark.parametrize(
    ("file", "severity"), [("meshes/arm.stl", "warning"), ("parts/arm.stl", "error")]
)
def test_a_mesh_in_a_submodule_that_is_not_checked_out(
    tmp_path: Path, file: str, severity: str
) -> None:
    """akros2_description: all of its meshes are a repository of their own."""
    package(tmp_path, "arm")
    (tmp_path / ".git").mkdir()
    (tmp_path / ".gitmodules").write_text('[submodule "meshes"]\n\tpath = meshes\n\turl = u\n')
    (tmp_path / "meshes").mkdir()
    urdf = tmp_path / "urdf" / "arm.urdf"
    (found,) = robot(urdf, f"package://arm/{file}")
    assert found.severity.value == severity
    assert ("git submodule update --init" in str(found.help)) == (severity == "warning")
    put(tmp_path, "meshes/other.stl")
    (found,) = robot(urdf, f"package://arm/{file}")
    assert found.severity.value == "error"


@pytest.mark.parametrize(
    ("pattern", "others", "severity"),
    [
        ("*meshes*", (), Severity.WARNING),  # kscalelabs/sim: a program downloads the meshes
        ("*.stl", ("meshes/b.obj",), Severity.WARNING),
        ("*.stl", ("meshes/forearm_left.stl",), Severity.ERROR),  # which git tracks nevertheless
        ("*.obj", (), Severity.ERROR),
    ],
)
def test_a_mesh_that_git_ignores(
    tmp_path: Path, pattern: str, others: tuple[str, ...], severity: Severity
) -> None:
    if shutil.which("git") is None:
        pytest.skip("git is not installed")
    subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    (tmp_path / ".gitignore").write_text(f"{pattern}\n")
    put(tmp_path, *others)
    (found,) = robot(tmp_path / "r.urdf", "meshes/wrist_camera.stl")
    assert found.severity is severity
    assert found.message.endswith("; git ignores it") == (severity is Severity.WARNING)


@pytest.mark.parametrize(
    ("mesh", "is_fixed"),
    [
        ("robots/iiwa/meshes/link_7.stl", True),
        ("apps/widget_demo/mesh/link_7.stl", False),  # the mesh of a demo, by chance of that name
    ],
)
def test_a_file_far_away_is_not_surely_meant(tmp_path: Path, mesh: str, is_fixed: bool) -> None:
    (tmp_path / ".git").mkdir()
    put(tmp_path, mesh)
    (finding,) = robot(tmp_path / "robots" / "iiwa" / "urdf" / "iiwa.urdf", "visual/link_7.stl")
    assert "link_7.stl" in finding.help
    assert (finding.fix is not None) is is_fixed


@pytest.mark.parametrize(
    ("reference", "severity"),
    [("file://@URDF_DESTINATION@/a.stl", "info"), ("file://URDF_DESTINATION@/a.stl", "error")],
)
def test_a_path_that_cmake_replaces(tmp_path: Path, reference: str, severity: str) -> None:
    """mc_panda: configure_file writes the installed URDFs."""
    (found,) = robot(tmp_path / "r.urdf", reference)
    assert found.severity.value == severity


@pytest.mark.parametrize(
    ("file", "help"),
    [
        ("assets/wheel.stl", naming("assets/wheel.stl")),
        ("assets/body.stl", naming("relative", "package://PACKAGE")),
    ],
)
def test_a_package_that_is_missing_where_there_is_none(
    tmp_path: Path, file: str, help: str
) -> None:
    """onshape-to-robot-examples: MuJoCo's copy of the robot has its meshes in assets."""
    add_file(tmp_path / file, SOUND)
    (found,) = robot(tmp_path / "r.urdf", "package://wheel.stl")
    assert found.help == help


@pytest.mark.parametrize(("wanted", "count"), [("hip_L_Link", 0), ("hip_R_Lnik", 1)])
def test_the_mesh_of_the_other_side_is_not_offered(tmp_path: Path, wanted: str, count: int) -> None:
    package(tmp_path, "arm", "meshes/hip_R_Link.stl")
    (found,) = robot(tmp_path / "r.urdf", f"package://arm/meshes/{wanted}.stl")
    assert found.help.count("hip_R_Link") == count


def test_a_path_below_the_working_directory_of_xacro(tmp_path: Path) -> None:
    """simplefetch: its README calls xacro in the directory of the file."""
    add_file(tmp_path / "r" / "meshes" / "table.stl", SOUND)
    (found,) = robot(tmp_path / "r" / "r.xacro", "file://$(cwd)/meshes/table.stl")
    assert found.severity is Severity.INFO
    assert "$(dirname)" in found.help
    (found,) = robot(tmp_path / "r" / "r.xacro", "file://$(cwd)/meshes/tables.stl")
    assert found.severity is Severity.ERROR
