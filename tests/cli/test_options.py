"""The table of options, the two parsers that read it, and what the values mean."""

from pathlib import Path
from typing import Any

import click
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from urdfkit.cli import main, options, output, quick
from urdfkit.cli.group import group
from urdfkit.cli.options import CHECK, COLOR, Option, UsageError

KNOWN = (*CHECK, COLOR)
FLAGS = [option.flag for option in KNOWN]


def by_click(words: list[str]) -> dict[str, Any] | None:
    """What click makes of a command line; None if it refuses it, or gives help."""
    command = group.get_command(click.Context(group), "check")
    assert command is not None
    try:
        # As in the group: click keeps the option for help that is made first.
        made = command.make_context("check", list(words), help_option_names=["-h", "--help"])
        return made.params | {"color": output.used_color()}
    except (click.UsageError, click.exceptions.Exit):
        return None


def ordinary(option: Option) -> st.SearchStrategy[list[str]]:
    """An option as people type it."""
    if not option.metavar:
        return st.just([option.flag])
    values = st.sampled_from(option.choices) if option.choices else st.text(max_size=8)
    values = values.filter(lambda value: not value.startswith("-"))
    apart = values.map(lambda value: [option.flag, value])
    joined = values.map(lambda value: [f"{option.flag}={value}"])
    return apart | joined


FILES = st.one_of(
    st.just("-"), st.text(max_size=8).filter(lambda word: not word.startswith("-"))
).map(lambda word: [word])
ORDINARY = st.lists(st.one_of(FILES, *map(ordinary, KNOWN)), max_size=8).map(
    lambda parts: [word for part in parts for word in part]
)
MANGLED = [
    word
    for flag in FLAGS
    for word in (flag, f"{flag}=", f"{flag}=x", flag[:-1], flag[1:], flag.upper())
]
ODD = st.lists(
    st.sampled_from(
        [*MANGLED, *"-- - --help -h -x --- = a a:=b error auto -1".split(), "", "--no-trust"]
    ),
    max_size=8,
)


@given(ORDINARY, FILES)
def test_both_parsers_read_the_ordinary_alike(words: list[str], file: list[str]) -> None:
    words = words + file
    values = quick.parse(["check", *words])
    assert values is not None
    assert values == by_click(words)


@given(st.one_of(ODD, st.lists(st.text(max_size=8), max_size=5)))
@example(["a", "--", "--trust"])
@example(["a", "--select", "--trust"])
@example(["a", "--trust=yes"])
@example(["a", "--fail-on", "fatal"])
@example(["a", "--format"])
def test_the_quick_parser_never_contradicts_click(words: list[str]) -> None:
    values = quick.parse(["check", *words])
    if values is not None:
        assert values == by_click(words)


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["rules"],
        ["--version"],
        ["check"],
        ["check", "--trust"],
        ["check", "--help", "a"],
        ["check", "a", "--unknown"],
        ["check", "a", "-t"],
        ["check", "a", "--select"],
        ["check", "a", "--select", "--trust"],
        ["check", "a", "--color", "red"],
        ["check", "a", "--trust=1"],
        ["check", "--", "a"],
        ["a", "check"],
    ],
)
def test_unusual_command_lines_are_left_to_click(words: list[str]) -> None:
    assert quick.parse(words) is None


def values(*words: str) -> dict[str, Any]:
    found = quick.parse(["check", *words])
    assert found is not None
    return found


def test_files_and_arguments_are_distinguished() -> None:
    found = values("a.urdf", "x:=1", "-", "y:=a=b", "x:=2", "z:=")
    assert options.files(found) == ["a.urdf", "-"]
    assert options.arguments(found) == {"x": "2", "y": "a=b", "z": ""}


def test_lists_of_codes_may_be_repeated_and_have_commas() -> None:
    found = values("a", "--select", "MSH, XML001", "--select=TRE,")
    assert options.words(found, "select") == ["MSH", "XML001", "TRE"]
    assert options.words(found, "ignore") == []


def test_packages(tmp_path: Path) -> None:
    found = values("a", "--package", f"p={tmp_path}", "--package=q=.")
    assert options.packages(found) == {"p": str(tmp_path), "q": "."}


@pytest.mark.parametrize(
    ("words", "outputs"),
    [
        ([], [("text", "")]),
        (["--format", "json"], [("json", "")]),
        (["--format", "json:-", "--format", "text", "-o", "b"], [("json", ""), ("text", "b")]),
        (["--format", "json:a:b.json", "--format=text"], [("json", "a:b.json"), ("text", "")]),
        (["--statistics"], [("statistics", "")]),
        (
            ["--statistics", "--format", "json", "--format", "text:t"],
            [("json", ""), ("statistics", "t")],
        ),
        (["--info", "--format", "text:t"], [("full", "t")]),
        (["--select", "INE008"], [("full", "")]),
    ],
)
def test_outputs(words: list[str], outputs: list[tuple[str, str]]) -> None:
    assert options.outputs(values("a", *words), "warning") == outputs


def test_fail_on_info_shows_infos() -> None:
    assert options.outputs(values("a"), "info") == [("full", "")]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["x:=1"], "no file to check"),
        (["-", "-"], "can be read only once"),
        (["a", ":=1"], "':=1' has no name"),
        (["prefix=left_"], "a xacro argument has the form prefix:=left_"),
        (["a", "--package", "p"], "expected NAME=DIR"),
        (["a", "--package", "=."], "expected NAME=DIR"),
        (["a", "--format", "yaml"], "only "),
        (["a", "--format", "_paths"], "only "),
        (["a", "--format", "json:"], "a file name after the colon"),
        (["a", "--format", "json", "--format", "text"], "two formats write to standard output"),
        (["a", "--format", "json:x", "--format", "text:x"], "two formats write to x"),
    ],
)
def test_usage_errors(words: list[str], reason: str) -> None:
    found = values(*words)
    reasons = []
    readers = (options.files, options.arguments, options.packages)
    for read in (*readers, lambda found: options.outputs(found, "warning")):
        try:
            read(found)
        except UsageError as error:
            reasons.append(str(error))
    assert len(reasons) == 1
    assert reason in reasons[0]


def test_a_file_may_have_an_equals_sign_in_its_name(tmp_path: Path) -> None:
    file = tmp_path / "a=b.urdf"
    file.write_bytes(b"")
    assert options.files(values(str(file))) == [str(file)]


@pytest.mark.parametrize("word", ["--config=a.yaml", "--trust", "-v.urdf"])
def test_a_file_is_not_an_option(
    word: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """pre-commit lists the files of a pull request behind the options."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.yaml").write_text("trust = true")
    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    (tmp_path / word).write_text("")
    assert main(["check", "r.urdf", word]) == 2
    assert capsys.readouterr().err == f"error: '{word}' is a file, not an option; write ./{word}\n"
    assert main(["check", "--", "r.urdf"]) == 0
