from __future__ import annotations

import pytest

from urdfkit.diagnostic import Edit
from urdfkit.editing.fixer import apply_edits
from urdfkit.source import Source, Span

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
