"""What docs/security.md says in numbers and names is what the code does."""

import re

import click
import pytest

from tests.conftest import ROOT
from urdfkit.cli.group import COMMANDS, group
from urdfkit.scan import models
from urdfkit.text import located_yaml, source, xml_reader
from urdfkit.xacro import bounds, dom_builder, yaml_files
from urdfkit.xacro.substitution import ENVIRONMENT

PAGE = (ROOT / "docs" / "security.md").read_text(encoding="utf-8")
FLAT = " ".join(PAGE.split())


def chapter(heading: str) -> str:
    return PAGE.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]


def test_the_environment_variables_are_those_that_models_see() -> None:
    assert (
        set(re.findall(r"\b[A-Z]+(?:_[A-Z]+)+\b", chapter("Environment variables"))) == ENVIRONMENT
    )


def test_the_commands_in_a_process_of_their_own_have_its_limits() -> None:
    sentence = chapter("Time, memory and crashes").partition("compute in")[0]
    named = set(re.findall(r"`([a-z]+)`", sentence))
    context = click.Context(group)
    limited = {name for name in COMMANDS if _has_limits(group.get_command(context, name))}
    assert named == limited - {"scan"}  # which has limits for each model


def _has_limits(command: click.Command | None) -> bool:
    """True for a command with a limit of memory, or one all of whose commands have it."""
    assert command is not None
    if isinstance(command, click.Group):
        return all(map(_has_limits, command.commands.values()))
    return any("--memory" in option.opts for option in command.params)


@pytest.mark.parametrize(
    "sentence",
    [
        f"integers to {bounds.MAX_BITS:,} bits",
        f"sets and tables to {bounds.MAX_HASHED:,} texts",
        f"XML: {dom_builder.MAX_DEPTH} levels",
        f"YAML: {yaml_files.MAX_LEVELS} levels",
        f"numbers of {yaml_files.MAX_DIGITS} characters",
        f"Files: {source.MAX_BYTES // 2**20} MiB, YAML {located_yaml.MAX_BYTES // 2**20} MiB",
        f"Archives of `scan`: {models._LARGE / 1e9:.0f} GB when extracted",
        f"or {models._MOST_TIMES} times their size",
        f"headers of a tar {models._LARGEST_HEADER // 2**20} MiB",
    ],
)
def test_the_bounds_are_those_of_the_code(sentence: str) -> None:
    assert sentence in FLAT


def test_the_powers_of_ten_are_those_of_the_code() -> None:
    assert "10^6 characters or items" in FLAT
    assert bounds.MAX_LENGTH == 10**6
    assert "10^6 elements and attributes" in FLAT
    assert xml_reader.MAX_ELEMENTS == 10**6
    assert "10^5 values with every alias" in FLAT
    assert yaml_files.MAX_VALUES == 10**5
