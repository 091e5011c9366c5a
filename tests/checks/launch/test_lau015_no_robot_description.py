"""LAU015: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming

NODE = "Node(package='robot_state_publisher', executable='robot_state_publisher'{})\n"
XML = '<node pkg="robot_state_publisher" exec="robot_state_publisher">{}</node>'


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        (NODE.format(""), ""),
        (NODE.format(", parameters=[{'use_sim_time': True}]"), ""),
        (NODE.format(", parameters=[{'robot_descripton': x}]"), "robot_descripton"),
    ],
)
def test_without_a_robot(tmp_path: Path, text: str, mistake: str) -> None:
    (found,) = reported(tmp_path, "LAU015", "a.launch.py", text)
    other = [mistake, "robot_description"] if mistake else []
    assert found.message == naming("robot_state_publisher", "robot_description", *other)


def test_in_xml(tmp_path: Path) -> None:
    text = XML.format('<param name="use_sim_time" value="true"/>')
    assert len(reported(tmp_path, "LAU015", "a.launch", text)) == 1


@pytest.mark.parametrize(
    "text",
    [
        NODE.format(", parameters=[{'robot_description': x, 'use_sim_time': True}]"),
        "p = {'robot_description': x}\n" + NODE.format(", parameters=[p]"),
        "p = {}\np.update(config.robot_description)\n" + NODE.format(", parameters=[p]"),
        "p = {}\np['robot_description'] = x\n" + NODE.format(", parameters=[p]"),
        "p = [{'a': 1}]\np.append({'robot_description': x})\n" + NODE.format(", parameters=p"),
        NODE.format(", parameters=[unknown()]"),
        NODE.format(", parameters=[{**p}]"),
        NODE.format(", parameters=p"),
        NODE.format(", arguments=['arm.urdf']"),
        NODE.format(", ros_arguments=['--params-file', 'a.yaml']"),
    ],
)
def test_passed_or_unknown_description_is_accepted(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU015", "a.launch.py", text) == []


@pytest.mark.parametrize(
    "text",
    [
        XML.format('<param name="robot_description" value="x"/>'),
        XML.format('<param from="a.yaml"/>'),
        XML.replace("exec", "type").format(""),  # of ROS 1
    ],
)
def test_valid_in_xml(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU015", "a.launch", text) == []


@pytest.mark.parametrize(("value", "count"), [("'a.urdf'", 1), ("'<robot/>'", 0)])
def test_the_path_of_a_file(tmp_path: Path, value: str, count: int) -> None:
    text = NODE.format(f", parameters=[{{'robot_description': {value}}}]")
    assert len(reported(tmp_path, "LAU015", "a.launch.py", text)) == count


XACRO = {
    "arm.xacro": '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:if value="1"/></robot>'
}
PLAIN = {"arm.xacro": "<robot><!-- <xacro:if/> --></robot>"}
#: myCobot's URDFs: URDF parsers ignore the property, which nothing uses.
UNUSED = {"arm.xacro": XACRO["arm.xacro"].replace('if value="1"', 'property name="w" value="1"')}
USED = {"arm.xacro": UNUSED["arm.xacro"].replace("</robot>", '<link name="${w}"/></robot>')}
READS = [
    "text = open('../arm.xacro').read()\n",
    "with open('../arm.xacro') as f:\n    text = f.read()\n",
    "from pathlib import Path\ntext = Path('../arm.xacro').read_text()\n",
]


@pytest.mark.parametrize("read", READS)
@pytest.mark.parametrize(("files", "count"), [(XACRO, 1), (PLAIN, 0), (UNUSED, 0), (USED, 1)])
def test_unexpanded_xacro(tmp_path: Path, read: str, files: dict[str, str], count: int) -> None:
    text = read + NODE.format(", parameters=[{'robot_description': text}]")
    assert len(reported(tmp_path, "LAU015", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(("program", "count"), [("cat", 1), ("xacro", 0)])
def test_a_command_that_expands_nothing(tmp_path: Path, program: str, count: int) -> None:
    command = f"$(command '{program} $(dirname)/../arm.xacro')"
    text = f'<param name="robot_description" type="str" value="{command}"/>'
    text = f'<node pkg="robot_state_publisher" exec="robot_state_publisher">{text}</node>'
    assert len(reported(tmp_path, "LAU015", "a.launch.xml", text, XACRO)) == count


@pytest.mark.parametrize(("files", "count"), [(XACRO, 1), (PLAIN, 0), (UNUSED, 0), ({}, 1)])
def test_the_path_of_a_xacro_file(tmp_path: Path, files: dict[str, str], count: int) -> None:
    """A file that is only called .xacro is read by robot_state_publisher, too."""
    text = NODE.format(f", arguments=['{tmp_path}/arm.xacro']")
    assert len(reported(tmp_path, "LAU015", "a.launch.py", text, files)) == count


def test_expanded_xacro_is_accepted(tmp_path: Path) -> None:
    text = "import xacro\ntext = xacro.parse(open('../arm.xacro')).toxml()\n"
    text += NODE.format(", parameters=[{'robot_description': text}]")
    assert reported(tmp_path, "LAU015", "a.launch.py", text, XACRO) == []


def test_a_textfile_of_ros_1(tmp_path: Path) -> None:
    text = '<param name="robot_description" textfile="$(dirname)/../arm.xacro"/>'
    (found,) = reported(tmp_path, "LAU015", "a.launch", text, XACRO)
    assert found.message == naming("arm.xacro", "without")
