"""Groups findings with a common cause into one.

Reports for people (terminal, pull request, HTML) show groups. Programs get single findings: an
editor marks every place, and a baseline must recognise an additional finding as new.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby

from urdfkit.core.words import more_like_this
from urdfkit.text.diagnostic import (
    NOT_BUILT,
    NOT_CREATED,
    Diagnostic,
    Fix,
    Related,
    Severity,
)

#: Largest group whose findings are shown separately.
MAX_SINGLE = 2
#: Most places of further findings of a group that are shown.
MAX_NOTES = 20
#: Rules whose findings in several files have one cause: a missing package.
_ACROSS_FILES = frozenset(("XAC011",))
#: Keys of groups of XAC001 in several files with one cause: a step that creates files.
_STEPS = (NOT_BUILT, NOT_CREATED)
#: A name or a number in a message.
_VALUE = re.compile(r"'[^']*'|[-+]?\b\d[\w.]*(?:[eE][-+]?\d+)?")
#: What a message is about, such as ``link 'arm'``.
_SUBJECT = r"[a-z][\w -]* '[^']+'(?=: |[^']*$)"
#: A word of a message that corrects a name.
_SUGGESTION = "did you mean"


def grouped(diagnostics: Sequence[Diagnostic], *, brief: bool = False) -> tuple[Diagnostic, ...]:
    """Findings, with each group replaced by one finding at the place of its first.

    Args:
        brief: of a further finding of a group, note what it is about, not its message.
    """
    return tuple(
        _as_one(group, brief=brief) if len(group) > 1 else group[0] for group in groups(diagnostics)
    )


def groups(diagnostics: Iterable[Diagnostic]) -> Iterator[list[Diagnostic]]:
    """The findings that are shown as one, in the order of the first finding of each group."""
    by_key: dict[object, list[Diagnostic]] = {}
    for number, finding in enumerate(diagnostics):
        by_key.setdefault(_key(finding, number), []).append(finding)
    for group in by_key.values():
        is_one = len(group) > MAX_SINGLE or _is_across_files(group[0]) or _is_repeated(group)
        yield from [group] if is_one else ([finding] for finding in group)


def by_file(
    diagnostics: Iterable[Diagnostic], severity: Severity | None = None
) -> Iterator[tuple[Diagnostic, ...]]:
    """The findings of each file, sorted by file; a group of several files is in its first file.

    Args:
        diagnostics: sorted by file; read twice, as there may be too many for the memory.
        severity: of the findings; None for all.
    """
    across: dict[object, list[Diagnostic]] = {}
    for finding in diagnostics:
        if severity in (None, finding.severity) and _is_across_files(finding):
            across.setdefault(_key(finding), []).append(finding)
    for _, of_file in groupby(diagnostics, key=lambda finding: finding.span.source.path):
        part: list[Diagnostic] = []
        for finding in of_file:
            if severity in (None, finding.severity):
                is_across = _is_across_files(finding)
                part += across.pop(_key(finding), ()) if is_across else (finding,)
        if part:
            yield tuple(part)


def _key(finding: Diagnostic, number: int = 0) -> object:
    """What the findings of a group share; the number for a finding that is like no other."""
    path = "" if _is_across_files(finding) else finding.span.source.path
    alike = finding.group_key or _without_values(finding) or number
    return finding.code, finding.severity, alike, path, finding.variants


def _is_across_files(finding: Diagnostic) -> bool:
    is_step = finding.code == "XAC001" and finding.group_key in _STEPS
    return is_step or finding.code in _ACROSS_FILES


def _without_values(finding: Diagnostic) -> object:
    """What findings share that differ in names and numbers alone; None for a misspelt name."""
    if _SUGGESTION in finding.message:
        return None
    return _VALUE.sub("", finding.message), finding.fix and finding.fix.safe


def _is_repeated(group: list[Diagnostic]) -> bool:
    """True for one missing file, such as that of visual and collision."""
    return group[0].code == "MSH001" and len({finding.span.text for finding in group}) == 1


def _as_one(group: list[Diagnostic], *, brief: bool) -> Diagnostic:
    first, *others = group
    notes = tuple(_note(other, first, brief=brief) for other in others[:MAX_NOTES])
    return first._replace(
        message=first.message + more_like_this(len(others)),
        related=first.related + notes,
        fix=_combined([finding.fix for finding in group]),
    )


def _note(other: Diagnostic, first: Diagnostic, *, brief: bool) -> Related:
    """The note about a further finding of a group, with its help if it differs."""
    message, help = other.message, other.help if other.help != first.help else ""
    if _is_across_files(other):
        message, help = without_search(message), ""
    elif brief and (subject := re.match(_SUBJECT, message)):
        is_alone = other.group_key or "'" not in message[subject.end() :]
        message = subject[0] if is_alone else message
    return Related(other.span, f"{message}: {help}" if help else message)


def without_search(message: str) -> str:
    """A message without the searched places, which are long and the same for the whole group."""
    return message.partition("; searched: ")[0].partition("; tried ")[0]


def _combined(fixes: list[Fix | None]) -> Fix | None:
    """One fix with the edits of all; None if a finding has no fix."""
    present = [fix for fix in fixes if fix is not None]
    if not present or len(present) < len(fixes):
        return None
    edits = dict.fromkeys(edit for fix in present for edit in fix.edits)  # fixes may share edits
    title = present[0].title + more_like_this(len(present) - 1)
    return Fix(title, tuple(edits), all(fix.safe for fix in present))
