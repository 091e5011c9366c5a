"""PKG005: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST
from tests.naming import naming
from tests.workspaces import add_files
from urdfkit import Diagnostic, check

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/>{}</robot>'
MESH = '<link name="b"><visual><geometry><mesh filename="package://arm/b.stl"/></geometry></visual></link>'
USES = '<xacro:include filename="$(find arm)/b.xacro"/>'


def reported(directory: Path, manifest: str, more: str = USES) -> list[Diagnostic]:
    (directory / "package.xml").write_text(manifest)
    (directory / "b.xacro").write_text(ROBOT.format(""))
    (directory / "urdf").mkdir()
    (directory / "urdf" / "r.xacro").write_text(ROBOT.format(more))
    report = check(directory / "urdf" / "r.xacro", select=["PKG005"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize(
    ("old", "new", "message", "line"),
    [
        ("  <license>Apache-2.0</license>\n", "", "the package has no <license>", 2),
        ("<version>1.0.0</version>", "", "the package has no <version>", 2),
        (">1.0.0<", ">1.0<", "version '1.0' does not", 4),
        (">1.0.0<", "><", "version '' does not", 4),
        (' email="arm@example.org"', "", "the maintainer has", 6),
        (">Apache-2.0<", "><", "the license is", 7),
        ("</package>", "<run_depend>a</run_depend></package>", "<run_depend> is not a tag of ", 8),
        (
            "</package>",
            "<exec_dep>a</exec_dep></package>",
            "<exec_dep> is not a tag of format 3",
            8,
        ),
        ("</package>", "<depend>arm</depend></package>", "the package depends on", 8),
        ("</license>", "</licence>", "package.xml is not valid", 7),
        ("<license>", "<licence>", "package.xml is not valid", 7),
        ("</package>", "<export/><export/></package>", "duplicate <export>", 8),
    ],
)
def test_an_invalid_manifest(tmp_path: Path, old: str, new: str, message: str, line: int) -> None:
    assert old in MANIFEST
    (found,) = reported(tmp_path, MANIFEST.replace(old, new))
    assert found.message.startswith(message)
    assert (Path(found.span.source.path).name, found.span.line) == ("package.xml", line)


@pytest.mark.parametrize(("wrong", "help"), [("run_depend", "exec_depend"), ("depnd", "depend")])
def test_the_tag_that_was_meant(tmp_path: Path, wrong: str, help: str) -> None:
    text = MANIFEST.replace("</package>", f"<{wrong}>xacro</{wrong}></package>")
    assert reported(tmp_path, text)[0].help == f"write <{help}>"


def test_a_package_without_a_name(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, MANIFEST.replace("<name>arm</name>", ""), MESH)
    assert found.message == naming("package", "<name>")


@pytest.mark.parametrize(
    "manifest",
    [
        MANIFEST,
        MANIFEST.replace('"3"', '"1"') + "<!-- <run_depend>a</run_depend> -->",
        MANIFEST.replace("</package>", '<depend condition="$X">a</depend><export/></package>'),
        MANIFEST.replace("An arm.", "An <b>arm</b>."),
        MANIFEST.replace('"3"', '"4"').replace("</package>", "<new/></package>"),
        "<package><name>arm</name><version>1</version></package>",
    ],
)
def test_what_the_build_takes_is_calm(tmp_path: Path, manifest: str) -> None:
    assert reported(tmp_path, manifest) == []


def test_a_robot_that_uses_no_package_does_not_mind(tmp_path: Path) -> None:
    assert reported(tmp_path, MANIFEST.replace("1.0.0", "1"), "") == []


def test_a_launch_file_does(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST.replace("1.0.0", "1"))
    (tmp_path / "a.launch").write_text("<launch/>")
    assert len(check(tmp_path / "a.launch", select=["PKG005"]).diagnostics) == 1


ROBOT_PROJECT = """<robot name="r"><link name="base">
<visual><geometry><mesh filename="package://arm/a.stl"/></geometry></visual>
</link></robot>"""


def reported_project(directory: Path, build: str, file: str = "CMakeLists.txt") -> list[Diagnostic]:
    (directory / "package.xml").write_text("<package><name>arm</name></package>")
    (directory / file).write_text(build)
    (directory / "r.urdf").write_text(ROBOT_PROJECT)
    report = check(directory / "r.urdf", select=["PKG005"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize(
    ("file", "build"),
    [
        ("CMakeLists.txt", "# project(arm)\nproject(amr VERSION 1.0)\n"),
        ("CMakeLists.txt", 'PROJECT (\n  "amr")\n'),
        ("setup.py", "from setuptools import setup\npackage_name = 'amr'\n"),
    ],
)
def test_another_name(tmp_path: Path, file: str, build: str) -> None:
    (found,) = reported_project(tmp_path, build, file)
    assert found.message == naming("amr", file, "arm", "package.xml")
    assert found.span.source.path == str(tmp_path / file)
    assert found.span.text == "amr"


@pytest.mark.parametrize(
    "build", ["project(arm)", "project(${NAME})", "", "# no project here", "myproject(amr)"]
)
def test_the_same_name_or_none_that_is_written_out(tmp_path: Path, build: str) -> None:
    assert reported_project(tmp_path, build) == []


TYPE = "<export><build_type>ament_python</build_type></export>"
PYTHON = MANIFEST.replace("</package>", f"{TYPE}</package>")
SETUP = """\
package_name = 'arm'
setup(data_files=[
    ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
])
"""


def reported_python(directory: Path, manifest: str, setup: str, *more: str) -> list[Diagnostic]:
    (directory / "package.xml").write_text(manifest)
    (directory / "setup.py").write_text(setup)
    for name in more:
        (directory / name).parent.mkdir(exist_ok=True)
        (directory / name).touch()
    (directory / "a.launch").write_text("<launch/>")
    report = check(directory / "a.launch", select=["PKG005"])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_without_the_index(tmp_path: Path) -> None:
    (found,) = reported_python(tmp_path, PYTHON, "setup(data_files=[])", "resource/arm")
    assert found.message == naming("nothing", "share/ament_index/resource_index/packages", "arm")
    assert found.severity.value == "warning"
    assert Path(found.span.source.path).name == "setup.py"


def test_without_the_file_in_it(tmp_path: Path) -> None:
    (found,) = reported_python(tmp_path, PYTHON, SETUP)
    assert found.message == naming("resource/arm", "setup.py")
    assert found.span.line == 3


def test_without_a_build_type(tmp_path: Path) -> None:
    (found,) = reported_python(tmp_path, MANIFEST, SETUP, "resource/arm")
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
    assert reported_python(tmp_path, manifest, setup, *more) == []


@pytest.mark.parametrize(
    ("kind", "needed"),
    [
        (TYPE, [naming("ament_python", "setup.py", "CMakeLists.txt")]),
        (TYPE.replace("ament_python", "ament_cmake"), []),
        (f"<!-- {TYPE} -->", []),
    ],
)
def test_the_build_file_of_the_build_type(tmp_path: Path, kind: str, needed: list[str]) -> None:
    (tmp_path / "CMakeLists.txt").write_text("project(arm)\n")
    found = reported(tmp_path, PYTHON.replace(TYPE, kind))
    assert [one.message for one in found] == needed


@pytest.mark.parametrize(
    ("last", "count"),
    [
        ("ament_package()", 0),
        ("ament_auto_package()", 0),
        ("# ament_package()", 1),
        ("", 1),
        ("include(cmake/package.cmake)", 0),
    ],
)
def test_ament_package_is_called(tmp_path: Path, last: str, count: int) -> None:
    text = f"project(arm)\nfind_package(ament_cmake REQUIRED)\n{last}\n"
    (tmp_path / "CMakeLists.txt").write_text(text)
    assert len(reported(tmp_path, MANIFEST)) == count


REGISTERED = "RCLCPP_COMPONENTS_REGISTER_NODE({})\n"


@pytest.mark.parametrize(
    ("named", "source", "meant"),
    [
        ("arm::WatchDog", REGISTERED.format("arm::Watchdog"), ["arm::Watchdog"]),
        ("arm::Watchdog", REGISTERED.format("Watchdog"), ["Watchdog"]),
        ("arm::Watchdog", REGISTERED.format("arm::dog::Watchdog"), ["arm::dog::Watchdog"]),
        ("arm::Watchdog", REGISTERED.format("arm::Watchdog"), []),
        ("arm::Watchdog", "// " + REGISTERED.format("arm::WatchDog"), []),
        ("arm::Watchdog", "#define A(X) " + REGISTERED.format("arm::X") + "A(Watchdog)", []),
        ("${PROJECT_NAME}::WatchDog", REGISTERED.format("arm::Watchdog"), []),
        ("arm::Reader", REGISTERED.format("arm::Watchdog"), []),  # of a generated source
    ],
)
def test_components(tmp_path: Path, named: str, source: str, meant: list[str]) -> None:
    """From basler/pylon-ros-camera#190."""
    calls = f'rclcpp_components_register_node(dog PLUGIN "{named}" EXECUTABLE dog)\n'
    (tmp_path / "CMakeLists.txt").write_text(f"find_package(a)\n{calls}ament_package()\n")
    (tmp_path / "src").mkdir()
    (tmp_path / "src/dog.cpp").write_text(source)
    found = reported(tmp_path, MANIFEST)
    assert [(one.span.text, one.message.split("'")[3]) for one in found] == [
        (named, name) for name in meant
    ]


