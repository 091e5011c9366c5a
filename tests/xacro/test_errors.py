"""All errors of a file, in words that help; and nothing that only follows from them."""

import gc
import weakref
from pathlib import Path

import pytest

from tests.xacro.problems import brief, briefs, related, run
from urdfkit.xacro import recovery
from urdfkit.xacro.expansion import ExpansionRun

LIBRARY = (
    """<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="link"/></robot>"""
)


def test_all_errors_of_a_file(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<a b="${x}" c="1 ${y} ${z}"/>\n'
        "<a>text ${w} and ${v}</a>\n"
        '<a b="${1/0}"/>\n'
        '<a b="${1 +}"/>\n'
        "<xacro:m/>\n"
        '<xacro:insert_block name="q"/>\n'
        '<xacro:if value="maybe"/>\n'
        '<a b="${u"/>\n'
        '<xacro:include filename="none.xacro"/>\n'
        '<a b="$(arg no)"/>\n<a b="${().real}"/>',
    )
    assert briefs(xacro) == [
        "robot.xacro:2:7 ${x}",
        "robot.xacro:2:18 ${y}",
        "robot.xacro:2:23 ${z}",
        "robot.xacro:3:9 ${w}",
        "robot.xacro:3:18 ${v}",
        "robot.xacro:4:7 ${1/0}",
        "robot.xacro:5:7 ${1 +}",
        "robot.xacro:6:2 xacro:m",
        "robot.xacro:7:2 xacro:insert_block",
        "robot.xacro:8:18 maybe",
        "robot.xacro:9:7 ${u",
        "robot.xacro:10:26 none.xacro",
        "robot.xacro:12:7 ${().real}",
    ]
    assert {problem.code for problem in xacro.problems} == {"XAC001"}
    messages = [problem.message for problem in xacro.problems]
    assert messages[0] == "name 'x' is not defined in ${x}"
    assert messages[5] == "division by zero in ${1/0}"
    assert messages[6] == "not an expression: invalid syntax in ${1 +}"
    assert messages[7] == "macro 'm' is not defined"
    assert messages[8] == "block 'q' is not defined"
    assert messages[9] == "the condition is 'maybe', neither true nor false"
    assert messages[10] == "'${u' is never closed"
    assert messages[11] == f"file not found: {tmp_path}/none.xacro"


