"""``urdfkit check`` for a parsed command line."""

from __future__ import annotations

import os
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager

from urdfkit.cli import options, output
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.lint import rule_index
from urdfkit.lint.engine import check_with
from urdfkit.lint.finding_store import StoredFindings
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.output import formats
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import STANDARD_INPUT, Source

if TYPE_CHECKING:
    from collections import Counter

    from urdfkit.core.progress import Progress
    from urdfkit.lint.baseline import Fingerprint
    from urdfkit.lint.context import Simulate

#: Formats that state how many findings can be fixed.
_FOR_PEOPLE = ("text", "full")


def run_check(values: Mapping[str, Any]) -> int:
    """Check, report, and return the exit code."""
    if values["watch"]:
        from urdfkit.cli.watch import watch

        return watch(run_check, values)
    settings = check_settings(values)
    settings = settings._replace(simulate=_simulate(values, settings.select))
    if values["show_files"]:
        from urdfkit.cli.progress import working
        from urdfkit.cli.shown_files import shown_files

        with working():
            text = shown_files(options.files(values), settings)
        output.write(text)
        return 0
    if values["show_settings"]:
        from urdfkit.cli.settings import shown_settings

        output.write(shown_settings(settings, fail_on(values, settings)))
        return 0
    return (_add_ignores if values["add_ignore"] else _report)(values, settings)


def _report(values: Mapping[str, Any], settings: Options) -> int:
    outputs = options.outputs(values, fail_on(values, settings).value)
    known = _baseline(values)  # before the check, which may take minutes
    if values["fix"] or values["diff"]:
        from urdfkit.cli.fixing import apply_fixes, print_fixes, print_no_fixes
        from urdfkit.lint.fixable import counted

        fixes = apply_fixes(values, settings)
        if values["diff"]:
            if not fixes.files and not values["quiet"]:
                print_no_fixes(fixes)
            return int(bool(fixes.files))
        if not values["quiet"]:
            print_fixes(fixes)
        report = fixes.report._replace(fixable=counted(fixes.left))
        report = _with_baseline(report, known, values)
    elif values["unsafe_fixes"] or values["force"]:
        raise options.UsageError("--unsafe-fixes and --force need --fix or --diff")
    else:
        report = _with_baseline(_check(values, settings), known, values)
        if any(name in _FOR_PEOPLE for name, _ in outputs) and _has_fixes(report):
            report = _with_fixable(report, values, settings)
    _show_crashes(report)
    if not any(name in _FOR_PEOPLE and not file for name, file in outputs):
        for typo in report.argument_typos:
            options.warn(typo)
    written = _write(report, outputs, values)
    code = report.exit_code(fail_on(values, settings))
    code = 0 if code == 1 and values["exit_zero"] else code
    if _is_cacheable(values, settings) and not (report.crashed or _is_huge(report)):
        from urdfkit.cli import result_recording

        result_recording.finish(code, written)
    return code


def _write(
    report: Report, outputs: Iterable[tuple[str, str]], values: Mapping[str, Any]
) -> list[tuple[str, bytes]]:
    """Write the report in each format to its file or standard output; return files and contents."""
    # Files first: if a file cannot be written, standard output stays empty.
    ordered = sorted(outputs, key=lambda name_and_file: not name_and_file[1])
    return [
        (file, (_write_file if file else _print)(report, name, file, values))
        for name, file in ordered
    ]


def _write_file(report: Report, name: str, file: str, values: Mapping[str, Any]) -> bytes:
    """Write a report to a file; return its content, or b"" for a huge report."""
    from urdfkit.core import atomic

    parts = map(output.encode, formats.stream(name, report, quiet=values["quiet"]))
    if _is_huge(report):
        atomic.write(file, parts)
        return b""
    data = b"".join(parts)
    atomic.write(file, data)
    return data


def _print(report: Report, name: str, _: str, values: Mapping[str, Any]) -> bytes:
    """Print a report; return the output, or b"" for a huge report."""
    color = output.has_color()
    texts = formats.stream(name, report, color=color, width=output.width(), quiet=values["quiet"])
    if _is_huge(report):
        for text in texts:
            output.write(text)
        return b""
    return output.write("".join(texts))


def _is_huge(report: Report) -> bool:
    """True if the findings of a report are stored on disk."""
    return isinstance(report.diagnostics, StoredFindings)


def _has_fixes(report: Report) -> bool:
    """True if fixable findings are to be counted, which takes too long for a huge report."""
    return not _is_huge(report) and any(finding.fix for finding in report.diagnostics)


def _is_cacheable(values: Mapping[str, Any], settings: Options) -> bool:
    """False for a check that writes files, or whose result depends on more than files."""
    writes = values["fix"] or values["write_baseline"] or values["changed"]
    # External rules and trusted models may run any code.
    return not (
        writes or settings.with_config().trust or settings.rules or settings.config.external_rules
    )


