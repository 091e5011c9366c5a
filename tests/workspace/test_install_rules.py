from pathlib import Path

import pytest

from tests.workspaces import add_file
from urdfkit.workspace.install_rules import InstallRules, is_built

INSTALL = "project(arm)\ninstall(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\n".format


def installs(directory: Path, text: str, path: str, file: str = "CMakeLists.txt") -> bool:
    (directory / file).write_text(text)
    return InstallRules(str(directory), "arm").installs(path)


@pytest.mark.parametrize(
    ("text", "path", "installed"),
    [
        (INSTALL("urdf meshes"), "meshes/a.stl", True),
        (INSTALL("urdf"), "meshes/a.stl", False),
        (INSTALL("meshes_old"), "meshes/a.stl", False),
        ("install(DIRECTORY v DESTINATION share/arm/meshes)", "meshes", True),
        (INSTALL("."), "meshes/a.stl", True),
        (INSTALL("src/meshes"), "meshes/a.stl", True),
        (INSTALL("urdf # meshes\n"), "meshes/a.stl", False),
        (INSTALL("${DIRECTORIES}"), "meshes/a.stl", True),
        ("set(F meshes)\n" + INSTALL("${F}"), "meshes/a.stl", True),
        ("set(F urdf)\n" + INSTALL("${F}"), "meshes/a.stl", False),
        ("file(GLOB F *)\n" + INSTALL("urdf ${F}"), "meshes/a.stl", True),
        ("foreach(d urdf)\n" + INSTALL("${d}") + "endforeach()", "meshes/a.stl", False),
        ("add_subdirectory(more)\n" + INSTALL("urdf"), "meshes/a.stl", True),
        ("include(cmake/more.cmake)\n" + INSTALL("urdf"), "meshes/a.stl", True),
        ("include(GNUInstallDirs)\n" + INSTALL("urdf"), "meshes/a.stl", False),
        ("my_install_all()\n" + INSTALL("urdf"), "meshes/a.stl", True),
        ("catkin_install_python(PROGRAMS a)\n" + INSTALL("urdf"), "meshes/a.stl", False),
        ("project(arm)\n", "meshes/a.stl", True),
        ("install(TARGETS arm DESTINATION lib/arm)", "meshes/a.stl", True),
    ],
)
def test_cmake(tmp_path: Path, text: str, path: str, installed: bool) -> None:
    assert installs(tmp_path, text, path) is installed


@pytest.mark.parametrize(
    ("text", "installed"),
    [
        ("data_files=[('share/arm/meshes', glob('meshes/*'))]", True),
        ("data_files=[('share/arm/urdf', glob('urdf/*'))]", False),
        ("for root, _, files in os.walk('.'): pass", True),
        ("glob('**/*', recursive=True)", True),
        ("data_files=[('share/arm/meshes', glob('meshes/*.dae', recursive=True))]", False),
    ],
)
def test_setup_py(tmp_path: Path, text: str, installed: bool) -> None:
    assert installs(tmp_path, text, "meshes/a.stl", "setup.py") is installed


def test_no_build_file(tmp_path: Path) -> None:
    shipping = InstallRules(str(tmp_path), "arm")
    assert shipping.file == ""
    assert shipping.installs("meshes/a.stl")


def test_the_fix(tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_text("")
    assert InstallRules(str(tmp_path), "arm").advice("urdf") == (
        "add the files of urdf to data_files in setup.py"
    )
    (tmp_path / "CMakeLists.txt").write_text("")
    assert InstallRules(str(tmp_path), "arm").advice("urdf") == (
        "write install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})"
    )


def test_comments_make_no_files(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text("# the header file (see below)\nproject(arm)\n")
    assert not InstallRules(str(tmp_path), "arm").makes_files
    (tmp_path / "CMakeLists.txt").write_text("file(COPY a DESTINATION b)\n")
    assert InstallRules(str(tmp_path), "arm").makes_files


@pytest.mark.parametrize(
    ("text", "more", "makes"),
    [
        ("file(GLOB F src/*.cpp)\nfile(READ a b)", "", False),  # f1tenth_simulator
        ("File(WRITE a b)", "", True),
        (
            "add_subdirectory(src)",
            "add_library(a a.cpp)\ninstall(TARGETS a DESTINATION lib)",
            False,
        ),
        ("add_subdirectory(src)", "install(DIRECTORY launch DESTINATION share/arm)", True),
        ("add_subdirectory(src)", "add_custom_target(b)", True),
        ("add_subdirectory(src)", "ADD_SUBDIRECTORY(more)", True),
        ("add_subdirectory(${A})", "", True),
    ],
)
def test_commands_that_make_files(tmp_path: Path, text: str, more: str, makes: bool) -> None:
    add_file(tmp_path / "CMakeLists.txt", text)
    add_file(tmp_path / "src" / "CMakeLists.txt", more)
    assert InstallRules(str(tmp_path), "arm").makes_files is makes


@pytest.mark.parametrize(
    ("command", "built"),
    [
        ("execute_process(COMMAND gunzip -k ${PROJECT_SOURCE_DIR}/meshes/a.stl.gz)", True),
        ("add_custom_command(OUTPUT meshes/a.stl COMMAND make_it)", True),
        ('file(DOWNLOAD https://x.org/a.stl "${CMAKE_CURRENT_SOURCE_DIR}/meshes/a.stl")', True),
        ("catkin_download(a.stl https://x.org/1)", True),
        ("install(FILES ${CMAKE_CURRENT_BINARY_DIR}/a.stl DESTINATION share/arm/meshes)", True),
        ("install(FILES meshes/a.stl DESTINATION share/arm)", False),
        ("execute_process(COMMAND gunzip -k meshes/aa.stl.gz)", False),
        ("execute_process(COMMAND git log)\nset(MESH meshes/a.stl)", False),
        ("# execute_process(COMMAND gunzip -k meshes/a.stl.gz)", False),
        ("generate_gazebo_mesh(${models}/a.dae)", True),
        ("generate_gazebo_mesh(${models}/ba.dae)", False),
    ],
)
def test_a_file_that_the_build_creates(tmp_path: Path, command: str, built: bool) -> None:
    (tmp_path / "CMakeLists.txt").write_text(f"project(arm)\n{command}\n")
    assert is_built(str(tmp_path / "meshes" / "a.stl")) is built
