"""Nothing that people read is wider than their terminal; programs get whole lines."""

import os
import subprocess
import sys
from collections.abc import Iterator

import click
import pytest

from tests.conftest import MISSION, ROOT
from urdfkit.cli import main, output
from urdfkit.cli.group import COMMANDS, group

ROBOT = str((MISSION).relative_to(ROOT))


def commands() -> Iterator[list[str]]:
    for name in COMMANDS:
        yield [name]
        command = group.get_command(click.Context(group), name)
        if isinstance(command, click.Group):
            yield from ([name, inner] for inner in command.list_commands(click.Context(command)))


@pytest.mark.parametrize("words", list(commands()), ids=" ".join)
def test_every_help_fits(
    words: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert main([*words, "--help"]) == 0
    assert [line for line in capsys.readouterr().out.splitlines() if len(line) > 80] == []


def on_terminal(*words: str) -> list[str]:
    """The lines that a command shows on a terminal of 80 columns."""
    pty = pytest.importorskip("pty")  # not on Windows
    ours, theirs = pty.openpty()
    try:
        subprocess.run(
            [sys.executable, "-m", "urdfkit", *words],
            check=False,
            cwd=ROOT,
            env={**os.environ, "COLUMNS": "80", "NO_COLOR": "1"},
            stdout=theirs,
            stderr=theirs,
            timeout=60,
        )
    finally:
        os.close(theirs)
    data = b""
    try:
        while read := os.read(ours, 1 << 16):
            data += read
    except OSError:  # the end, on Linux
        pass
    finally:
        os.close(ours)
    return data.decode().splitlines()


@pytest.mark.parametrize(
    "words",
    [
        ["check", ROBOT, "--format", "x"],
        ["tree", ROBOT, "--format", "x"],
        ["convert", ROBOT, "--to", "sdf", "-o", "/nowhere"],
        ["rules", "TRE"],
    ],
)
def test_lines_are_wrapped_on_a_terminal(words: list[str]) -> None:
    lines = on_terminal(*words)
    assert max(map(len, lines)) <= 80
    assert len(lines) > 1


def test_errors_are_one_line_without_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", ROBOT, "--format", "x"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert len(line) > 100


def test_comments_below_a_patch_fit_the_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["migrate", str(ROOT / ROBOT), "--to", "gz-harmonic"]) == 1
    comments = [line for line in capsys.readouterr().out.splitlines() if line.startswith("#")]
    assert len(comments) > 8
    assert [line for line in comments if len(line) > 80 and " " in line.lstrip("# ")] == []


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["check", "--ignor"], "no such option '--ignor'; did you mean '--ignore'? (see"),
        (["check", "--foo"], "no such option '--foo' (see 'urdfkit check --help')"),
        (["info", "x", "--timeout", "soon"], "'--timeout': 'soon' is not a number (see"),
        (["scan", "x", "-o", "y", "--jobs", "q"], "'--jobs': 'q' is not an integer (see"),
        (["mesh", ROBOT], f"unknown command '{ROBOT}'; to check that file: urdfkit check {ROBOT}"),
    ],
)
def test_usage_errors_are_plain(
    words: list[str],
    message: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(ROOT)
    assert main(words) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(("columns", "expected"), [("40", 40), ("200", 200), ("0", 80), ("x", 80)])
def test_the_variable_columns_sets_the_width(
    columns: str, expected: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    assert output.width() == expected
