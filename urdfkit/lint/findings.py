"""Findings of a rule: their length, the consistency of their fixes, conversion to diagnostics."""

from collections.abc import Iterable, Mapping

from urdfkit.lint.rules import Finding, Location, Rule
from urdfkit.text.diagnostic import Call, Diagnostic, Related
from urdfkit.text.document import Attribute, Element, Step, Tag
from urdfkit.text.source import Span, shown_text

#: Most characters of a message: names in it may be as long as a file.
MAX_MESSAGE = 2000
#: Most places in data files that a finding lists.
MAX_DATA = 10


def bounded(finding: Finding) -> Finding:
    """A finding with a message of bounded length and displayed paths."""
    message, help = shown_text(finding.message), shown_text(finding.help)
    if len(message) > MAX_MESSAGE:
        message = f"{message[:MAX_MESSAGE]}..."
    if (message, help) == (finding.message, finding.help):
        return finding
    return finding._replace(message=message, help=help)


def diagnose(
    rule: Rule, findings: Iterable[Finding], targets: tuple[str, ...] = ()
) -> list[Diagnostic]:
    """Diagnostics of a rule; findings at one place of a macro body become one diagnostic."""
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for number, finding in enumerate(findings):
        span, via = place(finding)
        key: tuple[object, ...] = (span.source.path, span.start, span.end)
        # Findings of several macro calls have one cause; any other place can have two defects.
        is_copied = any(step.kind != "launch" for step in via)
        groups.setdefault(key if is_copied else (*key, number), []).append(finding)
    return [_fold(rule, group, targets) for group in groups.values()]


def _fold(rule: Rule, group: list[Finding], targets: tuple[str, ...]) -> Diagnostic:
    severity, affected = rule.severity_for(targets)
    group.sort(key=lambda finding: ((finding.severity or severity).rank, -finding.weight))
    worst = group[0]
    if worst.severity is not None:
        severity, affected = worst.severity, worst.targets
    calls = tuple(Call(f.message, place(f)[1], f.node.path if f.node else "") for f in group)
    return Diagnostic(
        rule.code,
        rule.name,
        severity,
        worst.confidence or rule.confidence,
        worst.message,
        place(worst)[0],
        calls,
        (*worst.related, *_in_data_files(group)),
        worst.help or rule.help,
        worst.fix,
        affected,
        worst.group_key,
    )


def _in_data_files(group: list[Finding]) -> list[Related]:
    """The places in data files of the values of findings, without duplicates."""
    lines = dict.fromkeys(
        line
        for finding in group
        for line in (finding.data.lines if finding.data else ())
        if line.span != place(finding)[0]
    )
    return list(lines)[:MAX_DATA]


def place(finding: Finding) -> tuple[Span, tuple[Step, ...]]:
    """The span of a finding, and its macro calls and includes.

    A number in a YAML file is to be edited there; the expression that includes it is the innermost
    step.
    """
    at = finding.at
    if isinstance(at, Span):
        return at, ()
    if isinstance(at, Location):
        return at.span, at.frame.steps() if at.frame else ()
    if finding.data is not None and finding.data.value is not None:
        value = finding.data.value
        return value, (*at.via, Step("include", value.source.path, at.span, None))
    return at.span, at.via


def without_inconsistent_fixes(findings: list[Finding], uses: Mapping[Tag, int]) -> list[Finding]:
    """The findings; without their fix if another use of the same text does not propose it.

    The body of a macro and the block of a property are written once, and are in the document as
    often as they are used. An edit there changes all uses, so all of them must propose it.

    Args:
        uses: number of uses of each tag in the document.
    """
    proposers: dict[tuple[object, ...], set[int]] = {}
    for finding in findings:
        element = _element(finding)
        if finding.fix is not None and element is not None:
            proposers.setdefault(_proposal(finding, element), set()).add(id(element))
    if not proposers:
        return findings
    return [
        finding
        if finding.fix is None
        or (element := _element(finding)) is None
        or len(proposers[_proposal(finding, element)]) == uses[element.tag_at]
        else finding._replace(fix=None)
        for finding in findings
    ]


def _proposal(finding: Finding, element: Element) -> tuple[object, ...]:
    """The place of a finding and the edits that it proposes."""
    assert finding.fix is not None
    edits = [(span.source.path, *span[1:], text) for span, text in finding.fix.edits]
    return (element.tag_at, *edits)


def _element(finding: Finding) -> Element | None:
    """The element of a finding; None for a place outside of all elements."""
    return finding.node.element if isinstance(finding.node, Attribute) else finding.node
