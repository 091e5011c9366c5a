"""LAU014: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported

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
    (found,) = reported(
        tmp_path, "LAU014", "a.launch", LOAD, files(CMakeLists__txt=CMAKE.format("config"))
    )
    assert found.message.startswith("'launch/a.launch' is not installed by ")
    assert found.help == "write install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"
    assert found.span.line == 1


def test_what_it_names(tmp_path: Path) -> None:
    (found,) = reported(
        tmp_path, "LAU014", "a.launch", LOAD, files(CMakeLists__txt=CMAKE.format("launch"))
    )
    assert found.message.startswith("'config/c.yaml' is not installed by ")
    assert found.span.line == 2


@pytest.mark.parametrize("pattern", ["'launch/*.launch.py'", "os.path.join('launch', '*.xml')"])
def test_a_pattern_that_does_not_match(tmp_path: Path, pattern: str) -> None:
    setup = SETUP.format(pattern)
    (found,) = reported(tmp_path, "LAU014", "a.launch", LOAD, files(setup__py=setup))
    assert found.message.startswith("'launch/a.launch' is not installed by ")
    assert found.help == "add the files of launch to data_files in setup.py"


@pytest.mark.parametrize(
    "pattern",
    [
        "'launch/*'",
        "'launch/a.launch'",
        "'./launch/*.launch'",
        "os.path.join('launch', '*launch*')",
        "os.path.join('launch', '*.[pyl]*')",
        "'launch/**', recursive=True",
        "FOLDER",
    ],
)
def test_a_pattern_that_may_match_is_calm(tmp_path: Path, pattern: str) -> None:
    setup = SETUP.format(pattern)
    assert reported(tmp_path, "LAU014", "a.launch", LOAD, files(setup__py=setup)) == []


@pytest.mark.parametrize(
    "cmake", [CMAKE.format("config launch"), "install(DIRECTORY ${FOLDERS} DESTINATION x)", ""]
)
def test_installed_or_unclear_is_calm(tmp_path: Path, cmake: str) -> None:
    assert reported(tmp_path, "LAU014", "a.launch", LOAD, files(CMakeLists__txt=cmake)) == []


def test_tests_stay_where_they_are(tmp_path: Path) -> None:
    made = files(CMakeLists__txt=CMAKE.format("config"))
    assert reported(tmp_path, "LAU014", "../a.launch", LOAD, made) == []
