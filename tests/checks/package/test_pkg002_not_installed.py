from pathlib import Path

import pytest

from tests.launched import reported as of_launch
from tests.naming import naming
from urdfkit import Diagnostic, check

MESH = '<visual><geometry><mesh filename="package://arm/{}"/></geometry></visual>'
INSTALL = "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\n"


def reported(directory: Path, *paths: str, build: str | None = INSTALL) -> list[Diagnostic]:
    (directory / "package.xml").write_text("<package><name>arm</name></package>")
    if build is not None:
        (directory / "CMakeLists.txt").write_text(build)
    for name in ("urdf", "meshes"):
        (directory / name).mkdir(exist_ok=True)
        (directory / name / "a.stl").write_text("solid")
    file = directory / "urdf" / "r.urdf"
    meshes = "\n".join(map(MESH.format, paths))
    file.write_text(f'<robot name="r"><link name="base">\n{meshes}\n</link></robot>')
    report = check(file, select=["PKG002"])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_a_directory_that_is_not_installed(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "urdf/a.stl", "meshes/a.stl", "meshes/a.stl")
    assert found.message == naming("meshes/a.stl", f"{tmp_path}/CMakeLists.txt")
    assert found.help == "write install(DIRECTORY meshes DESTINATION share/${PROJECT_NAME})"
    assert (found.span.line, found.span.text) == (3, "package://arm/meshes/a.stl")


def test_a_macro_of_another_package_is_checked_with_its_own_build(tmp_path: Path) -> None:
    """The robot of the one package includes the laser of the other, whose mesh is not installed."""
    lidar = tmp_path / "lidar"
    for name in ("lidar", "bot"):
        (tmp_path / name / "urdf").mkdir(parents=True)
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
        (tmp_path / name / "CMakeLists.txt").write_text(INSTALL)
    (lidar / "meshes").mkdir()
    (lidar / "meshes" / "a.stl").write_text("solid")
    text = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
    mesh = MESH.replace("//arm/", "//lidar/").format("meshes/a.stl")
    macro = f'<xacro:macro name="lidar"><link name="laser">{mesh}</link></xacro:macro>'
    (lidar / "urdf" / "lidar.xacro").write_text(text.format(macro))
    include = '<xacro:include filename="$(find lidar)/urdf/lidar.xacro"/><xacro:lidar/>'
    robot = tmp_path / "bot" / "urdf" / "bot.urdf.xacro"
    robot.write_text(text.format(include))
    (found,) = check(robot, select=["PKG002"]).diagnostics
    assert found.message == naming("meshes/a.stl", f"{lidar}/CMakeLists.txt")
    assert found.span.source.path == str(lidar / "urdf" / "lidar.xacro")


ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'


@pytest.mark.parametrize(
    "path",
    ["$(find arm)/control/c.xacro", "$(find ${package})/control/c.xacro", "../control/c.xacro"],
)
def test_an_included_file(tmp_path: Path, path: str) -> None:
    """KUKA's iiwa: a property names the package."""
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "CMakeLists.txt").write_text(INSTALL)
    for name in ("urdf", "control"):
        (tmp_path / name).mkdir()
    macro = '<xacro:macro name="c"><link name="base"/></xacro:macro>'
    (tmp_path / "control" / "c.xacro").write_text(ROBOT.format(macro))
    package = '<xacro:property name="package" value="arm"/>'
    robot = tmp_path / "urdf" / "r.urdf.xacro"
    robot.write_text(
        ROBOT.format(f'{package}\n<xacro:include filename="{path}"/>\n<xacro:c/>'),
    )
    (found,) = check(robot, select=["PKG002"]).diagnostics
    assert found.message == naming("control/c.xacro", f"{tmp_path}/CMakeLists.txt")
    assert (found.span.source.path, found.span.line) == (str(robot), 2)
    (tmp_path / "CMakeLists.txt").write_text(INSTALL.replace("urdf", "urdf control"))
    assert check(robot, select=["PKG002"]).diagnostics == ()


