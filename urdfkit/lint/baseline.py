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
from urdfkit.lint.rule_index import redirect
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import why_unreadable

VERSION = 1


class BaselineError(UrdfkitError):
    """The file is no baseline."""


class Fingerprint(Record):
    """What a finding is known by.

    Attributes:
        path: of the file, relative to the baseline's folder, with forward slashes.
        code: of the rule.
        text: of the line where the finding is, without indentation.
    """

    path: str
    code: str
    text: str


def fingerprint(diagnostic: Diagnostic, folder: str) -> Fingerprint:
    """What a finding is known by, in a baseline in a folder."""
    span = diagnostic.span
    path = os.path.relpath(os.path.abspath(span.source.path), os.path.abspath(folder))
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


def dump(diagnostics: Iterable[Diagnostic], folder: str) -> str:
    """The text of a baseline of these findings; the same findings give the same text."""
    counts = Counter(fingerprint(diagnostic, folder) for diagnostic in diagnostics)
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
            raise BaselineError(f"{path}: a baseline of version {document['version']!r}")
        found: Counter[Fingerprint] = Counter()
        for entry in document["findings"]:
            code = redirect(entry["code"]) or entry["code"]
            found[Fingerprint(entry["path"], code, entry["text"])] += int(entry["count"])
        return found
    except OSError as error:
        raise BaselineError(f"{path}: {why_unreadable(path, error)}") from error
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise BaselineError(f"{path}: not a urdfkit baseline ({error})") from error


def sift(
    diagnostics: Iterable[Diagnostic], known: Counter[Fingerprint], folder: str
) -> tuple[list[Diagnostic], int]:
    """The findings that a baseline does not tolerate, and how many it does."""
    paths = {key.path for key in known}
    gone = {path for path in paths if not disk.has_name(os.path.join(folder, path))}
    left: Counter[Fingerprint] = Counter()
    for key, count in known.items():
        left[key._replace(path="") if key.path in gone else key] += count
    new: list[Diagnostic] = []
    tolerated = 0
    for diagnostic in diagnostics:
        own = fingerprint(diagnostic, folder)
        key = own if left[own] > 0 else own._replace(path="")
        if left[key] > 0:
            left[key] -= 1
            tolerated += 1
        else:
            new.append(diagnostic)
    return new, tolerated
