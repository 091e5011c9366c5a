from pathlib import Path

import pytest

from tests.naming import naming
from tests.xacros import codes, marked, reported, told_of, write, xacro
from urdfkit import check

MACRO = '<xacro:macro name="m" params="a b:=1 *c"><link name="l${a}"/></xacro:macro>\n'


@pytest.mark.parametrize(
    ("body", "place", "message", "help"),
    [
        (
            '<link name="a${x}"/>',
            "${x}",
            naming("x", "${x}"),
            naming("x", "above"),
        ),
        (
            '<link name="${widht}"/><xacro:property name="width" value="1"/>',
            "${widht}",
            naming("widht", "${widht}"),
            naming("widht", "above", "width"),
        ),
        (
            '<link name="${a}"/><xacro:property name="a" value="1"/>',
            "${a}",
            naming("a", "${a}"),
            naming("a", "robot.xacro:2:20", "above"),
        ),
        (
            '<xacro:arg name="a" default="1"/><link name="${a}"/>',
            "${a}",
            naming("a", "${a}"),
            naming("a", "$(arg a)", "above"),
        ),
        (
            (
                '<xacro:macro name="m" params="p"><link name="$(arg p)"/></xacro:macro>'
                '<xacro:m p="q"/>'
            ),
            "$(arg p)",
            naming("p"),
            naming("${p}"),
        ),
        ('<link name="${1/0}"/>', "${1/0}", naming("zero", "${1/0}"), ""),
        (
            '<link name="${1 +}"/>',
            "${1 +}",
            naming("syntax", "${1 +}"),
            naming("Python"),
        ),
        ('<link name="${1"/>', "${1", naming("${1", "never"), naming("missing", "}")),
        ('<link name="$(arg"/>', "$(arg", naming("$(arg", "never"), naming("missing", ")")),
        (
            "<xacro:wheel/>",
            "xacro:wheel",
            naming("wheel", "defined"),
            naming("above", "call"),
        ),
        (
            f"{MACRO}<xacro:mm/>",
            "xacro:mm",
            naming("mm", "defined"),
            naming("above", "m"),
        ),
        (
            f'{MACRO}<xacro:m a="1" z="2"><x/></xacro:m>',
            "2",
            naming("m", "z"),
            "it has: a, b, *c",
        ),
        (
            f"{MACRO}<xacro:m><x/></xacro:m>",
            "xacro:m",
            naming("m", "without a"),
            naming("every", "without"),
        ),
        (
            f'{MACRO}<xacro:m a="1"/>',
            "xacro:m",
            naming("m", "*c"),
            naming("*c", "call"),
        ),
        (
            f'{MACRO}<xacro:m a="1"><x/><y/></xacro:m>',
            "xacro:m",
            naming("m", "<y>"),
            naming("delete", "parameter"),
        ),
        (
            '<xacro:insert_block name="z"/>',
            "xacro:insert_block",
            naming("block", "z"),
            naming("insert_block", "elements"),
        ),
        (
            '<xacro:if value="maybe"><link/></xacro:if>',
            "maybe",
            naming("maybe", "neither"),
            naming("true", "false"),
        ),
        (
            '<xacro:property name="x" scope="parent" value="1"/>',
            "parent",
            naming('scope="parent"', "outside"),
            "delete the scope",
        ),
        (
            '<xacro:property name="zero" value="0"/><link name="${1 / zero}"/>',
            "${1 / zero}",
            naming("division by zero", "${1 / zero}"),
            naming("zero", "is 0", "definition"),
        ),
        (
            '<xacro:property name="n" value="3"/><link name="${[0][n]}"/>',
            "${[0][n]}",
            naming("${[0][n]}"),
            naming("n", "3"),
        ),
        ('<link name="${true}"/>', "${true}", naming("true", "${true}"), "write True"),
        (
            '<xacro:arg name="a"/>',
            "xacro:arg",
            naming("<xacro:arg>", "default"),
            naming('default="..."', "$(arg NAME)"),
        ),
        (
            "<xacro:include/>",
            "<xacro:include/>",
            naming("<xacro:include>", "filename"),
            naming('filename="..."'),
        ),
        (
            '<xacro:property name="1x" value="1"/>',
            "1x",
            naming("1x"),
            "write letters, digits and _, and no digit first",
        ),
        (
            '<link name="$(find)"/>',
            "$(find)",
            naming("$(find ...)", 0, "$(find)"),
            "write $(find NAME)",
        ),
        ('<link name="$(finde arm)"/>', "$(finde arm)", naming("$(finde arm)", "find"), ""),
        (
            '<link name="$(env URDFKIT_NONE)"/>',
            "$(env URDFKIT_NONE)",
            naming("URDFKIT_NONE", "$(env URDFKIT_NONE)"),
            "set it, and pass --trust, or write $(optenv URDFKIT_NONE DEFAULT)",
        ),
    ],
)
def test_what_is_wrong_where_and_what_to_do(body: str, place: str, message: str, help: str) -> None:
    (found,) = reported("XAC001", body)
    assert (found.span.text, found.message) == (place, message)
    assert found.help == (help or "correct the expression or the call")


