"""Checkstyle's XML, which many CI servers and review tools read: Jenkins, SonarQube, reviewdog.

Source of the format: the output of Checkstyle's own ``XMLLogger``; it has no schema.
"""

from xml.etree.ElementTree import Element, SubElement

from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import posix
from urdfkit.output.formats._xml import document, xml_text

#: Version of Checkstyle, by which programs recognise the format.
_VERSION = "4.3"


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """An element for every file, with its findings; a rule that crashed is an error of the file."""
    root = Element("checkstyle", version=_VERSION)
    files: dict[str, Element] = {}
    for path in report.files:
        _file(root, files, path)
    for diagnostic in report.diagnostics:
        place = {"line": str(diagnostic.span.line), "column": str(diagnostic.span.column)}
        _error(
            _file(root, files, diagnostic.span.source.path),
            place,
            diagnostic.severity.value,
            diagnostic.message_with_variants,
            diagnostic.code,
        )
    for crash in report.crashed:
        file = _file(root, files, crash.path)
        _error(
            file, {"line": "1"}, "error", f"the rule crashed: {crash.error}", crash.code or "check"
        )
    return document(root)


def _file(root: Element, files: dict[str, Element], path: str) -> Element:
    """The element of a file, created on first use."""
    name = posix(path)
    if name not in files:
        files[name] = SubElement(root, "file", name=xml_text(name))
    return files[name]


def _error(file: Element, place: dict[str, str], severity: str, message: str, code: str) -> None:
    SubElement(
        file, "error", place, severity=severity, message=xml_text(message), source=f"urdfkit.{code}"
    )
