"""The report command: forms by suffix, exit codes."""

import json
from pathlib import Path

import pytest

from tests.shipped import GRIPPER, MISSION
from urdfkit.cli import main


def test_markdown_on_standard_output(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["report", GRIPPER]) == 0
    assert capsys.readouterr().out.startswith("## gripper\n")


@pytest.mark.usefixtures("small_pictures")
def test_files_by_suffix(tmp_path: Path) -> None:
    for suffix in ("json", "md", "csv"):
        assert main(["report", MISSION, "-o", str(tmp_path / f"r.{suffix}")]) == 0
    assert json.loads((tmp_path / "r.json").read_text())["summary"]["error"] == 1
    assert (tmp_path / "r.csv").read_text().startswith("severity,code,name,")
    pytest.importorskip("jinja2")
    assert main(["report", MISSION, "-o", str(tmp_path / "r.html"), "--lang", "zh"]) == 0
    assert '<html lang="zh">' in (tmp_path / "r.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("robot", "severity", "code"),
    [(MISSION, "error", 1), (GRIPPER, "error", 0), (GRIPPER, "warning", 0)],
)
def test_fail_on(robot: str, severity: str, code: int, tmp_path: Path) -> None:
    words = ["report", robot, "-o", str(tmp_path / "r.md")]
    assert main([*words, "--fail-on", severity]) == code
    assert main(words) == 0


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ([MISSION, MISSION], "expected one file"),
        (["none.urdf"], "none.urdf"),
        ([MISSION, "-o", "r.pdf"], "the suffix is not one of"),
        ([MISSION, "-o", "/nowhere/r.md"], "no such directory"),
        ([MISSION, "--target", "mars"], "unknown target 'mars'"),
    ],
)
def test_usage_errors(words: list[str], error: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["report", *words]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert error in captured.err
