import pytest

from tests.naming import naming
from tests.xacros import marked, reported, xacro
from urdfkit.lint import engine
from urdfkit.text.schema import XACRO_TAGS
from urdfkit.text.source import Source

ARM = '<xacro:macro name="arm" params="side"><link name="${side}"/></xacro:macro>\n'


def test_a_macro() -> None:
    (found,) = reported("XAC002", f'{ARM}<link name="base"/>\n<arm side="left"/>')
    assert (found.span.line, found.span.text) == (4, '<arm side="left"/>')
    assert found.message == naming("arm", "without")
    assert found.help == naming("prefix", "<xacro:...>")


def test_a_macro_inside_a_link() -> None:
    body = (
        '<xacro:macro name="default_inertial" params="m"><inertial/></xacro:macro>\n'
        '<link name="base">\n<default_inertial m="1"/></link>'
    )
    assert marked(reported("XAC002", body)) == [(4, '<default_inertial m="1"/>')]


@pytest.mark.parametrize("tag", sorted(XACRO_TAGS))
def test_a_tag_of_xacro(tag: str) -> None:
    (found,) = reported("XAC002", f'{ARM}<xacro:arm side="a"/>\n<{tag} {XACRO_TAGS[tag]}="b"/>')
    assert found.span.line == 4
    assert found.message == f"<{tag}> is a tag of xacro without its prefix"


def test_a_tag_of_another_program_is_not_that_of_xacro() -> None:
    """AUBO's joints have a ``<property>`` of their own."""
    body = (
        '<link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/>'
        '<child link="b"/><property inertia="4.9" ratio="101"/></joint>'
    )
    assert reported("XAC002", f'{ARM}<xacro:arm side="a"/>{body}') == []


def test_no_other_rule_says_the_same() -> None:
    body = f'{ARM}<link name="base"><arm side="l"/></link>\n<arm side="r"/><include filename="x"/>'
    report = engine.check(Source("robot.xacro", xacro(body).encode()))
    codes = [one.code for one in report.diagnostics]
    assert codes.count("XAC002") == 3
    assert not [code for code in codes if code.startswith("URD") or code == "XAC004"]


def test_elements_of_urdf_and_of_gazebo_may_be_called_like_a_macro() -> None:
    body = (
        '<xacro:macro name="inertial" params=""><inertial/></xacro:macro>\n'
        '<xacro:macro name="plugin" params=""><gazebo/></xacro:macro>\n'
        '<link name="a"><inertial/></link><gazebo><plugin/><include/></gazebo>'
    )
    assert reported("XAC002", body) == []


def test_a_macro_may_be_called_robot() -> None:
    assert reported("XAC002", '<xacro:macro name="robot" params=""/><link name="a"/><robot/>') == []


def test_a_plain_urdf_is_another_rule() -> None:
    source = Source("a.urdf", b'<robot name="r"><link name="a"/><include/></robot>')
    report = engine.check(source, select=["XML", "XAC", "URD"])
    assert [one.code for one in report.diagnostics] == ["URD001"]
