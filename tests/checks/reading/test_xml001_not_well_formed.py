from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import reported
from urdfkit.lint import engine
from urdfkit.text.source import Source

# What is said of each mistake, and where, is tests/test_malformed.py.


def test_the_tag_that_is_not_closed_is_the_place_and_its_end_is_related() -> None:
    (found,) = reported("XML001", '<robot name="r">\n  <link name="arm">\n</robot>')
    assert (found.span.line, found.span.column, found.span.text) == (2, 3, '<link name="arm">')
    assert found.message == '<link name="arm"> is not closed before </robot>'
    (related,) = found.related
    assert (related.span.line, related.span.column, related.span.text) == (3, 1, "</robot>")
    assert found.help == ""


def test_every_typo_is_reported_and_nothing_that_follows_from_it() -> None:
    robot = (
        '<robot name="r">\n  <link name=a/>\n  <!-- a -- b -->\n  <joint name="j" & />\n</robot>'
    )
    assert [(one.span.line, one.span.column) for one in reported("XML001", robot)] == [
        (2, 14),
        (3, 10),
        (4, 19),
    ]


def test_rules_that_need_the_robot_are_skipped_and_say_why() -> None:
    report = engine.check(Source("robot.urdf", b"<robot>"))
    assert [one.code for one in report.diagnostics] == ["XML001"]
    assert {skipped.reason for skipped in report.skipped} == {"the description cannot be read"}
    assert report.exit_code() == 1


@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
def test_a_file_without_a_byte(name: str) -> None:
    (found,) = reported("XML001", b"", name)
    assert (found.message, found.span.line, found.span.column) == (naming("file", "empty"), 1, 1)
    assert found.help == naming("<robot>", "another")


def test_in_a_file_that_a_xacro_includes(tmp_path: Path) -> None:
    (tmp_path / "arm.xacro").write_text('<robot>\n  <link name="a"\n</robot>', encoding="utf-8")
    robot = tmp_path / "robot.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        '  <link name="base"/>\n  <xacro:include filename="arm.xacro"/>\n</robot>',
        encoding="utf-8",
    )
    (found,) = engine.check(robot).diagnostics
    assert (found.code, Path(found.span.source.path).name) == ("XML001", "arm.xacro")
    assert (found.span.line, found.span.column) == (2, 17)
    assert [step.span.line for step in found.calls[0].via] == [3]


def test_a_declaration_that_xacro_refuses() -> None:
    robot = '<?xml verison="1.0"?><robot name="r"><link name="a"/></robot>'
    (found,) = reported("XML001", robot, "robot.xacro")
    assert found.message == naming("declaration", 'version="1.0"')
    assert reported("XML001", robot, "robot.urdf") == [], "urdfdom forgives it: XML007"


def test_text_before_the_declaration_which_urdfdom_refuses() -> None:
    robot = 'my robot\n<?xml version="1.0"?><robot name="r"><link name="a"/></robot>'
    assert [one.span.line for one in reported("XML001", robot)] == [1, 2]


def test_what_only_expat_refuses_is_reported_in_its_words() -> None:
    (found,) = reported("XML001", '<robot name="r"><link\u00d7/></robot>')
    assert found.message == naming("not well-formed", "invalid token")
    assert (found.span.line, found.span.column) == (1, 22)


@pytest.mark.parametrize(
    ("behind", "marked", "message"),
    [
        ('<robot name="s"/>', '<robot name="s"/>', naming("<robot>", "after", "<robot>")),
        ('<link name="b"></link>', '<link name="b">', naming("<link>", "after", "<robot>")),
        ("the end", "the end", naming("after", "<robot>")),
    ],
)
@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
def test_what_follows(name: str, behind: str, marked: str, message: str) -> None:
    robot = f'<robot name="r"><link name="a"/></robot>\n\n  {behind}\n'
    (found,) = reported("XML001", robot, name)
    assert (found.span.line, found.span.column, found.span.text) == (3, 3, marked)
    assert found.message == message
    (related,) = found.related
    assert (related.span.line, related.message) == (1, "<robot> begins here")


def test_only_the_first_that_follows_is_reported() -> None:
    assert len(reported("XML001", "<robot/><a/><b/>text")) == 1


def test_comments_and_white_space_may_follow() -> None:
    assert reported("XML001", '<robot name="r"><link name="a"/></robot>\n<!-- end -->\n\n') == []


@pytest.mark.parametrize(
    ("tag", "severity"),
    [
        ("xacro:$ROBOT_NAME$", "info"),
        ("{{ tag }}", "info"),
        ("xacro:@name@", "info"),
        ("xacro:$(arg name)", "error"),
        ("xacro:arm$", "error"),
    ],
)
def test_a_template_is_an_info(tag: str, severity: str) -> None:
    """Templates of ros_team_workspace: its scripts replace `$ROBOT_NAME$`."""
    found = reported("XML001", f'<robot name="r">\n  <{tag} parent="world"/>\n</robot>')
    assert {one.severity.value for one in found} == {severity}


def test_a_namespace_with_a_line_break() -> None:
    """A Pioneer: Python's parsers separate namespace and name by a space."""
    robot = """<robot name="r" xmlns:controller="http://g/
      #controller" xmlns:xacro="http://ros.org/wiki/xacro">
  <link name="base"/>
</robot>"""
    (found,) = reported("XML001", robot, "robot.xacro")
    assert (found.span.line, found.span.text.split()) == (1, ["http://g/", "#controller"])
    assert found.message == naming("white", "namespace", "xacro")
    assert found.help == naming("namespace")
    assert reported("XML001", robot, "robot.urdf") == []
