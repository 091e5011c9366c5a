"""Reasons why findings are not fixed that are known before a fix is tried."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.lint.report import Report
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.editing.apply import encoded
from urdfkit.text.editing.rewriting import NOT_TEXT, Rewrite
from urdfkit.text.source import Source, shown
from urdfkit.workspace.ownership import Ownership
from urdfkit.workspace.resolve import Resolver


class UnappliedFix(Record):
    """A finding that is not fixed, and the reason."""

    diagnostic: Diagnostic  # of the last check
    reason: str  # ``unsafe``, ``info`` or a sentence; empty if the finding has no fix


class FixReasons:
    """Reasons why fixes are not applied that are known before they are tried.

    Args:
        files: the checked descriptions; fixes may edit files in their workspaces.
        named: codes of the rules whose infos are to be fixed.
        unsafe, force: see ``fix``.
    """

    def __init__(
        self,
        files: Iterable[str],
        resolver: Resolver,
        named: Iterable[str],
        *,
        unsafe: bool = False,
        force: bool = False,
    ) -> None:
        self._resolver = resolver
        self._ownership = None if force else Ownership(files, resolver)
        self._named = frozenset(named)
        self._unsafe = unsafe
        self._protected: dict[Source, str] = {}
        #: The edited files before any fix, by real path.
        self.originals: dict[str, Rewrite] = {}

    def of_report(self, report: Report) -> tuple[UnappliedFix, ...]:
        """The findings of a report on the unchanged files."""
        return tuple(UnappliedFix(finding, self.of(finding, {})) for finding in report.diagnostics)

    def of(self, diagnostic: Diagnostic, texts: Mapping[str, bytes]) -> str:
        """Why the fix of a finding is not applied; empty if it may be, or there is none.

        Args:
            texts: contents of files after earlier fixes, by real path.
        """
        if diagnostic.fix is None:
            return ""
        sources = (edit.span.source for edit in diagnostic.fix.edits)
        reasons = (self._why_protected(source, texts) for source in sources)
        if reason := next(filter(None, reasons), ""):
            return reason
        if diagnostic.severity is Severity.INFO and diagnostic.code not in self._named:
            return "info"
        return "" if diagnostic.fix.safe or self._unsafe else "unsafe"

    def _why_protected(self, source: Source, texts: Mapping[str, bytes]) -> str:
        """Why a file is not edited; empty if it may be."""
        if source not in self._protected:
            self._protected[source] = self._find_protection(source, texts)
        return self._protected[source]

    def _find_protection(self, source: Source, texts: Mapping[str, bytes]) -> str:
        real = disk.real(source.path)
        if real not in self.originals:
            before = self._resolver.text(source.path)
            before = disk.contents(source.path) if before is None else before
            if before is None:
                return "file not found"
            self.originals[real] = Rewrite(shown(source.path), before, before)
        if source.undecodable is not None:
            return NOT_TEXT
        original = self.originals[real].before
        if encoded_as(source, source.data, original) != texts.get(real, original):
            return f"its encoding, {source.encoding}, cannot be kept"
        return self._ownership.why_protected(source) if self._ownership else ""


def encoded_as(source: Source, text: bytes, original: bytes) -> bytes | None:
    """A text in the encoding of a source; None if it cannot be encoded, or for a bad encoding.

    Args:
        text: in UTF-8.
        original: the bytes of the source's file.
    """
    try:
        return encoded(text, source.encoding, original)
    except (UnicodeError, LookupError):
        return None
