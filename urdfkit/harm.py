"""What forbids a fix: that it makes anything worse, for anybody, or that it does not help."""

from __future__ import annotations

import os
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from itertools import zip_longest

from urdfkit.config import Config
from urdfkit.diagnostic import Diagnostic, Edit, Report
from urdfkit.discovery import affected
from urdfkit.errors import UnreadableFile
from urdfkit.source import Source
from urdfkit.subject import Subject
from urdfkit.workspace.resolve import Resolver

#: A finding in any round: its code, its file and its message, since places move.
Key = tuple[str, str, str]

#: An edit, known in every robot that includes its file: real path, first and last byte, new text.
Place = tuple[str, int, int, str]


def harm(before: Report, after: Report) -> str:
    """What forbids the fixes between two checks; empty if nothing does.

    Errors of rules that could not look before were there, but hidden.
    """
    if lost := {(s.path, s.code) for s in after.skipped} - {
        (s.path, s.code) for s in before.skipped
    }:
        path = min(lost)[0]
        return f"dropped: with it, {path} could not be checked any more"
    hidden = {skipped.code for skipped in before.skipped}
    for now, old in zip_longest(after.errors, before.errors, fillvalue=()):
        if added := sorted((Counter(now) - Counter(old)).keys() - hidden):
            return f"dropped: it would add {added[0]}"
    if len(after.crashed) > len(before.crashed):
        return f"dropped: with it, {after.crashed[-1].code or 'the check'} fails"
    return ""


def useless(before: Report, after: Report, applied: list[Diagnostic]) -> str:
    """Says so if a fix left its finding as it was; it would be applied for ever."""
    expected = Counter(map(key_of, before.diagnostics))
    expected.subtract(Counter(map(key_of, applied)))
    now = Counter(map(key_of, after.diagnostics))
    stays = any(now[key] > expected[key] for key in map(key_of, applied))
    return "dropped: the finding stays" if stays else ""


class Watch:
    """Looks at what fixes may break beyond the findings that they are for.

    That is other robots of the workspace that include a file, and what the rules say that were
    not asked for.

    Args:
        check: all rules over the robots and some others.
        subjects: the same descriptions, in the same order.
        resolver, config: of the check.
        is_partial: True if the findings to fix are those of some rules only.
    """

    def __init__(
        self,
        check: Callable[[Mapping[str, bytes], Iterable[str]], Report],
        subjects: Callable[[Mapping[str, bytes], Iterable[str]], Iterable[Subject | None]],
        resolver: Resolver,
        config: Config | None,
        is_partial: bool,
    ) -> None:
        self._check = check
        self._subjects = subjects
        self._resolver = resolver
        self._config = config or Config()
        self._is_partial = is_partial

    def disputes(
        self, chosen: Iterable[Diagnostic], texts: Mapping[str, bytes], report: Report
    ) -> set[Key]:
        """The findings whose fix edits what another robot uses without asking for the edit.

        Args:
            chosen: findings with fixes.
            texts: in the place of those on disk.
            report: that they are from.
        """
        edits = {key_of(one): [place_of(e) for e in one.fix.edits] for one in chosen if one.fix}
        files = {place[0] for places in edits.values() for place in places}
        others = self._others(files, report.files)
        if others:
            report = self._check(texts, others)
        if len(report.proposals) < 2:
            return set()
        found: set[Key] = set()
        for subject, proposed in zip(self._subjects(texts, others), report.proposals, strict=True):
            tags = _tags(subject, files) if subject is not None else {}
            asked = set(map(place_of, proposed))
            for key, places in edits.items():
                if any(one not in asked and _is_used(one, tags) for one in places):
                    found.add(key)
        return found

    def harm(
        self, before: Mapping[str, bytes], after: Mapping[str, bytes], known: Iterable[str]
    ) -> str:
        """What forbids the change from some texts to others; empty if nothing does.

        Args:
            before: texts in the place of those on disk.
            after: likewise.
            known: the descriptions that were checked already, with the rules asked for.
        """
        changed = [path for path, text in after.items() if before.get(path) != text]
        others = self._others(changed, known)
        if not others and not self._is_partial:
            return ""
        return harm(self._check(before, others), self._check(after, others))

    def _others(self, changed: Iterable[str], known: Iterable[str]) -> list[str]:
        """Robots that changed files are part of, and that were not asked for."""
        try:
            found = affected(changed, self._config, self._resolver)
        except UnreadableFile:  # a folder with too many files to look at
            return []
        asked = set(map(os.path.realpath, known))
        others = dict.fromkeys(os.path.relpath(robot.file) for robot in found.robots)
        return [file for file in others if os.path.realpath(file) not in asked]


def _tags(subject: Subject, files: set[str]) -> dict[str, list[tuple[int, int]]]:
    """First and last byte of the start tags that a robot uses of some files, in their order."""
    real = {source.path: os.path.realpath(source.path) for source in subject.document.sources}
    found: dict[str, set[tuple[int, int]]] = {}
    for element in subject.document.root.walk():
        path = real.get(element.tag_at.source.path, "")
        if path in files:
            found.setdefault(path, set()).add(element.span[1:])
    return {path: sorted(tags) for path, tags in found.items()}


def _is_used(place: Place, tags: Mapping[str, list[tuple[int, int]]]) -> bool:
    """True if an edit changes a start tag; one between tags concerns nobody."""
    path, start, end, _ = place
    here = tags.get(path, [])
    first = max(0, bisect_left(here, (start, 0)) - 1)
    return any(
        tag_start < end and start < tag_end
        for tag_start, tag_end in here[first : bisect_left(here, (end, 0))]
    )


def key_of(diagnostic: Diagnostic) -> Key:
    """What tells a finding from others in any round."""
    return (diagnostic.code, real_path(diagnostic.span.source), diagnostic.message)


def place_of(edit: Edit) -> Place:
    """What tells an edit from others, whatever its file is called."""
    return (real_path(edit.span.source), *edit.span[1:], edit.text)


def real_path(source: Source) -> str:
    """The path of the file of a source, whatever it is called."""
    return os.path.realpath(source.path)
