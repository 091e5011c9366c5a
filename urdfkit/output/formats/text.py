"""For people: every finding with its line of source, at 80 columns or in the log of a CI run."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from itertools import groupby

from urdfkit.core.words import counted, few
from urdfkit.lint.grouping import grouped
from urdfkit.lint.report import Crashed, Report
from urdfkit.lint.rule_index import NOT_CHECKED, external
from urdfkit.text.diagnostic import Call, Confidence, Diagnostic, Related, Severity
from urdfkit.text.document import Step
from urdfkit.text.source import Span, shown
from urdfkit.text.terminal import columns, frame, printable, wrap

#: Calls of one macro, and steps of one way, that are shown.
MAX_CALLS = 8
#: Letters of arguments; they may be paths.
MAX_VALUES = 160
#: Rules that failed with one error that are named.
MAX_CODES = 4
#: Skipped files that are named.
MAX_FILES = 3

_COLORS = {Severity.ERROR: "1;31", Severity.WARNING: "1;33", Severity.INFO: "1;36"}
_STEPS = {
    "macro": "expanded from macro '{}' at",
    "include": "included at",
    "launch": "launched from",
}
_GUTTER = 8  # columns before a line of source


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """All findings, then the crashed rules, then where to read more, then the summary."""
    return "".join(stream(report, color=color, width=width))


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """The same in parts."""
    page = _TextReport(color, width)
    between = ""
    for block in _blocks(report, page):
        yield between + block
        between = "\n"
    yield summary(report, color=color, width=width)


def _blocks(report: Report, page: _TextReport) -> Iterator[str]:
    # What is shown as one is in one file, and the findings are in the order of files.
    for _, of_file in groupby(report.diagnostics, key=lambda one: page.path(one.span.source.path)):
        yield from map(page.diagnostic, grouped(tuple(of_file)))
    yield from (page.crash(crash, codes) for crash, codes in _crashed(report))
    hints = [f"Explain a code: urdfkit explain {found.code}" for found in report.diagnostics[:1]]
    hints += (page.wrap(hint, indent=2) for hint in _fixable(report))
    for name, suggested in report.unknown_arguments:
        hint = f"; did you mean '{suggested}'?" if suggested else ""
        hints.append(printable(f"No robot here has an argument '{name}'{hint}"))
    evidence = dict.fromkeys(why for _, targets in report.targets for why in targets.evidence)
    if evidence:
        targets = ", ".join("{} ({})".format(*why.split(": ", 1)) for why in evidence)
        hints.append(page.wrap(f"Targets: {targets}; override with --target", indent=2))
    if hints:
        yield "".join(f"{hint}\n" for hint in hints)


def _fixable(report: Report) -> Iterator[str]:
    """How many findings would be fixed, what lets more be fixed, and why some are left."""
    fixable = report.fixable
    if fixable is None:
        return
    safe, unsafe, infos, left = fixable
    if safe:
        more = f" ({unsafe} more have an unsafe fix, see --unsafe-fixes)" if unsafe else ""
        yield f"{safe} fixable with --fix{more}"
    elif unsafe:
        yield f"{unsafe} with an unsafe fix: --fix --unsafe-fixes applies those that add no error"
    if infos:
        yield f"Fixes of infos need --select {','.join(infos)}"
    for reason, count in left:
        yield f"Not fixable: {count} ({printable(reason)})"


def summary(report: Report, *, color: bool = False, width: int = 80) -> str:
    """The last line: how much was found, and which rules did not get to look."""
    page = _TextReport(color, width)
    counts = {severity: report.count(severity) for severity in Severity}
    found = [counted(count, severity.value) for severity, count in counts.items() if count]
    text = f"{', '.join(found) or 'no findings'} in {counted(len(report.files), 'file')}"
    reasons = [*_launched(report)]
    if unchecked := sum(found.code == NOT_CHECKED for found in report.diagnostics):
        reasons.append(f"{counted(unchecked, 'robot')} not checked")
    reasons += [f"{what} skipped: {why}" for why, what in _skipped(report)]
    if crashed := {crash.code for crash in report.crashed if crash.code}:
        reasons.append(f"{counted(len(crashed), 'rule')} crashed")
    if report.suppressed:
        reasons.append(f"{counted(report.suppressed, 'finding')} suppressed")
    if report.tolerated:
        reasons.append(f"{counted(report.tolerated, 'finding')} in the baseline")
    if reasons:
        text += f" ({'; '.join(reasons)})"
    text = page.wrap(text, indent=2)
    for severity, count in counts.items():
        if count:
            words = counted(count, severity.value)
            text = text.replace(words, page.paint(words, _COLORS[severity]), 1)
    return text + "\n"


def _crashed(report: Report) -> Iterator[tuple[Crashed, list[str]]]:
    """The first crash of each error and file, with the codes of all rules that failed with it."""
    alike: dict[tuple[str, str], list[Crashed]] = {}
    for crash in report.crashed:
        alike.setdefault((crash.path, crash.error), []).append(crash)
    for crashes in alike.values():
        yield crashes[0], [crash.code for crash in crashes]


def _launched(report: Report) -> Iterator[str]:
    """Which robots were checked with the arguments of which launch files."""
    values: dict[tuple[str, str], dict[str, str]] = {}
    for one in report.launched:
        for name, value in one.arguments.items():
            values.setdefault((one.path, name), {}).setdefault(value, one.launch)
    for (path, name), launches in values.items():
        files = {os.path.basename(launch) for launch in launches.values()}
        where = min(files) if len(files) == 1 else counted(len(files), "launch file")
        what = f"{name} {', '.join(launches)}"
        if len(what) > MAX_VALUES:
            what = f"{len(launches)} values of {name}"
        yield printable(f"{shown(path)} with {what} of {where}")


def _skipped(report: Report) -> list[tuple[str, str]]:
    """Reasons, and which files or how many rules were skipped for them."""
    codes: dict[str, set[str]] = {}
    files: dict[str, set[str]] = {}
    reported = {one.span.source.path for one in report.diagnostics if one.code == NOT_CHECKED}
    for skip in report.skipped:
        if skip.path in reported:
            continue
        if skip.code:
            codes.setdefault(skip.reason, set()).add(skip.code)
        else:
            files.setdefault(skip.reason, set()).add(skip.path)
    found = [(reason, counted(len(codes[reason]), "rule")) for reason in sorted(codes)]
    for reason in sorted(files):
        paths = sorted({shown(path) for path in files[reason]})
        named = ", ".join(paths) if len(paths) <= MAX_FILES else counted(len(paths), "file")
        found.append((reason, printable(named)))
    return found


class _TextReport:
    """Lays out findings for one width, with colours or without."""

    def __init__(self, color: bool, width: int) -> None:
        self.color = color
        self.width = max(width, 40)
        self._paths: dict[str, str] = {}

    def diagnostic(self, diagnostic: Diagnostic) -> str:
        blocks = [
            self._head(diagnostic),
            *self._frame(diagnostic.span, diagnostic.severity),
            *self._ways(diagnostic),
            *(self._note(related, diagnostic) for related in diagnostic.related),
        ]
        if diagnostic.variants:
            blocks.append(self._labelled("variants", ", ".join(diagnostic.variants)))
        title = diagnostic.fix.title if diagnostic.fix else ""
        if diagnostic.help and diagnostic.help != title:
            blocks.append(self._labelled("help", diagnostic.help))
        if title:
            blocks.append(self._labelled("fix", title))
        return "".join(f"{line.rstrip()}\n" for block in blocks for line in block.split("\n"))

    def crash(self, crash: Crashed, codes: Sequence[str]) -> str:
        whose = "that rule" if crash.code in external() else "urdfkit"
        what = few(codes, MAX_CODES) or "the check"
        text = (
            f"{self.path(crash.path)}: {what} failed with {crash.error}. This is a bug in "
            f"{whose}, not in the robot: please report it with the file."
        )
        return self.wrap(text, indent=4) + "\n"

    def _head(self, diagnostic: Diagnostic) -> str:
        place, severity = self.place(diagnostic.span), diagnostic.severity
        remarks = [f"for {name}" for name in diagnostic.targets]
        if diagnostic.confidence is not Confidence.MEASURED:
            remarks.append(diagnostic.confidence.value)
        message = diagnostic.message + (f" ({', '.join(remarks)})" if remarks else "")
        used = columns(f"{place}: {severity.value} {diagnostic.code} ")
        kind = f"{self.paint(severity.value, _COLORS[severity])} {self.paint(diagnostic.code, '1')}"
        return f"{self.paint(place, '1')}: {kind} {self.wrap(message, indent=4, used=used)}"

    def _note(self, related: Related, diagnostic: Diagnostic) -> str:
        return self._labelled("note", f"{self._near(related.span, diagnostic)}: {related.message}")

    def _frame(self, span: Span, severity: Severity) -> Iterator[str]:
        line, carets = frame(span, self.width - _GUTTER)
        if line:
            yield f"{span.line:>5} | {line}"
            yield f"      | {self.paint(carets, _COLORS[severity])}"

    def _labelled(self, label: str, text: str) -> str:
        used = 2 + len(f"{label}: ")
        return f"  {self.paint(f'{label}:', '1')} {self.wrap(text, indent=used, used=used)}"

    def _ways(self, diagnostic: Diagnostic) -> Iterator[str]:
        """How expansion arrived at the place, from there outwards.

        Steps that all calls share are printed once: the inner ones before the calls, the outer
        ones after them.
        """
        ways = [call.via[::-1] for call in diagnostic.calls]
        if not any(ways):
            return
        inner = _shared(ways)
        own = [way[inner:] for way in ways]
        outer = _shared([way[::-1] for way in own])
        yield from self._steps(ways[0][:inner])
        if len(ways) > 1:
            what = "expanded from {} places" if any(own) else "{} findings here"
            yield f"  {what.format(len(ways))}:"
            for call, way in zip(diagnostic.calls[:MAX_CALLS], own, strict=False):
                yield self._call(call, way[: len(way) - outer], diagnostic)
            if len(ways) > MAX_CALLS:
                yield f"    and {len(ways) - MAX_CALLS} more"
        yield from self._steps(own[0][len(own[0]) - outer :])

    def _call(self, call: Call, way: Sequence[Step], diagnostic: Diagnostic) -> str:
        """One of several calls: where it is, and what it says that the finding has not said."""
        places = [self._near(step.span, diagnostic) for step in way[:MAX_CALLS]]
        text = call.element if call.message == diagnostic.message else call.message
        where = ", from ".join(places)
        # A path that is longer than a line begins there nevertheless.
        return "    " + self.wrap(f"{where}: {text}" if where else text, indent=6, used=4).lstrip()

    def _steps(self, way: Sequence[Step]) -> Iterator[str]:
        for number, step in enumerate(way):
            if MAX_CALLS <= number < len(way) - 1:  # the outermost is where a person looks
                if number == MAX_CALLS:
                    yield f"  ... {counted(len(way) - MAX_CALLS - 1, 'more call')} ..."
                continue
            yield f"  {_STEPS[step.kind].format(printable(step.name))} {self.place(step.span)}"

    def _near(self, span: Span, diagnostic: Diagnostic) -> str:
        """A place; without the path if it is the path of the finding."""
        if span.source.path != diagnostic.span.source.path:
            return self.place(span)
        line, column = span.source.position(span.start)
        return f"line {line}:{column}"

    def place(self, span: Span) -> str:
        line, column = span.source.position(span.start)
        return f"{self.path(span.source.path)}:{line}:{column}"

    def path(self, path: str) -> str:
        """A path as it is shown; many findings have the same."""
        if path not in self._paths:
            self._paths[path] = printable(shown(path))
        return self._paths[path]

    def wrap(self, text: str, *, indent: int, used: int = 0) -> str:
        return wrap(printable(text), self.width, indent=indent, used=used)

    def paint(self, text: str, code: str) -> str:
        return f"\x1b[{code}m{text}\x1b[0m" if self.color else text


def _shared(ways: Sequence[Sequence[Step]]) -> int:
    """How many first steps all ways share."""
    shared = min(map(len, ways))
    while any(way[:shared] != ways[0][:shared] for way in ways):
        shared -= 1
    return shared
