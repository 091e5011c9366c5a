"""What an editor offers to do about a finding: its fix, and a comment that accepts it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.lsp.markup import Page
from urdfkit.text.diagnostic import Diagnostic, Edit, Fix
from urdfkit.text.source import Span


class QuickFix(Record):
    """Something to do about a finding."""

    title: str  # for the menu
    edits: tuple[Edit, ...]  # of any files
    diagnostic: Diagnostic  # that it is about
    preferred: bool = False  # True if it cannot change what the robot does


def actions(page: Page, diagnostic: Diagnostic) -> Iterator[QuickFix]:
    """What can be done about a finding.

    Args:
        page: the file that it is in.
        diagnostic: one that holds for the text as it is.
    """
    fix: Fix | None = diagnostic.fix
    if fix is not None:
        yield QuickFix(_capital(fix.title), fix.edits, diagnostic, fix.safe)
    if edit := _comment(page, diagnostic):
        yield QuickFix(f"Suppress {diagnostic.code} here with a comment", (edit,), diagnostic)


def _comment(page: Page, diagnostic: Diagnostic) -> Edit | None:
    """An ignore comment before the element in which the finding is; none before the root."""
    node = page.node_at(diagnostic.span.start + 1)
    if node is None or node.parent is None:
        return None
    data = page.source.data
    line = data.rfind(b"\n", 0, node.start) + 1
    indent = data[line : node.start].decode("utf-8", "replace")
    newline = "\r\n" if b"\r\n" in data else "\n"
    separator = " " if indent.strip() else newline + indent
    text = f"<!-- urdfkit: ignore[{diagnostic.code}] -->{separator}"
    return Edit(Span(page.source, node.start, node.start), text)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
