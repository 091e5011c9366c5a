"""The layout of one document: what it looks like, and that it says the same."""

import re
from functools import cache
from pathlib import Path
from typing import Any
from xml import sax

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.conftest import CORPUS, MODELS, needs_corpus
from tests.xacros import NAMESPACE
from urdfkit.errors import UnreadableRobot, UrdfkitError
from urdfkit.text.editing.formatter import formatted
from urdfkit.text.source import Source


def laid_out(text: str, width: int = 100) -> str:
    return formatted(Source("r.urdf", text.encode()), width).decode()


def inside(text: str, width: int = 100) -> str:
    """The layout of the inside of a robot, without the indentation that it has there."""
    lines = laid_out(f'<robot name="r" {NAMESPACE}>\n{text}\n</robot>', width).splitlines()
    return "\n".join(line.removeprefix("  ") for line in lines[1:-1])


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        # one way to write a tag
        ("<link  name = 'a' />", '<link name="a"/>'),
        ('<link\n name="a"\n></link >', '<link name="a"/>'),
        ('<link name="a">\n\n</link>', '<link name="a"/>'),
        ("<a b='say \"x\"'/>", "<a b='say \"x\"'/>"),
        ("<a b='&quot;&#10;x'/>", '<a b="&quot;&#10;x"/>'),
        # the order of URDF, and of nobody else
        ('<joint type="fixed" name="j"/>', '<joint name="j" type="fixed"/>'),
        ('<origin rpy="0 0 1" xyz="1 2 3"/>', '<origin xyz="1 2 3" rpy="0 0 1"/>'),
        ('<x:y b="1" a="2"/>', '<x:y b="1" a="2"/>'),
        ('<link b="1" name="a" a="2"/>', '<link name="a" b="1" a="2"/>'),
        (
            '<gazebo><joint type="t" name="j"/></gazebo>',
            '<gazebo>\n  <joint type="t" name="j"/>\n</gazebo>',
        ),
        ('<xacro:macro params="b a" name="m"/>', '<xacro:macro name="m" params="b a"/>'),
        (
            '<xacro:macro name="m" params="\n  a\t b:=1 \n *c "/>',
            '<xacro:macro name="m" params="a b:=1 *c"/>',
        ),
        (
            '<xacro:macro name="m" params="a:=\'0  0\'  b"/>',
            '<xacro:macro name="m" params="a:=\'0  0\' b"/>',
        ),
        (
            '<xacro:macro name="m" params="a:=\'0\n 0\'  b"/>',
            '<xacro:macro name="m" params="a:=\'0  0\' b"/>',
        ),
        ('<xacro:m params=" a  b"/>', '<xacro:m params=" a  b"/>'),
        # vectors, spelt as they were
        ('<origin xyz=" 1.0  .5\t-2e-3\n"/>', '<origin xyz="1.0 .5 -2e-3"/>'),
        ('<box size="${a  +  b}  1"/>', '<box size="${a  +  b}  1"/>'),
        ('<mesh filename="a  b.stl"/>', '<mesh filename="a  b.stl"/>'),
        # text means what it is
        ("<gazebo><mu1> 0.5 </mu1></gazebo>", "<gazebo>\n  <mu1> 0.5 </mu1>\n</gazebo>"),
        ("<p>one <b/>\ntwo</p>", "<p>one <b/>\ntwo</p>"),
        ("<p> </p>", "<p> </p>"),
        ("<p><![CDATA[ a<b ]]></p>", "<p><![CDATA[ a<b ]]></p>"),
        ("<p xml:space='preserve'> <b/> </p>", '<p xml:space="preserve"> <b/> </p>'),
        ("<p><b>&lt;</b></p>", "<p>\n  <b>&lt;</b>\n</p>"),
        # comments stay where they stand
        ("<a/> <!-- behind -->", "<a/> <!-- behind -->"),
        ("<a/><!--behind--><b/>", "<a/> <!--behind-->\n<b/>"),
        ("<!-- before --><a/>", "<!-- before -->\n<a/>"),
        ("<a><!-- in --></a>", "<a> <!-- in -->\n</a>"),
        ("<a> <!-- in -->\n<b/></a>", "<a> <!-- in -->\n  <b/>\n</a>"),
        ("<a>\n<!-- one\n     two -->\n</a>", "<a>\n  <!-- one\n       two -->\n</a>"),
        ("\t\t<!-- one\n\t\t\ttwo  \n\n-->", "<!-- one\n    two\n\n-->"),
        # blank lines
        ("<a/>\n\n\n\n<b/>\n<c/>", "<a/>\n\n<b/>\n<c/>"),
        ("<a>\n\n<b/>\n\n</a>", "<a>\n  <b/>\n</a>"),
        ("<?pi x?><a/>", "<?pi x?>\n<a/>"),
    ],
)
def test_the_layout(written: str, expected: str) -> None:
    assert inside(written) == expected
    assert inside(expected) == expected


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        (
            '<limit lower="-3.14159" upper="3.14159" effort="100.0" velocity="3.0"/>',
            '<limit lower="-3.14159" upper="3.14159"\n       effort="100.0" velocity="3.0"/>',
        ),
        (
            '<inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>',
            (
                '<inertia ixx="0.001" ixy="0" ixz="0"\n'
                '         iyy="0.001" iyz="0"\n         izz="0.001"/>'
            ),
        ),
        (
            '<xacro:wheel prefix="front_left" radius="0.05" width="0.02"/>',
            (
                '<xacro:wheel prefix="front_left"\n             radius="0.05"\n'
                '             width="0.02"/>'
            ),
        ),
        (
            '<xacro:a_macro_with_a_very_long_name prefix="front_left" radius="0.05"/>',
            '<xacro:a_macro_with_a_very_long_name prefix="front_left"\n    radius="0.05"/>',
        ),
        (
            '<mesh filename="package://a_package/meshes/and/a/long/way/down/visual.dae"/>',
            '<mesh filename="package://a_package/meshes/and/a/long/way/down/visual.dae"/>',
        ),
    ],
)
def test_long_tags_are_broken_between_attributes(written: str, expected: str) -> None:
    assert inside(written, width=60) == expected
    assert inside(expected, width=60) == expected
    assert inside(expected, width=200) == written


