"""``urdfkit check`` once its command line is read."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from typing import Any

from urdfkit import atomic, formats
from urdfkit.cli import options, output
from urdfkit.diagnostic import Report, Severity
from urdfkit.engine import check
from urdfkit.errors import UnreadableFile
from urdfkit.source import MAX_BYTES, Source


def run_check(values: Mapping[str, Any]) -> int:
    """Check, report, and return the exit code.

    Args:
        values: of the options and files, by key.
    """
    outputs = options.outputs(values)
    stdin = values["stdin_filename"] or "<stdin>"
    files = options.files(values)
    rules = options.add_rules(values)
    config = options.config(values, os.curdir if files[0] == "-" else files[0])
    report = check(
        *(_read_stdin(stdin) if file == "-" else file for file in files),
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
    )
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


def _read_stdin(name: str) -> Source:
    if sys.stdin is None:
        raise UnreadableFile("standard input is closed; name a file instead of '-'")
    data = sys.stdin.buffer.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise UnreadableFile(f"standard input: larger than {MAX_BYTES // 2**20} MiB")
    return Source(name, data)


def _show_crashes(report: Report) -> None:
    if os.environ.get("URDFKIT_DEBUG") == "1" and sys.stderr is not None:
        for crash in report.crashed:
            print(crash.traceback, file=sys.stderr)