def check_settings(values: Mapping[str, Any]) -> Options:
    """The options of the command line as options of ``urdfkit.check``."""
    files = options.files(values)
    added = options.add_rules(values)  # first: other options contain their codes
    base = options.check_options(values, files[0])  # may also add rules
    return base._replace(
        select=options.selected(values),
        ignore=options.ignored(values),
        rules=added,
        preview=values["preview"],
        min_confidence=values["min_confidence"] or "",
        changed=values["changed"],
        jobs=options.jobs(values),
        cache=not values["no_cache"],
    )


def _simulate(values: Mapping[str, Any], select: Collection[str]) -> Simulate | None:
    """What simulates the robots; None without ``--simulate``."""
    if values["simulate"]:
        from urdfkit.cli.simulating import simulator

        return simulator(values)
    for key in ("timeout", "memory"):
        if values[key] is not None:
            raise options.UsageError(f"--{key} needs --simulate")
    for word in select:
        codes = rule_index.codes_of(word)
        if codes and rule_index.of_family("simulation").issuperset(codes):
            raise options.UsageError(f"--select {word} needs --simulate")
    return None


def _add_ignores(values: Mapping[str, Any], settings: Options) -> int:
    """Write comments for the findings at or above ``--fail-on``, or for the selected ones."""
    from urdfkit.core.words import counted
    from urdfkit.lint.added_ignores import add_ignores
    from urdfkit.text.editing import rewriting

    files = options.files(values)
    if "-" in files or values["fix"]:
        raise options.UsageError("--add-ignore cannot be combined with '-' or --fix")
    report = _with_baseline(_check(values, settings), _baseline(values), values)
    least = Severity.INFO if values["select"] else fail_on(values, settings)
    findings = [found for found in report.diagnostics if found.severity.rank <= least.rank]
    added = add_ignores(findings, files, settings, force=values["force"])
    if values["diff"]:
        output.write_diff("".join(file.diff() for file in added.files))
        return int(bool(added.files))
    rewriting.write(added.files)
    if not values["quiet"]:
        lines = [f"{left.span}: {left.code} left: {reason}" for left, reason in added.left]
        suppressed = counted(len(added.suppressed), "finding")
        lines.append(f"{suppressed} suppressed in {counted(len(added.files), 'file')}")
        output.page(lines)
    return 0


def fail_on(values: Mapping[str, Any], settings: Options) -> Severity:
    """The lowest severity that makes the exit code 1."""
    return Severity(values["fail_on"] or settings.config.fail_on)


def _check(values: Mapping[str, Any], settings: Options) -> Report:
    name = values["stdin_filename"] or STANDARD_INPUT
    files = options.files(values)
    with _progress(files) as progress:
        sources = [_standard_input(name) if file == "-" else file for file in files]
        return check_with(settings._replace(progress=progress), sources, spills=True)


def _standard_input(name: str) -> Source:
    from urdfkit.cli import stdin

    return stdin.read(name)


def _with_fixable(report: Report, values: Mapping[str, Any], settings: Options) -> Report:
    """The report with the number of fixable findings, unless it is of standard input."""
    from urdfkit.lint.fixable import fixable

    files = options.files(values)
    if "-" in files:
        return report
    return report._replace(fixable=fixable(report, settings._replace(simulate=None), files))


def _baseline(values: Mapping[str, Any]) -> Counter[Fingerprint] | None:
    """The findings in the baseline; None if there is no baseline, or it is to be written."""
    file = values["baseline"]
    if values["write_baseline"] and not file:
        raise options.UsageError("--write-baseline needs --baseline FILE to write to")
    if not file or values["write_baseline"]:
        return None
    from urdfkit.lint.baseline import load

    return load(file)


def _with_baseline(
    report: Report, known: Counter[Fingerprint] | None, values: Mapping[str, Any]
) -> Report:
    """The report without the findings in the baseline; writes the baseline if requested."""
    file = values["baseline"]
    if not file:
        return report
    from urdfkit.core import atomic
    from urdfkit.lint import baseline

    directory = os.path.dirname(os.path.abspath(file))
    if known is None:
        atomic.write(file, output.encode(baseline.dump(report, directory)))
        known = baseline.load(file)
    return baseline.apply_baseline(report, known, directory)


@contextmanager
def _progress(files: Sequence[str]) -> Iterator[Progress | None]:
    """A progress bar of robots."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield None  # saves the import
        return
    from urdfkit.cli.progress import progress_of_files

    with progress_of_files(files) as bar:
        yield bar


def _show_crashes(report: Report) -> None:
    if os.environ.get("URDFKIT_DEBUG") == "1" and sys.stderr is not None:
        for crash in report.crashed:
            print(crash.traceback, file=sys.stderr)
