"""Slips of XML: what is said, where, and how often."""

from xml.parsers import expat

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.conftest import CORPUS, GRIPPER, needs_corpus
from urdfkit.text.source import Source
from urdfkit.text.tag_matching import MAX_ERRORS
from urdfkit.text.xml_errors import MAX_TAGS, syntax_mistakes


def mistakes(text: str) -> list[tuple[int, int, str]]:
    """Line, column and message of every mistake."""
    data = text.encode()
    source = Source("robot.urdf", data)
    return [(*source.position(mistake.start), mistake.message) for mistake in syntax_mistakes(data)]


def one(text: str) -> tuple[str, str]:
    """The text that the only mistake marks, and its message; ``|`` where something is missing."""
    data = text.encode()
    (mistake,) = syntax_mistakes(data)
    return data[mistake.start : mistake.end].decode() or "|", mistake.message


def inside(text: str) -> str:
    return f'<robot name="r">{text}</robot>'


class TestAttributes:
    @pytest.mark.parametrize(
        ("tag", "marked", "message"),
        [
            ("<link name=a/>", "a", "the value of 'name' needs quotes: name=\"a\""),
            ('<link name="a" type/>', "type", "attribute 'type' has no value"),
            ('<link name="a" type= />', "|", "attribute 'type' has no value"),
            ('<link name="a"type="b"/>', "|", "a space is missing before 'type'"),
            ('<link name="a", type="b"/>', ",", "',' does not belong in <link>"),
            ('<link name="a" #todo\n b="c"/>', "#todo", "'#todo' does not belong in <link>"),
            ('<link name="a" // b c />', "// b c ", "'// b c' does not belong in <link>"),
            ('<link name="a""/>', '"', "'\"' does not belong in <link>"),
            ('<parent link="a"//>', "/", "'/' does not belong in <parent>"),
            ('<link 1="a"/>', '1="a"', "'1=\"a\"' does not belong in <link>"),
            ('<origin xyz=0 0 0" rpy="0 0 0"/>', "|", "the value of 'xyz' has no opening quote"),
            ('<origin xyz="0 0 0 rpy="0 0 0"/>', '"', "the value of 'xyz' has no closing quote"),
            ('<link name="a/><link name="b"/>', '"', "the value of 'name' has no closing quote"),
            ('<link name="a></link>', '"', "the value of 'name' has no closing quote"),
            ('<if value="${a < b}"/>', "<", "'<' inside a value must be written '&lt;'"),
            ('<link name="a & b"/>', "&", "'&' must be written '&amp;'"),
        ],
    )
    def test_mistake(self, tag: str, marked: str, message: str) -> None:
        assert one(inside(tag)) == (marked, message)

    def test_given_twice(self) -> None:
        data = inside('<link name="a" name="b"/>').encode()
        (mistake,) = syntax_mistakes(data)
        assert mistake.message == "attribute 'name' is given twice"
        assert (mistake.start, mistake.end) == (31, 35)
        assert mistake.notes == ((22, 26, "first given here"),)

    def test_of_the_same_name_in_another_element_is_none(self) -> None:
        assert syntax_mistakes(inside('<link name="a"/><link name="a"/>').encode()) == []


class TestText:
    @pytest.mark.parametrize(
        ("text", "marked", "message"),
        [
            ("a & b", "&", "'&' must be written '&amp;'"),
            ("1 < 2", "<", "'<' does not begin a tag; in a text it must be written '&lt;'"),
            (
                "a&nbsp;b",
                "&nbsp;",
                "'&nbsp;' is not defined; XML defines only &lt; &gt; &amp; &quot; &apos;",
            ),
            ("&#0;", "&#0;", "'&#0;' is not a character"),
            ("&#xD800;", "&#xD800;", "'&#xD800;' is not a character"),
            ("]]>", "]]>", "']]>' in a text must be written ']]&gt;'"),
            ("\x01", "\x01", "the control character U+0001 is not allowed in XML"),
            ("\0", "\0", "a NUL byte is not allowed in XML"),
            ("a </1 b", "</", "'</' does not begin an end tag: a name must follow"),
            ("< link/>", "< link", "no space is allowed between '<' and 'link'"),
        ],
    )
    def test_mistake(self, text: str, marked: str, message: str) -> None:
        assert one(inside(text)) == (marked, message)

    @pytest.mark.parametrize("text", ["&lt;&gt;&amp;&quot;&apos;", "&#228;", "&#x1F916;", "a > b"])
    def test_what_xml_allows(self, text: str) -> None:
        assert syntax_mistakes(inside(text).encode()) == []

    def test_an_entity_that_the_file_declares_is_none(self) -> None:
        text = '<!DOCTYPE robot [<!ENTITY b "c">]>' + inside("&b;")
        assert syntax_mistakes(text.encode()) == []