def test_a_stray_text_in_a_robot_or_a_link_gets_a_line_of_its_own() -> None:
    text = '<robot name="r">,\n<link name="a">;<visual> x\n y<geometry/></visual></link>.</robot>'
    assert laid_out(text).split() == [
        *("<robot", 'name="r">', ",", "<link", 'name="a">', ";"),
        *("<visual>", "x", "y", "<geometry/>", "</visual>", "</link>", ".", "</robot>"),
    ]
    assert max(map(len, laid_out(text).splitlines())) < 20
    kept = "<gazebo> <a> 1</a> b</gazebo>"  # whose readers may take it for a value
    assert kept in laid_out(f'<robot name="r">x{kept}</robot>')


def test_parameters_of_a_macro_keep_their_lines_and_stand_below_one_another() -> None:
    written = (
        '<xacro:macro name="wheel" params="prefix parent \n\t reflect:=1  *origin\n'
        "  a_long_one:='0 0 0' another_long_one:=${pi}\n\"/>"
    )
    expected = (
        '<xacro:macro name="wheel"\n'
        '             params="prefix parent\n'
        "                     reflect:=1 *origin\n"
        "                     a_long_one:='0 0 0'\n"
        '                     another_long_one:=${pi}"/>'
    )
    assert inside(written, width=60) == expected
    assert inside(expected, width=60) == expected
    assert inside(expected, width=200) == (
        '<xacro:macro name="wheel" params="prefix parent reflect:=1 *origin '
        "a_long_one:='0 0 0' another_long_one:=${pi}\"/>"
    )


def test_what_stands_around_the_robot_stays() -> None:
    text = '<?xml version="1.0" ?>\n<!-- a -->\n\n\n<robot name="r"/>\n<!-- b -->\n\n'
    assert laid_out(text) == '<?xml version="1.0" ?>\n<!-- a -->\n\n<robot name="r"/>\n<!-- b -->\n'
    doctype = '<!DOCTYPE robot [\n<!ENTITY x "1>2">\n]>\n<robot name="r"/>\n'
    assert laid_out(doctype) == doctype


def test_line_ends_are_kept() -> None:
    text = '<robot name="r">\r\n<link name="a"/> <!-- x\r\n y -->\r\n</robot>'
    assert laid_out(text) == (
        '<robot name="r">\r\n  <link name="a"/> <!-- x\r\n y -->\r\n</robot>\r\n'
    )


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('<robot name="r"><link></robot>', "r.urdf:1:17"),
        ("", "r.urdf"),
        ("<launch/>", "the root element is <launch>, not <robot>"),
    ],
)
def test_what_cannot_be_laid_out(text: str, reason: str) -> None:
    with pytest.raises(UnreadableRobot, match=re.escape(reason)):
        laid_out(text)
    with pytest.raises(UnreadableRobot, match="not valid text"):
        formatted(Source("r.urdf", b"<robot name='\xff'/>"))


