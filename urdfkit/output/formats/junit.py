"""JUnit XML for CI servers: one test case per rule and file, failed by its findings.

Errors and warnings are failures, infos are output, rules that did not run are skipped, and a rule
that crashed is an error of the test case. A robot that is not checked is a skipped test case.
"""

from operator import itemgetter
from xml.etree.ElementTree import Element, SubElement

from urdfkit.lint.report import Report
from urdfkit.lint.rule_index import NOT_CHECKED
from urdfkit.output.formats._paths import posix
from urdfkit.output.formats._xml import document, xml_text
from urdfkit.text.diagnostic import Diagnostic, Severity


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """The whole report; one test suite per file."""
    root = Element("testsuites", name="urdfkit")
    paths = dict.fromkeys(map(posix, report.files))
    paths.update(dict.fromkeys(posix(d.span.source.path) for d in report.diagnostics))
    paths.update(dict.fromkeys(posix(skip.path) for skip in report.skipped))
    for path in paths:
        _suite(root, path, report)
    _count(root)
    return document(root)


def _suite(root: Element, path: str, report: Report) -> None:
    suite = SubElement(root, "testsuite", name=xml_text(path))
    by_rule: dict[str, list[Diagnostic]] = {}
    unchecked = []
    for diagnostic in report.diagnostics:
        if posix(diagnostic.span.source.path) != path:
            continue
        if diagnostic.code == NOT_CHECKED:
            unchecked.append(f"{_line(diagnostic)}\n{diagnostic.help}")
        else:
            by_rule.setdefault(f"{diagnostic.code} {diagnostic.name}", []).append(diagnostic)
    for name, diagnostics in sorted(by_rule.items()):
        _case(suite, path, name, diagnostics)
    skipped = [(skip.code, skip.reason) for skip in report.skipped if posix(skip.path) == path]
    if unchecked:
        skipped = [*filter(itemgetter(0), skipped), ("", "\n".join(unchecked))]
    for code, reason in skipped:
        case = _new_case(suite, path, code or "check")
        SubElement(case, "skipped", message=xml_text(reason))
    for crash in report.crashed:
        if posix(crash.path) == path:
            case = _new_case(suite, path, crash.code or "check")
            SubElement(case, "error", message=xml_text(crash.error)).text = xml_text(
                crash.traceback
            )
    if not len(suite):
        _new_case(suite, path, "check")


def _new_case(suite: Element, path: str, name: str) -> Element:
    return SubElement(suite, "testcase", classname=xml_text(path), name=xml_text(name))


def _case(suite: Element, path: str, name: str, diagnostics: list[Diagnostic]) -> None:
    case = _new_case(suite, path, name)
    case.set("file", xml_text(path))
    case.set("line", str(diagnostics[0].span.line))
    variants = dict.fromkeys(name for finding in diagnostics for name in finding.variants)
    if all(finding.variants for finding in diagnostics):
        properties = SubElement(case, "properties")
        value = xml_text(", ".join(variants))
        SubElement(properties, "property", name="variants", value=value)
    failures = [d for d in diagnostics if d.severity is not Severity.INFO]
    if failures:
        failure = SubElement(
            case, "failure", type=failures[0].severity.value, message=xml_text(failures[0].message)
        )
        failure.text = xml_text("\n".join(map(_line, failures)))
    infos = [d for d in diagnostics if d.severity is Severity.INFO]
    if infos:
        SubElement(case, "system-out").text = xml_text("\n".join(map(_line, infos)))


def _line(diagnostic: Diagnostic) -> str:
    kind = f"{diagnostic.severity.value} {diagnostic.code}"
    return f"{diagnostic.span}: {kind} {diagnostic.message_with_variants}"


def _count(root: Element) -> None:
    for element in (root, *root):
        cases = list(element.iter("testcase"))
        element.set("tests", str(len(cases)))
        for kind, attribute in (("failure", "failures"), ("error", "errors")):
            element.set(attribute, str(sum(case.find(kind) is not None for case in cases)))
        element.set("skipped", str(sum(case.find("skipped") is not None for case in cases)))
