"""What follows the findings in a text: crashed rules, what can be fixed, targets, the counts."""

import os
from collections.abc import Iterator
from itertools import islice

from urdfkit.core.words import counted, few
from urdfkit.lint.report import Crashed, Report
from urdfkit.lint.rule_index import NOT_CHECKED, external
from urdfkit.output.formats._page import COLORS, TextPage
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import shown
from urdfkit.text.terminal import printable

#: Letters of arguments; they may be paths.
MAX_VALUES = 160
#: Rules that failed with one error that are named.
MAX_CODES = 4
#: Skipped files that are named.
MAX_FILES = 3


def crashes(report: Report, page: TextPage) -> Iterator[str]:
    """The rules that crashed, those with one error together."""
    for crash, codes in _crashed(report):
        whose = "that rule" if crash.code in external() else "urdfkit"
        what = few(codes, MAX_CODES) or "the check"
        text = (
            f"{page.path(crash.path)}: {what} failed with {crash.error}. This is a bug in "
            f"{whose}, not in the robot: please report it with the file."
        )
        yield page.wrap(text, indent=4) + "\n"


def hints(report: Report, page: TextPage) -> str:
    """Where to read more, what can be fixed, and what the severities depend on."""
    lines = [f"Explain a code: urdfkit explain {code}" for code in _worst(report)]
    lines += (page.wrap(hint, indent=2) for hint in _fixable(report))
    lines += map(printable, report.argument_typos)
    evidence = dict.fromkeys(why for _, targets in report.targets for why in targets.evidence)
    if evidence:
        targets = ", ".join("{} ({})".format(*why.split(": ", 1)) for why in evidence)
        lines.append(page.wrap(f"Targets: {targets}; override with --target", indent=2))
    return "".join(f"{line}\n" for line in lines)


def _worst(report: Report) -> Iterator[str]:
    """The code of the first of the worst findings, if there are any."""
    worst = next(filter(report.count, Severity), None)
    codes = (found.code for found in report.diagnostics if found.severity is worst)
    yield from islice(codes, 1)


def summary(report: Report, *, color: bool = False, width: int = 80) -> str:
    """The last line: how much was found, and which rules did not get to look."""
    page = TextPage(color, width)
    counts = {severity: report.count(severity) for severity in Severity}
    found = [counted(count, severity.value) for severity, count in counts.items() if count]
    none = "no new findings" if report.tolerated else "no findings"
    text = f"{', '.join(found) or none} in {counted(len(report.files), 'file')}"
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
            text = text.replace(words, page.paint(words, COLORS[severity]), 1)
    return text + "\n"


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