@pytest.mark.parametrize(
    ("before", "use", "help"),
    [
        (
            '<xacro:if value="0"><xacro:property name="a" value="1"/></xacro:if>',
            '<link name="${a}"/>',
            ["a", "robot.xacro:2:21", "<xacro:if>"],
        ),
        (
            '<xacro:macro name="m"><xacro:property name="a" value="1"/></xacro:macro><xacro:m/>',
            '<link name="${a}"/>',
            ["a", "robot.xacro:2:23", "inside that macro"],
        ),
        (
            "<xacro:m/>",
            '<xacro:macro name="m"><link name="w"/></xacro:macro>',
            ["m", "later", "robot.xacro:3:1"],
        ),
    ],
    ids=["condition", "macro", "later"],
)
def test_a_name_that_is_defined_elsewhere(before: str, use: str, help: list[str]) -> None:
    (found,) = reported("XAC001", f"{before}\n{use}")
    assert found.help == naming(*help)


@pytest.mark.parametrize(
    ("side", "found"),
    [
        ({}, ("warning", "guessed")),
        ({"side": "up"}, ("error", "measured")),
        ({"side": "left"}, None),
    ],
)
def test_a_name_that_is_defined_for_other_values_of_an_argument(
    side: dict[str, str], found: tuple[str, str] | None
) -> None:
    """franka_description's fr3_duo_arm: an arm for left and for right, and none for the default."""
    corner = '<xacro:if value="${side == \'left\'}"><xacro:property name="a" value="1"/></xacro:if>'
    argument = (
        '<xacro:arg name="side" default=""/><xacro:property name="side" value="$(arg side)"/>'
    )
    all_found = reported("XAC001", f'{argument}{corner}\n<link name="${{a}}"/>', **side)
    assert [(one.severity.value, one.confidence.value) for one in all_found] == (
        [found] if found else []
    )


def test_a_macro_of_a_file_that_another_macro_includes(tmp_path: Path) -> None:
    """A mobile base: <xacro:kmr_base/> includes a file with omni_steering, which comes next."""
    (tmp_path / "base.xacro").write_text(xacro('<xacro:macro name="steering"/>'))
    robot = tmp_path / "robot.xacro"
    include = '<xacro:include filename="base.xacro"/>'
    robot.write_text(
        xacro(f'<xacro:macro name="base">{include}</xacro:macro><xacro:base/><xacro:steering/>')
    )
    (found,) = check(robot, select=["XAC001"]).diagnostics
    assert found.help.endswith("the macro that includes it")


def test_all_errors_are_reported_each_at_its_place() -> None:
    body = (
        '<link name="${a}"/>\n<xacro:nope/>\n<xacro:property name="p" scope="parent" value="1"/>\n'
        '<xacro:if value="${b}"/>\n<xacro:include filename="none.xacro"/>'
    )
    assert marked(reported("XAC001", body)) == [
        (2, "${a}"),
        (3, "xacro:nope"),
        (4, "parent"),
        (5, "${b}"),
        (6, "none.xacro"),
    ]


