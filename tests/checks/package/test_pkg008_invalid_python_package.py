"""PKG008: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, reported
from tests.naming import naming
from tests.workspaces import add_files
from urdfkit import Diagnostic, check

BUILD_TYPE = "<export><build_type>ament_python</build_type></export></package>"
PYTHON = MANIFEST.replace("</package>", BUILD_TYPE)
SETUP = """\
package_name = 'arm'
setup(data_files=[
    ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
])
"""


def built(directory: Path, manifest: str, setup: str, *more: str) -> list[Diagnostic]:
    """The findings for a package with further files, which are empty."""
    files = {"package.xml": manifest, "setup.py": setup, **dict.fromkeys(more, "")}
    return reported(directory / "arm", "PKG008", "a.launch", "", files)


def test_another_name(tmp_path: Path) -> None:
    (found,) = built(tmp_path, MANIFEST, "package_name = 'amr'\n")
    assert found.message == naming("amr", "setup.py", "arm", "package.xml")
    assert found.span.text == "amr"


def test_without_the_index(tmp_path: Path) -> None:
    (found,) = built(tmp_path, PYTHON, "setup(data_files=[])", "resource/arm")
    assert found.message == naming("nothing", "share/ament_index/resource_index/packages", "arm")
    assert found.severity.value == "warning"
    assert Path(found.span.source.path).name == "setup.py"


def test_without_the_file_in_it(tmp_path: Path) -> None:
    (found,) = built(tmp_path, PYTHON, SETUP)
    assert found.message == naming("resource/arm", "setup.py")
    assert found.span.line == 3


def test_without_a_build_type(tmp_path: Path) -> None:
    (found,) = built(tmp_path, MANIFEST, SETUP, "resource/arm")
    assert found.message == naming("colcon", "CMakeLists.txt")
    assert Path(found.span.source.path).name == "package.xml"


@pytest.mark.parametrize(
    ("manifest", "setup", "more"),
    [
        (PYTHON, SETUP, ["resource/arm"]),
        (PYTHON, SETUP.replace("'resource/' + package_name", "MARKER"), []),
        (MANIFEST, "setup()", []),
        (MANIFEST, SETUP, ["CMakeLists.txt"]),
        (PYTHON.replace("ament_python", "cmake"), "setup()", []),
    ],
)
def test_registered_or_unclear_is_calm(
    tmp_path: Path, manifest: str, setup: str, more: list[str]
) -> None:
    assert built(tmp_path, manifest, setup, *more) == []


RUNNING = """\
from setuptools import setup
package_name = "arm"
setup(
    data_files=[("share/ament_index/resource_index/packages", ["resource/arm"])],
    entry_points={"console_scripts": ["talk = arm.talker:main"]},
)
"""
CONFIG = "[develop]\nscript_dir=$base/lib/arm\n[install]\ninstall_scripts=$base/lib/arm\n"


def started(
    directory: Path,
    setup: str,
    config: str | None = CONFIG,
    module: str = "def main(): ...",
    more: tuple[str, ...] = (),
) -> list[Diagnostic]:
    """The findings for a package with an executable."""
    files = {"package.xml": PYTHON, "setup.py": setup, "arm/talker.py": module}
    files |= dict.fromkeys(("resource/arm", *more), "")
    files |= {} if config is None else {"setup.cfg": config}
    return reported(directory / "arm", "PKG008", "a.launch", "", files)


@pytest.mark.parametrize(
    ("setup", "config", "module", "message", "line"),
    [
        (RUNNING, None, "def main(): ...", "setup.cfg does not set install_scripts", 5),
        (RUNNING, "[develop]\n", "def main(): ...", "setup.cfg does not set install_scripts", 5),
        (
            RUNNING,
            CONFIG.replace("lib/arm", "lib/leg"),
            "def main(): ...",
            "the executables are",
            4,
        ),
        (
            RUNNING.replace("arm.talker", "arm.talk"),
            CONFIG,
            "def main(): ...",
            "executable 'talk': there is no",
            5,
        ),
        (RUNNING, CONFIG, "def run(): ...", "executable 'talk': arm.talker has", 5),
    ],
)
def test_executables_that_do_not_start(
    tmp_path: Path, setup: str, config: str | None, module: str, message: str, line: int
) -> None:
    (found,) = started(tmp_path, setup, config, module)
    assert found.message.startswith(message)
    assert found.span.line == line


@pytest.mark.parametrize(
    ("setup", "config"),
    [
        (RUNNING, CONFIG),
        (RUNNING, CONFIG.replace("_s", "-s")),
        (RUNNING.replace("talk = arm.talker:main", "talk = other.talker:main"), CONFIG),
        (RUNNING.replace('["talk = arm.talker:main"]', "[]"), None),
        (RUNNING.replace(":main", ":Talker.main"), CONFIG),  # my_ros2_robot_gazebo: a method
    ],
)
def test_executables_that_start(tmp_path: Path, setup: str, config: str | None) -> None:
    assert started(tmp_path, setup, config) == []


@pytest.mark.parametrize(("module", "hint"), [("talkr", "; did you mean 'talker'?"), ("baker", "")])
def test_a_module_of_another_name(tmp_path: Path, module: str, hint: str) -> None:
    """ROS2_gazebo: test_node is not suber_node."""
    (found,) = started(tmp_path, RUNNING.replace("arm.talker", f"arm.{module}"))
    assert found.message == f"executable 'talk': there is no module arm.{module}{hint}"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("setup(", "setup(,", "setup.py is not a Python"),
        (
            "setup(",
            'setup(packages=["arms"], ',
            "setup.py names the package 'arms'",
        ),
        ("setup(", 'setup(packages=["arm"], ', ""),
        (
            "arm.talker",
            "arm.nodes.talker",
            "executable 'talk': there is no module arm.nodes.talker",
        ),
        (
            "setup(",
            "from setuptools import find_packages\nsetup(packages=find_packages(), ",
            "find_packages does not find 'arm'",
        ),
        (
            "setup(",
            "from setuptools import *\nsetup(packages=find_namespace_packages(), ",
            "",
        ),
        ("setup(", "import glob\nsetup(x=glob('a'), ", "setup.py calls the module 'glob'"),
        ("setup(", "import glob\nsetup(x=glob.glob('a'), ", ""),
        ("setup(", "import glob\nfrom glob import glob\nsetup(x=glob('a'), ", ""),
        ("setup(", "setup(x=os.path, ", "setup.py: name 'os' is not defined"),
    ],
)
def test_modules_that_are_not_built(tmp_path: Path, old: str, new: str, message: str) -> None:
    found = started(tmp_path, RUNNING.replace(old, new))
    assert len(found) == bool(message)
    assert all(one.message.startswith(message) for one in found)


@pytest.mark.parametrize(
    ("pattern", "count"), [("*.launch.py", 1), ("launch/*.launch.py", 0), ("*.md", 0)]
)
def test_a_pattern_without_its_directory(tmp_path: Path, pattern: str, count: int) -> None:
    files = f"data_files=[('share/arm/launch', glob('{pattern}'))], "
    setup = "from glob import glob\n" + RUNNING.replace("setup(", f"setup({files}")
    found = started(tmp_path, setup, more=("launch/arm.launch.py",))
    assert [one.span.text for one in found] == [f"'{pattern}'"] * count


@pytest.mark.parametrize(
    ("listed", "help"),
    [
        ("launch/arms.launch.py", "write launch/arm.launch.py"),
        (
            "launch/arms.launch.py', 'launch/arm.launch.py",
            "remove it",
        ),  # which is installed already
        ("launch/b.launch.py", "remove it"),
        ("launch/arm.launch.py", None),
        ("launch/arm.pt", "remove it"),  # a model is not a launch file
        ("x.txt", "remove it"),
        ("resource/other", "write resource/"),
        ("models/walk.pt", "remove it"),  # spider_robot_ws: nor does the directory exist
    ],
)
def test_a_listed_file(tmp_path: Path, listed: str, help: str | None) -> None:
    setup = RUNNING.replace("setup(", f"setup(data_files=[('share/arm', ['{listed}'])], ")
    found = started(tmp_path, setup, more=("launch/arm.launch.py",))
    missing = listed.partition("'")[0]
    assert [one.span.text for one in found] == ([] if help is None else [f"'{missing}'"])
    assert all(one.help.startswith(help or "") for one in found)


def test_the_package_of_a_node_that_is_started(tmp_path: Path) -> None:
    files = {
        "talk/package.xml": PYTHON.replace("<name>arm", "<name>talk"),
        "talk/resource/talk": "",
        "talk/talk/talker.py": "def main(): ...",
        "talk/setup.cfg": CONFIG.replace("lib/arm", "lib/talk"),
        "talk/setup.py": RUNNING.replace("arm.talker", "talk.talk").replace("arm", "talk"),
        "arm/package.xml": MANIFEST,
        "arm/launch/a.launch.xml": '<launch><node pkg="talk" exec="talk"/></launch>',
        ".git/HEAD": "",
    }
    add_files(tmp_path, files)
    report = check(tmp_path / "arm" / "launch" / "a.launch.xml", select=["PKG008"])
    (found,) = report.diagnostics
    assert "no module talk.talk;" in found.message
