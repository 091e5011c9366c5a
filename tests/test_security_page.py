"""What docs/security.md says in numbers and names is what the code does."""

import json
import re
from pathlib import Path

import click
import pytest

from docs.playground.browser import MOST_FILES, MOST_UNPACKED
from tests.conftest import ROOT
from urdfkit.cli import main
from urdfkit.cli.group import COMMANDS, group
from urdfkit.core.expansion_limits import Limits
from urdfkit.mesh.io import assemble
from urdfkit.scan import archives
from urdfkit.text import located_yaml, python_source, source, xml_reader
from urdfkit.xacro import bounds, dom_builder, yaml_files
from urdfkit.xacro.substitution import ENVIRONMENT

_info = group.get_command(click.Context(group), "info")
assert _info is not None
LIMITS = {option.name: option for option in _info.params}
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
        f"Python launch files {python_source.MAX_BYTES // 1024} KiB",
        f"Meshes: {assemble.MAX_PARTS:,} surfaces",
        f"or one for {archives._BYTES_PER_MEMBER} bytes",
        f"Archives of `scan`: {archives._LARGE / 1e9:.0f} GB when extracted",
        f"or {archives._MAX_RATIO} times their size",
        f"headers of a tar {archives._MAX_HEADER // 2**20} MiB",
        f"playground: {MOST_UNPACKED // 10**6} MB and {MOST_FILES:,} files when extracted",
        f"takes at most {Limits().seconds:g} s of processor time",
        f"adds at most {Limits().megabytes} MB to the process",
        f"| {LIMITS['timeout'].default} s | `--timeout SECONDS` | `not finished after 300 s:",
        f"| {LIMITS['memory'].default} GiB | `--memory GIB` | `not enough memory` |",
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


def test_how_often_ci_fuzzes_is_what_it_does() -> None:
    assert "CI runs 2,000 of each every night (`tests/test_fuzz.py`)" in FLAT
    text = (ROOT / "tests" / "test_fuzz.py").read_text(encoding="utf-8")
    assert 'count = 2000 if pytestconfig.getoption("thorough")' in text
    workflow = (ROOT / ".github" / "workflows" / "tests.yml").read_text(encoding="utf-8")
    assert ".ci/run --thorough\n        if: github.event_name == 'schedule'" in workflow


def test_a_set_holds_about_300_other_keys() -> None:
    assert "or about 300 other keys" in FLAT
    bounds.check_comparisons(range(300))
    with pytest.raises(bounds.TooLarge):
        bounds.check_comparisons(range(330))


def test_a_file_of_2_gb_is_one_error_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    large = tmp_path / "large.urdf"
    with large.open("wb") as file:
        file.truncate(2 * 10**9)  # takes no room on the disk
    assert main(["check", str(large)]) == 2
    assert capsys.readouterr().err.endswith("large.urdf: larger than 64 MiB\n")


def test_an_untrusted_workspace_does_not_choose_the_program() -> None:
    manifest = json.loads((ROOT / "editors" / "vscode" / "package.json").read_text("utf-8"))
    untrusted = manifest["capabilities"]["untrustedWorkspaces"]
    assert untrusted["restrictedConfigurations"] == ["urdfkit.path"]
