"""Executables of a package of ROS 2, as its build file names them."""

from pathlib import Path

import pytest

from urdfkit.workspace.executables import MissingExecutable, entry_points, missing_executable

PYTHON = "<package><name>arm</name><export><build_type>ament_python</build_type></export></package>"
CMAKE = "project(arm)\nfind_package(ament_cmake REQUIRED)\n"
INSTALL = "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
BUILT = "add_executable(talker src/talker.cpp)\n"
SETUP = "from setuptools import setup\nsetup(name='arm', entry_points={})\n"
_ALL_OF_SCRIPTS = "data_files=[(os.path.join('lib', package), glob('scripts/*'))], name="
TALKER = "{'console_scripts': ['talker = arm.talker:main']}"


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        (BUILT + INSTALL, "talker", None),
        (BUILT, "talker", MissingExecutable(True, ("talker",))),
        (BUILT + INSTALL.replace("talker", "${ALL}"), "talker", None),
        (BUILT + "ament_auto_package()\n", "talker", None),
        (BUILT + INSTALL, "listener", MissingExecutable(False, ("talker",))),
        (BUILT + INSTALL + "# listener\n", "listener", MissingExecutable(False, ("talker",))),
        (BUILT + INSTALL + "include(more.cmake)\n", "listener", None),
        (BUILT + INSTALL + "install(PROGRAMS ${ALL} DESTINATION lib/arm)\n", "listener", None),
        (BUILT + INSTALL + "add_executable(${NODE} a.cpp)\n", "listener", None),
        *(
            (BUILT + INSTALL + rest, "listener", MissingExecutable(False, ("talker",)))
            for rest in (
                "include_directories(include)\ninstall(DIRECTORY include/ DESTINATION include)\n",
                "include(FetchContent)\n",
                "include(${LCM_USE_FILE})\nfile(GLOB MESSAGES *.lcm)\n",
            )
        ),
        (BUILT + INSTALL + "foreach(n a b)\nendforeach()\n", "listener", None),
        (
            "install(PROGRAMS scripts/a.py DESTINATION lib/${PROJECT_NAME})\n",
            "b.py",
            MissingExecutable(False, ("a.py",)),
        ),
        ("install(PROGRAMS scripts/a.py DESTINATION lib/${PROJECT_NAME})\n", "a.py", None),
        (
            "ament_python_install_package(arm)\ninstall(PROGRAMS a.py DESTINATION lib/arm)\n",
            "a",
            MissingExecutable(False, ("a.py",)),
        ),
        ("install(PROGRAMS scripts/a.py DESTINATION lib/arm RENAME a)\n", "a", None),
        ("install(DIRECTORY scripts DESTINATION lib/${PROJECT_NAME})\n", "a.py", None),
        (
            "add_executable(${PROJECT_NAME} a.cpp)\n" + INSTALL,
            "arm",
            MissingExecutable(True, ("arm",)),
        ),
        (
            "install(PROGRAMS scripts/a.py DESTINATION bin/)\n",
            "a.py",
            MissingExecutable(True, ("a.py",), "bin"),
        ),
        (
            BUILT + "install(TARGETS talker LIBRARY DESTINATION lib RUNTIME DESTINATION bin)\n",
            "talker",
            MissingExecutable(True, ("talker",), "bin"),
        ),
        (
            BUILT + "install(TARGETS talker LIBRARY DESTINATION lib RUNTIME DESTINATION lib/arm)\n",
            "talker",
            None,
        ),
        (BUILT + INSTALL.replace("lib/", "bin)\n") + INSTALL, "talker", None),
        (BUILT + INSTALL.replace("lib/${PROJECT_NAME}", "${BIN}"), "talker", None),
        (
            BUILT.replace("talker", "talker_node", 1) + INSTALL.replace("talker", "talker_node"),
            "talker",
            MissingExecutable(False, ("talker_node",)),
        ),
        ('rclcpp_components_register_node(a PLUGIN "b" EXECUTABLE c)\n', "c", None),
    ],
)
def test_cmake(tmp_path: Path, text: str, name: str, expected: MissingExecutable | None) -> None:
    (tmp_path / "CMakeLists.txt").write_text(CMAKE + text)
    assert missing_executable(str(tmp_path), "arm", name) == expected


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        (SETUP.format(TALKER), "talker", None),
        (SETUP.format(TALKER), "listener", MissingExecutable(False, ("talker",))),
        (SETUP.format("{}"), "listener", MissingExecutable(False, ())),
        (SETUP.format("{'console_scripts': names()}"), "listener", None),
        (SETUP.format("{}").replace("name=", "scripts=all(), name="), "listener", None),
        (SETUP.format("{}").replace("name=", _ALL_OF_SCRIPTS), "light.bash", None),
        (
            SETUP.format("{}").replace("name=", _ALL_OF_SCRIPTS.replace("'lib'", "'share'")),
            "light.bash",
            MissingExecutable(False, ()),
        ),
        (
            SETUP.format("{}").replace("name=", _ALL_OF_SCRIPTS.replace("glob('scripts/*')", "[]")),
            "light.bash",
            MissingExecutable(False, ()),
        ),
        ("setup(", "listener", None),
    ],
)
def test_setup_py(tmp_path: Path, text: str, name: str, expected: MissingExecutable | None) -> None:
    (tmp_path / "package.xml").write_text(PYTHON)
    (tmp_path / "setup.py").write_text(text)
    assert missing_executable(str(tmp_path), "arm", name) == expected


def test_console_scripts_of_setup_cfg(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(CMAKE + "ament_python_install_package(arm)\n")
    (tmp_path / "arm").mkdir()
    (tmp_path / "arm" / "setup.cfg").write_text("[options.entry_points]\n")
    assert missing_executable(str(tmp_path), "arm", "a") is None


def test_a_package_without_a_build_file(tmp_path: Path) -> None:
    assert missing_executable(str(tmp_path), "arm", "talker") is None


def test_entry_points_have_places() -> None:
    (entry,) = entry_points(SETUP.format(TALKER)) or []
    assert (entry.name, entry.module, entry.function) == ("talker", "arm.talker", "main")
    text = SETUP.format(TALKER).split("\n")[entry.line - 1]
    assert text[entry.column : entry.column + entry.length] == "'talker = arm.talker:main'"
