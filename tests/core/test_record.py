"""A Record is a named tuple, whatever one does with it."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import NamedTuple

import pytest

import urdfkit
from urdfkit.core.record import Record


class Place(Record):
    """One of urdfkit's."""

    file: str
    line: int
    column: int = 1
    note: str = ""

    @property
    def brief(self) -> str:
        return f"{self.file}:{self.line}"


class Same(NamedTuple):
    """The same, as the standard library makes it."""

    file: str
    line: int
    column: int = 1
    note: str = ""


@pytest.mark.parametrize(
    ("values", "named"),
    [
        (("a", 1), {}),
        (("a", 1, 2), {}),
        (("a", 1, 2, "n"), {}),
        (("a",), {"line": 3}),
        ((), {"note": "n", "file": "a", "line": 3}),
        (("a", 1), {"note": "n"}),
    ],
)
def test_it_is_made_as_a_named_tuple_is(values: tuple[object, ...], named: dict[str, str]) -> None:
    place, same = Place(*values, **named), Same(*values, **named)  # type: ignore[arg-type]
    assert tuple(place) == tuple(same)
    assert hash(place) == hash(tuple(place)) == hash(same)
    assert place._asdict() == same._asdict()
    assert repr(place) == repr(same).replace("Same", "Place")
    assert tuple(place._replace(line=9)) == tuple(same._replace(line=9))
    assert (place.file, place.line, place.column, place.note) == tuple(place)
    assert place.brief == f"{same.file}:{same.line}"


@pytest.mark.parametrize(
    ("values", "named"),
    [
        ((), {}),
        (("a",), {}),
        (("a", 1, 2, "n", 5), {}),
        (("a", 1), {"line": 2}),
        (("a", 1), {"row": 2}),
        ((), {"file": "a"}),
    ],
)
def test_a_wrong_call_says_what_it_takes(values: tuple[object, ...], named: dict[str, str]) -> None:
    with pytest.raises(TypeError):
        Same(*values, **named)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"Place\(file, line, column, note\): "):
        Place(*values, **named)  # type: ignore[arg-type]


def test_a_change_of_what_is_not_there_is_refused() -> None:
    with pytest.raises(TypeError, match="no row"):
        Place("a", 1)._replace(row=2)  # type: ignore[call-arg]


def test_it_cannot_be_changed_and_has_no_dict() -> None:
    place = Place("a", 1)
    with pytest.raises(AttributeError):
        place.line = 2  # type: ignore[misc]
    with pytest.raises(AttributeError):
        place.more = 2  # type: ignore[attr-defined]


def test_it_goes_between_processes() -> None:
    place = Place("a", 1, note="n")
    back = pickle.loads(pickle.dumps(place))
    assert back == place
    assert type(back) is Place


def test_it_can_be_matched() -> None:
    match Place("a", 1):
        case Place(file, line):
            assert (file, line) == ("a", 1)


def test_the_modules_of_records_keep_their_annotations_as_text() -> None:
    """As Python 3.14 needs it."""
    package = Path(urdfkit.__file__).parent
    texts = {path: path.read_text(encoding="utf-8") for path in package.rglob("*.py")}
    users = [path for path, text in texts.items() if "(Record)" in text]
    assert len(users) > 50
    assert [p for p in users if "from __future__ import annotations" not in texts[p]] == []
