"""Which fixes hold for every use of the text that they edit.

The body of a macro and the block of a property are written once and stand in the document as
often as they are used. An edit there changes all uses, so all of them must ask for it.
"""

from collections.abc import Mapping

from urdfkit.lint.rules import Finding
from urdfkit.text.document import Attribute, Element, Tag


def without_inconsistent_fixes(findings: list[Finding], uses: Mapping[Tag, int]) -> list[Finding]:
    """The findings, those without their fix whose place is used elsewhere without that fix.

    Args:
        uses: how often each tag stands in the document that they are about.
    """
    in_favour: dict[tuple[object, ...], set[int]] = {}
    for finding in findings:
        element = _element(finding)
        if finding.fix is not None and element is not None:
            in_favour.setdefault(_proposal(finding, element), set()).add(id(element))
    if not in_favour:
        return findings
    return [
        finding
        if finding.fix is None
        or (element := _element(finding)) is None
        or len(in_favour[_proposal(finding, element)]) == uses[element.tag_at]
        else finding._replace(fix=None)
        for finding in findings
    ]


def _proposal(finding: Finding, element: Element) -> tuple[object, ...]:
    """The place of a finding and the edits that it proposes."""
    assert finding.fix is not None
    edits = [(span.source.path, *span[1:], text) for span, text in finding.fix.edits]
    return (element.tag_at, *edits)


def _element(finding: Finding) -> Element | None:
    """The element that a finding is at; None for a place that is no element of the document."""
    return finding.node.element if isinstance(finding.node, Attribute) else finding.node
