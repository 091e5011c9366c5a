from pathlib import Path

import pytest

from tests.documents import document
from tests.xacros import xacro
from urdfkit.lint import loading
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing import edits
from urdfkit.text.editing.apply import apply_edits


def read(text: str) -> Element:
    return document(text).root


def after(element: Element, made: tuple[Edit, ...] | None) -> str:
    assert made is not None
    return apply_edits(element.tag_at.source.data, made).decode()


@pytest.mark.parametrize(
    ("text", "renamed"),
    [
        ("<a/>", "<b/>"),
        ("<a></a>", "<b></b>"),
        ("<a x='/>'><c/></a >", "<b x='/>'><c/></b >"),
        ("<a\n><a></a>\n</a\n>", "<b\n><a></a>\n</b\n>"),
    ],
)
def test_rename_element(text: str, renamed: str) -> None:
    root = read(text)
    assert after(root, edits.rename_element(root, "b")) == renamed


def test_an_element_whose_name_an_expression_gives_keeps_it(tmp_path: Path) -> None:
    (tmp_path / "r.xacro").write_text(xacro('<xacro:element xacro:name="link" name="a"/>'))
    (link,) = loading.load(tmp_path / "r.xacro").links
    assert edits.rename_element(link.at, "joint") is None


def test_replace_text_keeps_the_white_space_around_it() -> None:
    root = read("<a><b>\n 1 \n</b><c>1<d/></c></a>")
    b, c = root.children
    assert after(root, edits.replace_text(b, "<2 & 3>")) == (
        "<a><b>\n &lt;2 &amp; 3> \n</b><c>1<d/></c></a>"
    )
    assert edits.replace_text(c, "2") is None


def test_an_empty_element_before_the_end_of_its_parent() -> None:
    root = read("<a><a/></a>")
    (child,) = root.children
    assert after(root, edits.rename_element(child, "b")) == "<a><b/></a>"
    assert after(root, edits.remove_element(child)) == "<a></a>"


@pytest.mark.parametrize("text", ["<a x='1' y = \"2\"/>", "<a x='1'\n\ty\n=\n'2'/>"])
def test_rename_attribute(text: str) -> None:
    root = read(text)
    assert after(root, edits.rename_attribute(root.attributes["y"], "zz")) == (
        text.replace("y", "zz")
    )


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("<a x='1' y = \"2\" z='3'/>", "<a x='1' z='3'/>"),
        ("<a x='1'\n\ty\n=\n'2'/>", "<a x='1'/>"),
        ("<a y='y'/>", "<a/>"),
        ("<a  y='2' ></a>", "<a ></a>"),
    ],
)
def test_remove_attribute(text: str, left: str) -> None:
    root = read(text)
    assert after(root, edits.remove_attribute(root.attributes["y"])) == left


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("<a>\n  <b/>\n  <c/>\n</a>", "<a>\n  <c/>\n</a>"),
        ("<a>\n  <b/> <!-- size -->\n</a>", "<a>\n  <!-- size -->\n</a>"),
        ("<a>\n  <c/> <b/>\n</a>", "<a>\n  <c/> \n</a>"),
        ("<a><c/>\n\n  <b/>\n\n  <c/>\n</a>", "<a><c/>\n\n  <c/>\n</a>"),
        ("<a><c/>\n\n  <b/>\n  <c/>\n</a>", "<a><c/>\n\n  <c/>\n</a>"),
        ("<a>\n<b/></a>", "<a>\n</a>"),
    ],
)
def test_what_is_left_where_an_element_was(text: str, left: str) -> None:
    root = read(text)
    element = next(child for child in root.children if child.tag == "b")
    assert after(root, edits.remove_element(element)) == left


@pytest.mark.parametrize(
    ("written", "value", "new"),
    [("1", "2", "2"), (" 1\t2", "1 2", "1 2"), ("x", "a\"b'<&", "a&quot;b&apos;&lt;&amp;")],
)
def test_replace_value(written: str, value: str, new: str) -> None:
    root = read(f"<a x='{written}' y='{written}'/>")
    made = edits.replace_value(root.attributes["x"], value)
    assert after(root, made) == f"<a x='{new}' y='{written}'/>"


