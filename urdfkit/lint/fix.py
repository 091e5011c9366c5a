"""fix(): applies the fixes of findings to the text, round by round, until none is left.

A round applies the fixes of a check to the texts in memory and checks again. Files are written
at the end, or not at all.
"""

from __future__ import annotations

import os
from bisect import bisect_left, insort
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.lint.engine import subjects
from urdfkit.lint.fix_guard import (
    Checker,
    Key,
    RegressionGuard,
    Robots,
    key_of,
    real_path,
    regression,
    useless,
)
from urdfkit.lint.options import Options, choose, foreign_codes
from urdfkit.lint.report import Fixable, Report
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.editing import rewriting
from urdfkit.text.editing.apply import apply_edits, encoded
from urdfkit.text.editing.rewriting import Rewrite, on_disk
from urdfkit.text.source import Source, shown
from urdfkit.workspace.ownership import OUTSIDE, Ownership

if TYPE_CHECKING:
    from urdfkit.robot.assets.placeholder_meshes import GeneratedMesh, NotGenerated

MAX_ROUNDS = 10

#: Robots, or variants of one, share the text and not the finding.
_DISPUTED = "skipped: another robot uses this text and is correct as it is"

#: First and last byte of an edit, and its text.
_Piece = tuple[int, int, str]


class UnappliedFix(Record):
    """A finding that is not fixed, and why.

    Attributes:
        diagnostic: as the last check found it.
        reason: why its fix was not applied, ``unsafe``, ``info`` or a sentence; empty if it has
            none.
    """

    diagnostic: Diagnostic
    reason: str


class Fixes(Record):
    """The outcome of fixing some descriptions; nothing is written before ``write``.

    Attributes:
        files: that change, sorted by path.
        applied: the findings that were fixed, as the check of their round found them.
        left: what the last check still found.
        report: of the last check.
        meshes: that were made for missing and broken files.
        not_generated: missing and broken files for which none could be generated.
    """

    files: tuple[Rewrite, ...]
    applied: tuple[Diagnostic, ...]
    left: tuple[UnappliedFix, ...]
    report: Report
    meshes: tuple[GeneratedMesh, ...] = ()
    not_generated: tuple[NotGenerated, ...] = ()

    def diff(self) -> str:
        """All changes as a unified diff."""
        return "".join(file.diff() for file in self.files)

    def write(self) -> None:
        """Replace the files, each whole or not at all, and write the meshes.

        Raises:
            UnwritableFile: a file may not be written, or has changed since it was read.
        """
        rewriting.write(self.files)
        for mesh in self.meshes:
            mesh.write()


def fix(
    *files: str | os.PathLike[str],
    unsafe: bool = False,
    force: bool = False,
    generate_meshes: bool = False,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    targets: Iterable[str] = (),
    trust: bool = False,
    config: Config | None = None,
    options: Options = Options(),
) -> Fixes:
    """Apply the fixes of findings in descriptions of robots and in the files that they include.

    >>> fixes = fix("models/gazebo_pkg/urdf/waking_robot_new.xacro", select=["JNT020"])
    >>> [(one.code, one.span.line) for one in fixes.applied]
    [('JNT020', 203), ('JNT020', 234), ('JNT020', 265)]

    The fix of an info is applied only where ``select`` has its code or name, not just the beginning
    of it. Fixes that overlap are applied one after the other. A fix that adds an error, makes a
    description unreadable, edits what another robot uses and is right about, or leaves its finding
    as it was, is dropped.

    Args:
        files: URDF, xacro or launch files, or directories, as of ``check``.
        unsafe: apply the fixes that may change what the robot does, too.
        force: edit files as well that are generated, read-only or ignored by git, or that lie
            outside the workspace of ``files``.
        generate_meshes: make a mesh for every file of one that is missing, empty or broken. What
            the rules say of the robot with these meshes, a second run reports and fixes.
        arguments: xacro arguments by name.
        packages: directories of ROS packages by name.
        select: rules whose findings are fixed; all if empty.
        ignore: rules whose findings are not.
        targets: names of the programs to check for.
        trust: do not sandbox the expressions of the model.
        config: settings of the project.
        options: the other ones of ``check``.

    Raises:
        UrdfkitError: as of ``check``.
    """
    given = options.given(
        arguments=arguments,
        packages=packages,
        select=tuple(select),
        ignore=tuple(ignore),
        targets=tuple(targets),
        trust=trust,
        config=config,
    )
    fixes = _session(files, given, unsafe=unsafe, force=force).run()
    if not generate_meshes:
        return fixes
    texts = {**given.texts, **{file.path: file.after for file in fixes.files}}
    return _with_meshes(fixes, files, given._replace(texts=texts), force=force)


