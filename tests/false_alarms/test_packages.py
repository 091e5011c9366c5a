"""Packages that are built and installed as they should be."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, reported
from tests.workspaces import add_file
from tests.xacros import xacro
from urdfkit import check
from urdfkit.text.diagnostic import Severity


@pytest.mark.parametrize(("inner", "count"), [("arm", 0), ("other", 1)])
def test_a_superbuild_around_the_package(tmp_path: Path, inner: str, count: int) -> None:
    """Husarion: `project(SUPERBUILD NONE)`, and the package in the other branch."""
    text = f"if(X)\n  project(SUPERBUILD NONE)\nelse()\n  project({inner})\nendif()\n"
    found = reported(tmp_path / "arm", "PKG007", "a.launch", "", {"CMakeLists.txt": text})
    assert len(found) == count


def test_files_that_a_setup_py_puts_into_one_directory(tmp_path: Path) -> None:
    """Nav2's loopback simulator and wheeltec: `glob('launch/*/*')` makes one flat directory."""
    setup = (
        "import os\nfrom glob import glob\nfrom setuptools import setup\n\nname = 'arm'\n"
        "setup(name=name, data_files=[(os.path.join('share', name, 'launch'), "
        "glob('launch/*.*') + glob('launch/*/*.*')), ('share/' + name, glob('config/*.yaml'))])\n"
    )
    files = {"setup.py": setup, "launch/nav/b.launch": "<launch/>", "config/a.yaml": ""}
    found = '<include file="$(find arm)/launch/b.launch"/><rosparam file="$(find arm)/a.yaml"/>'
    assert reported(tmp_path / "arm", "LAU003", "a.launch", found, files) == []
    lost = found.replace("launch/b", "launch/nav/c").replace("a.yaml", "b.yaml")
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", lost, files)) == 2


@pytest.mark.parametrize(
    "listed",
    [
        "files = []\nfiles.append(('share/arm', glob('launch/*')))",
        "files = []\nfiles += [('share/arm', glob('launch/*'))]",
        "files = [('share/arm', [])]\nfiles.extend([('share/arm', glob('launch/*'))])",
    ],
)
def test_files_that_a_setup_py_appends(tmp_path: Path, listed: str) -> None:
    """panda_ros2_gazebo installs its launch files next to the package.xml."""
    text = f"from glob import glob\n{listed}\nsetup(name='arm', data_files=files)\n"
    files = {"setup.py": text, "launch/b.launch": "<launch/>"}
    for name, count in (("b.launch", 0), ("c.launch", 1)):
        include = f'<include file="$(find arm)/{name}"/>'
        found = reported(tmp_path / "arm", "LAU003", "a.launch", include, files)
        assert len(found) == count


def test_the_marker_of_a_package_with_another_name(tmp_path: Path) -> None:
    """robotis_gz_sim, whose package.xml says robotis: one finding names the cause."""
    manifest = "<package><name>arm</name><export><build_type>ament_python</build_type></export>"
    setup = (
        "package_name = 'arm_sim'\nsetup(\n    name=package_name,\n    data_files=["
        "('share/ament_index/resource_index/packages', ['resource/' + package_name])])\n"
    )
    add_file(tmp_path / "package.xml", f"{manifest}</package>".encode())
    add_file(tmp_path / "setup.py", setup.encode())
    path = add_file(tmp_path / "launch" / "a.launch.py", b"")
    found = check(path, select=["PKG008"]).diagnostics
    assert not any("resource/" in one.message for one in found)
    assert any("differs from" in one.message for one in found)


def test_what_colcon_still_does_by_itself(tmp_path: Path) -> None:
    """A planner without `data_files`: colcon makes the entry in the index, and warns."""
    manifest = MANIFEST.replace(
        "</package>", "<export><build_type>ament_python</build_type></export></package>"
    )
    package = tmp_path / "arm"
    files = {"setup.py": "from setuptools import setup\nsetup(name='arm')\n"}
    reported(package, "PKG008", "a.launch", "", files)
    (package / "package.xml").write_text(manifest)
    (found,) = check(package / "launch" / "a.launch", select=["PKG008"]).diagnostics
    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(("pattern", "count"), [("meshes/arm/*.stl", 0), ("meshes/*.stl", 1)])
def test_a_directory_whose_files_are_installed(tmp_path: Path, pattern: str, count: int) -> None:
    """AKROS2: an argument with the directory of the meshes, `package://.../meshes/`."""
    setup = (
        "from glob import glob\nfrom setuptools import setup\n"
        f"setup(name='arm', data_files=[('share/arm/meshes', glob('{pattern}'))])\n"
    )
    robot = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="meshes" default="package://arm/meshes/arm/"/><link name="a"/></robot>'
    )
    files = {"setup.py": setup, "meshes/arm/a.stl": "", "urdf/r.xacro": robot}
    reported(tmp_path / "arm", "PKG002", "a.launch", "", files)
    found = check(tmp_path / "arm" / "urdf" / "r.xacro", select=["PKG002"]).diagnostics
    assert len(found) == count


@pytest.mark.parametrize(("kind", "mentions"), [("ament_python", []), ("ament_cmake", [1])])
def test_a_build_file_that_the_build_does_not_read(
    tmp_path: Path, kind: str, mentions: list[int]
) -> None:
    """Bipedal-URDF: a CMakeLists.txt, left from a template, in a package of Python."""
    build = f"<export><build_type>{kind}</build_type></export>"
    (tmp_path / "package.xml").write_text(f"<package><name>arm</name>{build}</package>")
    (tmp_path / "CMakeLists.txt").write_text(
        "project(amr)\ninstall(DIRECTORY launch DESTINATION share/arm)\n"
    )
    (tmp_path / "setup.py").write_text(
        "package_name = 'arm'\n"
        "setup(data_files=[('share/arm/urdf', glob('urdf/*')), ('share/arm/meshes', glob('*')),\n"
        "    ('share/ament_index/resource_index/packages', ['setup.py'])])\n"
    )
    for directory in ("launch", "urdf", "meshes"):
        (tmp_path / directory).mkdir()
    (tmp_path / "meshes" / "a.stl").write_bytes(b"")
    mesh = '<visual><geometry><mesh filename="package://arm/meshes/a.stl"/></geometry></visual>'
    robot = tmp_path / "urdf" / "r.urdf"
    robot.write_text(f'<robot name="r"><link name="a">{mesh}</link></robot>')
    for code in ("PKG002", "PKG007"):
        found = check(robot, select=[code]).diagnostics
        assert [one.message.count("CMakeLists.txt") for one in found] == mentions


@pytest.mark.parametrize(
    ("named", "count"), [("urdf/r.urdf.xacro", 0), ("description/urdf/r.urdf.xacro", 1)]
)
def test_a_description_by_the_path_at_which_it_is_installed(
    tmp_path: Path, named: str, count: int
) -> None:
    """odrive_ros2_control_example: `description/urdf` is installed as `share/<package>/urdf`."""
    cmake = "project(arm)\ninstall(DIRECTORY description/urdf launch DESTINATION share/arm)\n"
    robot = '<robot name="r"><link name="base"/></robot>'
    files = {"CMakeLists.txt": cmake, "description/urdf/r.urdf.xacro": robot}
    text = f"Command(['xacro ', FindPackageShare('arm'), '/{named}'])\n"
    assert len(reported(tmp_path / "arm", "PKG002", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(
    ("named", "count"),
    [
        ("config//arm/a.yaml", 0),
        ("./config/arm/../arm/a.yaml", 0),
        ("meshes//a.yaml", 1),
    ],
)
def test_a_path_that_is_written_in_another_way(tmp_path: Path, named: str, count: int) -> None:
    files = {
        "CMakeLists.txt": "project(arm)\ninstall(DIRECTORY config DESTINATION share/arm)\n",
        "config/arm/a.yaml": "",
        "meshes/a.yaml": "",
        "urdf/r.urdf": f'<robot name="r"><link name="$(find arm)/{named}"/></robot>',
    }
    reported(tmp_path / "arm", "PKG002", "a.launch", "", files)
    found = check(tmp_path / "arm" / "urdf" / "r.urdf", select=["PKG002"]).diagnostics
    assert len(found) == count


@pytest.mark.parametrize(("installed", "count"), [("urdf launch", 0), ("urdf", 1)])
def test_a_launch_file_in_a_directory_of_the_model(
    tmp_path: Path, installed: str, count: int
) -> None:
    """Plankton's tutorial: ros2 launch finds the file anywhere below share/<package>."""
    place = "share/${PROJECT_NAME}/models/rov"
    text = f"project(arm)\ninstall(DIRECTORY {installed} DESTINATION {place})\n"
    found = reported(tmp_path / "arm", "PKG002", "a.launch.py", "", {"CMakeLists.txt": text})
    assert len(found) == count


@pytest.mark.parametrize(
    ("installed", "count"),
    [
        ("headers/ DESTINATION include", 1),
        ("headers/ DESTINATION include FILES_MATCHING PATTERN *.h", 0),
        ("headers/ DESTINATION include)\ninstall(DIRECTORY launch DESTINATION x FILES_MATCHING", 1),
    ],
)
def test_a_directory_of_which_some_files_are_installed(
    tmp_path: Path, installed: str, count: int
) -> None:
    """The driver of Xsens: CMake installs nothing, and does not stop."""
    text = "project(arm)\nfind_package(ament_cmake REQUIRED)\n"
    text += f"install(DIRECTORY {installed})\nament_package()\n"
    found = reported(tmp_path / "arm", "PKG007", "a.launch", "", {"CMakeLists.txt": text})
    assert ["'headers' is installed" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("installed", "line"),
    [
        ("install(DIRECTORY include DESTINATION x)", 4),
        ("install(DIRECTORY ${ALL} DESTINATION x)", 3),
    ],
)
def test_the_place_where_a_directory_is_installed(
    tmp_path: Path, installed: str, line: int
) -> None:
    """vox_nav: what include_directories names need not exist."""
    text = "project(arm)\nfind_package(ament_cmake REQUIRED)\nset(ALL include)\n" + installed
    files = {"CMakeLists.txt": text + "\nament_package()\n"}
    (found,) = reported(tmp_path / "arm", "PKG007", "a.launch", "", files)
    assert (found.span.line, found.span.text) == (line, "include")


@pytest.mark.parametrize(("mark", "count"), [("COLCON_IGNORE", 0), ("README", 1)])
def test_a_package_that_the_build_skips(tmp_path: Path, mark: str, count: int) -> None:
    """dm_imu_python in a biped's workspace lacks the file of its name in resource/."""
    setup = (
        "from setuptools import setup\nsetup(name='arm', data_files=["
        "('share/ament_index/resource_index/packages', ['resource/arm'])])\n"
    )
    files = {"setup.py": setup, mark: ""}
    assert len(reported(tmp_path / "arm", "PKG008", "a.launch", "", files)) == count


MACRO = """macro(attach robot out)
  set(body models/${robot}_body.urdf)
  COMMAND(OUTPUT models/${out} COMMAND attach.sh ${body})
endmacro()
attach(arm "arm_sensors.urdf")
"""


@pytest.mark.parametrize(
    ("command", "file", "severity"),
    [
        ("add_custom_command", "arm_sensors.urdf", "warning"),
        ("add_custom_command", "arm_body.urdf", "warning"),
        ("add_custom_command", "leg_body.urdf", "error"),
        ("message", "arm_sensors.urdf", "error"),
    ],
)
def test_files_that_a_macro_of_cmake_creates(
    tmp_path: Path, command: str, file: str, severity: str
) -> None:
    """rtmros_tutorials: macros add sensors and hands to the robots that others convert."""
    add_file(tmp_path / "CMakeLists.txt", MACRO.replace("COMMAND(", f"{command}(").encode())
    include = f'<xacro:include filename="{file}"/><link name="a"/>'
    add_file(tmp_path / "models" / "r.urdf.xacro", xacro(include).encode())
    found = check(tmp_path / "models" / "r.urdf.xacro", select=["XAC001"]).diagnostics
    assert [one.severity.value for one in found] == [severity]


@pytest.mark.parametrize(("other", "code"), [("arm", "XAC011"), ("", "XAC001")])
def test_a_few_files_that_lie_over_an_installed_package(
    tmp_path: Path, other: str, code: str
) -> None:
    """UR10e with RG6: ur_description without package.xml, whose other files are installed.

    In a copy without any package the directory stands for the package.
    """
    file = tmp_path / "src/ur_description/urdf/robot.xacro"
    add_file(tmp_path / "src/ur_description/urdf/macro.xacro", b"<robot/>")
    find = '<xacro:include filename="$(find ur_description)/urdf/{}.xacro"/>'
    add_file(file, xacro('<link name="base"/>' + find.format("macro") + find.format("common")))
    if other:
        add_file(tmp_path / "src" / other / "package.xml", MANIFEST.encode())
    found = check(file, select=["XAC001", "XAC011"]).diagnostics
    assert [(one.code, one.span.text) for one in found] == [
        (code, "$(find ur_description)/urdf/common.xacro")
    ]
