"""LAU005: see the rule."""

from pathlib import Path

import pytest

from tests.launched import launch, reported
from tests.naming import naming, values
from tests.xacros import xacro
from urdfkit import Diagnostic, check
from urdfkit.text.diagnostic import Severity

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="camera" default="true"/>
<xacro:include filename="more.xacro"/>
<link name="base_$(arg camera)_$(arg arm)"/>
</robot>"""
MORE = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="arm" default="left"/>
</robot>"""
XML = """<launch>
<param name="robot_description" command="xacro $(dirname)/r.xacro {}:=x"/>
</launch>"""


def xacro_reported(directory: Path, name: str, launch: str) -> list[Diagnostic]:
    (directory / "r.xacro").write_text(ROBOT)
    (directory / "more.xacro").write_text(MORE)
    (directory / name).write_text(launch)
    report = check(directory / name, select=["LAU005"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize(("name", "text", "line"), [("a.launch", XML, 2)])
def test_an_argument_that_the_xacro_lacks(tmp_path: Path, name: str, text: str, line: int) -> None:
    (found,) = xacro_reported(tmp_path, name, text.format("camra"))
    assert values(found.message)[1:] == ["camra", "camera"]
    assert found.help == naming("arm", "camera")
    assert found.span.line == line


def test_not_all_of_many_arguments_are_listed(tmp_path: Path) -> None:
    """Elite's cs.urdf.xacro has 35."""
    (tmp_path / "r.xacro").write_text(
        xacro("".join(f'<xacro:arg name="a{number}" default=""/>' for number in range(20)))
    )
    (tmp_path / "a.launch").write_text(XML.format("other"))
    (found,) = check(tmp_path / "a.launch", select=["LAU005"]).diagnostics
    assert found.help.endswith(" and 12 more")


@pytest.mark.parametrize("argument", ["camera", "arm"])
def test_arguments_of_included_files_are_accepted(tmp_path: Path, argument: str) -> None:
    assert xacro_reported(tmp_path, "a.launch", XML.format(argument)) == []


ROS_1 = '<include file="$(find arm)/launch/b.launch">\n<arg name="{}" value="1"/></include>'
ROS_2 = ROS_1.replace("$(find ", "$(find-pkg-share ")
TAKES = launch('<arg name="world" default="empty"/>')
PYTHON = """IncludeLaunchDescription(
    PythonLaunchDescriptionSource("b.launch.py"),
    launch_arguments={{"{}": "1"}}.items(),
)
"""
TAKES_PYTHON = 'DeclareLaunchArgument("world", default_value="empty")\n'


@pytest.mark.parametrize("text", [ROS_1, ROS_2])
def test_an_argument_that_the_file_lacks(tmp_path: Path, text: str) -> None:
    files = {"launch/b.launch": TAKES}
    (found,) = reported(tmp_path, "LAU005", "a.launch", text.format("wrld"), files)
    assert found.message == naming("b.launch", "unknown", "wrld", "world")
    assert (found.span.line, found.span.text) == (3, "wrld")
    assert reported(tmp_path, "LAU005", "a.launch", text.format("world"), files) == []


@pytest.mark.parametrize(("text", "count"), [(ROS_1, 1), (ROS_2, 0)])
def test_an_argument_of_a_file_that_cannot_be_parsed(tmp_path: Path, text: str, count: int) -> None:
    """myCobot: LAU001 reports the merge conflict, behind which the argument is declared."""
    conflict = "<<<<<<< HEAD\n=======\n>>>>>>> 24a2559\n"
    files = {"launch/b.launch": TAKES.replace("</launch>", f"{conflict}</launch>")}
    assert reported(tmp_path, "LAU005", "a.launch", text.format("world"), files) == []
    assert len(reported(tmp_path, "LAU005", "a.launch", text.format("wrld"), files)) == count


def test_in_python(tmp_path: Path) -> None:
    files = {"launch/b.launch.py": TAKES_PYTHON}
    (found,) = reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format("gui"), files)
    assert (found.message, found.span.line) == (naming("b.launch.py", "unknown", "gui"), 3)
    assert found.severity is Severity.INFO  # ROS 2 passes it and nothing reads it
    (found,) = reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format("wrld"), files)
    assert found.severity is Severity.WARNING
    assert reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format("world"), files) == []


@pytest.mark.parametrize(
    "more",
    [
        "LaunchConfiguration('gui')",
        "from arm_bringup import declare",
        "IncludeLaunchDescription(somewhere())",
        "DeclareLaunchArgument(name)",
        "def (",
    ],
)
def test_used_argument_is_accepted(tmp_path: Path, more: str) -> None:
    files = {"launch/b.launch.py": TAKES_PYTHON + more}
    assert reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format("gui"), files) == []


@pytest.mark.parametrize(
    ("more", "count"),
    [
        ("Node(parameters=[{'gui': LaunchConfiguration('world')}])", 1),
        ("gui = LaunchConfiguration('world')", 1),
        ("for name in ('gui',): LaunchConfiguration(name)", 0),
        ("Node(arguments=['--gui $(var gui)'])", 0),
    ],
)
def test_the_name_of_another_thing_is_no_argument(tmp_path: Path, more: str, count: int) -> None:
    """Elkapod: its launch file has a parameter use_sim_time, and an argument sim_mode."""
    files = {"launch/b.launch.py": TAKES_PYTHON + more}
    found = reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format("gui"), files)
    assert len(found) == count


