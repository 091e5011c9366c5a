"""Why a fix is dropped: it causes a regression in some robot, or has no effect."""

import os
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import cached_property
from itertools import chain, zip_longest

from urdfkit.core import disk
from urdfkit.errors import UnreadableFile
from urdfkit.lint import rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check_with, contexts
from urdfkit.lint.options import Options
from urdfkit.lint.processes import Workers
from urdfkit.lint.report import Crashed, Report, Skipped
from urdfkit.lint.rules import Need
from urdfkit.text.diagnostic import Diagnostic, Edit
from urdfkit.text.document import Element
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

#: A finding in any round: its code, its file and its message, since places move.
FindingKey = tuple[str, str, str]

#: An edit, known in every robot that includes its file: real path, first and last byte, new text.
Place = tuple[str, int, int, str]

#: Reads the robots of a report, in its order.
Robots = Callable[[], Iterable[Context | None]]

#: What takes long to compute. The rules that need it have no fix.
SLOW = frozenset((Need.DYNAMICS, Need.COLLISIONS))


def regression(
    before: Report, after: Report, old: Robots, new: Robots, *, may_reveal: bool = True
) -> str:
    """Why the fixes between two checks of the same robots are dropped; empty if they are kept.

    Only what both versions can see is compared. Errors of rules that could not look before were
    there, but hidden, and so were those of elements that the document did not have before.

    Args:
        before: the check without the fixes.
        old: the contexts of the first, which are read only where an error is new.
        may_reveal: the robot was broken anyway, so that hidden errors may come to light.
    """
    if lost := _rules(after.skipped) - _rules(before.skipped):
        return f"dropped: with it, {min(lost)[0]} could not be checked any more"
    if added := _added_error(before, after, old, new, may_reveal=may_reveal):
        return f"skipped: it would add {added}"
    if failed := _rules(after.crashed) - _rules(before.crashed):
        return f"dropped: with it, {min(failed)[1] or 'the check'} fails"
    return ""


def _rules(without_result: Iterable[Skipped | Crashed]) -> set[tuple[str, str]]:
    return {(one.path, one.code) for one in without_result}


def _added_error(
    before: Report, after: Report, old: Robots, new: Robots, *, may_reveal: bool
) -> str:
    """The code of an error that is new, and could have been seen before; empty if there is none."""
    hidden = {skipped.code for skipped in before.skipped}
    added = [
        {code: count for code, count in (_codes(now) - _codes(then)).items() if code not in hidden}
        for now, then in zip_longest(after.errors, before.errors, fillvalue=())
    ]
    if not any(added):
        return ""
    if not may_reveal:
        return min(min(codes) for codes in added if codes)
    for codes, errors, then, now in zip_longest(added, after.errors, old(), new()):
        revealed = _revealed(then, now) if codes and then and now else frozenset[str]()
        visible: Counter[str] = Counter(codes) - _codes(
            one for one in errors or () if _is_at(one, revealed)
        )
        if visible:
            return min(visible)
    return ""


def _codes(diagnostics: Iterable[Diagnostic]) -> Counter[str]:
    return Counter(one.code for one in diagnostics)


def _is_at(diagnostic: Diagnostic, paths: Collection[str]) -> bool:
    """True if a finding is about elements with these paths only, or about their attributes."""
    places = [call.element for call in diagnostic.calls]
    return bool(places) and all(
        place in paths or place.rpartition("@")[0] in paths for place in places
    )


def _revealed(before: Context, after: Context) -> frozenset[str]:
    """The paths of the elements that a document has only after a fix.

    An element with a new name in the place of one with the old is the same one.
    """
    if before.reading.document is None or after.reading.document is None:
        return frozenset()
    old = {element.path: element for element in before.document.root.walk()}
    new = {element.path: element for element in after.document.root.walk()}
    renamed = {_kind(element) for path, element in old.items() if path not in new}
    found: set[str] = set()
    for path, element in new.items():  # parents first
        is_below = element.parent is not None and element.parent.path in found
        if is_below or (path not in old and _kind(element) not in renamed):
            found.add(path)
    return frozenset(found)


def _kind(element: Element) -> tuple[str, str]:
    return (element.parent.path if element.parent else "", element.tag)


def ineffective(before: Report, after: Report, applied: list[Diagnostic]) -> str:
    """Says so if a fix left its finding as it was; it would be applied for ever.

    Elements that a fix of the same round has brought to light may have the same finding.
    """
    expected = Counter(chain.from_iterable(map(_places, before.diagnostics)))
    fixed = [place for one in applied for place in _places(one)]
    expected.subtract(fixed)
    now = Counter(chain.from_iterable(map(_places, after.diagnostics)))
    stays = any(now[place] > expected[place] for place in fixed)
    return "skipped: it does not remove the finding" if stays else ""


def _places(diagnostic: Diagnostic) -> list[tuple[FindingKey, str]]:
    """A finding at each of its elements."""
    elements = [call.element for call in diagnostic.calls] or [""]
    return [(key_of(diagnostic), element) for element in elements]


