"""Migration of a model to another Gazebo: automatic renames, and edits to make by hand."""

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
    """The result of a migration, which is not yet written."""

    texts: dict[Source, bytes]  # new contents of the changed files, by Source
    left: tuple[Diagnostic, ...]  # findings without a pure rename, to be edited by hand
    renamed: tuple[Diagnostic, ...]  # findings that the new texts fix
    unread: dict[str, str]  # skipped descriptions, each with the reason

    def diff(self) -> str:
        """The changes as a unified diff for ``patch -p0``."""
        return "".join(diff(file.path, file.data, text) for file, text in self.texts.items())


def migrate(
    path: str | os.PathLike[str] | Source,
    target: str,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
) -> Migration:
    """The changes of a model that another Gazebo requires; nothing is written.

    Args:
        target: one of ``urdfkit.ros.targets.GAZEBO``.
        packages: directories of ROS packages by name.
        trust: do not sandbox the expressions of the model, and let it read any file.

    Raises:
        UnreadableFile: the file cannot be read.
        UnknownTarget: the target is unknown.
    """
    report = check(
        path,
        arguments=arguments,
        packages=packages,
        select=[rule.code for rule in all_rules() if rule.migrates],
        ignore=(NOT_CHECKED,),  # reported as `unread`
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
    unread = {skip.path: skip.reason for skip in report.skipped if skip.reason != DEFINES_NO_LINK}
    return Migration(texts, tuple(left), tuple(renamed), unread)


def _overlaps(diagnostic: Diagnostic, edits: dict[Source, list[Edit]]) -> bool:
    """True if a fix overlaps other edits."""
    assert diagnostic.fix is not None
    return any(
        edit.span.start < other.span.end and other.span.start < edit.span.end
        for edit in diagnostic.fix.edits
        for other in edits.get(edit.span.source, ())
    )
