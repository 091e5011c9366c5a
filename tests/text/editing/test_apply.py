import codecs

import pytest

from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.apply import apply_edits, encoded
from urdfkit.text.source import Source, Span

DATA = "<a b='é'/>".encode()
SOURCE = Source("a.urdf", DATA)


def edit(start: int, end: int, text: str) -> Edit:
    return Edit(Span(SOURCE, start, end), text)


def test_edits_are_applied_in_the_order_of_the_text() -> None:
    assert apply_edits(DATA, [edit(6, 8, "ü"), edit(1, 2, "axis"), edit(3, 4, "")]) == (
        "<axis ='ü'/>".encode()
    )


def test_insertions_at_one_place_keep_their_order_and_may_touch_a_replacement() -> None:
    edits = [edit(1, 1, "x"), edit(1, 2, "A"), edit(1, 1, "y"), edit(2, 2, "z")]
    assert apply_edits(DATA, edits).startswith(b"<xyAz b")


def test_no_edit_changes_nothing() -> None:
    assert apply_edits(DATA, []) is not None
    assert apply_edits(DATA, []) == DATA


@pytest.mark.parametrize(
    "edits",
    [
        [edit(1, 4, "x"), edit(3, 5, "y")],
        [edit(1, 4, "x"), edit(2, 2, "y")],
        [edit(1, 4, "x"), edit(1, 4, "x")],
        [edit(9, 1000, "x")],
        [edit(5, 4, "x")],
    ],
)
def test_edits_that_overlap_or_lie_outside_are_refused(edits: list[Edit]) -> None:
    with pytest.raises(ValueError, match=r"overlap|not in the text"):
        apply_edits(DATA, edits)


def test_an_insertion_at_the_very_end() -> None:
    assert apply_edits(DATA, [edit(len(DATA), len(DATA), "\n")]) == DATA + b"\n"


@pytest.mark.parametrize(
    ("mark", "codec"),
    [
        (codecs.BOM_UTF8, "utf-8-sig"),
        (codecs.BOM_UTF16_LE, "utf-16"),
        (codecs.BOM_UTF16_BE, "utf-16"),
        (codecs.BOM_UTF32_LE, "utf-32"),
        (codecs.BOM_UTF32_BE, "utf-32"),
    ],
)
def test_the_mark_of_the_file_stays(mark: bytes, codec: str) -> None:
    """Codecs of Python that read the mark, and take it off, are the judges."""
    written = encoded(DATA, "whatever", mark + b"...")
    assert written.startswith(mark)
    assert written.decode(codec) == DATA.decode()


@pytest.mark.parametrize("encoding", ["utf-8", "utf8", "iso-8859-1", "utf-16-le", "cp1252"])
def test_without_a_mark_the_encoding_counts(encoding: str) -> None:
    assert encoded(DATA, encoding, b"<").decode(encoding) == DATA.decode()


def test_a_character_that_the_encoding_lacks_is_refused() -> None:
    with pytest.raises(UnicodeEncodeError):
        encoded("<轮/>".encode(), "iso-8859-1", b"<")