@pytest.mark.parametrize(
    ("first", "count"),
    [("", 1), ("# find_package(ament_cmake)", 1), ("include(a.cmake)", 0), ("find_package(a)", 0)],
)
def test_ament_package_is_known(tmp_path: Path, first: str, count: int) -> None:
    (tmp_path / "CMakeLists.txt").write_text(f"project(arm)\n{first}\nament_package()\n")
    found = [one for one in reported(tmp_path, MANIFEST) if "is unknown" in one.message]
    assert len(found) == count


OF_PYTHON = MANIFEST.replace(
    "</package>", "<export><build_type>ament_python</build_type></export></package>"
)
RUNNING = """\
from setuptools import setup
package_name = "arm"
setup(
    data_files=[("share/ament_index/resource_index/packages", ["resource/arm"])],
    entry_points={"console_scripts": ["talk = arm.talker:main"]},
)
"""
CONFIG = "[develop]\nscript_dir=$base/lib/arm\n[install]\ninstall_scripts=$base/lib/arm\n"


def of_python(directory: Path, setup: str, config: str | None, module: str) -> list[Diagnostic]:
    for name in ("resource", "arm"):
        (directory / name).mkdir()
    (directory / "resource" / "arm").write_text("")
    (directory / "arm" / "talker.py").write_text(module)
    (directory / "setup.py").write_text(setup)
    if config is not None:
        (directory / "setup.cfg").write_text(config)
    return reported(directory, OF_PYTHON)


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
    (found,) = of_python(tmp_path, setup, config, module)
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
    assert of_python(tmp_path, setup, config, "def main(): ...") == []