def test_the_place_of_a_property_that_fails_is_its_definition() -> None:
    body = '<xacro:property name="a" value="${b * 2}"/>\n<link name="${a}"/>\n<link name="x${a}"/>'
    (found,) = reported("XAC001", body)
    assert (found.span.line, found.span.text) == (2, "${b * 2}")
    assert [(one.span.line, one.message) for one in found.related] == [
        (3, naming("needed", "a")),
        (4, naming("needed", "a")),
    ]


def test_a_call_shows_where_its_macro_is_defined() -> None:
    (found,) = reported("XAC001", f"{MACRO}<xacro:m/>")
    assert [(one.span.line, one.message) for one in found.related] == [(2, naming("m"))]


def test_conditions_with_one_wrong_value_are_one_finding() -> None:
    body = '<xacro:property name="right" value="yes"/>'
    body += '<xacro:if value="${right}"/>\n<xacro:unless value="${right}"/>'
    found = reported("XAC001", xacro(body))
    assert len({one.group_key for one in found}) == 1 < len(found)
    other = reported("XAC001", xacro(body + '<xacro:if value="no"/>'))
    assert len({one.group_key for one in other}) == 2


def test_a_missing_key_of_a_yaml_file_is_one_finding(tmp_path: Path) -> None:
    (tmp_path / "sizes.yaml").write_text("arm: {length: 1}")
    body = "<xacro:property name='sizes' value=\"${xacro.load_yaml('sizes.yaml')}\"/>\n"
    body += "".join(f"<link name=\"${{sizes['leg']['{key}']}}\"/>\n" for key in "abc")
    body += "<link name=\"${sizes['arm']['width']}\"/>"
    robot = tmp_path / "robot.xacro"
    robot.write_text(xacro(body))
    found = told_of("XAC001", robot)
    assert [finding.group_key for finding in found[:3]] == 3 * [found[0].group_key]
    assert found[3].group_key not in ("", found[0].group_key)


def test_a_macro_that_fails_in_every_call_is_one_finding() -> None:
    body = '<xacro:macro name="m" params="a"><link name="${a + z}"/></xacro:macro>\n'
    (found,) = reported("XAC001", body + '<xacro:m a="1"/>\n<xacro:m a="2"/>')
    assert (found.span.line, found.span.text) == (2, "${a + z}")
    assert sorted(call.via[0].span.line for call in found.calls) == [3, 4]


