"""The result of a check: findings, skipped rules and failed rules."""

from __future__ import annotations

from collections.abc import Sequence

from urdfkit.core import limits
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import NotEnoughMemory
from urdfkit.lint.finding_store import StoredFindings
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.ros.targets import Targets


#: Why only the text of a file of macros is checked.
DEFINES_NO_LINK = "defines no link; check a robot that uses it"
#: Why only the text of an SRDF is checked.
IS_SRDF = "is an SRDF; check the robots that it is for with --changed"


class Skipped(Record):
    """A rule that did not run, and the reason; without a code, a skipped description."""

    code: str
    path: str
    reason: str


class Launched(Record):
    """A robot that was checked with values for its arguments without a default."""

    path: str  # path of the robot
    launch: str  # path of the launch file, xacro file or directory that the values are from
    arguments: dict[str, str]  # values of the arguments without a default


class Crashed(Record):
    """A rule that failed: a bug in urdfkit, not a defect of the robot.

    The code is empty if another part of the check failed.
    """

    code: str
    path: str
    error: str
    traceback: str = ""


def crash(code: str, path: str, error: Exception) -> Crashed:
    """The record of an exception that is being handled; the code is empty outside of rules.

    Raises:
        NotEnoughMemory: the cause is a lack of memory.
    """
    if limits.lacks_memory(error):
        raise NotEnoughMemory(f"{shown(path)}: not enough memory") from error
    from traceback import format_exc  # 9 ms

    return Crashed(code, path, f"{type(error).__name__}: {error}", format_exc())


class Fixable(Record):
    """The number of findings of a report that ``urdfkit fix`` would fix."""

    safe: int  # number of findings that it fixes
    unsafe: int  # number of further findings that it may fix with ``--unsafe-fixes``
    infos: tuple[str, ...]  # codes of the infos that it fixes if they are selected
    left: tuple[tuple[str, int], ...]  # reasons why other fixes are not applied, and their number


class Superseded(Record):
    """Findings that are consequences of others, which are reported instead."""

    causes: tuple[Diagnostic, ...]  # the reported findings, before merging
    findings: tuple[Diagnostic, ...]  # the consequences, which are not reported


class Report(Record):
    """The result of a check.

    Attributes:
        files: the checked files, by the paths that the user passed.
        diagnostics: findings sorted by file, place and code.
        skipped: rules that did not run.
        crashed: rules that failed.
        rules: codes of the rules that ran.
        targets: per file, the targets that severities depend on.
        tolerated: number of findings in the baseline.
        suppressed: number of findings that ignore comments or the configuration suppress.
        errors: errors of each description, in the order of the check; a diagnostic that several
            descriptions share is an error of each.
        proposals: edits of the fixes of each description.
        launched: the robots whose missing arguments got values from launch files or other sources.
        unknown_arguments: arguments that no description declares, each with the suggested name,
            or an empty string.
        unknown_in_config: the same for arguments in the configuration, each after a clause that
            states the robot.
        fixable: number of fixes that ``urdfkit fix`` would apply; None if it was not computed.
        superseded: findings that are not reported because their cause is, by description.
    """

    files: tuple[str, ...]
    diagnostics: Sequence[Diagnostic]
    skipped: tuple[Skipped, ...]
    crashed: tuple[Crashed, ...]
    rules: tuple[str, ...]
    targets: tuple[tuple[str, Targets], ...] = ()
    suppressed: int = 0
    tolerated: int = 0
    errors: tuple[tuple[Diagnostic, ...], ...] = ()
    proposals: tuple[tuple[Edit, ...], ...] = ()
    launched: tuple[Launched, ...] = ()
    unknown_arguments: tuple[tuple[str, str], ...] = ()
    unknown_in_config: tuple[tuple[str, str, str], ...] = ()
    fixable: Fixable | None = None
    superseded: tuple[Superseded, ...] = ()

    def count(self, severity: Severity) -> int:
        """The number of diagnostics with a severity."""
        if isinstance(self.diagnostics, StoredFindings):
            return self.diagnostics.counts[severity]
        return sum(1 for diagnostic in self.diagnostics if diagnostic.severity is severity)

    @property
    def argument_typos(self) -> tuple[str, ...]:
        """Messages about arguments that no description declares."""
        unknown = (("No robot here has an", *item) for item in self.unknown_arguments)
        return tuple(
            f"{clause} argument '{name}'" + (f"; did you mean '{nearest}'?" if nearest else "")
            for clause, name, nearest in (*unknown, *self.unknown_in_config)
        )

    @property
    def ok(self) -> bool:
        """True if there is no error and no warning, and no rule crashed."""
        return self.exit_code() == 0

    def exit_code(self, fail_on: Severity = Severity.WARNING) -> int:
        """0 clean, 1 findings of ``fail_on`` or worse, 3 a bug in urdfkit."""
        if self.crashed:
            return 3
        severities = (severity for severity in Severity if severity.rank <= fail_on.rank)
        return int(any(map(self.count, severities)))


class UncheckedValues(Record):
    """Values of an argument in launch files with which a robot is not checked."""

    name: str  # name of the argument
    values: tuple[str, ...]  # values that are not checked
    total: int  # number of all values
    why: str  # reason for not checking them