@pytest.mark.parametrize(
    ("tag", "message", "help"),
    [
        ("<depend>rospy</depend>", "<depend> rospy: ROS 2", "write rclpy"),
        (
            "<exec_depend>ros-gz-sim</exec_depend>",
            "<exec_depend> ros-gz-sim: the name",
            "write ros_gz_sim",
        ),
        ('<depend condition="$ROS_VERSION == 1">rospy</depend>', "", ""),
        ("<exec_depend>python3-numpy</exec_depend>", "", ""),
    ],
)
def test_dependencies_that_ros_2_does_not_have(
    tmp_path: Path, tag: str, message: str, help: str
) -> None:
    manifest = MANIFEST.replace(
        "</package>", f"{tag}<export><build_type>ament_cmake</build_type></export></package>"
    )
    found = reported(tmp_path, manifest)
    assert len(found) == bool(message)
    assert all(one.message.startswith(message) and one.help == help for one in found)


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
    setup = RUNNING.replace(old, new)
    found = of_python(tmp_path, setup, CONFIG, "def main(): ...")
    assert len(found) == bool(message)
    assert all(one.message.startswith(message) for one in found)


@pytest.mark.parametrize(
    ("pattern", "count"), [("*.launch.py", 1), ("launch/*.launch.py", 0), ("*.md", 0)]
)
def test_a_pattern_without_its_directory(tmp_path: Path, pattern: str, count: int) -> None:
    files = f"data_files=[('share/arm/launch', glob('{pattern}'))], "
    setup = "from glob import glob\n" + RUNNING.replace("setup(", f"setup({files}")
    (tmp_path / "launch").mkdir()
    (tmp_path / "launch" / "arm.launch.py").write_text("")
    found = of_python(tmp_path, setup, CONFIG, "def main(): ...")
    assert [one.span.text for one in found] == [f"'{pattern}'"] * count


@pytest.mark.parametrize(
    ("listed", "help"),
    [
        ("launch/b.launch.py", "write "),
        ("launch/arm.launch.py", None),
        ("x.txt", "remove it"),
        ("models/walk.pt", "remove it"),  # spider_robot_ws: nor does the directory exist
    ],
)
def test_a_listed_file(tmp_path: Path, listed: str, help: str | None) -> None:
    setup = RUNNING.replace("setup(", f"setup(data_files=[('share/arm', ['{listed}'])], ")
    (tmp_path / "launch").mkdir()
    (tmp_path / "launch" / "arm.launch.py").write_text("")
    found = of_python(tmp_path, setup, CONFIG, "def main(): ...")
    assert [one.span.text for one in found] == ([] if help is None else [f"'{listed}'"])
    assert all(one.help.startswith(help or "") for one in found)


