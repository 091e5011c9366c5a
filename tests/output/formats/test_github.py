"""Annotations of GitHub workflows, read back as the runner reads commands."""

import re

import pytest

from tests.output.formats.made import diagnostic, report, span
from urdfkit.lint.report import Crashed
from urdfkit.output import formats
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import Source

render = formats.get("github")

PLAIN = Source("urdf/robot.urdf", b'<robot name="r">\n  <link name="arm"/>\n</robot>\n')


def commands(*diagnostics: Diagnostic, **changes) -> list[tuple[str, dict[str, str], str]]:
    """Name, properties and message of every line."""
    found = []
    for line in render(report(*diagnostics, **changes)).splitlines():
        match = re.fullmatch(r"::(\w+) ([^:]*)::(.*)", line)
        assert match, line
        name, properties, message = match.groups()
        pairs = (pair.split("=", 1) for pair in properties.split(","))
        found.append((name, {key: plain(value) for key, value in pairs}, plain(message)))
    return found


def plain(text: str) -> str:
    for code, char in (("%0D", "\r"), ("%0A", "\n"), ("%3A", ":"), ("%2C", ","), ("%25", "%")):
        text = text.replace(code, char)
    return text


def test_a_line_for_each_finding_at_its_place() -> None:
    assert commands(diagnostic(span(PLAIN, "arm"), severity=Severity.ERROR, help="mend it")) == [
        (
            "error",
            {
                "file": "urdf/robot.urdf",
                "line": "2",
                "endLine": "2",
                "col": "15",
                "endColumn": "18",
                "title": "ABC123 some-defect",
            },
            "link 'arm': 2 m is over 1 m\nmend it",
        )
    ]


@pytest.mark.parametrize(
    ("severity", "name"),
    [(Severity.ERROR, "error"), (Severity.WARNING, "warning"), (Severity.INFO, "notice")],
)
def test_severities(severity: Severity, name: str) -> None:
    ((command, _, _),) = commands(diagnostic(span(PLAIN, "arm"), severity=severity))
    assert command == name


def test_a_place_of_several_lines_has_no_columns() -> None:
    ((_, properties, _),) = commands(diagnostic(span(PLAIN, '<link name="arm"/>\n</robot>')))
    assert "col" not in properties
    assert (properties["line"], properties["endLine"]) == ("2", "3")


@pytest.mark.parametrize(
    "text", ["50 % of 100%25", "a\nb\r\nc", "::error::not a command\n::error::nor this", "a, b: c"]
)
def test_a_message_stays_one_command(text: str) -> None:
    ((_, _, message),) = commands(diagnostic(span(PLAIN, "arm"), message=text))
    assert message == text


@pytest.mark.parametrize("path", ["a,b.urdf", "a:b%.urdf", "a\nb.urdf"])
def test_a_path_stays_one_property(path: str) -> None:
    ((_, properties, _),) = commands(diagnostic(span(Source(path, b"<robot/>"), "robot")))
    assert properties["file"] == path


def test_an_absolute_path_is_relative_to_the_current_directory(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    source = Source(str(tmp_path / "urdf" / "a.urdf"), b"<robot/>")
    ((_, properties, _),) = commands(diagnostic(span(source, "robot")))
    assert properties["file"] == "urdf/a.urdf"


def test_a_crashed_rule_is_an_error() -> None:
    crashed = (Crashed("ABC003", "a.urdf", "ValueError: a\nb", "Traceback ..."),)
    ((name, properties, message),) = commands(crashed=crashed)
    assert (name, message) == ("error", "a.urdf: ValueError: a\nb")
    assert properties == {"title": "urdfkit ABC003"}


def test_nothing_found_is_nothing() -> None:
    assert render(report()) == ""
