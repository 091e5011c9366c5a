"""Adds ignore comments for accepted findings, so that a check reports new ones only."""

from __future__ import annotations

from collections.abc import Iterable

from urdfkit.core.record import Record
from urdfkit.lint.engine import check_with
from urdfkit.lint.fix_checker import finding_key, real_path
from urdfkit.lint.ignore_comments import CommentPlaces
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.editing.rewriting import NOT_TEXT, Rewrite, rewrites
from urdfkit.text.source import Source
from urdfkit.workspace.ownership import Ownership
from urdfkit.workspace.resolve import Resolver


class AddedIgnores(Record):
    """The result of adding ignore comments, which are not yet written."""

    files: tuple[Rewrite, ...]  # changed files
    suppressed: tuple[Diagnostic, ...]  # findings that a check no longer reports
    left: tuple[tuple[Diagnostic, str], ...]  # the other findings, each with the reason


def add_ignores(
    findings: Iterable[Diagnostic], files: Iterable[str], options: Options, *, force: bool = False
) -> AddedIgnores:
    """Add an ignore comment before the element of each finding.

    Args:
        force: also edit files that are generated, read-only, ignored by git, or outside the
            workspace of ``files``.

    Raises:
        UrdfkitError: see ``check``; or a file has changed since it was read.
    """
    files = tuple(files)
    places = _CommentFiles(Ownership(files, Resolver(options.with_config().packages)), force=force)
    reasons = [(finding, places.why_not(finding)) for finding in findings]
    commented = [finding for finding, reason in reasons if not reason]
    texts = {**options.texts, **{file.path: file.after for file in places.rewritten(commented)}}
    after = check_with(options._replace(texts=texts), files)
    remaining = set(map(finding_key, after.diagnostics))
    suppressed = tuple(finding for finding in commented if finding_key(finding) not in remaining)
    return AddedIgnores(
        places.rewritten(suppressed),
        suppressed,
        tuple(
            (finding, reason or "a comment does not reach it")
            for finding, reason in reasons
            if reason or finding_key(finding) in remaining
        ),
    )


class _CommentFiles:
    """Places for comments in several files; each file is read once."""

    def __init__(self, ownership: Ownership, *, force: bool) -> None:
        self._ownership = ownership
        self._force = force
        self._files: dict[str, tuple[Source, CommentPlaces]] = {}

    def _file(self, source: Source) -> tuple[Source, CommentPlaces]:
        path = real_path(source)
        if path not in self._files:
            self._files[path] = source, CommentPlaces(source)
        return self._files[path]

    def why_not(self, finding: Diagnostic) -> str:
        """Why a finding cannot have a comment; empty if it can."""
        source, places = self._file(finding.span.source)
        if not places.has_root:
            return "only XML that can be read takes a comment; for other files: per-file-ignores"
        if places.element(finding.span.start) is None:
            return "only a comment for the whole file would do"
        if source.undecodable is not None:
            return NOT_TEXT
        return "" if self._force else self._ownership.why_protected(source)

    def rewritten(self, findings: Iterable[Diagnostic]) -> tuple[Rewrite, ...]:
        """The files with a comment before each element that has findings."""
        codes: dict[tuple[str, int], set[str]] = {}
        for finding in findings:
            source = finding.span.source
            element = self._file(source)[1].element(finding.span.start)
            assert element is not None
            codes.setdefault((real_path(source), element), set()).add(finding.code)
        return rewrites(
            self._files[path][1].edit(element, sorted(element_codes))
            for (path, element), element_codes in codes.items()
        )
