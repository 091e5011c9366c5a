"""Consistency of fixes with all uses of the text that they edit.

The body of a macro and the block of a property are written once, and are in the document as often
as they are used. An edit there changes all uses, so all of them must propose it.
"""

from collections.abc import Mapping

from urdfkit.lint.rules import Finding
from urdfkit.text.document import Attribute, Element, Tag


def without_inconsistent_fixes(findings: list[Finding], uses: Mapping[Tag, int]) -> list[Finding]:
    """The findings; without their fix if another use of the same text does not propose it.

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