class TestComments:
    def test_dashes(self) -> None:
        assert one(inside("<!-- a -- b -->")) == ("--", "'--' is not allowed inside a comment")

    def test_a_third_dash_at_the_end(self) -> None:
        assert mistakes(inside("<!-- a --->")) == [(1, 24, "'--->' does not end a comment")]

    @pytest.mark.parametrize("begin", ["<--", "<!-", "<! --"])
    def test_a_mistyped_begin(self, begin: str) -> None:
        """pa10_shadow_description: no text in which '<' must be written '&lt;'."""
        data = inside(f"{begin} <limit> & -->").encode()
        (mistake,) = syntax_mistakes(data)
        assert mistake.message == f"a comment begins with '<!--', not with '{begin}'"
        (edit,) = mistake.fix
        fixed = data[: edit[0]] + edit[2].encode() + data[edit[1] :]
        assert syntax_mistakes(fixed) == []

    def test_an_arrow_at_both_ends(self) -> None:
        assert one(inside("<!- the end ->")) == (
            "<!- the end ->",
            "a comment is written '<!-- ... -->'",
        )

    @pytest.mark.parametrize("text", ["a <-- b", "a <-- b <!-- c -->", "a <- b"])
    def test_what_is_no_mistyped_begin(self, text: str) -> None:
        assert one(inside(text))[1].startswith("'<' does not begin a tag")

    def test_a_row_of_dashes_is_one_mistake(self) -> None:
        assert one(inside("<!---------->"))[1] == "'--' is not allowed inside a comment"

    def test_without_an_end_hides_the_rest_and_nothing_follows_from_it(self) -> None:
        message = "the comment never ends: '-->' is missing"
        assert mistakes(inside("<link><!-- a <b>")) == [(1, 23, message)]

    def test_anything_else_may_stand_in_it(self) -> None:
        assert syntax_mistakes(inside("<!-- <a & b - c> \"'' -->").encode()) == []


class TestTags:
    def test_not_closed_names_the_tag_and_where_it_should_have_ended(self) -> None:
        data = b'<robot name="r">\n  <link name="arm">\n</robot>'
        (mistake,) = syntax_mistakes(data)
        assert data[mistake.start : mistake.end] == b'<link name="arm">'
        assert mistake.message == '<link name="arm"> is not closed before </robot>'
        ((start, end, note),) = mistake.notes
        assert data[start:end] == b"</robot>"
        assert note == "</robot> closes an enclosing element"

    def test_two_not_closed(self) -> None:
        assert mistakes('<robot><link name="a"><link name="b"></robot>') == [
            (1, 8, '<link name="a"> is not closed before </robot>'),
            (1, 23, '<link name="b"> is not closed before </robot>'),
        ]

    def test_an_end_tag_of_another_name(self) -> None:
        data = b'<robot name="r"><joint name="j"></link></robot>'
        (mistake,) = syntax_mistakes(data)
        assert data[mistake.start : mistake.end] == b"</link>"
        assert mistake.message == "expected </joint>, found </link>"
        assert mistake.notes == ((16, 32, '<joint name="j"> is opened here'),)

    def test_an_end_tag_of_another_name_that_is_open_too(self) -> None:
        text = '<robot><link name="a"><visual></link></link></robot>'
        assert mistakes(text) == [(1, 31, "expected </visual>, found </link>")]

    def test_not_closed_inside_one_that_is(self) -> None:
        text = '<robot><link name="a"><visual></link><link name="b"/></robot>'
        assert mistakes(text) == [(1, 23, "<visual> is not closed before </link>")]

    def test_an_empty_element_that_is_closed_again(self) -> None:
        data = b'<robot><link name="a"/>\n<visual/></link></robot>'
        (mistake,) = syntax_mistakes(data)
        assert mistake.message == "</link> closes nothing: no <link> is open"
        ((start, end, note),) = mistake.notes
        assert data[start:end] == b'<link name="a"/>'
        assert note == "<link .../> closes itself: its '/' is one too many"

    @pytest.mark.parametrize(
        ("before", "noted"),
        [
            ('<!-- <link name="a"> --><visual/>', ['<link name="a">']),
            ('<link name="a"></link><!--<link name="b">-->', ['<link name="b">']),
            ('<!-- <link name="a"> --><link name="b"></link>', []),
            ('<!-- <link name="a"/> -->', []),
        ],
    )
    def test_a_start_tag_in_a_comment(self, before: str, noted: list[str]) -> None:
        data = f"<robot>{before}</link></robot>".encode()
        (mistake,) = syntax_mistakes(data)
        assert mistake.message == "</link> closes nothing: no <link> is open"
        assert [data[start:end].decode() for start, end, _ in mistake.notes] == noted

    def test_closed_in_the_wrong_order_is_one_mistake(self) -> None:
        assert mistakes("<robot><a><b></a></b></robot>") == [
            (1, 11, "<b> is not closed before </a>")
        ]

    def test_without_its_bracket(self) -> None:
        text = '<robot><parent link="a"\n  <child link="b"/></robot>'
        assert mistakes(text) == [(1, 24, "'>' is missing at the end of <parent")]

    def test_without_its_bracket_may_have_content(self) -> None:
        text = '<robot><link name="a"\n  <visual/></link></robot>'
        assert mistakes(text) == [(1, 22, "'>' is missing at the end of <link")]

    def test_an_end_tag_with_attributes(self) -> None:
        message = "an end tag contains only its name: </link>"
        assert mistakes('<robot><link></link name="a"></robot>') == [(1, 14, message)]

    def test_an_end_tag_without_its_bracket(self) -> None:
        text = "<robot><link></link</robot>"
        assert mistakes(text) == [(1, 14, "'>' is missing after </link")]


