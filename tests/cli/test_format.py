"""``urdfkit format``: what it writes, says and exits with."""

import io
import re
from pathlib import Path

import pytest

from tests.lint.test_formatting import NEAT, UGLY
from urdfkit.cli import main


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    file = tmp_path / "r.urdf"
    file.write_text(UGLY)
    return file


def test_a_formatted_file_is_unchanged(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["format", str(robot)]) == 0
    assert robot.read_text() == NEAT
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err == f"reformatted: {robot}\n1 reformatted, 0 unchanged\n"
    assert main(["format", str(robot), "--check"]) == 0
    assert capsys.readouterr().err == "0 would be reformatted, 1 unchanged\n"


@pytest.mark.parametrize("option", ["--check", "--diff"])
def test_checking_writes_nothing(
    robot: Path, option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["format", str(robot), option]) == 1
    assert robot.read_text() == UGLY
    captured = capsys.readouterr()
    *_, file, total = captured.err.splitlines()
    assert (file, total) == (
        f"would be reformatted: {robot}",
        "1 would be reformatted, 0 unchanged",
    )
    assert ('+  <link name="a"/>\n' in captured.out) is (option == "--diff")


def test_a_redirected_diff_has_colours_only_if_always(
    robot: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")  # as CI servers do
    assert main(["format", str(robot), "--diff"]) == 1
    plain = capsys.readouterr().out
    assert "\x1b" not in plain
    assert main(["format", str(robot), "--diff", "--color", "always"]) == 1
    colored = capsys.readouterr().out
    assert '\x1b[32m+  <link name="a"/>\x1b[0m\n' in colored
    assert re.sub(r"\x1b\[\d+m", "", colored) == plain


def test_a_failed_file_does_not_stop_the_others(
    robot: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bad = tmp_path / "bad.urdf"
    bad.write_text("<robot>")
    assert main(["format", str(bad), str(robot)]) == 2
    assert robot.read_text() == NEAT
    assert f"error: {bad}:1:" in capsys.readouterr().err


def test_standard_input(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(UGLY.encode())))
    assert main(["format", "-"]) == 0
    assert capsys.readouterr().out == NEAT


@pytest.mark.parametrize(("text", "code"), [(UGLY, 1), (NEAT, 0)])
@pytest.mark.parametrize("option", ["--check", "--diff"])
def test_standard_input_is_checked(
    text: str,
    code: int,
    option: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
    assert main(["format", "-", option]) == code
    assert bool(capsys.readouterr().out) is (code == 1 and option == "--diff")


def test_a_read_only_file_is_checked_and_not_written(robot: Path) -> None:
    robot.chmod(0o444)
    assert main(["format", str(robot)]) == 0
    assert robot.read_text() == UGLY
    assert main(["format", str(robot), "--check"]) == 1


def test_a_missing_file_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["format", "no.urdf"]) == 2
    assert "no.urdf" in capsys.readouterr().err
