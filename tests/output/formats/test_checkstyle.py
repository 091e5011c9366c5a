"""Checkstyle's XML, as a reader of XML understands it."""

from typing import Any
from xml.etree import ElementTree

import pytest

import urdfkit
from tests.conftest import MODELS
from tests.output.formats.made import diagnostic, report, span
from urdfkit.lint.report import Crashed
from urdfkit.output.formats.checkstyle import render
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

ONE = Source("one.urdf", '<robot name="轮">\n  <link name="arm"/>\n</robot>\n'.encode())


def read(text: str) -> dict[str, list[dict[str, str]]]:
    """The attributes of the errors by file; the shape is Checkstyle's."""
    root = ElementTree.fromstring(text.encode())
    assert (root.tag, sorted(root.attrib)) == ("checkstyle", ["version"])
    files: dict[str, list[dict[str, str]]] = {}
    for file in root:
        assert (file.tag, list(file.attrib)) == ("file", ["name"])
        assert all(error.tag == "error" and not len(error) for error in file)
        assert file.get("name") not in files
        files[file.attrib["name"]] = [dict(error.attrib) for error in file]
    return files


def test_every_field() -> None:
    found = diagnostic(span(ONE, "arm"), severity=Severity.WARNING)
    assert read(render(report(found, files=("one.urdf", "two.urdf")))) == {
        "one.urdf": [
            {
                "line": "2",
                "column": "15",
                "severity": "warning",
                "message": "link 'arm': 2 m is over 1 m",
                "source": "urdfkit.ABC123",
            }
        ],
        "two.urdf": [],
    }


def test_columns_count_characters() -> None:
    ((error,),) = read(render(report(diagnostic(span(ONE, '">')), files=()))).values()
    assert error["column"] == "15"


@pytest.mark.parametrize("severity", list(Severity))
def test_severities_are_those_of_checkstyle(severity: Severity) -> None:
    ((error,),) = read(
        render(report(diagnostic(span(ONE, "arm"), severity=severity), files=()))
    ).values()
    assert error["severity"] == severity.value
    assert error["severity"] in ("ignore", "info", "warning", "error")


def test_a_crash_is_an_error_of_the_file() -> None:
    crash = Crashed("ABC003", "one.urdf", "ValueError: boom")
    assert read(render(report(crashed=(crash,), files=("one.urdf",))))["one.urdf"] == [
        {
            "line": "1",
            "severity": "error",
            "message": "the rule crashed: ValueError: boom",
            "source": "urdfkit.ABC003",
        }
    ]


def test_what_xml_cannot_hold_is_replaced() -> None:
    source = Source("bad\udcff.urdf", b"<robot/>")
    found = diagnostic(span(source, "robot"), message="a\x00<&>\"' 轮")
    (name, (error,)), *_ = read(render(report(found, files=()))).items()
    assert (name, error["message"]) == ("bad?.urdf", "a?<&>\"' 轮")


@pytest.mark.parametrize("model", sorted(MODELS.rglob("*.urdf")), ids=lambda path: path.name)
def test_reports_of_the_models(model: Any) -> None:
    checked = urdfkit.check(model)
    reported = [
        (error["source"], int(error["line"]), int(error["column"]), error["message"])
        for errors in read(render(checked)).values()
        for error in errors
    ]
    assert reported == [
        (f"urdfkit.{d.code}", d.span.line, d.span.column, d.message) for d in checked.diagnostics
    ]
