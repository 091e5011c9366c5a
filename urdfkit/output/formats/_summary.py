"""Text below the findings: crashed rules, fixable findings, targets, counts."""

import os
from collections.abc import Iterator
from itertools import islice

from urdfkit.core.grouping import by_key
from urdfkit.core.words import counted, few
from urdfkit.lint.report import Crashed, Report
from urdfkit.lint.rule_index import NOT_CHECKED, external
from urdfkit.output.formats._page import COLORS, TextPage
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import shown
from urdfkit.text.terminal import printable

#: Most characters of argument values that are shown; the values may be paths.
MAX_VALUES = 160
#: Most rules that are named if they failed with the same error.
MAX_CODES = 4
#: Most values of arguments from launch files that are named, and most skipped files.
MAX_LAUNCHED, MAX_FILES = 4, 3


def crashes(report: Report, page: TextPage) -> Iterator[str]:
    """The crashed rules, grouped by error."""
    for crash, codes in _crashed(report):
        owner = "that rule" if crash.code in external() else "urdfkit"
        rules = few(codes, MAX_CODES) or "the check"
        text = (
            f"{page.path(crash.path)}: {rules} failed with {crash.error}. This is a bug in "
            f"{owner}, not in the robot: please report it with the file."
        )
        yield page.wrap(text, indent=4) + "\n"


def hints(report: Report, page: TextPage) -> str:
    """Hints: how to explain a code, number of fixable findings, detected targets."""
    lines = [f"Explain a code: urdfkit explain {code}" for code in _worst(report)]
    lines += (page.wrap(hint, indent=2) for hint in _fixable(report))
    lines += map(printable, report.argument_typos)
    evidence = dict.fromkeys(why for _, targets in report.targets for why in targets.evidence)
    if evidence:
        targets = ", ".join("{} ({})".format(*why.split(": ", 1)) for why in evidence)
        lines.append(page.wrap(f"Targets: {targets}; override with --target", indent=2))
    return "".join(f"{line}\n" for line in lines)


def _worst(report: Report) -> Iterator[str]:
    """The code of the first finding of the highest severity, if any."""
    worst = next(filter(report.count, Severity), None)
    codes = (finding.code for finding in report.diagnostics if finding.severity is worst)
    yield from islice(codes, 1)


def summary(report: Report, *, color: bool = False, width: int = 80) -> str:
    """The last line: number of findings, and skipped files and rules."""
    page = TextPage(color, width)
    counts = {severity: report.count(severity) for severity in Severity}
    totals = [counted(count, severity.value) for severity, count in counts.items() if count]
    none = "no new findings" if report.tolerated else "no findings"
    text = f"{', '.join(totals) or none} in {counted(len(report.files), 'file')}"
    reasons = [*_launched(report)]
    if unchecked := sum(item.code == NOT_CHECKED for item in report.diagnostics):
        reasons.append(f"{counted(unchecked, 'robot')} not checked")
    reasons += [f"{skipped} skipped: {reason}" for reason, skipped in _skipped(report)]
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
            text = text.replace(words, page.paint(words, COLORS[severity]), 1)
    return text + "\n"


def _fixable(report: Report) -> Iterator[str]:
    """Number of fixable findings, options that fix more, and reasons why others are not fixable."""
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


def _crashed(report: Report) -> Iterator[tuple[Crashed, list[str]]]:
    """The first crash of each error and file, with the codes of all rules that failed with it."""
    by_error = by_key(((crash.path, crash.error), crash) for crash in report.crashed)
    for crashes in by_error.values():
        yield crashes[0], [crash.code for crash in crashes]


def _launched(report: Report) -> Iterator[str]:
    """Robots that were checked with arguments from launch files."""
    values: dict[tuple[str, str], dict[str, str]] = {}
    for robot in report.launched:
        for name, value in robot.arguments.items():
            values.setdefault((robot.path, name), {}).setdefault(value, robot.launch)
    if len(values) > MAX_LAUNCHED:
        robots, files = {path for path, _ in values}, {robot.launch for robot in report.launched}
        where = counted(len(files), "launch file")
        yield f"{counted(len(robots), 'robot')} with arguments of {where}, see --show-files"
        return
    for (path, name), launches in values.items():
        files = {os.path.basename(launch) for launch in launches.values()}
        where = min(files) if len(files) == 1 else counted(len(files), "launch file")
        text = f"{name} {', '.join(launches)}"
        if len(text) > MAX_VALUES:
            text = f"{len(launches)} values of {name}"
        yield printable(f"{shown(path)} with {text} of {where}")


def _skipped(report: Report) -> list[tuple[str, str]]:
    """Pairs of a reason, and the files or the number of rules that were skipped for it."""
    codes: dict[str, set[str]] = {}
    files: dict[str, set[str]] = {}
    reported = {item.span.source.path for item in report.diagnostics if item.code == NOT_CHECKED}
    for skip in report.skipped:
        if skip.path in reported:
            continue
        if skip.code:
            codes.setdefault(skip.reason, set()).add(skip.code)
        else:
            files.setdefault(skip.reason, set()).add(skip.path)
    reasons = [(reason, counted(len(codes[reason]), "rule")) for reason in sorted(codes)]
    for reason in sorted(files):
        paths = sorted({shown(path) for path in files[reason]})
        named = ", ".join(paths) if len(paths) <= MAX_FILES else counted(len(paths), "file")
        reasons.append((reason, printable(named)))
    return reasons
