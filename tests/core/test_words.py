"""Names in a sentence."""

import pytest

from urdfkit.core.words import few, listed


@pytest.mark.parametrize(
    ("names", "expected"),
    [("a", "a"), ("ab", "a, b"), ("abc", "a, b and 1 more"), ("abcd", "a, b and 2 more")],
)
def test_few(names: str, expected: str) -> None:
    assert few([*names], 2) == expected


@pytest.mark.parametrize(
    ("names", "most", "expected"),
    [
        ("a", None, "a"),
        ("ab", None, "a and b"),
        ("abc", None, "a, b and c"),
        ("abc", 3, "a, b and c"),
        ("abcd", 3, "a, b, c and 1 more"),
    ],
)
def test_listed(names: str, most: int | None, expected: str) -> None:
    assert listed([*names], most) == expected