INTERFACES = """cmake_minimum_required(VERSION 3.8)
project(arm_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(std_msgs REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Load.msg"
  DEPENDENCIES std_msgs)
ament_package()
"""
GROUP = "<member_of_group>rosidl_interface_packages</member_of_group>"


@pytest.mark.parametrize(
    ("old", "new", "group", "message"),
    [
        ("", "", GROUP, ""),
        ("", "", "", "package.xml has no <member_of_group>"),
        ("std_msgs)", "std_msgs SKIP_INSTALL)", "", ""),
        ("Load", "Laod", GROUP, "interface 'msg/Laod.msg' does not exist"),
        ("msg/", "interfaces/", GROUP, "interface 'interfaces/Load.msg' does not exist"),
        ("find_package(std_msgs REQUIRED)", "", GROUP, "CMakeLists.txt does not find std_msgs"),
        ("find_package(std_msgs", "find_package(nav_msgs", GROUP, ""),  # which finds std_msgs
        ("find_package(std_msgs", "foreach(name a b)\n#", GROUP, ""),
        ("msg/Load.msg", "${files}", GROUP, ""),
    ],
)
def test_interfaces(tmp_path: Path, old: str, new: str, group: str, message: str) -> None:
    """They are those of a package on which the package of the robot depends."""
    messages, robot = tmp_path / "arm_msgs", tmp_path / "arm"
    (messages / "msg").mkdir(parents=True)
    robot.mkdir()
    manifest = MANIFEST.replace("<name>arm<", "<name>arm_msgs<")
    (messages / "package.xml").write_text(manifest.replace("</package>", f"{group}</package>"))
    (messages / "CMakeLists.txt").write_text(INTERFACES.replace(old, new, 1))
    (messages / "msg" / "Load.msg").write_text("float64 mass\n")
    dependency = "<depend>arm_msgs</depend><export><build_type>ament_cmake</build_type></export>"
    found = reported(robot, MANIFEST.replace("</package>", f"{dependency}</package>"))
    assert [one.message.startswith(message) for one in found] == [True] * bool(message)


def test_a_tag_of_a_later_format(tmp_path: Path) -> None:
    text = MANIFEST.replace('"3"', '"2"').replace("</package>", f"{GROUP}</package>")
    assert [one.help for one in reported(tmp_path, text)] == ['write format="3"']


FINDS = "project(arm)\nfind_package(ament_cmake REQUIRED)\n{}\nament_package()\n"


@pytest.mark.parametrize(
    ("command", "depend", "count"),
    [
        ("find_package(arm_msgs REQUIRED)", "", 1),
        ("find_package(arm_msgs REQUIRED)", "<depend>arm_msgs</depend>", 0),
        ("find_package(arm_msgs REQUIRED)", "<depend>tools</depend>", 0),  # which depends on it
        ("find_package(arm_msgs QUIET)", "", 0),
        ("# find_package(arm_msgs REQUIRED)", "", 0),
        ("find_package(other REQUIRED)", "", 0),
    ],
)
def test_a_package_that_is_found_and_not_declared(
    tmp_path: Path, command: str, depend: str, count: int
) -> None:
    robot = tmp_path / "arm"
    manifest = MANIFEST.replace("<name>arm<", "<name>{}<")
    for name, more in (("arm_msgs", ""), ("tools", "<depend>arm_msgs</depend>"), ("arm", "")):
        (tmp_path / name).mkdir()
        text = manifest.format(name).replace("</package>", f"{more}</package>")
        (tmp_path / name / "package.xml").write_text(text)
    (robot / "CMakeLists.txt").write_text(FINDS.format(command))
    found = reported(robot, MANIFEST.replace("</package>", f"{depend}</package>"))
    assert ["does not declare" in one.message for one in found] == [True] * count


def test_the_package_of_a_node_that_is_started(tmp_path: Path) -> None:
    files = {
        "talk/package.xml": OF_PYTHON.replace("<name>arm", "<name>talk"),
        "talk/resource/talk": "",
        "talk/talk/talker.py": "def main(): ...",
        "talk/setup.cfg": CONFIG.replace("lib/arm", "lib/talk"),
        "talk/setup.py": RUNNING.replace("arm.talker", "talk.talk").replace("arm", "talk"),
        "arm/package.xml": MANIFEST,
        "arm/launch/a.launch.xml": '<launch><node pkg="talk" exec="talk"/></launch>',
        ".git/HEAD": "",
    }
    add_files(tmp_path, files)
    report = check(tmp_path / "arm" / "launch" / "a.launch.xml", select=["PKG005"])
    (found,) = report.diagnostics
    assert "no module talk.talk;" in found.message
