"""A description that comes in through standard input."""

import io
from pathlib import Path

import pytest

from tests.conftest import GRIPPER
from tests.xacros import xacro
from urdfkit.cli import main


@pytest.fixture(autouse=True)
def gripper(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(GRIPPER.read_bytes())))


@pytest.mark.parametrize(
    "words",
    [
        ["info"],
        ["tree"],
        ["kinematics"],
        ["mass"],
        ["gazebo"],
        ["inertia"],
        ["report"],
        ["migrate", "--to", "gz-harmonic"],
        ["mesh", "collision"],
    ],
    ids=lambda words: words[0],
)
def test_standard_input_gives_the_result_of_the_file(
    words: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(GRIPPER.parent)
    assert main([*words, "-"]) == 0
    of_stdin = capsys.readouterr()
    assert main([*words, GRIPPER.name]) == 0
    of_file = capsys.readouterr()
    said = of_stdin.out.replace(r"\<stdin\>", "<stdin>").replace("<stdin>", GRIPPER.name)
    assert (said, of_stdin.err) == (of_file.out, of_file.err)


def test_the_element_of_trace_may_be_in_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["trace", "-", "link/palm"]) == 0
    assert '<stdin>:13:3  <link name="palm">' in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["view", "-"], "standard input cannot be watched; pass a file"),
        (["diff", str(GRIPPER), "-"], "standard input cannot be compared; pass a file"),
        (["fix", "-"], "standard input cannot be fixed in place; pass a file"),
        (["inertia", "-", "--write", "--link", "palm", "--mass", "3"], "file not found"),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else "",
)
def test_commands_that_need_a_file_report_it(
    words: list[str],
    reason: str,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(words) == 2
    captured = capsys.readouterr()
    assert (captured.out, reason in captured.err) == ("", True), captured.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", ["expand", "report --quick", "diff", "check --format json"])
def test_a_dash_after_o_is_standard_output(
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    if command.startswith(("report", "diff")):
        pytest.importorskip("trimesh")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    name, *options = command.split()
    files = ["r.urdf"] * (2 if name == "diff" else 1)
    code = main([name, *files, *options])
    printed = capsys.readouterr().out
    assert main([name, *files, *options, "-o", "-"]) == code
    assert capsys.readouterr().out == printed != ""
    assert not (tmp_path / "-").exists()


@pytest.mark.parametrize("words", [["check", "-"], ["info", "-"], ["expand", "-"]])
@pytest.mark.parametrize(("file", "is_relative"), [("a.xacro", True), ("/no/a.xacro", False)])
def test_a_missing_relative_include(
    words: list[str],
    file: str,
    is_relative: bool,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    text = xacro(f'<xacro:include filename="{file}"/>').encode()
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(text)))
    assert main(words) != 0
    captured = capsys.readouterr()
    assert ("--stdin-filename FILE" in captured.out + captured.err) is is_relative
