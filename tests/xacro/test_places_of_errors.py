"""Each error is reported at its very expression, with the calls and includes that led there."""

from pathlib import Path

import pytest

from tests.xacro.problems import brief, related, run, way
from urdfkit.lint import engine
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import expand

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


def test_an_error_in_a_macro_is_reported_for_every_call(tmp_path: Path) -> None:
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


def test_the_default_of_a_parameter_is_reported_at_its_macro(tmp_path: Path) -> None:
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


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("a: [1,\n   2\nb: 3\n", "3:2"),
        ("a:\t1\n", "1:3"),  # which libyaml accepts, but not the loader that xacro uses
    ],
)
def test_a_yaml_file_that_is_none(text: str, place: str, tmp_path: Path) -> None:
    xacro = run(tmp_path, "<a b=\"${xacro.load_yaml('yaml.yaml')['a']}\"/>", yaml=text)
    (problem,) = xacro.problems
    assert brief(problem) == "robot.xacro:2:7 ${xacro.load_yaml('yaml.yaml')['a']}"
    assert problem.message.startswith(f"{tmp_path}/yaml.yaml is not valid YAML: ")
    assert [str(one.span) for one in problem.related] == [f"{tmp_path}/yaml.yaml:{place}"]