def test_tags_that_fail_cost_no_further_expansion(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    runs: list[ExpansionRun] = []
    once = recovery._expand_once

    def counted(run: ExpansionRun) -> BaseException | None:
        runs.append(run)
        return once(run)

    monkeypatch.setattr(recovery, "_expand_once", counted)
    xacro = run(
        tmp_path,
        '<xacro:macro name="m"><xacro:n/></xacro:macro>\n<xacro:m/>\n<xacro:m/>\n'
        '<xacro:m x="1"/>\n'
        '<xacro:property name="1" value=""/>\n'
        '<xacro:macro name="call"/>\n'
        '<xacro:include filename="none.xacro"/>\n'
        '<xacro:include filename="$(find none_of_mine)/a.xacro"/>\n'
        '<xacro:o/>\n<xacro:insert_block/>\n<a b="${1/0}"/>',
    )
    assert [f"{one.code} {brief(one)}" for one in xacro.problems] == [
        "XAC001 robot.xacro:2:24 xacro:n",
        "XAC001 robot.xacro:5:13 1",
        "XAC001 robot.xacro:6:23 1",
        "XAC001 robot.xacro:7:20 call",
        "XAC001 robot.xacro:8:26 none.xacro",
        "XAC011 robot.xacro:9:26 $(find none_of_mine)",
        "XAC001 robot.xacro:11:2 xacro:insert_block",
        "XAC001 robot.xacro:12:7 ${1/0}",
    ]
    assert len(runs) == 2  # one more for insert_block


def test_nothing_keeps_a_robot_that_is_not_used_any_more(tmp_path: Path) -> None:
    xacro = run(tmp_path, '<!-- a comment -->\n<xacro:property name="p" value="1"/>\n<a b="${p}"/>')
    document = weakref.ref(xacro._dom)
    del xacro
    gc.collect()
    assert document() is None


def test_a_property_that_fails_is_reported_once_with_its_uses(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:property name="p" value="${x}"/>\n'
        '<xacro:property name="q" value="${2 * p}"/>\n'
        '<a b="1 ${p}"/>\n'
        "<a>${q}</a>\n"
        '<xacro:if value="${p}"/>',
    )
    (problem,) = xacro.problems
    assert brief(problem) == "robot.xacro:2:33 ${x}"
    assert related(problem) == [
        "4:9 needed here for 'p'",
        "5:4 needed here for 'p'",
        "6:18 needed here for 'p'",
    ]


def test_definitions_of_the_names_are_related(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:property name="a" value="text"/>\n<xacro:property name="b" value="2"/>\n'
        '<a b="${a - b}"/>',
    )
    (problem,) = xacro.problems
    assert brief(problem) == "robot.xacro:4:7 ${a - b}"
    assert related(problem) == ["2:1 'a' is defined here", "3:1 'b' is defined here"]


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:property name="p" value="${x}" lazy_eval="false"/><a b="${p}" c="${p+1}">${p}</a>',
        '<xacro:property name="p" value="${x}" scope="global"/><a b="${p}"/>',
        (
            '<xacro:property name="p" value="${x}"/><xacro:macro name="m" params="p:=^">'
            '<a b="${p}"/></xacro:macro><xacro:m/>'
        ),
        (
            '<xacro:property name="p" value="${x}"/><xacro:macro name="m" params="p:=^|3">'
            '<a b="${p}"/></xacro:macro><xacro:m/>'
        ),
        (
            '<xacro:macro name="m" params="a"><a b="${a}" c="${a+1}"/><xacro:if value="${a}"/>'
            '</xacro:macro><xacro:m a="${x}"/>'
        ),
        '<xacro:arg name="a" default="${x}"/><a b="$(arg a)" c="${$(arg a) + 1}"/>',
        '<xacro:if value="${x}"><a/></xacro:if>',
        '<xacro:element xacro:name="${x}"><a/></xacro:element>',
        '<a><xacro:attribute name="${x}" value="1"/></a>',
        '<xacro:call macro="${x}" a="1"/>',
        '<xacro:property name="${x}" value="1"/><a b="${p}"/>',
        '<xacro:include filename="${x}"/><a b="${p}"/><xacro:m/><a b="$(arg a)"/>',
        '<xacro:include filename="a/${x}.xacro"/><a b="${p}"/>',
        '<xacro:include filename="${x}.xacro" optional="true"/><a b="${p}"/>',
        '<xacro:property name="y" value="${xacro.load_yaml(x)}"/><a b="${y[\'a\']}" c="${y.b}"/>',
        '<a b="${x}${x}"/>',
        "<a b=\"${dict(a=x)['a']}\"/>",
    ],
)
def test_what_follows_from_an_error_is_not_reported(body: str, tmp_path: Path) -> None:
    xacro = run(tmp_path, body)
    assert {one.message.partition(" in ")[0] for one in xacro.problems} == {
        "name 'x' is not defined"
    }
    assert xacro.document is None
    assert xacro.first_error is not None


@pytest.mark.parametrize(
    ("body", "place"),
    [
        ('<xacro:property name="1a" value="1"/><a b="${a}"/>', "2:23 1a"),
        ('<xacro:property name="a" value="1" default="2"/><a b="${a}"/>', "2:2 xacro:property"),
        ('<xacro:macro name="m" params="b:=${x"/><xacro:m/>', "2:34 ${x"),
        ('<xacro:arg name="a"/><a b="$(arg a)"/>', "2:2 xacro:arg"),
        ('<xacro:property value="1"/>', "2:2 xacro:property"),
    ],
)
def test_what_a_failing_tag_would_have_defined_is_not_missed(
    body: str, place: str, tmp_path: Path
) -> None:
    found = [brief(one) for one in run(tmp_path, body).problems]
    assert [one for one in found if "${a}" not in one] == [f"robot.xacro:{place}"]


def test_after_a_missing_include_nothing_is_missed(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<a b="${before}"/>\n<xacro:before/>\n<xacro:include filename="none.xacro"/>\n'
        '<a b="${after}"/>\n<xacro:after/>\n<a b="$(arg after)"/>\n<xacro:n.after/>\n'
        '<a b="${1/0}"/>\n<xacro:include filename="neither.xacro"/>',
    )
    assert briefs(xacro) == [
        "robot.xacro:2:7 ${before}",
        "robot.xacro:3:2 xacro:before",
        "robot.xacro:4:26 none.xacro",
        "robot.xacro:9:7 ${1/0}",
        "robot.xacro:10:26 neither.xacro",
    ]