def test_a_value_that_the_file_does_not_hold_is_not_replaced() -> None:
    root = read("<a x='&lt;1'/>")
    assert edits.replace_value(root.attributes["x"], "2") is None
    assert edits.as_written(root.attributes["x"]) == "<1"
    assert edits.as_written(read("<a x='1\t2'/>").attributes["x"]) == "1\t2"


@pytest.mark.parametrize(
    ("limit", "scaled"),
    [
        ('lower="-180" upper="90"', 'lower="-18" upper="9"'),
        ('lower="0" upper="5"', 'lower="0" upper="0.5"'),
        ('effort="3" upper="1e-3"', 'effort="3" upper="0.0001"'),
    ],
)
def test_scale_limits(limit: str, scaled: str) -> None:
    root = read(f"<limit {limit}/>")
    assert after(root, edits.scale_limits(root, 0.1)) == f"<limit {scaled}/>"


def test_limits_that_come_out_of_an_expression_are_not_scaled(tmp_path: Path) -> None:
    file = tmp_path / "r.xacro"
    limit = '<limit lower="-90" upper="${9 * 10}"/>'
    file.write_text(xacro(f'<link name="a"/><joint name="j">{limit}</joint>'))
    joint = loading.load(file).joints_by_name["j"].at
    element = joint.child("limit")
    assert element is not None
    assert edits.scale_limits(element, 0.1) is None


def test_all_or_none() -> None:
    one = (Edit(read("<a/>").span, "b"),)
    assert edits.all_or_none([one, (), one]) == (*one, *one)
    assert edits.all_or_none([one, None]) is None
    assert edits.all_or_none([]) == ()


def test_insert_before_takes_the_indentation() -> None:
    root = read("<a>\r\n\t<b/>\r\n</a>")
    made = edits.insert_before(root.children[0], ("<c/>", "<d/>"))
    assert after(root, made) == "<a>\r\n\t<c/>\r\n\t<d/>\r\n\t<b/>\r\n</a>"


def test_insert_before_on_the_same_line() -> None:
    root = read("<a><b/></a>")
    assert after(root, edits.insert_before(root.children[0], ("<c/>",))) == "<a><c/>\n<b/></a>"


def test_move_after() -> None:
    root = read("<a>\n  <b>\n    <c>\n      <d/>\n    </c>\n  </b>\n</a>")
    inner = root.children[0].children[0]
    assert after(root, edits.move_after(inner, root.children[0])) == (
        "<a>\n  <b>\n  </b>\n  <c>\n    <d/>\n  </c>\n</a>"
    )


def test_lines_end_where_lines_of_a_file_end() -> None:
    root = read("<a>\r\n  <b>\r\n    <!-- 1\u20282\x853 -->\r\n  </b>\r\n</a>")
    assert edits.lines_of(root.children[0]) == ["<b>", "  <!-- 1\u20282\x853 -->", "</b>"]


