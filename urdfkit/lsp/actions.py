"""What an editor offers to do about a finding: its fix, and a comment that accepts it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.lint.ignore_comments import CommentPlaces
from urdfkit.lsp.markup import Page
from urdfkit.text.diagnostic import Diagnostic, Edit, Fix


class QuickFix(Record):
    """Something to do about a finding."""

    title: str  # for the menu
    edits: tuple[Edit, ...]  # of any files
    diagnostic: Diagnostic  # that it is about
    preferred: bool = False  # True if it cannot change what the robot does


def actions(page: Page, diagnostic: Diagnostic) -> Iterator[QuickFix]:
    """What can be done about a finding.

    Args:
        diagnostic: one that holds for the text as it is.
    """
    fix: Fix | None = diagnostic.fix
    if fix is not None:
        yield QuickFix(_capital(fix.title), fix.edits, diagnostic, fix.safe)
    places = CommentPlaces(page.source)
    element = places.element(diagnostic.span.start)
    if element is not None:
        edit = places.edit(element, [diagnostic.code])
        yield QuickFix(f"Suppress {diagnostic.code} here with a comment", (edit,), diagnostic)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