class TestTheWholeFile:
    def test_cut_off_between_tags(self) -> None:
        data = b'<robot name="r">\n  <link name="a">\n    <visual>\n'
        (mistake,) = syntax_mistakes(data)
        assert mistake.message == "the file ends before </visual>, </link>, </robot>"
        assert mistake.start == mistake.end == len(data) - 1
        assert [message for _, _, message in mistake.notes] == [
            "<visual> is not closed",
            '<link name="a"> is not closed',
            '<robot name="r"> is not closed',
        ]

    @pytest.mark.parametrize("end", ["<link", '<link name="a"', "<link name=", '<link name="a'])
    def test_cut_off_inside_a_tag_is_one_mistake(self, end: str) -> None:
        ((line, column, _),) = mistakes(f"<robot>\n  {end}")
        assert (line, column >= 3) == (2, True)

    def test_a_second_root(self) -> None:
        data = b"<robot/><link/><link/>"
        (mistake,) = syntax_mistakes(data)
        assert mistake.trailing
        assert (mistake.start, mistake.end) == (8, 15)
        assert mistake.message == "<link> after the end of <robot>"
        assert mistake.notes == ((0, 8, "<robot> begins here"),)

    @pytest.mark.parametrize("root", ["gazebo", "link", "xacro:macro"])
    def test_parts_without_a_robot_around_them(self, root: str) -> None:
        (mistake,) = syntax_mistakes(f"<{root}/><link/>".encode())
        assert mistake.help == "put all elements into one <robot>"

    def test_the_rest_of_a_comment_behind_the_end(self) -> None:
        text = "<robot></robot><!-- <a> <!-- b --> <c/></a> -->"
        assert [message for *_, message in mistakes(text)] == [
            "'<!--' inside a comment: comments do not nest"
        ]

    def test_text_behind_the_end(self) -> None:
        (mistake,) = syntax_mistakes(b"<robot></robot>\n  bye <b>\n")
        assert mistake.trailing
        assert (mistake.start, mistake.end) == (18, 21)

    def test_an_end_tag_behind_the_end(self) -> None:
        assert mistakes("<robot></robot></robot>") == [
            (1, 16, "</robot> closes nothing: no <robot> is open")
        ]

    def test_text_before_the_first_tag(self) -> None:
        assert mistakes("hello <robot/>") == [(1, 1, "text before the first tag")]

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("", "the file is empty"),
            (" \r\n\t", "the file is empty"),
            ("<!-- nothing -->", "the file has no element"),
            ("links: [a, b]", "not an XML file: it contains no tag"),
            (
                "<!DOCTYPE html>\n<html><br></html>",
                "the file is a web page, not a robot",
            ),
            (
                "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n",
                "the file is a Git LFS pointer, not the robot itself",
            ),
        ],
    )
    def test_is_something_else(self, text: str, message: str) -> None:
        assert mistakes(text) == [(1, 1, message)]

    def test_binary_is_one_mistake(self) -> None:
        (mistake,) = syntax_mistakes(b"<robot>" + bytes(range(32)) * 9)
        assert mistake.message == "not a text file: it contains 261 control characters"

    @pytest.mark.parametrize(
        "declaration", ['<?xml verison="1.0"?>', "<?xml?>", '<?xml version="1.0" standalone="x"?>']
    )
    def test_a_wrong_declaration(self, declaration: str) -> None:
        message = 'the XML declaration must be <?xml version="1.0"?>'
        assert mistakes(declaration + "<robot/>") == [(1, 1, message)]

    def test_a_declaration_further_down(self) -> None:
        message = "the XML declaration must be at the very beginning of the file"
        assert mistakes('\n<?xml version="1.0"?><robot/>') == [(2, 1, message)]

    @pytest.mark.parametrize(
        ("before", "help"),
        [
            ("<!-- a -->", "remove what is above"),
            # Arctos: the output of xacro twice in one file
            ("<robot/>\n", "a file has one root element: remove it"),
        ],
    )
    def test_the_help_for_it(self, before: str, help: str) -> None:
        found = syntax_mistakes(f'{before}<?xml version="1.0"?><robot/>'.encode())
        assert found[0].help == help

    def test_other_instructions_are_fine(self) -> None:
        assert syntax_mistakes(b'<?xml-model href="a"?><robot><?php ?></robot>') == []


