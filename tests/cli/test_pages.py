"""Every command has a page that names all its options and shows what it really prints."""

from __future__ import annotations

import os
import re
from importlib import import_module
from pathlib import Path

import click
import pytest

from docs import transcripts
from urdfkit.cli.group import COMMANDS

PAGES = sorted(transcripts.FOLDER.glob("*.md"))


def option_names(command: str) -> set[str]:
    params = import_module(f"urdfkit.cli.{command}").command.params
    return {flag for param in params if isinstance(param, click.Option) for flag in param.opts}


def test_every_command_has_a_page() -> None:
    assert [page.stem for page in PAGES] == sorted(COMMANDS)


@pytest.mark.parametrize("command", COMMANDS)
def test_the_page_names_every_option_of_its_command_and_no_other(command: str) -> None:
    text = (transcripts.FOLDER / f"{command}.md").read_text(encoding="utf-8")
    assert text.startswith(f"# urdfkit {command}\n")
    named = set(re.findall(r"(?<=[`\[])--?[a-z][a-z-]*", text))
    others = set().union(*map(option_names, COMMANDS)) - option_names(command)
    assert option_names(command) <= named
    assert named - option_names(command) <= others


@pytest.mark.skipif(os.name == "nt", reason="the pages show a Unix shell")
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_what_the_page_shows_is_what_is_printed(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert transcripts.with_output(text) == text, "run: python docs/transcripts.py"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links_lead_to_files_that_exist(page: Path) -> None:
    targets = re.findall(r"\]\((?!https?:)([^)#]+)", page.read_text(encoding="utf-8"))
    assert [target for target in targets if not (page.parent / target).exists()] == []
