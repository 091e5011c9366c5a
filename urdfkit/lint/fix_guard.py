"""Reasons to drop a fix: it causes a regression in some robot, or has no effect."""

import os
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping
from itertools import chain, zip_longest

from urdfkit.core import disk
from urdfkit.errors import UnreadableFile
from urdfkit.lint.context import Context
from urdfkit.lint.fix_checker import Checker, EditKey, FindingKey, edit_key, finding_key, real_path
from urdfkit.lint.report import Crashed, Report, Skipped
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.document import Element

#: Rules for files that cannot be read.
_READING = ("XML001", "XML002")

#: The reason to drop a fix that makes a robot unreadable.
UNCHECKED = "dropped: with it, {} could not be checked any more"

#: Reads the robots of a report, in its order.
Robots = Callable[[], Iterable[Context | None]]


def regression(
    before: Report, after: Report, old: Robots, new: Robots, *, may_reveal: bool = True
) -> str:
    """Why the fixes between two checks of the same robots are dropped; empty if they are kept.

    Errors of rules that were skipped before, and of elements that did not exist before, were hidden
    and do not count as new. A file that is not well-formed hides the files that it includes, and
    that it is no robot.

    Args:
        before: the check without the fixes.
        after: the check with the fixes.
        old, new: the contexts of these checks, which are read only if an error is new.
        may_reveal: True if the robot was broken before, so that fixes may reveal hidden errors.
    """
    if lost := unchecked(before, after, may_reveal=may_reveal):
        return UNCHECKED.format(lost[0])
    if added := _added_error(before, after, old, new, may_reveal=may_reveal):
        return f"skipped: it would add {added}"
    if failed := _failed_rules(after.crashed) - _failed_rules(before.crashed):
        return f"dropped: with it, {min(failed)[1] or 'the check'} fails"
    return ""


def unchecked(before: Report, after: Report, *, may_reveal: bool) -> list[str]:
    """The robots that could be checked without the fixes only; arguments as for `regression`."""
    readable = _unreadable_files(chain(*before.errors)) - _unreadable_files(chain(*after.errors))
    lost = {path for path, _ in _failed_rules(after.skipped) - _failed_rules(before.skipped)}
    return sorted(path for path in lost if not may_reveal or disk.real(path) not in readable)


def _unreadable_files(errors: Iterable[Diagnostic]) -> frozenset[str]:
    """The real paths of the files that are not well-formed."""
    return frozenset(real_path(error.span.source) for error in errors if error.code in _READING)


def _visible_errors(now: tuple[Diagnostic, ...], then: tuple[Diagnostic, ...]) -> list[Diagnostic]:
    """The errors of a robot that were not hidden by a file that is now well-formed."""
    before = _unreadable_files(then)
    if before <= _unreadable_files(now):
        return list(now)
    return [e for e in now if e.code in _READING and real_path(e.span.source) in before]


def _failed_rules(failures: Iterable[Skipped | Crashed]) -> set[tuple[str, str]]:
    return {(failure.path, failure.code) for failure in failures}


def _added_error(
    before: Report, after: Report, old: Robots, new: Robots, *, may_reveal: bool
) -> str:
    """The code of a new error that was not hidden before; empty if there is none."""
    hidden = {skipped.code for skipped in before.skipped}
    pairs = list(zip_longest(after.errors, before.errors, fillvalue=()))
    visible_errors = [_visible_errors(now, then) if may_reveal else now for now, then in pairs]
    added = [
        {code: count for code, count in (_codes(now) - _codes(then)).items() if code not in hidden}
        for now, (_, then) in zip(visible_errors, pairs, strict=True)
    ]
    if not any(added):
        return ""
    if not may_reveal:
        return min(min(codes) for codes in added if codes)
    for codes, errors, then, now in zip_longest(added, after.errors, old(), new()):
        revealed = _revealed(then, now) if codes and then and now else frozenset[str]()
        visible: Counter[str] = Counter(codes) - _codes(
            error for error in errors or () if _is_at(error, revealed)
        )
        if visible:
            return min(visible)
    return ""


def _codes(diagnostics: Iterable[Diagnostic]) -> Counter[str]:
    return Counter(diagnostic.code for diagnostic in diagnostics)


def _is_at(diagnostic: Diagnostic, paths: Collection[str]) -> bool:
    """True if all elements of a finding have these paths, or are attributes of them."""
    places = [call.element for call in diagnostic.calls]
    return bool(places) and all(
        place in paths or place.rpartition("@")[0] in paths for place in places
    )


def _revealed(before: Context, after: Context) -> frozenset[str]:
    """The paths of the elements that a document contains only after a fix.

    A renamed element is not new.
    """
    if before.reading.document is None or after.reading.document is None:
        return frozenset()
    old = {element.path: element for element in before.document.root.walk()}
    new = {element.path: element for element in after.document.root.walk()}
    renamed = {_kind(element) for path, element in old.items() if path not in new}
    revealed: set[str] = set()
    for path, element in new.items():  # parents first
        is_below = element.parent is not None and element.parent.path in revealed
        if is_below or (path not in old and _kind(element) not in renamed):
            revealed.add(path)
    return frozenset(revealed)


