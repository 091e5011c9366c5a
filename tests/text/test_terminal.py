import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.text.source import Source, Span
from urdfkit.text.terminal import columns, frame, printable, wrap


def framed(line: str, marked: str, width: int = 72) -> tuple[str, str]:
    start = line.encode().index(marked.encode())
    return frame(Span(Source("a", line.encode()), start, start + len(marked.encode())), width)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("Rad", "Rad"),
        ("轮子 é", "轮子 é"),
        ("a\tb\nc\rd", "a b c d"),
        ("\x1b[31mred\x07", "\\x1b[31mred\\x07"),
        ("x\u202ey", "x\\u202ey"),
        ("\udce9.urdf", "\\udce9.urdf"),
        ("a\u00a0b\u3000c", "a b c"),
    ],
)
def test_nothing_printable_steers_a_terminal(text: str, shown: str) -> None:
    assert printable(text) == shown


@given(st.text())
def test_what_is_printable_is_one_line_without_control_characters(text: str) -> None:
    assert all(char.isprintable() for char in printable(text))


@pytest.mark.parametrize(
    ("text", "size"), [("", 0), ("arm", 3), ("轮子", 4), ("é", 1), ("e\u0301", 1), ("ｗ", 2)]
)
def test_columns(text: str, size: int) -> None:
    assert columns(text) == size


def test_wrap_breaks_at_spaces_and_indents_what_follows() -> None:
    assert wrap("one two three four", 9, indent=2) == "one two\n  three\n  four"


def test_wrap_keeps_a_long_word_whole() -> None:
    assert wrap("see /a/very/long/path here", 8) == "see\n/a/very/long/path\nhere"


def test_wrap_counts_what_stands_before_the_first_line() -> None:
    assert wrap("one two three", 20, used=10, indent=4) == "one two\n    three"
    assert wrap("one two three", 20, used=5, indent=4) == "one two three"


def test_wrap_begins_on_the_next_line_where_little_room_is_left() -> None:
    assert wrap("a b c", 20, used=17, indent=4) == "\n    a b c"


@given(st.lists(st.text("ab轮", min_size=1, max_size=9)), st.integers(20, 60))
def test_wrap_loses_nothing_and_keeps_to_the_width(words: list[str], width: int) -> None:
    lines = wrap(" ".join(words), width, indent=2).split("\n")
    assert " ".join(lines).split() == words
    assert all(columns(line) <= width for line in lines)


def test_the_caret_is_below_the_span() -> None:
    assert framed('<link name="arm"/>', "arm") == ('<link name="arm"/>', "            ^^^")


def test_the_indentation_is_left_out() -> None:
    assert framed("\t  <link/>", "<link/>") == ("<link/>", "^^^^^^^")


def test_a_tab_takes_four_columns() -> None:
    assert framed("<a\tb='1'/>", "b") == ("<a    b='1'/>", "      ^")


def test_wide_characters_have_two_carets() -> None:
    assert framed("<link 名='轮子'/>", "轮子") == ("<link 名='轮子'/>", "          ^^^^")


def test_the_span_ends_with_its_line() -> None:
    assert framed("<link\n  name='a'/>", "<link\n  name='a'/>") == ("<link", "^^^^^")


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_only_the_line_of_the_span_is_shown(end: str) -> None:
    assert framed(f"<robot>{end}<link/>{end}</robot>", "<link/>") == ("<link/>", "^^^^^^^")


def test_a_place_without_length_has_one_caret() -> None:
    source = Source("a", b"<robot>\n</robo")
    assert frame(Span(source, 0, 0), 72) == ("<robot>", "^")
    assert frame(Span(source, 14, 14), 72) == ("</robo", "      ^")


def test_escape_sequences_of_the_file_are_shown_not_sent() -> None:
    assert framed("<link name='\x1b[2J'/>", "\x1b[2J") == (
        "<link name='\\x1b[2J'/>",
        "            ^^^^^^^",
    )


def test_a_robot_on_one_line_is_cut_around_the_span() -> None:
    line, carets = framed("<a/>" * 1500 + "<mesh/>" + "<b/>" * 1500, "<mesh/>", 40)
    assert (len(line), line[:3], line[-3:]) == (40, "...", "...")
    assert line[carets.index("^") : carets.rindex("^") + 1] == "<mesh/>"
    assert abs(carets.index("^") - (40 - carets.rindex("^"))) <= 2, "in the middle"


def test_of_a_long_span_the_beginning_is_shown() -> None:
    line, carets = framed("<a/>" * 50 + "X" * 500, "X" * 500, 40)
    assert line.startswith("...")
    assert line.endswith("XX...")
    assert carets.index("^") == line.index("X") < 10


def test_a_wide_line_is_cut_by_columns() -> None:
    line, carets = framed("轮" * 500 + "<x/>" + "子" * 500, "<x/>", 41)
    assert columns(line) <= 41
    assert columns(line[: line.index("<")]) == carets.index("^")


@given(
    st.text(st.sampled_from("ab \t轮\u0301\x1b\u202e🤖"), max_size=300),
    st.text(st.sampled_from("mn\t子é"), min_size=1, max_size=100),
    st.text(st.sampled_from("ab \t轮\u0301\x1b\u202e🤖"), max_size=300),
    st.integers(32, 100),
)
def test_every_frame_fits_and_has_its_carets_where_the_span_is(
    before: str, marked: str, after: str, width: int
) -> None:
    data = before.encode(), marked.encode(), after.encode()
    start = len(data[0])
    line, carets = frame(Span(Source("a", b"".join(data)), start, start + len(data[1])), width)
    assert columns(line) <= width
    assert len(carets) <= width
    assert re.fullmatch(r" *\^+", carets)
    shown = marked.replace("\t", "    ")
    at = len(carets) - len(carets.lstrip())
    line = line.replace("\u0301", "") + " " * width
    position = next(n for n in range(len(line) + 1) if columns(line[:n]) >= at)
    assert line[position] == shown[0]


def test_a_huge_line_costs_nothing() -> None:
    source = Source("a", b"<a/>" * 4_000_000)
    for offset in range(0, 16_000_000, 16_000):
        frame(Span(source, offset, offset + 4), 72)
