"""GitLab's code quality report."""

import json

import pytest

import urdfkit
from tests.conftest import MODELS
from tests.output.formats.made import diagnostic, report, span
from urdfkit.output.formats.gitlab import render
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

PLAIN = Source("urdf/robot.urdf", b'<robot name="r">\n  <link name="arm"/>\n</robot>\n')


def test_every_field() -> None:
    (issue,) = json.loads(render(report(diagnostic(span(PLAIN, "arm")))))
    assert len(issue.pop("fingerprint")) > 32
    assert issue == {
        "description": "link 'arm': 2 m is over 1 m",
        "check_name": "ABC123 some-defect",
        "severity": "minor",
        "location": {
            "path": "urdf/robot.urdf",
            "positions": {"begin": {"line": 2, "column": 15}, "end": {"line": 2, "column": 18}},
        },
    }


@pytest.mark.parametrize(
    ("severity", "name"),
    [(Severity.ERROR, "major"), (Severity.WARNING, "minor"), (Severity.INFO, "info")],
)
def test_severities(severity: Severity, name: str) -> None:
    (issue,) = json.loads(render(report(diagnostic(span(PLAIN, "arm"), severity=severity))))
    assert issue["severity"] == name


def test_text_stays_readable() -> None:
    source = Source("roboter/ärmchen.urdf", b"<r/>")
    assert '"path": "roboter/ärmchen.urdf"' in render(report(diagnostic(span(source, "r"))))


def test_nothing_found_is_an_empty_list() -> None:
    assert render(report()) == "[]\n"


def test_paths_are_relative_without_a_dot(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    for path in (str(tmp_path / "a.urdf"), "./a.urdf", "b/../a.urdf"):
        (issue,) = json.loads(render(report(diagnostic(span(Source(path, b"<r/>"), "r")))))
        assert issue["location"]["path"] == "a.urdf"


@pytest.mark.parametrize(
    "model", sorted(MODELS.rglob("*.urdf")) + sorted(MODELS.rglob("*.xacro")), ids=lambda p: p.name
)
def test_fingerprints_tell_the_findings_of_a_model_apart(model) -> None:
    checked = urdfkit.check(model)
    issues = json.loads(render(checked))
    assert len(issues) == len(checked.diagnostics)
    assert len({issue["fingerprint"] for issue in issues}) == len(issues)
