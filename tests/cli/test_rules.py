import json

import pytest

from urdfkit.cli import main
from urdfkit.lint import rule_index


def test_a_line_for_every_rule(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == rule_index.codes()
    line = next(line for line in lines if line.startswith("TRE003"))
    words = line.split()
    assert words[:3] == ["TRE003", "error", "cycle"]
    assert line.endswith(
        "  Joints form a closed loop, or one joint has the same link as parent and child."
    )
    for line in lines:
        assert ("  fix  " in line[:24]) is rule_index.get(line[:6]).fixable


def test_the_same_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules", "--format", "json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert [entry["code"] for entry in document] == rule_index.codes()
    rule = rule_index.get("TRE003")
    assert next(entry for entry in document if entry["code"] == "TRE003") == {
        "code": "TRE003",
        "name": "cycle",
        "severity": "error",
        "by_target": {},
        "status": "stable",
        "since": "0.1",
        "options": {},
        "needs": ["model"],
        "fixable": False,
        "help": rule.help,
        "explanation": rule.explanation,
        "sources": list(rule.sources),
    }


def test_codes_prefixes_and_names_select_rules(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules", "tre", "missing-file"]) == 0
    codes = [line[:6] for line in capsys.readouterr().out.splitlines()]
    assert codes == ["MSH001", *(code for code in rule_index.codes() if code.startswith("TRE"))]
    assert main(["rules", "MHS"]) == 2
    assert "did you mean 'MSH'" in capsys.readouterr().err
