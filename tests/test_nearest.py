from __future__ import annotations

import time

import pytest

from urdfkit.nearest import did_you_mean, nearest

CODES = ["XML001", "XML002", "TRE006", "not-well-formed", "base_link"]


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("XML01", "XML001"),
        ("xml002", "XML002"),
        ("TER006", "TRE006"),
        ("not-wellformed", "not-well-formed"),
        ("Base_Link", "base_link"),
        ("completely else", None),
        ("", None),
    ],
)
def test_nearest(word: str, meant: str | None) -> None:
    assert nearest(word, CODES) == meant


def test_did_you_mean() -> None:
    assert did_you_mean("bse_link", CODES) == "; did you mean 'base_link'?"
    assert did_you_mean("wheel", CODES) == ""
    assert did_you_mean("wheel", []) == ""


def test_an_endless_word_costs_little() -> None:
    start = time.process_time()
    nearest("x" * 10_000_000, [f"link_{n}" for n in range(1000)])
    assert time.process_time() - start < 5
