"""The sources of a checkout decide its results: a test that edits a copy of them."""

import os
from pathlib import Path

import pytest

from urdfkit.core import disk, own_sources
from urdfkit.core.file_log import FileLog, present_answer


def noted() -> FileLog:
    log = FileLog()
    disk.log_to(log)
    try:
        own_sources.log_sources()
    finally:
        disk.log_to(None)
    return log


def test_a_module_that_changes_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(own_sources, "_PACKAGE", str(tmp_path))
    facts = tmp_path / "facts.json"
    facts.write_text("{}")
    answer = noted().answers["t", str(facts)]
    assert present_answer("t", str(facts), answer, since=0) == answer
    os.utime(facts, ns=(1, 1))
    assert present_answer("t", str(facts), answer, since=0) is None


def test_imported_modules_and_data_are_sources() -> None:
    paths = {path for kind, path in noted().answers if kind == "t"}
    assert {own_sources.__file__, disk.__file__} <= paths
    assert any(path.endswith("redirects.json") for path in paths)


def test_an_installed_version_does_not_change(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(own_sources, "_PACKAGE", "/usr/lib/python3/site-packages/urdfkit")
    assert not noted().answers
