"""Classes that packages of a workspace export to pluginlib."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, add_files, add_package
from urdfkit import check
from urdfkit.workspace.plugin_descriptions import why_unknown
from urdfkit.workspace.resolve import Resolver

CMAKE = """find_package(ament_cmake REQUIRED)
pluginlib_export_plugin_description_file(hardware_interface ${PROJECT_NAME}.xml)
"""
DESCRIPTION = """<library path="drives">
  <!-- <class name="drives/Old" type="drives::Old"/> -->
  <class name="drives/Can"
         type="drives::Can" base_class_type="hardware_interface::SystemInterface"/>
  <class type="drives::Serial" base_class_type="hardware_interface::SystemInterface"/>
</library>
"""


def workspace(tmp_path: Path, build: str = CMAKE, description: str = DESCRIPTION) -> str:
    files = {"CMakeLists.txt": build, "drives.xml": description}
    add_files(add_package(tmp_path / "drives", "drives"), files)
    return str(add_file(add_package(tmp_path / "bot", "bot") / "urdf/bot.urdf"))


@pytest.mark.parametrize("name", ["drives/Can", "drives::Serial", "other/Can"])
def test_a_class_that_is_exported_or_not_known(tmp_path: Path, name: str) -> None:
    near = workspace(tmp_path)
    assert why_unknown(name, "hardware_interface", near, Resolver()) is None


@pytest.mark.parametrize(
    ("name", "written"),
    [("drives/Old", "one of drives/Can, drives::Serial"), ("drives/Cann", "drives/Can")],
)
def test_a_class_that_is_not_exported(tmp_path: Path, name: str, written: str) -> None:
    near = workspace(tmp_path)
    message, help = why_unknown(name, "hardware_interface", near, Resolver()) or ("", "")
    assert message.startswith(f"package 'drives' exports no class '{name}'")
    assert help.startswith(f"write {written}, or")


@pytest.mark.parametrize("path", ["../secret.xml", "/tmp/secret.xml"])
def test_files_outside_the_package_are_not_read(tmp_path: Path, path: str) -> None:
    add_file(tmp_path / "secret.xml", DESCRIPTION.encode())
    near = workspace(tmp_path, CMAKE.replace("${PROJECT_NAME}.xml", path))
    assert why_unknown("drives/Cann", "hardware_interface", near, Resolver()) is None


def test_a_description_that_is_not_exported(tmp_path: Path) -> None:
    near = workspace(tmp_path, CMAKE.partition("\n")[0])
    message, help = why_unknown("drives/Can", "hardware_interface", near, Resolver()) or ("", "")
    assert (
        message
        == "CMakeLists.txt of 'drives' does not export drives.xml, which describes 'drives/Can'"
    )
    assert help == "write pluginlib_export_plugin_description_file(hardware_interface drives.xml)"


@pytest.mark.parametrize(
    "build",
    [
        CMAKE + "add_subdirectory(more)\n",  # may export others
        CMAKE.replace("${PROJECT_NAME}", "${NAME}"),
        CMAKE.replace("ament_cmake", "catkin"),  # whose package.xml exports
        "find_package(ament_cmake REQUIRED)\n",  # and no description names the class
    ],
)
def test_a_package_whose_exports_are_not_clear(tmp_path: Path, build: str) -> None:
    near = workspace(tmp_path, build)
    assert why_unknown("drives/Spi", "hardware_interface", near, Resolver()) is None


def test_a_class_that_another_package_exports_under_this_name(tmp_path: Path) -> None:
    near = workspace(tmp_path)
    description = DESCRIPTION.replace('"drives/Can"', '"drives/Spi"')
    files = {"CMakeLists.txt": CMAKE, "spi.xml": description}
    add_files(add_package(tmp_path / "spi", "spi"), files)
    assert why_unknown("drives/Spi", "hardware_interface", near, Resolver()) is None


ROBOT = """<robot name="bot"><link name="base"/>
<ros2_control name="c" type="system">
<hardware><plugin>drives/Cann</plugin></hardware></ros2_control></robot>
"""


def test_hardware_that_its_package_does_not_export(tmp_path: Path) -> None:
    Path(workspace(tmp_path)).write_text(ROBOT)
    (found,) = check(tmp_path / "bot/urdf/bot.urdf", select=["RCT005"]).diagnostics
    assert (found.span.line, "did you mean 'drives/Can'" in found.message) == (3, True)
