from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import fixed, reported
from tests.xacros import NAMESPACE
from urdfkit.lint import engine


def test_every_prefix_is_reported_once_at_its_first_use() -> None:
    robot = (
        f'<robot name="r" {NAMESPACE}>\n  <gz:link name="b"/>\n  <gz:link name="c"/>\n'
        '  <link name="d" drake:acceleration="1"/>\n</robot>'
    )
    found = reported("XML007", robot, "robot.xacro")
    assert [(one.span.line, one.span.column, one.span.text, one.message) for one in found] == [
        (2, 4, "gz:link", naming("gz:", "never")),
        (4, 18, "drake:acceleration", naming("drake:", "never")),
    ]
    assert found[0].help == naming("declare", 'xmlns:gz="http://gazebosim.org/schema"')
    assert [one.fix for one in found] == [None, None]


@pytest.mark.parametrize("name", ["robot.xacro", "robot.urdf"])
def test_the_prefix_of_xacro_is_declared_by_the_fix(name: str) -> None:
    robot = '<?xml version="1.0"?>\n<robot\n  name="r"><xacro:property name="a" value="1"/></robot>'
    (found,) = reported("XML007", robot, name)
    assert found.fix is not None
    assert found.fix.safe
    assert fixed("XML007", robot, name) == robot.replace("<robot", f"<robot {NAMESPACE}")
    assert reported("XML007", fixed("XML007", robot, name), name) == []


def test_in_an_included_file(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text('<robot>\n<xacro:arg name="a" default=""/></robot>')
    robot = tmp_path / "robot.xacro"
    robot.write_text(
        f'<robot name="r" {NAMESPACE}>\n'
        '<link name="a"/><xacro:include filename="part.xacro"/></robot>'
    )
    (found,) = engine.check(robot, select=["XML007"]).diagnostics
    assert (Path(found.span.source.path).name, found.span.line) == ("part.xacro", 2)
    assert [step.span.line for step in found.calls[0].via] == [2]


def test_declared_further_in_is_declared() -> None:
    robot = f'<robot name="r"><gz:a xmlns:gz="g"><gz:b/></gz:a><link name="a" {NAMESPACE}/></robot>'
    assert reported("XML007", robot, "robot.xacro") == []


@pytest.mark.parametrize(("name", "severity"), [("r.xacro", "error"), ("r.urdf", "warning")])
def test_xacro_stops_and_urdfdom_reads_it(name: str, severity: str) -> None:
    (found,) = reported("XML007", '<robot name="r"><gz:a/><link name="b"/></robot>', name)
    assert found.severity.value == severity