def _session(
    files: Iterable[str | os.PathLike[str]], options: Options, *, unsafe: bool, force: bool
) -> _Session:
    resolved = options.resolved()
    codes = {*resolved.select, *choose((), (), options.config, foreign_codes(options))}
    checker = Checker(files, options._replace(preview=resolved.preview), codes)
    named = rule_index.named(options.select)
    return _Session(checker, resolved.select, named, unsafe=unsafe, force=force)


def _with_meshes(
    fixes: Fixes, files: Iterable[str | os.PathLike[str]], options: Options, *, force: bool
) -> Fixes:
    """The fixes, with meshes for what is missing or broken.

    Raises:
        UrdfkitError: what makes meshes is not installed.
    """
    try:
        from urdfkit.robot.assets.placeholder_meshes import (
            GeneratedMesh,
            NotGenerated,
            generate_missing,
        )
    except ImportError as error:
        text = f"generating meshes needs {error.name}: pip install 'urdfkit[meshes]'"
        raise UrdfkitError(text) from error
    found: dict[str, GeneratedMesh | NotGenerated] = {}
    for robot in filter(None, subjects(options, files)):
        if robot.reading.document is None:
            continue
        ours = Ownership([robot.source.path], robot.resolver)
        stand_ins = generate_missing(robot)
        for undone in stand_ins.undone:
            found[disk.real(undone.path)] = undone
        for made in stand_ins.made:
            foreign = not (force or ours.owns(made.path))
            refusal = NotGenerated(made.path, made.references, made.defect, OUTSIDE)
            found[disk.real(made.path)] = refusal if foreign else made
    meshes = tuple(one for one in found.values() if isinstance(one, GeneratedMesh))
    replaced = {reference.at.span for one in meshes for reference in one.references}
    places = {(real_path(span.source), *span[1:]) for span in replaced}
    left = tuple(
        one
        for one in fixes.left
        if not rule_index.get(one.diagnostic.code).about_files
        or (real_path(one.diagnostic.span.source), *one.diagnostic.span[1:]) not in places
    )
    not_generated = tuple(one for one in found.values() if isinstance(one, NotGenerated))
    return fixes._replace(left=left, meshes=meshes, not_generated=not_generated)


def fixable(report: Report, options: Options, files: Iterable[str | os.PathLike[str]]) -> Fixable:
    """What ``fix`` would do about the findings of a check with the same options.

    Safe fixes are tried, as ``fix`` does; how many of the others hold is known only then.

    Raises:
        UrdfkitError: as of ``check``.
    """
    if not any(one.fix for one in report.diagnostics):
        return Fixable(0, 0, (), ())
    session = _session(files, options, unsafe=False, force=False)
    left = session.reasons(report)
    if any(one.diagnostic.fix and not one.reason for one in left):
        fixes = session.run()
        return counted(fixes.left)._replace(safe=len(fixes.applied))
    return counted(left)


