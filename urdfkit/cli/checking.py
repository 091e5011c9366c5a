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
    report = check(
        *(_read_stdin(stdin) if file == "-" else file for file in options.files(values)),
        arguments=options.arguments(values),
        packages=options.packages(values),
        select=options.words(values, "select"),
        ignore=options.words(values, "ignore"),
        targets=options.words(values, "target"),
        trust=values["trust"],
    )
    _show_crashes(report)
    # Files first: if one cannot be written, standard output stays empty.
    for name, file in sorted(outputs, key=lambda one: not one[1]):
        render = formats.get(name)
        if file:
            atomic.write(file, output.encode(render(report)))
        else:
            color = output.has_color(values["color"])
            output.write(render(report, color=color, width=output.width()))
    code = report.exit_code(Severity(values["fail_on"]))
    return 0 if code == 1 and values["exit_zero"] else code


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
