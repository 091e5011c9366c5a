"""Every command has a page that names all its options and shows what it really prints."""

from __future__ import annotations

import os
import re
from pathlib import Path

import click
import pytest

pytest.importorskip("trimesh", reason="the commands about meshes need the extra meshes")

from docs import transcripts
from urdfkit.cli.group import group
from urdfkit.cli.lazy import LazyGroup


def all_commands(inside: LazyGroup, prefix: str = "") -> dict[str, click.Command]:
    """Every command by its full name, those of groups included."""
    found: dict[str, click.Command] = {}
    for name in inside.names:
        command = inside.get_command(click.Context(inside), name)
        assert command is not None
        found[prefix + name] = command
        if isinstance(command, LazyGroup):
            found |= all_commands(command, f"{prefix}{name} ")
    return found


assert isinstance(group, LazyGroup)
COMMANDS = all_commands(group)
PAGES = sorted(transcripts.FOLDER.glob("*.md"))


def option_names(command: str) -> set[str]:
    params = COMMANDS[command].params
    return {flag for param in params if isinstance(param, click.Option) for flag in param.opts}


def test_every_command_has_a_page() -> None:
    assert {page.stem for page in PAGES} == {name.replace(" ", "-") for name in COMMANDS}


@pytest.mark.parametrize("command", COMMANDS)
def test_the_page_names_every_option_of_its_command_and_no_other(command: str) -> None:
    text = (transcripts.FOLDER / f"{command.replace(' ', '-')}.md").read_text(encoding="utf-8")
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