class TestPlaces:
    def test_columns_count_characters(self) -> None:
        assert mistakes("<robot>\n\tÄ€🤖 & b</robot>") == [(2, 6, "'&' must be written '&amp;'")]

    @pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
    def test_lines_end_as_they_may(self, end: str) -> None:
        text = end.join(["<robot>", "  <link>", "</robot>", ""])
        assert mistakes(text) == [(2, 3, "<link> is not closed before </robot>")]

    def test_all_mistakes_are_reported_in_the_order_of_the_file(self) -> None:
        text = inside('\n<link name=a/>\n<!-- -- -->\n<b c="1"d="2"/>\n& <x>')
        assert [(line, column) for line, column, _ in mistakes(text)] == [
            (2, 12),
            (3, 6),
            (4, 9),
            (5, 1),
            (5, 3),
        ]

    def test_in_a_line_of_a_megabyte(self) -> None:
        text = inside("<link/>" * 150_000 + "&")
        assert mistakes(text) == [(1, 16 + 1_050_000 + 1, "'&' must be written '&amp;'")]


class TestBounds:
    @pytest.mark.parametrize(
        "data",
        [
            b"<" * 1_000_000,
            b"&" * 1_000_000,
            b"</a>" * 400_000,
            b"<a><b></a>" * 100_000,
            b"<a b='" * 200_000,
            b'<a b="<' * 200_000,
            b"<a " + b"b " * 500_000,
            b"<!--" * 300_000,
            b"<!DOCTYPE " + b"<!-- " * 100_000,
            b"<a>" + b"--" * 500_000,
        ],
        ids=range(10),
    )
    def test_hostile_text_ends_soon_and_is_refused(self, data: bytes) -> None:
        found = syntax_mistakes(data)
        assert 0 < len(found) <= MAX_ERRORS

    def test_beyond_the_bound_on_tags_the_parser_says_what_is_wrong(self) -> None:
        assert syntax_mistakes(b"<a>" * (MAX_TAGS + 1)) == []


def refused_by_expat(data: bytes) -> bool:
    try:
        expat.ParserCreate("utf-8").Parse(data, True)
    except expat.ExpatError:
        return True
    return False


@needs_corpus
def test_no_mistake_is_found_where_expat_finds_none() -> None:
    files = [path for path in CORPUS.rglob("*") if path.suffix in (".urdf", ".xacro", ".xml")]
    accepted = [path for path in files if not refused_by_expat(path.read_bytes())]
    assert len(accepted) > 300
    assert [path for path in accepted if syntax_mistakes(path.read_bytes())] == []


MODEL = (GRIPPER).read_bytes()
PIECES = [b"<", b">", b'"', b"&", b"/", b"--", b"</link>", b"<link>", b"]]>", b" ", b"=", b"\0"]


@settings(derandomize=True)
@given(
    st.integers(0, len(MODEL)),
    st.integers(0, 40),
    st.sampled_from([b"", *PIECES]),
)
def test_mistakes_are_found_exactly_where_expat_refuses(at: int, length: int, piece: bytes) -> None:
    data = MODEL[:at] + piece + MODEL[at + length :]
    found = syntax_mistakes(data)
    assert bool(found) == refused_by_expat(data)
    assert [mistake.start for mistake in found] == sorted({mistake.start for mistake in found})
    assert all(0 <= mistake.start <= mistake.end <= len(data) for mistake in found)


def test_merge_conflicts() -> None:
    """Nothing else is said of them: both sides may be valid."""
    sides = '<<<<<<< HEAD\n<link name="a"/>\n=======\n<link name="b">\n>>>>>>> 24a2559\n'
    message = "the file contains the markers of a merge conflict"
    assert mistakes(inside(f"\n{sides}<link/>\n{sides}")) == [(2, 1, message), (8, 1, message)]
    assert mistakes(sides + inside("")) == [(1, 1, message)]