def test_it_is_deep_or_wide() -> None:
    deep = f"{'<a>' * 20_000}{'</a>' * 20_000}"
    with pytest.raises(UnreadableRobot, match="nested too deeply"):
        laid_out(f'<robot name="r">{deep}</robot>')
    deep = f"{'<a>' * 900}{'</a>' * 900}"
    assert laid_out(f'<robot name="r">{deep}</robot>').count("\n") == 1801
    wide = "<a/>" * 20_000
    assert laid_out(f'<robot name="r">{wide}</robot>').count("\n") == 20_002


_names = st.sampled_from(["link", "origin", "gazebo", "xacro:m", "xacro:macro", "a"])
_values = st.text("01 .-\n\t$<&'\"{}é", max_size=12).map(
    lambda text: text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
)
_blanks = st.sampled_from(["", " ", "\n", "\n\n\n", "\n\t", "\r\n  "])
_attributes = st.dictionaries(st.sampled_from(["name", "xyz", "rpy", "b", "params"]), _values).map(
    lambda found: "".join(f'\n {key}="{value}"' for key, value in found.items())
)
_leaves = st.one_of(
    st.sampled_from(["<!-- a -->", "<!--b\n\t  c\n-->", "<![CDATA[ x ]]>", "text", "<?p q?>"]),
    st.tuples(_names, _attributes, _blanks).map(lambda t: f"<{t[0]}{t[1]}{t[2]}/>"),
)
_trees = st.recursive(
    _leaves,
    lambda inner: st.tuples(
        _names, _attributes, st.lists(st.tuples(_blanks, inner), max_size=4), _blanks
    ).map(lambda t: f"<{t[0]}{t[1]}>{''.join(a + b for a, b in t[2])}{t[3]}</{t[0]}>"),
    max_leaves=12,
)


@given(st.lists(st.tuples(_blanks, _trees), max_size=4), st.integers(20, 120))
def test_twice_is_once_and_means_the_same(parts: list[tuple[str, str]], width: int) -> None:
    text = f'<robot name="r" {NAMESPACE}>{"".join(a + b for a, b in parts)}</robot>'
    once = laid_out(text, width)
    assert laid_out(once, width) == once
    assert elements(once) == elements(text)


class Elements(sax.ContentHandler):
    """Tags, attributes and texts as SAX tells them, white space aside; prefixes may be unbound."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[object] = []
        self._path: list[str] = []

    def startElement(self, name: str, attrs: Any) -> None:  # noqa: N802
        self.found += [name, {key: value.split() for key, value in attrs.items()}, ""]
        self._path.append(name)

    def endElement(self, name: str) -> None:  # noqa: N802
        self.found += [f"/{name}", ""]
        self._path.pop()

    def characters(self, content: str) -> None:
        if self._path[-1] in ("robot", "link") and "gazebo" not in self._path:  # stray
            content = "".join(content.split())
        self.found[-1] = f"{self.found[-1]}{content}"


def elements(text: str) -> list[object]:
    handler = Elements()
    sax.parseString(text.encode(), handler)
    return [one.strip() if isinstance(one, str) else one for one in handler.found]


@cache
def corpus_files() -> list[Path]:
    suffixes = {".urdf", ".xacro", ".gazebo", ".trans", ".srdf"}
    files = [*MODELS.rglob("*"), *(CORPUS.rglob("*") if CORPUS.is_dir() else ())]
    return sorted(file for file in files if file.suffix in suffixes)


@needs_corpus
def test_real_files_mean_the_same_and_twice_is_once(pytestconfig: pytest.Config) -> None:
    every = 1 if pytestconfig.getoption("thorough") else 5
    done = 0
    for file in corpus_files()[::every]:
        source = Source.read(file)
        try:
            once = formatted(source)
        except UrdfkitError:
            continue
        done += 1
        again = Source(str(file), once)
        assert formatted(again) == once, file
        assert elements(once.decode()) == elements(source.data.decode()), file
        assert len(re.findall(r"<!--", once.decode())) == source.data.count(b"<!--"), file
    assert done >= 300 // every


@needs_corpus
@given(st.data())
def test_damaged_real_files_are_refused_or_laid_out(data: st.DataObject) -> None:
    file = data.draw(st.sampled_from(corpus_files()))
    text = Source.read(file).data[:20_000]
    at = data.draw(st.integers(0, len(text)))
    length = data.draw(st.integers(0, 20))
    damaged = (
        text[:at]
        + data.draw(st.sampled_from([b"", b" ", b"<", b"\n", b"<a/>"]))
        + text[at + length :]
    )
    try:
        once = formatted(Source(str(file), damaged))
    except UrdfkitError:
        return
    assert formatted(Source(str(file), once)) == once
