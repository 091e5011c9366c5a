"""All errors of a file, each at its very expression; and nothing that only follows from them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.expansion import models
from urdfkit import engine
from urdfkit.expansion import Xacro, expand
from urdfkit.reading import Problem
from urdfkit.source import Source
from urdfkit.workspace.resolve import Resolver


def run(folder: Path, body: str, arguments: dict[str, str] | None = None, **parts: str) -> Xacro:
    """Expand a model whose body begins in line 2; ``part="..."`` is ``part.xacro``."""
    for name, text in {"robot": body, **parts}.items():
        is_yaml = name.startswith("yaml")
        file = folder / f"{name}.{'yaml' if is_yaml else 'xacro'}"
        file.write_text(text if is_yaml else models.document(f"\n{text}\n"), encoding="utf-8")
    return expand(Source.read(folder / "robot.xacro"), Resolver({}, {}), arguments)


def brief(problem: Problem) -> str:
    """File, line, column, and the text there."""
    span = problem.span
    return f"{Path(span.source.path).name}:{span.line}:{span.column} {span.text}"


def briefs(xacro: Xacro) -> list[str]:
    return [brief(problem) for problem in xacro.problems]


def way(problem: Problem) -> list[str]:
    """The calls and includes that led to a problem, outermost first."""
    steps = problem.frame.steps() if problem.frame else ()
    return [f"{Path(s.name).name} {s.span.line}:{s.span.column}" for s in steps]


def related(problem: Problem) -> list[str]:
    return [f"{one.span.line}:{one.span.column} {one.message}" for one in problem.related]


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
    assert messages[11] == f"there is no file {tmp_path}/none.xacro"


PLACES = {
    "two attributes with the same text": ('<a b="${x}" c="${x}"/>', ["2:7", "2:16"]),
    "one text twice in an attribute": ('<a b="${x}, ${x}"/>', ["2:7", "2:13"]),
    "one text twice in a text": ("<a>${x} ${x}</a>", ["2:4", "2:9"]),
    "a text behind an element with the same": (
        '<a>${x}<b c="${x}"/>${x}</a>',
        ["2:4", "2:14", "2:21"],
    ),
    "texts between comments": ("<a><!-- ${x} -->${x}<!-- ${x} --> ${x} </a>", ["2:17", "2:35"]),
    "an evaluated comment": (
        "<!-- ${x} --><!-- xacro:eval-comments --><!-- ${x} ${y} -->",
        ["2:47", "2:52"],
    ),
    "an entity before it": ('<a b="1 &lt; ${x}">&amp;&#228; ${y}</a>', ["2:14", "2:32"]),
    "entities in it": ('<a b="${1 &lt; x}">${&quot;&quot; > y}</a>', ["2:7", "2:20"]),
    "characters of many bytes": ('<a b="轮😀ä ${x}">轮😀ä ${y}</a>', ["2:11", "2:21"]),
    "line ends": (
        '<a b="${x +\n 1}"\n  c="1\n 2 ${y}">\n\n  ${z +\n 1}\n</a>',
        ["2:7", "5:4", "7:3"],
    ),
    "carriage returns": ("<a b='${x +\r\n 1}'>\r\n ${y}\r\n</a>", ["2:7", "4:2"]),
    "a tab": ("<a\tb='\t${x}'>\t${y}</a>", ["2:8", "2:15"]),
    "other quotes": ("<a b='${x}' c = \"${y}\"/>", ["2:7", "2:18"]),
    "an attribute in a name space": ('<n:a xmlns:n="n" n:b="${x}"/>', ["2:23"]),
    "an attribute with its default": ('<a b="${x" c="${y}"/>', ["2:7", "2:15"]),
    "a section of data": ("<a><![CDATA[${x}]]>${x}</a>", ["2:20"]),
    "the value of a property": ('<xacro:property name="p" value="1 ${x}"/><a b="${p}"/>', ["2:35"]),
    "the name of a property": ('<xacro:property name="${x}" value="1"/>', ["2:23"]),
    "the condition": ('<xacro:if value="${x}"/><xacro:unless value="${y}"/>', ["2:18", "2:46"]),
    "a condition that is none": ("<xacro:if value=\"${'maybe'}\"/>", ["2:18"]),
    "the default of an argument": ('<xacro:arg name="a" default="${x}"/>', ["2:30"]),
    "the name of an element": ('<xacro:element xacro:name="${x}"/>', ["2:28"]),
    "an attribute's name and value": (
        '<a><xacro:attribute name="${x}" value="${y}"/></a>',
        ["2:27", "2:40"],
    ),
    "the name of a file": ('<xacro:include filename="a${x}.xacro"/>', ["2:27"]),
    "a name space": ('<xacro:include filename="part.xacro" ns="${x}"/>', ["2:42"]),
    "the name of a call": ('<xacro:call macro="${x}"/>', ["2:20"]),
    "a block": (
        (
            '<xacro:macro name="m" params="*b"><xacro:insert_block name="b"/></xacro:macro>'
            '\n<xacro:m><a b="${x}"/></xacro:m>'
        ),
        ["3:16"],
    ),
    "the element of a property": (
        '<xacro:property name="p"><a b="${x}"/></xacro:property>\n<xacro:insert_block name="p"/>',
        ["2:32"],
    ),
    "a parameter": ('<xacro:macro name="m" params="a"/>\n<xacro:m a="1 ${x}"/>', ["3:15"]),
    "the root": ("", []),
}


@pytest.mark.parametrize("what", PLACES)
def test_the_place_of_an_expression(what: str, tmp_path: Path) -> None:
    body, places = PLACES[what]
    xacro = run(tmp_path, body, part="")
    found = [f"{one.span.line}:{one.span.column}" for one in xacro.problems if one.code == "XAC001"]
    assert found == places
    assert all(one.span.text.startswith("${") for one in xacro.problems if one.code == "XAC001")


def test_the_root(tmp_path: Path) -> None:
    file = tmp_path / "robot.xacro"
    file.write_text("<?xml version='1.0'?>\n<robot name='${x}'/>", encoding="utf-8")
    (problem,) = expand(Source.read(file), Resolver({}, {})).problems
    assert brief(problem) == "robot.xacro:2:14 ${x}"


def test_a_property_that_fails_is_told_once_with_its_uses(tmp_path: Path) -> None:
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
def test_what_follows_from_an_error_is_not_told(body: str, tmp_path: Path) -> None:
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


def test_a_name_that_only_contains_a_lost_one_is_told(tmp_path: Path) -> None:
    body = '<xacro:property name="a" value="1" default="2"/><a b="${arm}" c="${a}"/>'
    assert [one.span.text for one in run(tmp_path, body).problems] == ["xacro:property", "${arm}"]


def test_a_package_that_is_not_found(tmp_path: Path) -> None:
    folder = tmp_path / "here"
    folder.mkdir()
    xacro = run(folder, '<xacro:include filename="$(find nowhere)/a.xacro"/><a b="${p}"/>')
    (problem,) = xacro.problems
    assert problem.code == "XAC011"
    assert brief(problem) == "robot.xacro:2:26 $(find nowhere)"
    assert problem.message.startswith(
        f"package 'nowhere' is not found; searched: {folder} and the folders above it, "
        "AMENT_PREFIX_PATH (not set), ROS_PACKAGE_PATH (not set)"
    )
    assert problem.help == "name its folder: --package nowhere=DIR"


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
    assert first.help == "pass it: c:=VALUE; the others: a (default 1), b (default two)"
    assert related(first) == ["6:7 needed here"]
    assert brief(second) == "robot.xacro:6:24 $(arg d)"


CALLS = """\
<xacro:macro name="m" params="a c:=1 *b"/>
<xacro:m/>
<xacro:m a="1"/>
<xacro:m a="1" d="2"><x/></xacro:m>
<xacro:m a="1"><x/><y/></xacro:m>
"""


def test_calls_that_do_not_fit_name_the_macro(tmp_path: Path) -> None:
    xacro = run(tmp_path, CALLS)
    assert [f"{brief(one)} | {one.message}" for one in xacro.problems] == [
        "robot.xacro:3:2 xacro:m | macro 'm' is called without an element for *b",
        "robot.xacro:4:2 xacro:m | macro 'm' is called without an element for *b",
        "robot.xacro:5:19 2 | macro 'm' has no parameter 'd'",
        "robot.xacro:6:2 xacro:m | macro 'm' has no block parameter for <y>",
    ]
    assert {tuple(related(one)) for one in xacro.problems} == {("2:1 macro 'm' is defined here",)}


def test_an_error_in_a_macro_is_told_for_every_call(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:macro name="m" params="v">\n<a b="${v + 1}"/>\n</xacro:macro>\n'
        '<xacro:macro name="outer"><xacro:m v="z"/></xacro:macro>\n'
        '<xacro:m v="x"/>\n<xacro:m v="2"/>\n<xacro:m v="y"/>\n<xacro:outer/>',
    )
    assert {brief(one) for one in xacro.problems} == {"robot.xacro:3:7 ${v + 1}"}
    assert [way(one) for one in xacro.problems] == [["m 6:1"], ["m 8:1"], ["outer 9:1", "m 5:27"]]


def test_the_engine_folds_the_calls(tmp_path: Path) -> None:
    run(tmp_path, '<xacro:macro name="m"><a b="${x}"/></xacro:macro>' + "<xacro:m/>" * 5)
    report = engine.check(tmp_path / "robot.xacro", select=["XAC001"])
    (diagnostic,) = report.diagnostics
    assert len(diagnostic.calls) == 5


def test_the_default_of_a_parameter_is_told_at_its_macro(tmp_path: Path) -> None:
    xacro = run(
        tmp_path, '<xacro:macro name="m" params="a:=${x} b:=${x}"/>\n<xacro:m/>\n<xacro:m b="1"/>'
    )
    found = [(one.span.line, one.span.column, *way(one)) for one in xacro.problems]
    assert found[:2] == [(2, 34, "m 3:1"), (2, 42, "m 3:1")]
    assert (2, 34, "m 4:1") in found


def test_errors_in_included_files(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:include filename="part.xacro"/>\n<xacro:m v="1"/>\n<a b="${w}"/>',
        part='<a b="${x}"/>\n<xacro:macro name="m" params="v">\n<a b="${y + v}"/>\n'
        '<xacro:include filename="inner.xacro"/>\n</xacro:macro>',
        inner='<a b="${z}"/>\n<xacro:nothing/>',
    )
    assert [(brief(one), way(one)) for one in xacro.problems] == [
        ("part.xacro:2:7 ${x}", ["part.xacro 2:1"]),
        ("part.xacro:4:7 ${y + v}", ["m 3:1"]),
        ("inner.xacro:2:7 ${z}", ["m 3:1", "inner.xacro 5:1"]),
        ("inner.xacro:3:2 xacro:nothing", ["m 3:1", "inner.xacro 5:1"]),
        ("robot.xacro:4:7 ${w}", []),
    ]


def test_a_broken_include(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text("<a>\n  <b>\n</a>", encoding="utf-8")
    xacro = run(tmp_path, '<xacro:include filename="part.xacro"/>\n<a b="${x}"/>\n<a b="${1/0}"/>')
    first, second = xacro.problems
    assert (first.code, second.code) == ("XML001", "XAC001")
    assert brief(first) == "part.xacro:2:3 <b>"
    assert [step.span.line for step in first.frame.steps()] == [2] if first.frame else False
    assert brief(second) == "robot.xacro:4:7 ${1/0}"


def test_a_yaml_file_that_is_none(tmp_path: Path) -> None:
    xacro = run(
        tmp_path, "<a b=\"${xacro.load_yaml('yaml.yaml')['a']}\"/>", yaml="a: [1,\n   2\nb: 3\n"
    )
    (problem,) = xacro.problems
    assert brief(problem) == "robot.xacro:2:7 ${xacro.load_yaml('yaml.yaml')['a']}"
    assert problem.message.startswith(f"{tmp_path}/yaml.yaml is no YAML: ")
    assert [str(one.span) for one in problem.related] == [f"{tmp_path}/yaml.yaml:3:2"]


def test_properties_in_a_circle(tmp_path: Path) -> None:
    xacro = run(
        tmp_path,
        '<xacro:property name="a" value="${b}"/>\n<xacro:property name="b" value="${a}"/>\n'
        '<l a="${a}"/>',
    )
    (problem,) = xacro.problems
    assert brief(problem) == "robot.xacro:3:33 ${a}"
    assert problem.message.startswith("circular variable definition: a -> b -> a")


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
        "XAC016 robot.xacro:4:23 pi",
        "XAC015 robot.xacro:5:9 sorted",
        "XAC017 robot.xacro:6:1 <a b=\"${xacro.warning('beware')}\"/>",
    ]


def test_a_long_message_is_cut(tmp_path: Path) -> None:
    (problem,) = run(tmp_path, "<a b=\"${xacro.fatal('x' * 100000)}\"/>").problems
    assert len(problem.message) == 1000


def test_many_errors_are_told_in_bounded_number(tmp_path: Path) -> None:
    body = "".join(f'<a b="${{x{number}}}"/>' for number in range(2000))
    assert len(run(tmp_path, body).problems) == 500
    body = "".join(f"<xacro:x{number}/>" for number in range(200))
    assert len(run(tmp_path, body).problems) == 51


def test_an_include_without_the_prefix_is_why_a_macro_lacks(tmp_path: Path) -> None:
    (problem,) = run(tmp_path, '<include filename="arm.xacro"/>\n<xacro:arm/>').problems
    assert problem.message == "macro 'arm' is not defined"
    assert (
        problem.help == "write <xacro:include>: xacro passes over an <include> without the prefix"
    )


def test_the_folders_that_there_are_instead_of_a_missing_one(tmp_path: Path) -> None:
    for arm in ("six_axes", "seven_axes"):
        (tmp_path / arm).mkdir()
    body = '<xacro:arg name="arm" default="NONE"/><xacro:include filename="$(arg arm)/arm.xacro"/>'
    (problem,) = run(tmp_path, body).problems
    assert problem.help == (
        f"there is no folder 'NONE' in {tmp_path}; there are seven_axes, six_axes"
    )


@pytest.mark.parametrize(
    ("body", "help"),
    [
        ("<xacro:propery name='a' value='1'/>", "did you mean 'property'?"),
        ("<xacro:property name='w' value='1.5'/><a b='${w^2}'/>", "write ** for a power"),
        ("<xacro:property name='w' value='0,5'/><a b='${w/2}'/>", "a value in it is text"),
        ("<xacro:property name='w' value='5 cm'/><a b='${-w}'/>", "a value in it is text"),
    ],
)
def test_what_was_meant_is_told(tmp_path: Path, body: str, help: str) -> None:
    (problem,) = run(tmp_path, body).problems
    assert help in problem.help