def test_what_is_installed_or_is_not_there(tmp_path: Path) -> None:
    assert reported(tmp_path, "urdf/a.stl") == []
    assert reported(tmp_path, "meshes/b.stl") == [], "MSH001"
    assert reported(tmp_path, "meshes/a.stl", build=INSTALL.replace("urdf", "urdf meshes")) == []


def test_nothing_says_what_is_installed(tmp_path: Path) -> None:
    assert reported(tmp_path, "meshes/a.stl", build=None) == []
    assert reported(tmp_path, "meshes/a.stl", build="project(arm)") == []


def test_a_directory_that_a_property_names(tmp_path: Path) -> None:
    (tmp_path / "meshes").mkdir()
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "CMakeLists.txt").write_text(INSTALL.replace("urdf", "urdf meshes"))
    file = tmp_path / "r.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>'
        '<xacro:property name="meshes" value="package://arm/meshes/"/></robot>'
    )
    assert check(file, select=["PKG002"]).diagnostics == ()


CMAKE = "project(arm)\ninstall(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\n"
SETUP = """\
from glob import glob
import os
package_name = 'arm'
setup(name=package_name, data_files=[
    ('share/' + package_name, ['package.xml']),
    (os.path.join('share', package_name, 'launch'), glob({})),
    ('share/' + package_name + '/config', ['config/c.yaml']),
])
"""
LOAD = '<rosparam file="$(find arm)/config/c.yaml"/>'


def files(**more: str) -> dict[str, str]:
    return {"config/c.yaml": "a: 1\n"} | {k.replace("__", "."): v for k, v in more.items()}


def test_the_launch_file_itself(tmp_path: Path) -> None:
    (found,) = of_launch(
        tmp_path, "PKG002", "a.launch", LOAD, files(CMakeLists__txt=CMAKE.format("config"))
    )
    assert found.message.startswith("'launch/a.launch' is not installed")
    assert found.help == "write install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"
    assert found.span.line == 1


def test_what_it_names(tmp_path: Path) -> None:
    (found,) = of_launch(
        tmp_path, "PKG002", "a.launch", LOAD, files(CMakeLists__txt=CMAKE.format("launch"))
    )
    assert found.message.startswith("'config/c.yaml' is not installed")
    assert found.span.line == 2


WORLD = """
from ament_index_python.packages import get_package_share_directory
from launch.actions import IncludeLaunchDescription

world = get_package_share_directory("{}") + "/worlds/hall.sdf"
simulation = get_package_share_directory("ros_gz_sim") + "/launch/gz_sim.launch.py"
IncludeLaunchDescription(simulation, launch_arguments={{"gz_args": [{}]}}.items())
"""


@pytest.mark.parametrize("package", ["arm", "tool"])
def test_a_world_in_a_command_line(tmp_path: Path, package: str) -> None:
    """Also of another package, whose own build installs it."""
    own = CMAKE.format("launch") if package == "tool" else CMAKE.format("launch urdf")
    made = {
        "CMakeLists.txt": own,
        f"../{package}/worlds/hall.sdf": "<sdf version='1.9'><world name='hall'/></sdf>",
        "../tool/package.xml": "<package format='3'><name>tool</name></package>",
        "../tool/CMakeLists.txt": CMAKE.format("config"),
    }
    for world in ("world", '"-r " + world', 'f"-r {world}"'):
        text = WORLD.format(package, world)
        (found,) = of_launch(tmp_path / "arm", "PKG002", "a.launch.py", text, made)
        assert found.message.startswith("'worlds/hall.sdf' is not installed by ")
        assert found.message.endswith(f"{package}/CMakeLists.txt")


@pytest.mark.parametrize("pattern", ["'launch/*.launch.py'", "os.path.join('launch', '*.xml')"])
def test_a_pattern_that_does_not_match(tmp_path: Path, pattern: str) -> None:
    setup = SETUP.format(pattern)
    (found,) = of_launch(tmp_path, "PKG002", "a.launch", LOAD, files(setup__py=setup))
    assert found.message.startswith("'launch/a.launch' is not installed")
    assert found.help == naming("data_files", "setup.py")


