"""The summary of a scan."""

from pathlib import Path
from typing import Any

import pytest

from urdfkit.cli import main
from urdfkit.lint.options import Options
from urdfkit.scan.isolated import Settings
from urdfkit.scan.rows import FindingRow, ModelRow
from urdfkit.scan.run import scan
from urdfkit.scan.summary import summarise


def row(name: str, *codes: str, **more: Any) -> dict[str, Any]:
    findings = [
        FindingRow(code, f"rule-{code}", "error", "m", "p", 1, 1, "", 1)._asdict() for code in codes
    ]
    values = {"status": "ok", "hash": name, "errors": len(codes), "findings": findings, **more}
    return ModelRow(name, "ok")._asdict() | values


def test_rates_count_models_not_findings() -> None:
    found = summarise([row("a", "X1", "X1", "X2"), row("b", "X1"), row("c")])
    assert [(rate.code, rate.models, rate.findings) for rate in found.rules] == [
        ("X1", 2, 3),
        ("X2", 1, 1),
    ]
    assert found.rules[0].examples == ("a", "b")
    assert (found.models, found.with_errors, found.clean) == (3, 2, 1)


def test_models_with_one_hash_are_copies() -> None:
    found = summarise(
        [row("a", hash="1"), row("b", hash="2"), row("c", hash="1"), row("d", hash="")]
    )
    assert found.duplicates == (("a", "c"),)
    assert found.redundant == 1


def test_the_farthest_are_outliers() -> None:
    ordinary = [row(f"r{number}", mass=1 + number / 10) for number in range(20)]
    found = summarise(
        [*ordinary, row("heavy", mass=5e6), row("light", mass=1e-9), row("none", mass=0)]
    )
    assert [one.model for one in found.outliers if one.fact == "mass"] == ["light", "heavy"]


def test_failures_say_why() -> None:
    found = summarise([row("a", status="timeout", reason="not finished after 60 s")])
    assert found.statuses == {"timeout": 1}
    assert found.failures == (("a", "timeout", "not finished after 60 s"),)
    assert (found.clean, found.with_errors) == (0, 0)


def test_the_command_prints_and_writes_a_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    zoo, out = tmp_path / "zoo", tmp_path / "out"
    zoo.mkdir()
    (zoo / "<b>.urdf").write_text('<robot name="r"><link name="a"/><link name="a"/></robot>')
    (zoo / "c.urdf").write_text("no robot")
    scan([str(zoo)], str(out), Settings(Options()))
    assert main(["scan", "summary", str(out)]) == 0
    text = capsys.readouterr().out
    assert text.startswith("2 models: 1 ok, 1 unreadable")
    assert "NAM001" in text
    page = (out / "summary.html").read_text()
    assert "NAM001" in page
    assert "<b>" not in page


def test_no_results_are_an_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["scan", "summary", str(tmp_path)]) == 2
    assert "contains no results of a scan" in capsys.readouterr().err