def _kind(element: Element) -> tuple[str, str]:
    return (element.parent.path if element.parent else "", element.tag)


def ineffective(before: Report, after: Report, applied: list[Diagnostic]) -> str:
    """The reason to drop fixes that do not remove their findings; empty if they do.

    Such a fix would be applied again in each round. New elements may have the same finding.
    """
    expected = Counter(chain.from_iterable(map(_places, before.diagnostics)))
    fixed = [place for diagnostic in applied for place in _places(diagnostic)]
    expected.subtract(fixed)
    actual = Counter(chain.from_iterable(map(_places, after.diagnostics)))
    remains = any(actual[place] > expected[place] for place in fixed)
    return "skipped: it does not remove the finding" if remains else ""


def _places(diagnostic: Diagnostic) -> list[tuple[FindingKey, str]]:
    """The key of a finding with each of its elements."""
    elements = [call.element for call in diagnostic.calls] or [""]
    return [(finding_key(diagnostic), element) for element in elements]


class RegressionGuard:
    """Detects regressions in other robots of the workspace that include an edited file."""

    def __init__(self, checker: Checker) -> None:
        self._checker = checker
        self._other_robots: dict[frozenset[str], list[str]] = {}

    def conflicts(
        self, chosen: Iterable[Diagnostic], texts: Mapping[str, bytes], report: Report
    ) -> set[FindingKey]:
        """The findings whose fix edits text of another robot that does not propose the edit."""
        chosen = tuple(chosen)
        edits = {
            finding_key(finding): [edit_key(edit) for edit in finding.fix.edits]
            for finding in chosen
            if finding.fix
        }
        files = {place[0] for places in edits.values() for place in places}
        others = self._others(files, report.files)
        if not others and len(report.proposals) < 2:
            return set()
        robots, proposals = self._checker.robots(texts), report.proposals
        if others:
            robots = chain(robots, self._checker.robots(texts, others))
            codes = {finding.code for finding in chosen}
            proposals += self._checker.proposals(texts, others, codes)
        conflicts: set[FindingKey] = set()
        for context, proposal in zip(robots, proposals, strict=True):
            proposed = set(map(edit_key, proposal))
            missing = {key: set(places) - proposed for key, places in edits.items()}
            if context is None or not any(missing.values()):
                continue
            tags = _tags(context, files)
            conflicts |= {
                key
                for key, places in missing.items()
                if any(_is_used(place, tags) for place in places)
            }
        return conflicts

    def regression(
        self,
        before: Mapping[str, bytes],
        after: Mapping[str, bytes],
        known: Iterable[str],
        *,
        may_reveal: bool,
    ) -> str:
        """Why a change of texts is dropped; empty if it is kept.

        Args:
            before, after: texts that replace files on disk, by path.
            may_reveal: see ``regression``.
        """
        checker = self._checker
        others = self._others((p for p, text in after.items() if before.get(p) != text), known)
        if not others:
            return ""
        report = checker.guard_others(after, others)
        if not (any(report.errors) or report.skipped or report.crashed):
            return ""
        return regression(
            checker.guard_others(before, others),
            report,
            lambda: checker.robots(before, others),
            lambda: checker.robots(after, others),
            may_reveal=may_reveal,
        )

    def _others(self, changed: Iterable[str], known: Iterable[str]) -> list[str]:
        """Robots that use changed files and are not among the known ones."""
        files = frozenset(changed)
        if files not in self._other_robots:
            from urdfkit.lint.discovery import affected  # not needed to count fixes

            try:
                robots = affected(files, self._checker.config, self._checker.resolver).robots
            except UnreadableFile:  # a directory with too many files
                robots = ()
            real = set(map(disk.real, known))
            paths = dict.fromkeys(os.path.relpath(robot.file) for robot in robots)
            self._other_robots[files] = [path for path in paths if disk.real(path) not in real]
        return self._other_robots[files]


def _tags(context: Context, files: set[str]) -> dict[str, list[tuple[int, int]]]:
    """First and last byte of the start tags in some files that a robot uses, sorted, by path."""
    if context.reading.document is None:
        return {}
    real = {source.path: disk.real(source.path) for source in context.document.sources}
    tags: dict[str, set[tuple[int, int]]] = {}
    for element in context.document.root.walk():
        path = real.get(element.tag_at.source.path, "")
        if path in files:
            tags.setdefault(path, set()).add(element.span[1:])
    return {path: sorted(spans) for path, spans in tags.items()}


def _is_used(place: EditKey, tags: Mapping[str, list[tuple[int, int]]]) -> bool:
    """True if an edit changes a start tag; edits between tags do not affect other robots."""
    path, start, end, _ = place
    spans = tags.get(path, [])
    first = max(0, bisect_left(spans, (start, 0)) - 1)
    return any(
        tag_start < end and start < tag_end
        for tag_start, tag_end in spans[first : bisect_left(spans, (end, 0))]
    )