def test_a_name_that_only_contains_a_lost_one_is_reported(tmp_path: Path) -> None:
    body = '<xacro:property name="a" value="1" default="2"/><a b="${arm}" c="${a}"/>'
    assert [one.span.text for one in run(tmp_path, body).problems] == ["xacro:property", "${arm}"]


def test_a_package_that_is_not_found(tmp_path: Path) -> None:
    directory = tmp_path / "here"
    directory.mkdir()
    xacro = run(directory, '<xacro:include filename="$(find nowhere)/a.xacro"/><a b="${p}"/>')
    (problem,) = xacro.problems
    assert problem.code == "XAC011"
    assert brief(problem) == "robot.xacro:2:26 $(find nowhere)"
    assert problem.message.startswith(
        f"package 'nowhere' is not found; searched: {directory} and its parent directories, "
        "AMENT_PREFIX_PATH (not set), ROS_PACKAGE_PATH (not set)"
    )
    assert problem.help == "pass its directory: --package nowhere=DIR"


def test_an_argument_without_a_value(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:arg name="a" default="1"/>\n<xacro:arg name="b" default="two"/>\n'
        '<xacro:arg name="a" default="3"/>\n<a b="$(arg c)"/>\n'
        '<a b="${$(arg c) * 2}">$(arg d)</a>',
        {"b": "given"},
    )
    first, second = xacro.problems
    assert (first.code, second.code) == ("XAC010", "XAC010")
    assert brief(first) == "robot.xacro:5:7 $(arg c)"
    assert first.message == "argument 'c' has no value and no default"
    assert first.help == "pass it: c:=VALUE; other arguments: a (default 1), b (default two)"
    assert related(first) == ["6:7 needed here"]
    assert brief(second) == "robot.xacro:6:24 $(arg d)"


def test_properties_in_a_circle(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:property name="a" value="${b}"/>\n<xacro:property name="b" value="${a}"/>\n'
        '<l a="${a}"/>',
    )
    (problem,) = xacro.problems
    assert brief(problem) == "robot.xacro:3:33 ${a}"
    assert problem.message == "properties refer to one another: a -> b -> a in ${a}"


def test_warnings_have_places(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:property name="a" value="1" foo="2"/>\n<xacro:include filename="none*"/>\n'
        '<xacro:property name="pi" value="3"/>\n<a b="${sorted([2, 1])}"/>\n'
        "<a b=\"${xacro.warning('beware')}\"/>",
    )
    assert xacro.document is not None
    assert [f"{one.code} {brief(one)}" for one in xacro.problems] == [
        "XAC017 robot.xacro:2:41 2",
        "XAC017 robot.xacro:3:26 none*",
        "XAC017 robot.xacro:4:23 pi",
        "XAC017 robot.xacro:5:9 sorted",
        "XAC017 robot.xacro:6:1 <a b=\"${xacro.warning('beware')}\"/>",
    ]


def test_a_long_message_is_cut(tmp_path: Path) -> None:
    (problem,) = run(tmp_path, "<a b=\"${xacro.fatal('x' * 100000)}\"/>").problems
    assert len(problem.message) == 1000


def test_many_errors_are_reported_in_bounded_number(tmp_path: Path) -> None:
    body = "".join(f'<a b="${{x{number}}}"/>' for number in range(2000))
    assert len(run(tmp_path, body).problems) == 500
    body = "".join(f"<xacro:x{number}/>" for number in range(2000))
    assert len(run(tmp_path, body).problems) == 500


def test_an_include_without_the_prefix_is_why_a_macro_lacks(tmp_path: Path) -> None:
    (problem,) = run(tmp_path, '<include filename="arm.xacro"/>\n<xacro:arm/>').problems
    assert problem.message == "macro 'arm' is not defined"
    assert problem.help == "write <xacro:include>: xacro ignores an <include> without the prefix"


def test_an_include_without_the_prefix_is_why_a_property_lacks(tmp_path: Path) -> None:
    """A Husky of ROS Fuerte, whose includes are for its own xacro."""
    (problem,) = run(tmp_path, '<include filename="a.xacro"/>\n<a b="${size}"/>').problems
    assert problem.help == "write <xacro:include>: xacro ignores an <include> without the prefix"
    commented = '<!-- <include filename="a.xacro"/> -->\n<a b="${size}"/>'
    (problem,) = run(tmp_path, commented).problems
    assert "'size'" in problem.help


