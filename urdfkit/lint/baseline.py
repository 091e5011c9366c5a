"""A baseline: the existing findings of a project, which checks tolerate.

A finding is recognised by its rule, its file and the text of its line, not by the line number or
numbers in its message, so that edits elsewhere do not make it new. A missing file may have been
moved: its findings are tolerated in any other file.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections import Counter
from collections.abc import Iterable

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.merging import in_reading_order
from urdfkit.lint.report import Report
from urdfkit.lint.rule_index import redirect
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import why_unreadable

VERSION = 1


class BaselineError(UrdfkitError):
    """The file is not a baseline."""


class Fingerprint(Record):
    """The identity of a finding in a baseline."""

    path: str  # path of the file, relative to the baseline's directory, with forward slashes
    code: str  # code of the rule
    text: str  # text of the finding's line, without indentation


def fingerprint(diagnostic: Diagnostic, directory: str) -> Fingerprint:
    """The fingerprint of a finding, for a baseline in a directory."""
    span = diagnostic.span
    path = os.path.relpath(os.path.abspath(span.source.path), os.path.abspath(directory))
    text = " ".join(span.source.line(span.line).split())
    return Fingerprint(path.replace(os.sep, "/"), diagnostic.code, text)


def fingerprints(diagnostics: Iterable[Diagnostic]) -> list[str]:
    """A short hash of every finding, for services that track findings across runs.

    Findings with the same fingerprint are numbered in their order.
    """
    counts: Counter[str] = Counter()
    hashes: list[str] = []
    for diagnostic in diagnostics:
        text = "\n".join(fingerprint(diagnostic, os.curdir))
        counts[text] += 1
        digest = hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
        hashes.append(f"{digest[:32]}:{counts[text]}")
    return hashes


def dump(report: Report, directory: str) -> str:
    """The text of a baseline of a report; deterministic for the same findings.

    Includes superseded findings, which are reported once their cause is tolerated.
    """
    superseded = (finding for group in report.superseded for finding in group.findings)
    distinct = {_identity(finding): finding for finding in (*report.diagnostics, *superseded)}
    counts = Counter(fingerprint(finding, directory) for finding in distinct.values())
    findings = [{**key._asdict(), "count": count} for key, count in sorted(counts.items())]
    document = {"version": VERSION, "findings": findings}
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def load(path: str) -> Counter[Fingerprint]:
    """The findings in a baseline, with the number of times that each is tolerated.

    Raises:
        BaselineError: the file cannot be read, or is not a baseline.
    """
    try:
        document = json.loads(disk.read(path))
        if document["version"] != VERSION:
            raise BaselineError(
                f"{path}: a baseline of version {document['version']!r}, not {VERSION}; "
                "write it anew with --write-baseline"
            )
        tolerated: Counter[Fingerprint] = Counter()
        for entry in document["findings"]:
            code = redirect(entry["code"]) or entry["code"]
            tolerated[Fingerprint(entry["path"], code, entry["text"])] += int(entry["count"])
        return tolerated
    except OSError as error:
        raise BaselineError(f"{path}: {why_unreadable(path, error)}") from error
    except ValueError as error:
        raise BaselineError(f"{path}: not a urdfkit baseline ({error})") from error
    except (KeyError, TypeError, AttributeError, RecursionError) as error:
        raise BaselineError(f"{path}: not a urdfkit baseline") from error


def apply_baseline(report: Report, known: Counter[Fingerprint], directory: str) -> Report:
    """A report without the findings in a baseline.

    A tolerated finding supersedes no others: its consequences are reported, unless the baseline
    contains them as well.
    """
    known_findings = _KnownFindings(known, directory)
    new = [finding for finding in report.diagnostics if not known_findings.takes(finding)]
    reported = {
        _identity(finding._replace(message=call.message))
        for finding in new
        for call in finding.calls
    }
    reported.update(map(_identity, new))
    consequences = {
        _identity(finding): finding
        for group in report.superseded
        if reported.isdisjoint(map(_identity, group.causes))
        for finding in group.findings
    }
    new += [finding for finding in consequences.values() if not known_findings.takes(finding)]
    return report._replace(diagnostics=in_reading_order(new), tolerated=known_findings.count)


def _identity(diagnostic: Diagnostic) -> tuple[object, ...]:
    """The identity of a finding, equal for a finding that several robots share."""
    span = diagnostic.span
    return (diagnostic.code, disk.real(span.source.path), *span[1:], diagnostic.message)


class _KnownFindings:
    """The findings that a baseline still tolerates.

    Args:
        known: the findings in the baseline, with the number of times that each is tolerated.
    """

    def __init__(self, known: Counter[Fingerprint], directory: str) -> None:
        self.count = 0
        self._directory = directory
        paths = {key.path for key in known}
        gone = {path for path in paths if not disk.has_name(os.path.join(directory, path))}
        self._left: Counter[Fingerprint] = Counter()
        for key, count in known.items():
            self._left[key._replace(path="") if key.path in gone else key] += count

    def takes(self, diagnostic: Diagnostic) -> bool:
        """True if a finding is tolerated; removes it from the tolerated ones."""
        own = fingerprint(diagnostic, self._directory)
        key = own if self._left[own] > 0 else own._replace(path="")
        if self._left[key] <= 0:
            return False
        self._left[key] -= 1
        self.count += 1
        return True