@pytest.mark.parametrize(
    "pattern",
    [
        "'launch/*'",
        "'launch/a.launch'",
        "'./launch/*.launch'",
        "os.path.join('launch', '*launch*')",
        "os.path.join('launch', '*.[pyl]*')",
        "'launch/**', recursive=True",
        "DIRECTORY",
    ],
)
def test_a_pattern_that_may_match_is_calm(tmp_path: Path, pattern: str) -> None:
    setup = SETUP.format(pattern)
    assert of_launch(tmp_path, "PKG002", "a.launch", LOAD, files(setup__py=setup)) == []


@pytest.mark.parametrize(
    "cmake", [CMAKE.format("config launch"), "install(DIRECTORY ${DIRECTORIES} DESTINATION x)", ""]
)
def test_installed_or_unclear_is_calm(tmp_path: Path, cmake: str) -> None:
    assert of_launch(tmp_path, "PKG002", "a.launch", LOAD, files(CMakeLists__txt=cmake)) == []


def test_tests_stay_where_they_are(tmp_path: Path) -> None:
    made = files(CMakeLists__txt=CMAKE.format("config"))
    assert of_launch(tmp_path, "PKG002", "../a.launch", LOAD, made) == []


NESTED = """\
from glob import glob
name = "arm"
setup(name=name, data_files=[
    ("share/" + name + "/launch", glob("launch/*")),
    ({}, ["config/c.yaml"]),
{}])
"""
ELSEWHERE = "hand/setup.py installs 'config/c.yaml' as share/arm/c.yaml"


@pytest.mark.parametrize(
    ("place", "more", "count"),
    [
        ('"share/" + name', "", 1),
        ('f"share/{name}/config"', "", 0),
        ('"share/" + name', '("share/arm/config", glob("config/*"))', 0),
        ('"share/" + name', '("share/arm/config", some_files())', 0),
        ('"share/" + name', "(directory(), some_files())", 0),
    ],
)
def test_a_file_that_setup_py_installs_elsewhere(
    tmp_path: Path, place: str, more: str, count: int
) -> None:
    made = files(setup__py=NESTED.format(place, more))
    found = of_launch(tmp_path, "PKG002", "a.launch", LOAD, made)
    assert len(found) == count
    for one in found:
        assert "setup.py installs 'config/c.yaml' as share/arm/c.yaml" in one.message
        assert one.help == naming("share/arm/config", "their")


CRATE = "install(DIRECTORY models/crate DESTINATION share/${PROJECT_NAME}/models)\n"
RESOURCES = """
import os
from ament_index_python.packages import get_package_share_directory
from launch.actions import AppendEnvironmentVariable

share = get_package_share_directory("arm")
AppendEnvironmentVariable("GZ_SIM_RESOURCE_PATH", os.path.join(share, "models"))
"""


@pytest.mark.parametrize(
    ("build", "count"),
    [
        ({"CMakeLists.txt": CMAKE.format("launch")}, 1),
        ({"CMakeLists.txt": CMAKE.format("launch models")}, 0),
        ({"CMakeLists.txt": CMAKE.format("launch") + CRATE}, 0),
        ({"setup.py": SETUP.format("'launch/*'")}, 1),
        ({"setup.py": SETUP.format("'launch/*') + glob('models/crate/*'")}, 0),
    ],
)
def test_a_directory_of_the_resource_path(
    tmp_path: Path, build: dict[str, str], count: int
) -> None:
    made = build | {"models/crate/model.sdf": "<sdf/>", "config/c.yaml": "a: 1\n"}
    found = of_launch(tmp_path, "PKG002", "a.launch.py", RESOURCES, made)
    assert [one.message.split()[0] for one in found] == ["'models'"] * count
