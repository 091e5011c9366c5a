"""Reports made by hand, for the tests of the formats."""

from typing import Any

from urdfkit.lint.report import Report
from urdfkit.text.diagnostic import Call, Confidence, Diagnostic, Severity
from urdfkit.text.document import Step
from urdfkit.text.source import Source, Span


def span(source: Source, text: str, number: int = 1) -> Span:
    """The ``number``-th place where a source has that text."""
    at = -1
    for _ in range(number):
        at = source.data.index(text.encode(), at + 1)
    return Span(source, at, at + len(text.encode()))


def macro(name: str, call: Span) -> Step:
    return Step("macro", name, call, None)


def diagnostic(at: Span, **changes: Any) -> Diagnostic:
    plain = Diagnostic(
        code="ABC123",
        name="some-defect",
        severity=Severity.WARNING,
        confidence=Confidence.MEASURED,
        message="link 'arm': 2 m is over 1 m",
        span=at,
        calls=(),
        related=(),
        help="",
        fix=None,
    )._replace(**changes)
    return plain if plain.calls else plain._replace(calls=(Call(plain.message, (), "link/arm"),))


def report(*diagnostics: Diagnostic, **changes: Any) -> Report:
    return Report(("robot.urdf",), diagnostics, (), (), ("ABC123",))._replace(**changes)
