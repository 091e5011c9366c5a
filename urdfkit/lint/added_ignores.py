"""Comments for the findings that a project has and accepts, so that a check reports new ones."""

from __future__ import annotations

from collections.abc import Iterable

from urdfkit.core.record import Record
from urdfkit.lint.engine import check_with
from urdfkit.lint.fix_guard import key_of, real_path
from urdfkit.lint.ignore_comments import CommentPlaces
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.editing.rewriting import Rewrite, rewrites
from urdfkit.text.source import Source
from urdfkit.workspace.ownership import Ownership
from urdfkit.workspace.resolve import Resolver


class AddedIgnores(Record):
    """What ignore comments do; nothing is written."""

    files: tuple[Rewrite, ...]  # that change
    suppressed: tuple[Diagnostic, ...]  # what a check does not report any more
    left: tuple[tuple[Diagnostic, str], ...]  # the others, each with the reason


def add_ignores(
    findings: Iterable[Diagnostic], files: Iterable[str], options: Options, *, force: bool = False
) -> AddedIgnores:
    """Put an ignore comment before the element of each finding.

    Args:
        force: edit files as well that are generated, read-only or ignored by git, or that lie
            outside the workspace of ``files``.

    Raises:
        UrdfkitError: as of ``check``; or a file has changed since it was read.
    """
    files = tuple(files)
    places = _CommentFiles(Ownership(files, Resolver(options.with_config().packages)), force=force)
    found = [(one, places.why_not(one)) for one in findings]
    wanted = [one for one, reason in found if not reason]
    texts = {**options.texts, **{one.path: one.after for one in places.rewritten(wanted)}}
    after = check_with(options._replace(texts=texts), files)
    remaining = set(map(key_of, after.diagnostics))
    return AddedIgnores(
        places.rewritten(one for one in wanted if key_of(one) not in remaining),
        tuple(one for one in wanted if key_of(one) not in remaining),
        tuple(
            (one, reason or "a comment does not reach it")
            for one, reason in found
            if reason or key_of(one) in remaining
        ),
    )


class _CommentFiles:
    """Where the comments of several files can stand; a file is read once."""

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
        """Why there can be no comment for a finding; empty if there can."""
        source, places = self._file(finding.span.source)
        if not places.has_root:
            return "the file is not XML that can be read, and takes no comment; fix it first"
        if places.element(finding.span.start) is None:
            return "only a comment for the whole file would do"
        return "" if self._force else self._ownership.why_protected(source)

    def rewritten(self, findings: Iterable[Diagnostic]) -> tuple[Rewrite, ...]:
        """The files with a comment before each element that has findings."""
        codes: dict[tuple[str, int], set[str]] = {}
        for one in findings:
            _, places = self._file(one.span.source)
            element = places.element(one.span.start)
            assert element is not None
            codes.setdefault((real_path(one.span.source), element), set()).add(one.code)
        return rewrites(
            self._files[path][1].edit(element, sorted(found))
            for (path, element), found in codes.items()
        )
