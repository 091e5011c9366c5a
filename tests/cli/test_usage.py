"""The command line as people type it: help, typos, and one line for what cannot be done."""

import subprocess
import sys

import pytest

from tests.shipped import GRIPPER
from urdfkit.cli import main
from urdfkit.core.libraries import missing_for_meshes
from urdfkit.text.source import shown


@pytest.mark.parametrize(
    ("word", "suggested"),
    [("lint", "check"), ("chek", "check"), ("xacro", "expand"), ("help", "--help")],
)
def test_a_command_of_another_tool(
    word: str, suggested: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([word]) == 2
    assert f"unknown command '{word}'; did you mean '{suggested}'?" in capsys.readouterr().err


needs_meshes = pytest.mark.skipif(bool(missing_for_meshes()), reason="it needs the extra meshes")
MESH = pytest.param(["mesh"], marks=needs_meshes)


@pytest.mark.parametrize(
    "words", [[], ["check"], MESH, pytest.param(["mesh", "hull"], marks=needs_meshes)]
)
def test_the_short_option_for_help(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*words, "-h"]) == 0
    assert capsys.readouterr().out.startswith(" ".join(["Usage: urdfkit", *words]))


def test_without_a_command_there_is_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    captured = capsys.readouterr()
    assert all(name in captured.out for name in ("check", "explain", "rules", "--version"))
    assert captured.err == ""


@pytest.mark.parametrize("group", [[], MESH])
def test_short_help_of_each_command_fits_80_columns(
    group: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert main([*group, "--help"]) == 0
    _, *lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if line.endswith("...")] == []
    assert max(map(len, lines)) <= 80


@pytest.mark.parametrize("command", [[], ["check"], ["explain"], ["rules"]])
def test_help_of_every_command(command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*command, "--help"]) == 0
    assert capsys.readouterr().out.startswith(" ".join(["Usage: urdfkit", *command]) + " ")


def test_ignoring_an_unknown_rule_is_a_warning(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", GRIPPER, "--ignore", "QQQ,XLM001"]) == 0
    assert capsys.readouterr().err.splitlines() == [
        "warning: --ignore: no rule 'QQQ'; 'urdfkit rules' lists them",
        "warning: --ignore: no rule 'XLM001'; did you mean 'XML001'?",
    ]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["chek", "a"], "'chek'"),
        (["--verbose"], "--verbose"),
        (["check"], "no file to check"),
        (["check", "a", "--slect", "MSH"], "--select"),
        (["check", "a", "--fail-on", "fatal"], "'error', 'warning', 'info'"),
        (["check", "a", "--select"], "--select"),
        (["check", GRIPPER, "--select", "XLM001"], "did you mean 'XML001'?"),
        (["check", GRIPPER, "--target", "movit"], "did you mean 'moveit'?"),
        (["check", "no_such.urdf"], "no_such.urdf: file not found"),
        (["check", ""], "'': file not found"),
        (["check", GRIPPER, "no_such.urdf"], "no_such.urdf: file not found"),
        (["check", GRIPPER.replace("gripper", "griper")], "did you mean 'gripper.urdf'?"),
        (["check", "/no/such/directory/robot.urdf"], "no such directory '/no/such/directory'"),
        (["check", GRIPPER, "--format", "json:/no/such/r.json"], "no such directory '/no/such'"),
        (["explain"], "RULE"),
        (["explain", "XML0001"], "did you mean 'XML001'?"),
        (["rules", "--format", "yaml"], "'text', 'json'"),
    ],
)
def test_usage_errors_are_one_line_and_exit_2(
    words: list[str], reason: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("error: ")
    assert captured.err.count("\n") == 1
    assert reason in captured.err


def test_control_characters_in_errors_are_escaped(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "no\x1b[2J\n.urdf"]) == 2
    assert capsys.readouterr().err == "error: no\\x1b[2J .urdf: file not found\n"


@pytest.mark.parametrize(
    ("word", "message"),
    [
        ("chekc", "unknown command 'chekc'; did you mean 'check'?"),
        (
            GRIPPER,
            (
                f"unknown command '{shown(GRIPPER)}'; "
                f"to check that file: urdfkit check {shown(GRIPPER)}"
            ),
        ),
        ("nothing", "unknown command 'nothing'"),
    ],
)
def test_a_typo_in_the_name_of_a_command(
    word: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([word]) == 2
    assert capsys.readouterr().err == f"error: {message} (see 'urdfkit --help')\n"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["tree"], "missing argument 'FILE [NAME:=VALUE]...'"),
        (["inertia", GRIPPER, "--mass", "heavy"], "invalid value for '--mass': 'heavy' is not a "),
        (["inertia", GRIPPER, "--mass", "1", "--density", "1"], "--mass, --density and --material"),
    ],
)
def test_usage_errors_begin_like_other_errors(
    words: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    assert capsys.readouterr().err.startswith(f"error: {message}")


@pytest.mark.parametrize(
    "words",
    [
        ["bundle", GRIPPER],
        ["convert", GRIPPER, "--to", "mjcf"],
        ["scan", GRIPPER],
        ["new", "robot", "--kind", "arm"],
    ],
)
def test_a_stream_is_no_directory(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*words, "-o", "-"]) == 2
    assert "'-' is not a directory" in capsys.readouterr().err


def test_help_of_the_mesh_commands_without_their_libraries() -> None:
    """A student looks at the help before installing anything."""
    code = (
        "import sys; sys.modules['numpy'] = None\n"
        "from urdfkit.cli import main\nsys.exit(main(['mesh', '--help']))"
    )
    ran = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True)
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "  simplify" in ran.stdout
    assert "needs numpy, which is not installed" in " ".join(ran.stdout.split())
