"""``urdfkit check`` once its command line is read."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from urdfkit import atomic, formats
from urdfkit.cli import options, output, stdin
from urdfkit.diagnostic import Report, Severity
from urdfkit.engine import check

if TYPE_CHECKING:
    from urdfkit.cli.progress import Progress


def run_check(values: Mapping[str, Any]) -> int:
    """Check, report, and return the exit code.

    Args:
        values: of the options and files, by key.
    """
    outputs = options.outputs(values)
    stdin_name = values["stdin_filename"] or "<stdin>"
    files = options.files(values)
    rules = options.add_rules(values)
    config = options.config(values, os.curdir if files[0] == "-" else files[0])
    progress = _progress(files)
    try:
        report = check(
            *(stdin.read(stdin_name) if file == "-" else file for file in files),
            arguments=options.arguments(values),
            packages=options.packages(values),
            select=options.words(values, "select"),
            ignore=options.words(values, "ignore"),
            targets=options.words(values, "target"),
            trust=values["trust"],
            rules=rules,
            config=config,
            changed=values["changed"],
            jobs=options.jobs(values),
            progress=progress,
        )
    finally:
        if progress is not None:
            progress.wipe()
    if values["baseline"] or values["write_baseline"]:
        report = _with_baseline(report, values)
    _show_crashes(report)
    # Files first: if one cannot be written, standard output stays empty.
    for name, file in sorted(outputs, key=lambda one: not one[1]):
        render = formats.get(name)
        if file:
            atomic.write(file, output.encode(render(report)))
        else:
            color = output.has_color(values["color"])
            output.write(render(report, color=color, width=output.width()))
    fail_on = config.fail_on if config else Severity.WARNING
    code = report.exit_code(Severity(values["fail_on"] or fail_on))
    return 0 if code == 1 and values["exit_zero"] else code


def _with_baseline(report: Report, values: Mapping[str, Any]) -> Report:
    """The findings that a baseline does not hold; after writing it there are none."""
    from urdfkit import baseline

    file = values["baseline"]
    if not file:
        raise options.UsageError("--write-baseline needs --baseline FILE to write to")
    folder = os.path.dirname(os.path.abspath(file))
    if values["write_baseline"]:
        atomic.write(file, output.encode(baseline.dump(report.diagnostics, folder)))
    new, tolerated = baseline.sift(report.diagnostics, baseline.load(file), folder)
    return report._replace(diagnostics=tuple(new), tolerated=tolerated)


def _progress(files: Sequence[str]) -> Progress | None:
    """Where a single file is checked there is no way to tell how far it is."""
    if len(files) == 1 and not os.path.isdir(files[0]):
        return None
    from urdfkit.cli.progress import on_terminal

    return on_terminal()


def _show_crashes(report: Report) -> None:
    if os.environ.get("URDFKIT_DEBUG") == "1" and sys.stderr is not None:
        for crash in report.crashed:
            print(crash.traceback, file=sys.stderr)