class TestMissingFiles:
    def test_a_file_like_it_is_named(self, tmp_path: Path) -> None:
        write(tmp_path, robot='<xacro:include filename="arms.xacro"/><link name="a"/>', arm="")
        (found,) = told_of("XAC001", tmp_path / "robot.xacro")
        assert found.span.text == "arms.xacro"
        assert found.message == f"file not found: {tmp_path}/arms.xacro"
        assert found.help == naming("mean", "arm.xacro")

    def test_a_directory_that_is_missing_is_named(self, tmp_path: Path) -> None:
        (tmp_path / "config" / "ur5e").mkdir(parents=True)
        write(tmp_path, robot="<link name=\"${xacro.load_yaml('config/ur5x/a.yaml')}\"/>")
        (found,) = told_of("XAC001", tmp_path / "robot.xacro")
        directory = tmp_path / "config"
        assert found.help == naming("ur5x", directory, "ur5e")

    @pytest.mark.parametrize("path", ["/home/badri-r-s/ws/src/arm/arm.urdf", "/ws-of-me/arm.urdf"])
    def test_a_path_of_another_computer(self, tmp_path: Path, path: str) -> None:
        """ENPM662: the help listed the users of this one."""
        write(tmp_path, robot=f'<xacro:include filename="{path}"/><link name="a"/>')
        (found,) = told_of("XAC001", tmp_path / "robot.xacro")
        assert found.message == naming(path)
        assert found.help == naming("computer", "$(find PACKAGE)")

    def test_a_path_to_no_package(self, tmp_path: Path) -> None:
        """The help listed the files of all users."""
        write(tmp_path, robot="<link name=\"${xacro.load_yaml('/tmp/no-such-hand.yaml')}\"/>")
        (found,) = told_of("XAC001", tmp_path / "robot.xacro")
        assert found.help == naming("package", "$(find PACKAGE)")

    def test_a_path_in_a_macro_is_relative_to_the_file_with_the_call(self, tmp_path: Path) -> None:
        """Reach Alpha: urdf/alpha.xacro includes tools/jaws.xacro in a macro for config/."""
        for name in (".git", "urdf/tools", "config"):
            (tmp_path / name).mkdir(parents=True)
        (tmp_path / "urdf/tools/jaws.xacro").write_text("<robot><link name='jaws'/></robot>")
        include = '<xacro:include filename="tools/jaws.xacro"/>'
        arm = f'<xacro:macro name="arm">{include}</xacro:macro>'
        (tmp_path / "urdf/arm.xacro").write_text(xacro(arm))
        robot = tmp_path / "config/robot.xacro"
        robot.write_text(xacro('<xacro:include filename="../urdf/arm.xacro"/><xacro:arm/>'))
        (found,) = told_of("XAC001", robot)
        path = f"{tmp_path}/config/tools/jaws.xacro"
        assert found.message == naming(path)
        assert "urdf/tools/jaws.xacro from everywhere" in found.help
        (tmp_path / "urdf/robot.xacro").write_text(robot.read_text().replace("../urdf/", ""))
        assert told_of("XAC001", tmp_path / "urdf/robot.xacro") == []

    def test_what_lacks_because_of_it_is_not_reported(self) -> None:
        body = '<xacro:include filename="none.xacro"/><xacro:arm/><link name="${length}"/>'
        assert codes(body) == ["XAC001"]


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:property name="a" value="1"/><link name="l${a}"/>',
        f'{MACRO}<xacro:m a="1"><x/></xacro:m>',
        '<xacro:if value="${1 &lt; 2}"><link name="a"/></xacro:if>',
        '<xacro:unless value="false"><link name="a"/></xacro:unless>',
        '<link name="$${a}"/>',
        '<xacro:include filename="none.xacro" optional="true"/><link name="a"/>',
        '<xacro:macro name="m" params=""><link name="${never}"/></xacro:macro><link name="a"/>',
    ],
)
def test_what_xacro_expands(body: str) -> None:
    assert reported("XAC001", body) == []


def test_an_include_by_package_url() -> None:
    (found,) = reported("XAC001", '<xacro:include filename="package://arm/urdf/arm.xacro"/>')
    assert found.message == naming("resolve", "package://arm/urdf/arm.xacro")
    assert found.help == "write $(find arm)/urdf/arm.xacro"


def test_properties_without_prefix_are_one_finding_for_programs_too() -> None:
    """One robot of 2016 had 204 of them in 13 files."""
    names = ("radius", "width", "gap")
    body = "".join(f'<property name="{name}" value="1"/>\n' for name in names)
    body += '<link name="${gap}${radius}${width}"/>'
    (found,) = reported("XAC001", body)
    assert found.message == naming("radius", "<property>", "without", "2")
    assert [note.span.text for note in found.related] == [
        "${radius}",
        '<property name="width" value="1"/>',
        '<property name="gap" value="1"/>',
    ]


def test_an_include_that_cannot_be_opened(tmp_path: Path) -> None:
    """The help is about the file; there is no expression to correct."""
    (tmp_path / "parts.xacro").mkdir()
    robot = tmp_path / "r.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:include filename="parts.xacro"/></robot>'
    )
    (found,) = check(robot, select=["XAC001"]).diagnostics
    assert found.message == naming(tmp_path / "parts.xacro")
    assert found.help == naming("name a file")


def test_a_macro_of_a_file_with_a_namespace(tmp_path: Path) -> None:
    namespace = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    (tmp_path / "leg.xacro").write_text(
        f'<robot {namespace}><xacro:macro name="leg"><link name="a"/></xacro:macro></robot>'
    )
    robot = tmp_path / "dog.xacro"
    robot.write_text(
        f'<robot name="dog" {namespace}><xacro:include filename="leg.xacro" ns="legs"/>'
        "<xacro:leg/></robot>"
    )
    (found,) = check(robot, select=["XAC001"]).diagnostics
    assert found.help == 'its file is included with ns="legs": write <xacro:legs.leg>'
