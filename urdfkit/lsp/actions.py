"""Code actions for a finding: its fix, and a comment that suppresses it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.lint.ignore_comments import CommentPlaces
from urdfkit.lsp.markup import Markup
from urdfkit.text.diagnostic import Diagnostic, Edit, Fix


class QuickFix(Record):
    """A code action for a finding."""

    title: str  # in the menu
    edits: tuple[Edit, ...]  # in any files
    diagnostic: Diagnostic  # the finding
    preferred: bool = False  # True if the fix is safe


def actions(markup: Markup, diagnostic: Diagnostic) -> Iterator[QuickFix]:
    """The code actions for a finding.

    Args:
        diagnostic: a finding in the current text.
    """
    fix: Fix | None = diagnostic.fix
    if fix is not None:
        title = fix.title[:1].upper() + fix.title[1:]
        yield QuickFix(title, fix.edits, diagnostic, fix.safe)
    places = CommentPlaces(markup.source)
    element = places.element(diagnostic.span.start)
    if element is not None:
        edit = places.edit(element, [diagnostic.code])
        yield QuickFix(f"Suppress {diagnostic.code} here with a comment", (edit,), diagnostic)
