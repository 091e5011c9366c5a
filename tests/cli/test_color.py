"""Colours of every command: ``--color``, the variables, and which of the streams is a terminal."""

import sys

import pytest

from tests.shipped import GRIPPER
from urdfkit.cli import gazebo, importers, main, output, simulate
from urdfkit.text.terminal import CYAN, GREEN, RED, YELLOW, painted


@pytest.fixture(autouse=True)
def no_variables(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("NO_COLOR", "FORCE_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)


def use_terminals(monkeypatch: pytest.MonkeyPatch, *streams: str) -> None:
    for name in ("stdout", "stderr"):
        monkeypatch.setattr(getattr(sys, name), "isatty", lambda found=name in streams: found)


ERROR = painted("error", RED)


@pytest.mark.parametrize(
    ("words", "terminal", "variables", "is_colored"),
    [
        ([], "stderr", {}, True),
        ([], "stdout", {}, False),
        ([], "stderr", {"TERM": "dumb"}, False),
        ([], "stderr", {"NO_COLOR": "1"}, False),
        ([], "", {"FORCE_COLOR": "1"}, True),
        (["--color", "never"], "stderr", {}, False),
        (["--color", "always"], "", {}, True),
        (["--color=always"], "", {"NO_COLOR": "1"}, True),
    ],
)
@pytest.mark.parametrize("command", ["check", "tree", "format", "simulate"])
def test_errors_have_a_colour_if_standard_error_has(
    command: str,
    words: list[str],
    terminal: str,
    variables: dict[str, str],
    is_colored: bool,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    use_terminals(monkeypatch, terminal)
    assert main([command, "none.urdf", *words]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    line = captured.err.splitlines()[0]
    assert line.startswith(f"{ERROR}: " if is_colored else "error: ")
    assert ("\x1b" in line) is is_colored


def test_a_choice_holds_for_one_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    main(["tree", "none.urdf", "--color", "always"])
    main(["tree", "none.urdf"])
    main(["check", "none.urdf", "--color", "always"])
    main(["tree", "--no-such-option"])
    starts = [line.partition(":")[0] for line in capsys.readouterr().err.splitlines()]
    assert starts == [ERROR, "error", ERROR, "error"]


def test_warnings_are_yellow(capsys: pytest.CaptureFixture[str]) -> None:
    main(["check", GRIPPER, "--ignore", "QQQ", "--color", "always"])
    assert capsys.readouterr().err.startswith(f"{painted('warning', YELLOW)}: --ignore: ")


def test_severities_of_rules(capsys: pytest.CaptureFixture[str]) -> None:
    main(["rules", "XML001", "--color", "always"])
    assert capsys.readouterr().out.startswith(f"XML001  {ERROR}  ")
    main(["rules", "XML001"])
    assert capsys.readouterr().out.startswith("XML001  error  ")


@pytest.mark.parametrize(
    ("line", "colors", "color"),
    [
        ("  [FAILS] drive: joint 'FAILS' passes", simulate.COLORS, RED),
        ("  [warns] timestep: FAILS", simulate.COLORS, YELLOW),
        ("  [passes] hold: warns", simulate.COLORS, GREEN),
        (
            "Drake [may reject this robot]: 'urdfkit check --target drake' reports",
            importers.COLORS,
            RED,
        ),
        ("libsdformat [rejects this robot]:", gazebo.COLORS, RED),
        ("dropped          -  [dropped]: no mass", gazebo.COLORS, YELLOW),
        ("  [info]     TRE001  multiple-roots: line 1", output.SEVERITIES, CYAN),
    ],
)
def test_verdicts(line: str, colors: dict[str, str], color: str) -> None:
    before, _, rest = line.partition("[")
    word, _, after = rest.partition("]")
    output.use_color("never")
    assert output.colored(before + word + after, colors) == before + word + after
    output.use_color("always")
    assert output.colored(before + word + after, colors) == before + painted(word, color) + after
    output.use_color("auto")