@pytest.mark.parametrize(
    ("more", "count"),
    [
        ("path = share + '/worlds/' + LaunchConfiguration('world')", 1),
        ("LaunchConfiguration('worlds')", 0),
        ("LaunchConfiguration(variable_name='worlds')", 0),
        ("context.launch_configurations['worlds']", 0),
        ("path = 'worlds'\nLaunchConfiguration(path)", 0),
        ("path = 'worlds'\nNode(arguments=['$(var worlds)'])", 0),
    ],
)
def test_a_directory_with_nearly_the_name_of_an_argument(
    tmp_path: Path, more: str, count: int
) -> None:
    """Next to an include of a file of ROS, which may have arguments of its own."""
    included = "IncludeLaunchDescription(PythonLaunchDescriptionSource('c.launch.py'))\n"
    files = {"launch/b.launch.py": TAKES_PYTHON + included + more, "launch/c.launch.py": ""}
    found = reported(tmp_path, "LAU005", "a.launch.py", PYTHON.format("worlds"), files)
    assert [one.severity for one in found] == [Severity.WARNING] * count


def test_all_arguments_may_be_forwarded(tmp_path: Path) -> None:
    files = {"launch/b.launch": TAKES}
    text = ROS_1.format("gui").replace("b.launch", 'b.launch" pass_all_args="true', 1)
    assert reported(tmp_path, "LAU005", "a.launch", text, files) == []


def test_few_of_many_get_a_suggestion(tmp_path: Path) -> None:
    """Each name is compared with all: 1,000 of each took 10 s."""
    declared = "".join(f'<arg name="left_{n}" default="1"/>' for n in range(100))
    passed = "".join(f'<arg name="lefd_{n}" value="1"/>' for n in range(100))
    (tmp_path / "b.launch").write_text(f"<launch>{declared}</launch>")
    path = tmp_path / "a.launch"
    path.write_text(f'<launch><include file="$(dirname)/b.launch">{passed}</include></launch>')
    found = check(path, select=["LAU005"]).diagnostics
    assert len(found) == 100
    assert sum("did you mean" in one.message for one in found) == 50


def test_few_of_many_arguments_of_a_xacro_get_a_suggestion(tmp_path: Path) -> None:
    declared = "".join(f'<xacro:arg name="speed_{n}" default="1"/>' for n in range(100))
    (tmp_path / "r.xacro").write_text(ROBOT.replace("<xacro:include", declared + "<xacro:include"))
    (tmp_path / "more.xacro").write_text(MORE)
    passed = " ".join(f"spead_{n}:=1" for n in range(100))
    path = tmp_path / "a.launch"
    path.write_text(XML.replace("{}:=x", passed))
    found = check(path, select=["LAU005"]).diagnostics
    assert len(found) == 100
    assert sum("did you mean" in one.message for one in found) == 50


@pytest.mark.parametrize(("name", "count"), [("params_file", 1), ("slam_params_file", 0)])
def test_arguments_of_a_launch_file_of_ros(tmp_path: Path, name: str, count: int) -> None:
    text = (
        '<node pkg="p" exec="e"/>\n'
        '<include file="$(find-pkg-share slam_toolbox)/launch/online_async_launch.py">\n'
        f'<arg name="{name}" value="x.yaml"/>\n</include>'
    )
    found = reported(tmp_path, "LAU005", "a.launch.xml", text)
    assert ["'slam_params_file'?" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("name", "suggested"),
    [
        ("paused", "pause"),
        ("world_name", "world"),
        ("pause", ""),
        ("world", ""),
        ("gui", ""),
        ("use_sim_time", ""),
        ("headless", ""),
    ],
)
def test_arguments_of_gazebo_classic(tmp_path: Path, name: str, suggested: str) -> None:
    text = (
        '<include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py">\n'
        f'<arg name="{name}" value="$(var x)"/>\n</include>'
    )
    found = reported(tmp_path, "LAU005", "a.launch.xml", text)
    expected = [naming("gazebo.launch.py", "unknown", name, suggested)] if suggested else []
    assert [one.message for one in found] == expected


@pytest.mark.parametrize(
    ("name", "more", "suggested"),
    [
        ("params", "", "params_file"),
        ("params", '<arg name="params_file" value="x.yaml"/>', ""),  # for other files as well
        ("yaml_params_file", "", "params_file"),
        ("map", "", ""),
        ("robot_name", "", ""),
    ],
)
def test_an_argument_of_nav2_with_another_word(
    tmp_path: Path, name: str, more: str, suggested: str
) -> None:
    text = (
        '<include file="$(find-pkg-share nav2_bringup)/launch/navigation_launch.py">\n'
        f'<arg name="{name}" value="$(var x)"/>{more}\n</include>'
    )
    found = reported(tmp_path, "LAU005", "a.launch.xml", text)
    expected = naming("navigation_launch.py", "unknown", name, suggested)
    assert [one.message for one in found] == [expected] * bool(suggested)
