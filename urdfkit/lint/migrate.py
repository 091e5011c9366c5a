"""From one Gazebo to another: what can be renamed, and what a person must decide."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.lint.engine import check
from urdfkit.lint.report import DEFINES_NO_LINK
from urdfkit.lint.rule_index import NOT_CHECKED, all_rules
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.editing.diff import diff
from urdfkit.text.source import Source


class Migration(Record):
    """What a migration needs."""

    texts: dict[Source, bytes]  # the new bytes of every file that changes, by its Source
    left: tuple[Diagnostic, ...]  # what has no pure rename, for a person
    renamed: tuple[Diagnostic, ...]  # findings that the new texts fix
    unread: dict[str, str]  # descriptions that nothing is known of, each with the reason

    def diff(self) -> str:
        """The changes as a unified diff, which ``patch -p0`` takes."""
        return "".join(diff(one.path, one.data, text) for one, text in self.texts.items())


def migrate(
    path: str | os.PathLike[str] | Source,
    target: str,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
) -> Migration:
    """What a model needs to run in another Gazebo; nothing is written.

    Args:
        target: one of ``urdfkit.ros.targets.GAZEBO``.
        packages: directories of ROS packages by name.
        trust: do not sandbox the expressions of the model, and let it read any file.

    Raises:
        UnreadableFile: the file cannot be read.
        UnknownTarget: there is no such target.
    """
    report = check(
        path,
        arguments=arguments,
        packages=packages,
        select=[rule.code for rule in all_rules() if rule.migrates],
        ignore=(NOT_CHECKED,),  # which `unread` says
        targets=(target,),
        trust=trust,
    )
    edits: dict[Source, list[Edit]] = {}
    left, renamed = [], []
    for diagnostic in report.diagnostics:
        if diagnostic.severity is Severity.INFO:
            continue  # has no effect in any Gazebo
        if diagnostic.fix is None or _overlaps(diagnostic, edits):
            left.append(diagnostic)
            continue
        renamed.append(diagnostic)
        for edit in diagnostic.fix.edits:
            edits.setdefault(edit.span.source, []).append(edit)
    texts = {source: apply_edits(source.data, parts) for source, parts in edits.items()}
    unread = {one.path: one.reason for one in report.skipped if one.reason != DEFINES_NO_LINK}
    return Migration(texts, tuple(left), tuple(renamed), unread)


def _overlaps(diagnostic: Diagnostic, edits: dict[Source, list[Edit]]) -> bool:
    """True if a fix changes what another one changes, too."""
    assert diagnostic.fix is not None
    return any(
        edit.span.start < other.span.end and other.span.start < edit.span.end
        for edit in diagnostic.fix.edits
        for other in edits.get(edit.span.source, ())
    )
