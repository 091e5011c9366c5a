"""``urdfkit check`` once its command line is read."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from typing import Any

from urdfkit import atomic, formats
from urdfkit.cli import output
from urdfkit.cli.options import CheckOptions
from urdfkit.diagnostic import Report, Severity
from urdfkit.engine import check
from urdfkit.errors import UnreadableFile
from urdfkit.source import MAX_BYTES, Source


def run_check(values: Mapping[str, Any]) -> int:
    """Check, report, and return the exit code."""
    options = CheckOptions.read(values)
    report = check(
        *(_stdin(options) if file == "-" else file for file in options.files),
        arguments=options.arguments,
        packages=options.packages,
        select=options.select,
        ignore=options.ignore,
        trust=options.trust,
    )
    _debug(report)
    _write(report, options)
    code = report.exit_code(Severity(options.fail_on))
    return 0 if code == 1 and options.exit_zero else code


def _stdin(options: CheckOptions) -> Source:
    if sys.stdin is None:
        raise UnreadableFile("standard input is closed; name a file instead of '-'")
    data = sys.stdin.buffer.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise UnreadableFile(f"standard input: larger than {MAX_BYTES // 2**20} MiB")
    return Source(options.stdin_filename, data)


def _write(report: Report, options: CheckOptions) -> None:
    """Write every report; the files first, so that standard output stays empty if one fails."""
    for name, file in sorted(options.outputs, key=lambda one: one.file is None):
        render = formats.get(name)
        if file is None:
            color = output.has_color(options.color)
            output.write(render(report, color=color, width=output.width()))
        else:
            atomic.write(file, output.encode(render(report)))


def _debug(report: Report) -> None:
    if os.environ.get("URDFKIT_DEBUG") == "1" and sys.stderr is not None:
        for crash in report.crashed:
            print(crash.traceback, file=sys.stderr)