class Checker:
    """Checks robots with some texts in the place of those on disk.

    Args:
        options: of ``check``.
        codes: of all rules that fixes are to answer or must not offend.
    """

    def __init__(
        self, files: Iterable[str | os.PathLike[str]], options: Options, codes: Iterable[str]
    ) -> None:
        self._files = tuple(files)
        self._options = options
        self._codes = frozenset(codes)
        self.config = options.config
        self.resolver = Resolver(options.with_config().packages, texts=options.texts)
        self.workers = Workers()

    def report(self, texts: Mapping[str, bytes]) -> Report:
        """What is reported to people: the rules that they asked for."""
        return check_with(self._with_texts(texts), self._files, self.resolver, workers=self.workers)

    def guard(self, texts: Mapping[str, bytes]) -> Report:
        """What fixes start from and are judged by, without the rules that cannot matter."""
        return self._check(self._files, texts, self._codes, only_errors=SLOW)

    def guard_others(self, texts: Mapping[str, bytes], files: Iterable[str]) -> Report:
        """Whether robots that were not asked for have errors."""
        return self._check(files, texts, self._errors)

    def proposals(
        self, texts: Mapping[str, bytes], files: Iterable[str], codes: Iterable[str]
    ) -> tuple[tuple[Edit, ...], ...]:
        """The edits that some rules propose for each of some robots."""
        return self._check(files, texts, codes).proposals

    def robots(
        self, texts: Mapping[str, bytes], files: Iterable[str] | None = None
    ) -> Iterator[Context | None]:
        """The robots of a check, in its order."""
        return contexts(self._with_texts(texts), self._files if files is None else files)

    def _check(
        self,
        files: Iterable[str | os.PathLike[str]],
        texts: Mapping[str, bytes],
        codes: Iterable[str],
        *,
        only_errors: frozenset[Need] = frozenset(),
    ) -> Report:
        # The others are not among the codes; of these the errors are.
        former = tuple(filter(rule_index.redirect, self._options.ignore))
        now = self._with_texts(texts)._replace(select=tuple(codes), ignore=former)
        now = now._replace(only_errors=only_errors)
        return check_with(now, files, self.resolver, workers=self.workers)

    def _with_texts(self, texts: Mapping[str, bytes]) -> Options:
        return self._options._replace(texts={**self._options.texts, **texts})

    @cached_property
    def _errors(self) -> list[str]:
        """The rules that may report errors."""
        severities = self.config.severities
        found = map(rule_index.get, self._codes)
        return [rule.code for rule in found if rule.may_report_errors(severities.get(rule.code))]


class RegressionGuard:
    """Looks at what fixes may break in other robots of the workspace that include a file."""

    def __init__(self, checker: Checker) -> None:
        self._checker = checker
        self._found: dict[frozenset[str], list[str]] = {}

    def conflicts(
        self, chosen: Iterable[Diagnostic], texts: Mapping[str, bytes], report: Report
    ) -> set[FindingKey]:
        """The findings whose fix edits what another robot uses without asking for the edit."""
        chosen = tuple(chosen)
        edits = {key_of(one): [place_of(e) for e in one.fix.edits] for one in chosen if one.fix}
        files = {place[0] for places in edits.values() for place in places}
        others = self._others(files, report.files)
        if not others and len(report.proposals) < 2:
            return set()
        robots, proposals = self._checker.robots(texts), report.proposals
        if others:
            robots = chain(robots, self._checker.robots(texts, others))
            codes = {one.code for one in chosen}
            proposals += self._checker.proposals(texts, others, codes)
        found: set[FindingKey] = set()
        for context, proposed in zip(robots, proposals, strict=True):
            asked = set(map(place_of, proposed))
            missing = {key: set(places) - asked for key, places in edits.items()}
            if context is None or not any(missing.values()):
                continue
            tags = _tags(context, files)
            found |= {
                key for key, places in missing.items() if any(_is_used(one, tags) for one in places)
            }
        return found

    def regression(
        self,
        before: Mapping[str, bytes],
        after: Mapping[str, bytes],
        known: Iterable[str],
        *,
        may_reveal: bool,
    ) -> str:
        """Why the change from some texts to others is dropped; empty if it is kept.

        Args:
            before: texts in the place of those on disk.
            may_reveal: as of ``regression``.
        """
        checker = self._checker
        others = self._others((p for p, text in after.items() if before.get(p) != text), known)
        if not others:
            return ""
        now = checker.guard_others(after, others)
        if not (any(now.errors) or now.skipped or now.crashed):
            return ""
        return regression(
            checker.guard_others(before, others),
            now,
            lambda: checker.robots(before, others),
            lambda: checker.robots(after, others),
            may_reveal=may_reveal,
        )

    def _others(self, changed: Iterable[str], known: Iterable[str]) -> list[str]:
        """Robots that changed files are part of, and that were not asked for."""
        files = frozenset(changed)
        if files not in self._found:
            from urdfkit.lint.discovery import affected  # not needed to count fixes

            try:
                found = affected(files, self._checker.config, self._checker.resolver).robots
            except UnreadableFile:  # a directory with too many files to look at
                found = ()
            asked = set(map(disk.real, known))
            others = dict.fromkeys(os.path.relpath(robot.file) for robot in found)
            self._found[files] = [f for f in others if disk.real(f) not in asked]
        return self._found[files]


def _tags(context: Context, files: set[str]) -> dict[str, list[tuple[int, int]]]:
    """First and last byte of the start tags that a robot uses of some files, in their order."""
    if context.reading.document is None:
        return {}
    real = {source.path: disk.real(source.path) for source in context.document.sources}
    found: dict[str, set[tuple[int, int]]] = {}
    for element in context.document.root.walk():
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


def key_of(diagnostic: Diagnostic) -> FindingKey:
    """Identifies a finding in any round."""
    return (diagnostic.code, real_path(diagnostic.span.source), diagnostic.message)


def place_of(edit: Edit) -> Place:
    """Identifies an edit, whatever its file is called."""
    return (real_path(edit.span.source), *edit.span[1:], edit.text)


def real_path(source: Source) -> str:
    """The path of the file of a source, whatever it is called."""
    return disk.real(source.path)
