"""A baseline: the findings that a project had when it began to check, and tolerates until later.

A finding is known again by its rule, its file and the text of its line, not by the line's number
or the numbers in its message, so that edits elsewhere do not bring it back. Where a file is no
more, it may have been moved: what it had is tolerated in another one.
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
    """The file is no baseline."""


class Fingerprint(Record):
    """What a finding is known by."""

    path: str  # of the file, relative to the baseline's directory, with forward slashes
    code: str  # of the rule
    text: str  # of the line where the finding is, without indentation


def fingerprint(diagnostic: Diagnostic, directory: str) -> Fingerprint:
    """What a finding is known by, in a baseline in a directory."""
    span = diagnostic.span
    path = os.path.relpath(os.path.abspath(span.source.path), os.path.abspath(directory))
    text = " ".join(span.source.line(span.line).split())
    return Fingerprint(path.replace(os.sep, "/"), diagnostic.code, text)


def fingerprints(diagnostics: Iterable[Diagnostic]) -> list[str]:
    """A short mark for every finding, for services that follow findings from run to run.

    Findings that cannot be distinguished are numbered in their order.
    """
    seen: Counter[str] = Counter()
    marks: list[str] = []
    for diagnostic in diagnostics:
        text = "\n".join(fingerprint(diagnostic, os.curdir))
        seen[text] += 1
        digest = hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
        marks.append(f"{digest[:32]}:{seen[text]}")
    return marks


def dump(report: Report, directory: str) -> str:
    """The text of a baseline of a report; the same findings give the same text.

    It has what is superseded as well, for its cause is tolerated from now on.
    """
    superseded = (one for group in report.superseded for one in group.findings)
    found = {_identity(one): one for one in (*report.diagnostics, *superseded)}
    counts = Counter(fingerprint(diagnostic, directory) for diagnostic in found.values())
    findings = [{**key._asdict(), "count": count} for key, count in sorted(counts.items())]
    document = {"version": VERSION, "findings": findings}
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def load(path: str) -> Counter[Fingerprint]:
    """The findings in a baseline, with how often each is tolerated.

    Raises:
        BaselineError: it cannot be read, or is no baseline.
    """
    try:
        document = json.loads(disk.read(path))
        if document["version"] != VERSION:
            raise BaselineError(
                f"{path}: a baseline of version {document['version']!r}, not {VERSION}; "
                "write it anew with --write-baseline"
            )
        found: Counter[Fingerprint] = Counter()
        for entry in document["findings"]:
            code = redirect(entry["code"]) or entry["code"]
            found[Fingerprint(entry["path"], code, entry["text"])] += int(entry["count"])
        return found
    except OSError as error:
        raise BaselineError(f"{path}: {why_unreadable(path, error)}") from error
    except ValueError as error:
        raise BaselineError(f"{path}: not a urdfkit baseline ({error})") from error
    except (KeyError, TypeError, AttributeError, RecursionError) as error:
        raise BaselineError(f"{path}: not a urdfkit baseline") from error


def apply_baseline(report: Report, known: Counter[Fingerprint], directory: str) -> Report:
    """A report without what a baseline tolerates.

    A tolerated finding silences nothing: what follows from it is reported, unless the baseline has
    that, too.
    """
    known_findings = _KnownFindings(known, directory)
    new = [one for one in report.diagnostics if not known_findings.takes(one)]
    stands = {_identity(one._replace(message=call.message)) for one in new for call in one.calls}
    stands.update(map(_identity, new))
    found = {
        _identity(one): one
        for group in report.superseded
        if stands.isdisjoint(map(_identity, group.causes))
        for one in group.findings
    }
    new += [one for one in found.values() if not known_findings.takes(one)]
    return report._replace(diagnostics=in_reading_order(new), tolerated=known_findings.count)


def _identity(diagnostic: Diagnostic) -> tuple[object, ...]:
    """The same for a finding of several robots, which merging makes one."""
    span = diagnostic.span
    return (diagnostic.code, disk.real(span.source.path), *span[1:], diagnostic.message)


class _KnownFindings:
    """What a baseline still tolerates.

    Args:
        known: the findings in it, with how often each is tolerated.
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
        """True if a finding is tolerated, which is then used up."""
        own = fingerprint(diagnostic, self._directory)
        key = own if self._left[own] > 0 else own._replace(path="")
        if self._left[key] <= 0:
            return False
        self._left[key] -= 1
        self.count += 1
        return True
