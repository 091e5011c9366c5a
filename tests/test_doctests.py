"""The examples in the docstrings of what users import are what happens."""

import doctest
from importlib import import_module

import pytest

from tests.conftest import ROOT

MODULES = ["urdfkit"] + [
    f"urdfkit.{name}" for name in "lint.engine lint.loading lint.rule_index text.source".split()
]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    failed, tried = doctest.testmod(import_module(name))
    assert tried > 0, "nothing to try"
    assert failed == 0