def counted(left: Iterable[UnappliedFix]) -> Fixable:
    """What could be done about findings that are left."""
    with_fix = [one for one in left if one.diagnostic.fix]
    reasons = Counter(one.reason for one in with_fix)
    return Fixable(
        reasons.pop("", 0),
        reasons.pop("unsafe", 0),
        tuple(sorted({one.diagnostic.code for one in with_fix if one.reason == "info"})),
        tuple(sorted(item for item in reasons.items() if item[0] != "info")),
    )


class _Session:
    """The texts as they are after some rounds.

    Args:
        checker: checks the robots.
        asked: codes of the rules whose findings are to be fixed.
        named: those that somebody selected one by one.
        unsafe, force: as of ``fix``.
    """

    def __init__(
        self,
        checker: Checker,
        asked: Iterable[str],
        named: Iterable[str],
        *,
        unsafe: bool,
        force: bool,
    ) -> None:
        self._checker = checker
        self._guard = RegressionGuard(checker)
        self._asked = frozenset(asked)
        self._named = frozenset(named)
        self._unsafe = unsafe
        self._force = force
        self._ownership = Ownership((), checker.resolver)
        self._refusals: dict[Source, str] = {}
        self._originals: dict[str, Rewrite] = {}
        self._texts: dict[str, bytes] = {}
        self._dropped: dict[Key, str] = {}
        self._applied: list[Diagnostic] = []

    def reasons(self, report: Report) -> tuple[UnappliedFix, ...]:
        """The findings of a report, and why their fixes are not applied."""
        self._ownership = Ownership(report.files, self._checker.resolver)
        return tuple(UnappliedFix(one, self._reason(one)) for one in report.diagnostics)

    def run(self) -> Fixes:
        """Apply what can be applied.

        Other robots that include the files are checked once, at the end; only if that shows a
        regression, they are checked with every step, to find the fix that causes it.
        """
        files = self._fix(is_careful=False)
        if self._guard.regression({}, self._texts, files):
            self._texts, self._dropped, self._applied = {}, {}, []
            self._fix(is_careful=True)
        report = self._checker.report(self._texts)
        changed = [
            original._replace(after=self._texts[real])
            for real, original in self._originals.items()
            if self._texts.get(real, original.before) != original.before
        ]
        left = tuple(UnappliedFix(one, self._reason(one)) for one in report.diagnostics)
        return Fixes(tuple(sorted(changed)), tuple(self._applied), left, report)

    def _fix(self, *, is_careful: bool) -> tuple[str, ...]:
        """Round after round, as long as there is something to fix; the files of the robots."""
        report = self._checker.guard({})
        self._ownership = Ownership(report.files, self._checker.resolver)
        for _ in range(MAX_ROUNDS):
            chosen = self._chosen(report)
            if not chosen:
                break
            report = self._round(report, chosen, is_careful=is_careful)
        return report.files

    def _chosen(self, report: Report) -> list[Diagnostic]:
        """The findings to fix in one round: of fixes that overlap, the first."""
        ready = [
            one
            for one in report.diagnostics
            if one.fix and one.code in self._asked and not self._reason(one)
        ]
        # A tensor comes from the shapes of its link, which other fixes turn, move and scale.
        settled = [one for one in ready if not rule_index.get(one.code).computes_fix]
        chosen: list[Diagnostic] = []
        taken: dict[str, list[_Piece]] = {}
        for diagnostic in settled or ready:
            edits = [(real_path(e.span.source), _piece(e)) for e in _edits(diagnostic)]
            if all(_fits(piece, taken.get(path, [])) for path, piece in edits):
                chosen.append(diagnostic)
                for path, piece in edits:
                    insort(taken.setdefault(path, []), piece)
        return chosen

    def _reason(self, diagnostic: Diagnostic) -> str:
        """Why the fix of a finding is not applied; empty if it may be, or there is none."""
        if diagnostic.fix is None:
            return ""
        refusals = (self._refusal(edit.span.source) for edit in diagnostic.fix.edits)
        if refusal := next(filter(None, refusals), ""):
            return refusal
        if diagnostic.severity is Severity.INFO and diagnostic.code not in self._named:
            return "info"
        if not (diagnostic.fix.safe or self._unsafe):
            return "unsafe"
        return self._dropped.get(key_of(diagnostic), "")

    def _refusal(self, source: Source) -> str:
        """Why a file is not edited; empty if it may be."""
        if source not in self._refusals:
            self._refusals[source] = self._judge(source)
        return self._refusals[source]

    def _judge(self, source: Source) -> str:
        real = real_path(source)
        if real not in self._originals:
            before = self._checker.resolver.text(source.path)
            before = on_disk(source.path) if before is None else before
            if before is None:
                return "file not found"
            self._originals[real] = Rewrite(shown(source.path), before, before)
        if source.undecodable is not None:
            return "the file is not valid text"
        original = self._originals[real].before
        now = self._texts.get(real, original)
        if _encoded(source.data, source, original) != now:
            return f"its encoding, {source.encoding}, cannot be kept"
        return "" if self._force else self._ownership.refusal(source)

    def _round(self, report: Report, chosen: list[Diagnostic], *, is_careful: bool) -> Report:
        """Apply all fixes without a regression; the report on the texts after them."""
        disputed = self._guard.disputes(chosen, self._texts, report)
        self._dropped.update(dict.fromkeys(disputed, _DISPUTED))
        chosen = [one for one in chosen if key_of(one) not in disputed]
        kept: list[Diagnostic] = []
        texts, latest = self._texts, report
        batches = [chosen] if chosen else []
        while batches:
            batch = batches.pop()
            trial = {**self._texts, **self._edited([*kept, *batch])}
            after = self._checker.guard(trial)
            reason = regression(report, after, *map(self._robots, (self._texts, trial))) or useless(
                report, after, [*kept, *batch]
            )
            if is_careful:
                reason = reason or self._guard.regression(self._texts, trial, report.files)
            if not reason:
                kept += batch
                texts, latest = trial, after
            elif len(batch) > 1:  # which one does it?
                middle = len(batch) // 2
                batches += [batch[middle:], batch[:middle]]
            else:
                self._dropped[key_of(batch[0])] = reason
        self._texts = texts
        self._applied += kept
        return latest

    def _robots(self, texts: Mapping[str, bytes]) -> Robots:
        return lambda: self._checker.robots(texts)

    def _edited(self, diagnostics: Iterable[Diagnostic]) -> dict[str, bytes]:
        """The bytes of the files that some fixes edit, after them."""
        edits: dict[str, dict[_Piece, Edit]] = {}
        for diagnostic in diagnostics:
            for edit in _edits(diagnostic):
                # Two robots may have the same finding in a file that both include.
                edits.setdefault(real_path(edit.span.source), {})[_piece(edit)] = edit
        texts = {}
        for real, parts in edits.items():
            source = next(iter(parts.values())).span.source
            data = apply_edits(source.data, parts.values())
            texts[real] = _encoded(data, source, self._originals[real].before) or source.data
        return texts


def _fits(piece: _Piece, others: list[_Piece]) -> bool:
    """True if an edit can be made together with others, which are sorted; the same one is one."""
    start, end, _ = piece
    after = bisect_left(others, (start, -1, ""))
    for other in others[max(0, after - 1) : after + 2]:
        overlaps = start == other[0] or (start < other[1] and other[0] < end)
        if overlaps and piece != other:
            return False
    return True


def _piece(edit: Edit) -> _Piece:
    return (edit.span.start, edit.span.end, edit.text)


def _edits(diagnostic: Diagnostic) -> tuple[Edit, ...]:
    assert diagnostic.fix is not None
    return diagnostic.fix.edits


def _encoded(text: bytes, source: Source, original: bytes) -> bytes | None:
    """A text in the encoding of its file; None if that lacks a character, or is no encoding."""
    try:
        return encoded(text, source.encoding, original)
    except (UnicodeError, LookupError):
        return None
