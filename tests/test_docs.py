"""The generated documents are those of the rules as they are."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from docs import generate, transcripts
from tests.conftest import ROOT
from urdfkit import rules

WRITTEN = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("benchmarks/*.md")])


def test_the_pages_of_the_rules_are_up_to_date() -> None:
    pytest.importorskip("pinocchio", reason="the examples of some rules need it")
    written = {page.name: page.read_text(encoding="utf-8") for page in generate.FOLDER.iterdir()}
    assert written == generate.pages(), "run: python docs/generate.py"


@pytest.mark.skipif(os.name == "nt", reason="README shows a Unix shell")
def test_the_report_in_readme_is_what_is_printed() -> None:
    readme = transcripts.README.read_text(encoding="utf-8")
    assert transcripts.with_output(readme) == readme, "run: python docs/transcripts.py"


def test_every_rule_has_a_page() -> None:
    written = {page.name for page in generate.FOLDER.iterdir()}
    assert written == {"README.md"} | {f"{code}.md" for code in rules.codes()}


@pytest.mark.parametrize("document", WRITTEN, ids=lambda path: path.name)
def test_links_lead_to_files_that_exist(document: Path) -> None:
    text = document.read_text(encoding="utf-8")
    targets = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    assert [link for link in targets if not (document.parent / link).exists()] == []


@pytest.mark.parametrize("document", WRITTEN, ids=lambda path: path.name)
def test_the_rules_that_are_named_exist(document: Path) -> None:
    text = document.read_text(encoding="utf-8")
    named = set(re.findall(r"\b(?:XML|XAC|URD|REF|NAM|TRE|MSH|CFG)\d{3}\b", text))
    assert named <= set(rules.codes())


def test_the_architecture_names_every_module() -> None:
    folder = ROOT / "urdfkit"
    modules = {path.name for path in folder.glob("*.py")} - {"__init__.py", "__main__.py"}
    packages = {f"{path.parent.name}/" for path in folder.glob("*/__init__.py")}
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    assert set(re.findall(r"`([a-z_]+(?:\.py|/))`", text)) == modules | packages