def test_the_directories_that_there_are_instead_of_a_missing_one(tmp_path: Path) -> None:
    for arm in ("six_axes", "seven_axes"):
        (tmp_path / arm).mkdir()
    body = '<xacro:property name="arm" value="NONE"/><xacro:include filename="${arm}/arm.xacro"/>'
    (problem,) = run(tmp_path, body).problems
    assert problem.help == (
        f"directory 'NONE' not found in {tmp_path}; available: seven_axes, six_axes"
    )


@pytest.mark.parametrize(
    ("body", "help"),
    [
        ("<xacro:propery name='a' value='1'/>", "did you mean 'property'?"),
        (
            "<xacro:include filename='arm.xacro' ns='arms'/>\n<xacro:arm.link/>",
            "did you mean 'arms.link'?",
        ),
        ("<a b=\"${xacro.load_yaml('arm.yaml')['lenght']}\"/>", "did you mean 'length'?"),
        ("<xacro:property name='w' value='1.5'/><a b='${w^2}'/>", "write ** for a power"),
        ("<xacro:property name='w' value='0,5'/><a b='${w/2}'/>", "'w' is '0,5', which is text"),
        ("<xacro:property name='w' value='5 cm'/><a b='${-w}'/>", "'w' is '5 cm', which is text"),
    ],
)
def test_what_was_meant_is_reported(tmp_path: Path, body: str, help: str) -> None:
    (tmp_path / "arm.yaml").write_text("length: 1\n")
    (tmp_path / "arm.xacro").write_text(LIBRARY)
    (problem,) = run(tmp_path, body).problems
    assert help in problem.help


def test_a_text_beside_a_property_that_is_not_evaluated(tmp_path: Path) -> None:
    body = (
        "<xacro:property name='bad' value='${1/0}'/><xacro:property name='w' value='0,5'/>\n"
        "<a b='${bad if 1 > 2 else w/2}'/>"
    )
    (problem,) = run(tmp_path, body).problems
    assert problem.span.text == "${bad if 1 > 2 else w/2}"
    assert problem.help.startswith("'w' is '0,5', which is text")


def test_a_property_without_prefix_is_one_problem(tmp_path: Path) -> None:
    """The old style, of which one robot made 620 errors; a comment defines nothing."""
    xacro = run(
        tmp_path,
        '<!-- <property name="r" value="0"/> --><property name="r" value="1"/>\n'
        '<a b="${r}"/>\n<a b="${2 * r}" c="${s}"/>\n<!-- <property name="s" value="1"/> -->',
    )
    assert briefs(xacro) == [
        'robot.xacro:2:40 <property name="r" value="1"/>',
        "robot.xacro:4:20 ${s}",
    ]
    bare = xacro.problems[0]
    assert bare.message == (
        "name 'r' is not defined: xacro ignores a <property> without the prefix"
    )
    assert related(bare) == ["3:7 needed here", "4:7 needed here"]


def test_a_key_that_is_not_there(tmp_path: Path) -> None:
    (problem,) = run(tmp_path, "<a b=\"${dict(left=1)['']}\"/>").problems
    assert problem.message == "key '' does not exist in ${dict(left=1)['']}"


def test_the_file_of_the_same_stem_instead_of_a_missing_one(tmp_path: Path) -> None:
    """delto_m_ros2: a hand of five fingers is no hand of four."""
    for file in ("dg4f.urdf", "dg5f.xacro"):
        (tmp_path / file).touch()
    (problem,) = run(tmp_path, '<xacro:include filename="dg4f.xacro"/>').problems
    assert problem.help == "create it, or correct the path; available: dg4f.urdf"


@pytest.mark.parametrize(
    ("expression", "help"),
    [
        ("1 = 1", "write =="),
        ("a &amp;&amp; b", "and"),
        ("!a", "not"),
        ("a ? 1 : 2", "if"),
        ("1 +", "valid"),
    ],
)
def test_operators_of_other_languages(tmp_path: Path, expression: str, help: str) -> None:
    (problem,) = run(tmp_path, f'<a b="${{{expression}}}"/>').problems
    assert help in problem.help
