"""LAU004: see the rule."""

from pathlib import Path

import pytest
import yaml

from tests.launched import reported
from urdfkit import Severity, check, expand
from urdfkit.text.source import Source

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n<link name="{}"/>\n</robot>'
LAUNCH = (
    b'<launch>\n<param name="robot_description" command="xacro $(dirname)/r.xacro"/>\n</launch>'
)


def test_an_argument_that_is_not_passed(tmp_path: Path) -> None:
    (tmp_path / "r.xacro").write_text(ROBOT.format("$(arg side)_arm"))
    (found,) = check(Source(str(tmp_path / "a.launch"), LAUNCH), select=["LAU004"]).diagnostics
    assert found.span.line == 2
    assert found.message.endswith("'side' has no value and no default")
    assert found.help == "pass it: side:=VALUE"


def test_an_error_of_the_xacro_is_reported_there_with_the_launch_file(tmp_path: Path) -> None:
    (tmp_path / "r.xacro").write_text(ROBOT.format("${nothing}"))
    report = check(Source(str(tmp_path / "a.launch"), LAUNCH), select=["LAU", "XAC"])
    (found,) = report.diagnostics
    assert (found.code, found.span.line) == ("XAC001", 2)
    (step,) = found.calls[0].via
    assert (step.kind, step.name) == ("launch", "a.launch")


def test_a_robot_that_expands_is_checked_with_the_launch_file_in_the_chain(tmp_path):
    (tmp_path / "r.xacro").write_text(ROBOT.format("a").replace("</robot>", "<bad/></robot>"))
    (finding,) = check(Source(str(tmp_path / "a.launch"), LAUNCH), select=["URD"]).diagnostics
    assert finding.code == "URD001"
    assert [step.kind for step in finding.calls[0].via] == ["launch"]


def test_missing_package_is_reported_once(tmp_path):
    """The missing package of a camera caused five errors in one repository."""
    text = ROBOT.format("a").replace("<link", '<xacro:include filename="$(find camera)/a"/>\n<link')
    (tmp_path / "r.xacro").write_text(text)
    report = check(Source(str(tmp_path / "a.launch"), LAUNCH), select=["LAU", "XAC"])
    assert [diagnostic.code for diagnostic in report.diagnostics] == ["XAC011"]


COMMAND = "Node(package='p', executable='e', parameters=[{{'robot_description': {}}}])\n"


@pytest.mark.parametrize(
    ("comment", "value", "count"),
    [
        ("Author: me", "Command(['xacro ', '{path}'])", 1),
        ("an author", "Command(['xacro ', '{path}'])", 0),
        ("an\tauthor", "Command(['xacro ', '{path}'])", 1),  # which libyaml accepts
        ("Author: me", "ParameterValue(Command(['xacro ', '{path}']), value_type=str)", 0),
    ],
)
def test_a_description_without_a_type_is_read_as_yaml(
    tmp_path: Path, comment: str, value: str, count: int
) -> None:
    xml = f'<robot name="r">\n  <!-- {comment} -->\n  <link name="base"/>\n</robot>'
    text = COMMAND.format(value.format(path=tmp_path / "r.xacro"))
    found = reported(tmp_path, "LAU004", "a.launch.py", text, {"r.xacro": xml})
    assert len([one for one in found if one.severity is Severity.ERROR]) == count
    assert len(found) == ("ParameterValue" not in value)
    assert sum(f"'<!-- {comment} -->': " in one.message for one in found) == count
    expanded = expand(tmp_path / "r.xacro").text()
    if comment == "an author":
        assert isinstance(yaml.safe_load(expanded), str)
    else:
        with pytest.raises(yaml.YAMLError):
            yaml.safe_load(expanded)


@pytest.mark.parametrize(("program", "count"), [("xacro ", 0), ("cat ", 1)])
def test_xacro_replaces_the_tabs_of_a_urdf(tmp_path: Path, program: str, count: int) -> None:
    """Orcahand: tabs indent the elements, and launch runs xacro on the URDF."""
    urdf = '<robot name="r">\n\t<link name="base"/>\n</robot>'
    text = COMMAND.format(f"Command(['{program}', '{tmp_path / 'r.urdf'}'])")
    found = reported(tmp_path, "LAU004", "a.launch.py", text, {"r.urdf": urdf})
    assert len([one for one in found if one.severity is Severity.ERROR]) == count


def test_a_robot_in_one_line_that_is_a_key_and_its_value(tmp_path: Path) -> None:
    urdf = '<robot name="r"> <!-- Author: me --><link name="base"/></robot>'
    text = COMMAND.format(f"Command(['cat ', '{tmp_path / 'r.urdf'}'])")
    (found,) = reported(tmp_path, "LAU004", "a.launch.py", text, {"r.urdf": urdf})
    assert found.message.endswith("which finds a mapping or list, not text, in line 1")
    assert isinstance(yaml.safe_load(urdf), dict)


@pytest.mark.parametrize(("passed", "count"), [("", 1), (" side:=left", 0)])
def test_an_argument_above_its_default(tmp_path: Path, passed: str, count: int) -> None:
    argument = '<xacro:arg name="side" default="left"/>'
    text = ROBOT.format("$(arg side)_arm").replace("</robot>", f"{argument}</robot>")
    (tmp_path / "r.xacro").write_text(text)
    launch = LAUNCH.replace(b"r.xacro", b"r.xacro" + passed.encode())
    found = check(Source(str(tmp_path / "a.launch"), launch), select=["LAU004"]).diagnostics
    assert ["above its <xacro:arg>" in one.message for one in found] == [True] * count


INCLUDE = '<xacro:include filename="r.xacro"/>\n<link'
MACROS = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="m">{}</xacro:macro>{}</robot>"""


@pytest.mark.parametrize(("more", "count"), [("", 1), ("<xacro:m/>", 0)])
def test_a_file_that_only_defines_macros(tmp_path: Path, more: str, count: int) -> None:
    (tmp_path / "r.xacro").write_text(MACROS.format('<link name="a"/>', more))
    found = check(Source(str(tmp_path / "a.launch"), LAUNCH), select=["LAU004"]).diagnostics
    assert [one.span.line for one in found] == [2] * count


@pytest.mark.parametrize(
    ("more", "help"),
    [
        ({}, "call its macro: <xacro:m .../>"),
        ({"robot.xacro": ROBOT.format("a").replace("<link", INCLUDE)}, "name robot.xacro"),
    ],
)
def test_what_calls_the_macros(tmp_path: Path, more: dict[str, str], help: str) -> None:
    files = {"r.xacro": MACROS.format('<link name="a"/>', ""), **more}
    text = "<param name='robot_description' command='xacro $(find arm)/r.xacro'/>"
    (found,) = reported(tmp_path / "arm", "LAU004", "a.launch", text, files)
    assert found.help.startswith(help)
