from pathlib import Path

import pytest

from tests.growth import executed_lines
from tests.naming import naming
from tests.xacros import codes, marked, reported, told_of, write

WIDTH = '<xacro:property name="width" value="0.3"/>\n'
BLOCK = '<xacro:property name="width"><origin/></xacro:property>\n'
PREFIX = '<xacro:arg name="prefix" default=""/>\n'
ARM = '<xacro:macro name="arm" params="side"><link name="${side}"/></xacro:macro>\n'
BASE = '<link name="base"/>'

#: A definition, and a use of it.
USED = {
    WIDTH: '<link name="a${width}"/>',
    PREFIX: '<link name="a$(arg prefix)"/>',
    ARM: '<xacro:arm side="l"/>',
}


@pytest.mark.parametrize(
    ("definition", "marked", "message", "severity"),
    [
        (WIDTH, WIDTH.strip(), naming("width", "never"), "info"),
        (BLOCK, '<xacro:property name="width">', naming("width", "never"), "info"),
        (PREFIX, PREFIX.strip(), naming("prefix", "never"), "info"),
        (
            ARM,
            '<xacro:macro name="arm" params="side">',
            naming("arm", "never"),
            "info",
        ),
    ],
)
def test_never_used(definition: str, marked: str, message: str, severity: str) -> None:
    (found,) = reported("XAC004", definition + BASE)
    assert (found.span.line, found.span.column, found.span.text) == (2, 1, marked)
    assert (found.message, found.severity.value) == (message, severity)


@pytest.mark.parametrize(
    ("comment", "is_fixed"),
    [("<!-- ${width} -->", False), ("<!-- ${2 * width} -->", False), ("<!-- width -->", True)],
)
def test_a_use_in_a_comment_may_come_back(comment: str, is_fixed: bool) -> None:
    """Hamster: <controlPeriod> is commented out, and its property was deleted."""
    (found,) = reported("XAC004", WIDTH + comment + BASE)
    assert bool(found.fix) is is_fixed


@pytest.mark.parametrize(
    ("text", "severity"),
    [
        (WIDTH + '<link name="a"><box size="0.30 1 1"/></link>', "warning"),
        (f'{WIDTH}{BASE}<xacro:if value="false"><link name="${{widht}}"/></xacro:if>', "warning"),
        (WIDTH.replace("0.3", "left") + BASE, "info"),
        (WIDTH.replace("0.3", "${2*pi}") + BASE, "info"),
        (WIDTH.replace("0.3", "1") + '<link name="a"><box size="1 1 1"/></link>', "info"),
        (WIDTH + '<link name="a"><color rgba="0.3 0.3 0.3 1"/></link>', "info"),
        (WIDTH + '<!-- 0.3 --><xacro:property name="x" value="0.3"/><link name="a${x}"/>', "info"),
        (WIDTH.replace("0.3", "1.0") + BASE, "info"),
    ],
)
def test_a_number_that_is_written_out_where_the_property_should_stand(
    text: str, severity: str
) -> None:
    (found,) = reported("XAC004", text)
    assert found.severity.value == severity


def test_a_value_that_is_given_changes_nothing() -> None:
    (found,) = reported("XAC004", PREFIX + BASE, prefix="x")
    assert found.severity.value == "warning"
    assert found.message == naming("prefix", "never", "nothing")


def test_an_argument_whose_use_is_misspelt() -> None:
    use = '<xacro:if value="false"><link name="$(arg prefx)a"/></xacro:if>'
    (found,) = reported("XAC004", PREFIX + BASE + use)
    assert found.severity.value == "warning"


@pytest.mark.parametrize(
    "use",
    [
        WIDTH + '<link name="a_${width}"/>',
        WIDTH + '<link name="a"/><gazebo>${width}</gazebo>',
        WIDTH + '<xacro:property name="x" value="${2*width}"/><material name="${x}"/>',
        WIDTH + BASE + '<xacro:if value="false"><link name="${width}"/></xacro:if>',
        WIDTH + BASE + '<xacro:macro name="m" params="width:=^"><link/></xacro:macro><xacro:m/>',
        WIDTH + BASE + '<xacro:macro name="m" params="width:=^|1"><link/></xacro:macro><xacro:m/>',
        BLOCK + '<link name="a"/><xacro:insert_block name="width"/>',
        PREFIX + '<link name="$(arg prefix)a"/>',
        PREFIX + "<link name=\"${xacro.arg('prefix')}a\"/>",
        PREFIX + BASE + "<gazebo>$(arg prefix)</gazebo>",
        PREFIX + BASE + '<xacro:if value="false"><link name="$(arg prefix)"/></xacro:if>',
        PREFIX + '<link name="$(eval prefix)a"/>',
        PREFIX + '<xacro:arg name="b" default="$(arg prefix)"/><link name="a$(arg b)"/>',
        ARM + BASE + '<xacro:arm side="l"/>',
        ARM + BASE + '<xacro:if value="false"><xacro:arm side="l"/></xacro:if>',
        ARM + BASE + '<xacro:macro name="x"><xacro:arm side="l"/></xacro:macro><xacro:x/>',
        ARM + BASE + '<xacro:call macro="arm" side="l"/>',
        WIDTH + BASE + '<xacro:if value="false"><xacro:include filename="x"/></xacro:if>',
    ],
)
def test_used(use: str) -> None:
    assert reported("XAC004", use) == []


def test_a_use_in_a_comment_is_none() -> None:
    assert marked(reported("XAC004", f"{WIDTH}{BASE}<!-- ${{width}} -->")) == [(2, WIDTH.strip())]


def test_a_macro_that_is_called_without_its_prefix_is_another_finding() -> None:
    assert codes(f'{ARM}{BASE}<arm side="l"/>') == ["XAC002"]


@pytest.mark.parametrize("definition", USED)
def test_an_included_file_uses_it(definition: str, tmp_path: Path) -> None:
    include = '<xacro:include filename="arm.xacro"/>'
    write(tmp_path, robot=definition + include + BASE, arm=USED[definition])
    assert told_of("XAC004", tmp_path / "robot.xacro") == []


@pytest.mark.parametrize("definition", USED)
def test_a_file_that_includes_this_one_may_use_it(definition: str, tmp_path: Path) -> None:
    write(tmp_path, robot=definition + BASE)
    assert len(told_of("XAC004", tmp_path / "robot.xacro")) == 1
    write(tmp_path, big=f'<xacro:include filename="robot.xacro"/>{USED[definition]}')
    assert told_of("XAC004", tmp_path / "robot.xacro") == []


@pytest.mark.parametrize("definition", USED)
def test_of_a_library_and_of_an_included_file(definition: str, tmp_path: Path) -> None:
    assert reported("XAC004", definition) == []
    write(tmp_path, robot=f'<xacro:include filename="c.xacro"/>{BASE}', c=definition)
    assert told_of("XAC004", tmp_path / "robot.xacro") == []


def test_the_work_grows_as_the_unused_names_do() -> None:
    """Used names were collected for each: 20,000 took more than a minute."""

    def lines(number: int) -> int:
        names = "".join(f'<xacro:property name="p{n}" value="{n}"/>' for n in range(number))
        return executed_lines(lambda: reported("XAC004", names + BASE))

    lines(1)  # imports
    few, many = lines(100), lines(400)
    assert many < 5 * few