def test_what_a_macro_wrote_through_an_include_is_from_a_macro(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text(xacro('<link name="included"/>'))
    body = """<xacro:include filename="part.xacro"/>
<xacro:macro name="m"><link name="called"/><xacro:include filename="more.xacro"/></xacro:macro>
<xacro:m/>
<link name="plain"/>"""
    (tmp_path / "more.xacro").write_text(xacro('<link name="within"/>'))
    (tmp_path / "r.xacro").write_text(xacro(body))
    links = loading.read(tmp_path / "r.xacro").model.links
    assert {link.name: edits.from_macro(link.at) for link in links} == {
        "included": False,
        "called": True,
        "within": True,
        "plain": False,
    }


def test_add_attribute(tmp_path: Path) -> None:
    root = read("<a x='1'  y = \"2\" ><c/></a>")
    made = [edits.add_attribute(root.attributes[name], "z", "3") for name in "xy"]
    assert [after(root, one) for one in made] == [
        '<a x=\'1\' z="3"  y = "2" ><c/></a>',
        '<a x=\'1\'  y = "2" z="3" ><c/></a>',
    ]
    (tmp_path / "r.xacro").write_text(
        xacro('<link><xacro:attribute name="name" value="a"/></link><link name="b"/>')
    )
    put, plain = loading.load(tmp_path / "r.xacro").links
    assert edits.add_attribute(put.at.attributes["name"], "z", "3") is None
    assert edits.add_attribute(plain.at.attributes["name"], "z", "3") is not None


def test_swap_exchanges_attributes_and_texts() -> None:
    root = read("<a x='1' y='2'><b> left </b><c>right</c><d><e/></d></a>")
    x, y = root.attributes.values()
    b, c, d = root.children
    assert after(root, edits.swap(x, y)).startswith("<a x='2' y='1'><b> left </b>")
    assert "<b> right </b><c>left</c>" in after(root, edits.swap(b, c))
    assert after(root, edits.swap(x, c)) == (
        "<a x='right' y='2'><b> left </b><c>1</c><d><e/></d></a>"
    )
    assert edits.swap(x, d) is None
    assert edits.swap(d, x) is None


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("<a>\n  <b/>\n  <b/>\n  <c/>\n</a>", "<a>\n  <c/>\n</a>"),
        ("<a><b/><b/></a>", "<a></a>"),
        ("<a>\n  <b/> <b/>\n  <c/>\n</a>", "<a>\n  <c/>\n</a>"),
        ("<a>\n  <b/>\n  <c/>\n  <b/>\n</a>", "<a>\n  <c/>\n</a>"),
        ("<a>\n\n  <b/>\n\n  <b/>\n\n  <c/>\n</a>", "<a>\n\n  <c/>\n</a>"),
    ],
)
def test_what_is_left_where_several_were(text: str, left: str) -> None:
    root = read(text)
    wrong = [child for child in root.children if child.tag == "b"]
    assert after(root, edits.remove_elements(wrong[::-1])) == left


@pytest.mark.parametrize(
    ("text", "first", "last"),
    [
        ("<a/>", "<a>\n  <n/>\n</a>", "<a>\n  <n/>\n</a>"),
        ("<a ></a>", "<a ><n/></a>", "<a ><n/></a>"),
        ("<a>\n</a>", "<a>\n  <n/>\n</a>", "<a>\n  <n/>\n</a>"),
        ("<a>1</a>", "<a><n/>1</a>", "<a>1<n/></a>"),
        (
            "<a>\r\n    <b/>\r\n</a>",
            "<a>\r\n    <n/>\r\n    <b/>\r\n</a>",
            "<a>\r\n    <b/>\r\n    <n/>\r\n</a>",
        ),
    ],
)
def test_lines_put_into_an_element(text: str, first: str, last: str) -> None:
    root = read(text)
    assert after(root, edits.insert_first(root, ("<n/>",))) == first
    assert after(root, edits.insert_last(root, ("<n/>",))) == last


def test_lines_behind_an_element_and_in_its_place() -> None:
    root = read("<a>\n\t<b>\n\t</b>\n</a>")
    (child,) = root.children
    lines = ("<c/>", "", "<d/>")
    assert after(root, edits.insert_after(child, lines)) == (
        "<a>\n\t<b>\n\t</b>\n\t<c/>\n\n\t<d/>\n</a>"
    )
    assert after(root, edits.replace(child.tag_at.whole_span, lines)) == (
        "<a>\n\t<c/>\n\n\t<d/>\n</a>"
    )


@pytest.mark.parametrize(
    ("text", "moved"),
    [
        ("<a><b><c/></b></a>", "<a><b></b><c/></a>"),
        ("<a>\n  <b><c/></b>\n</a>", "<a>\n  <b></b><c/>\n</a>"),
        ("<a><b>\n  <c/>\n</b></a>", "<a><b>\n</b><c/></a>"),
    ],
)
def test_what_shares_its_line_is_moved_as_it_is(text: str, moved: str) -> None:
    root = read(text)
    (outer,) = root.children
    assert after(root, edits.move_after(outer.children[0], outer)) == moved
