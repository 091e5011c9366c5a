"""The outcome of a check: findings, what was skipped, what failed."""

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


#: Why nothing but the text of a file of macros is checked.
DEFINES_NO_LINK = "defines no link; check a robot that uses it"


class Skipped(Record):
    """A rule that did not run, and why."""

    code: str
    path: str
    reason: str


class Launched(Record):
    """A robot that was checked with values for arguments that it lacks by itself."""

    path: str  # of the robot
    #: Of the launch file that gives them, or of the xacro file or directory they are from.
    launch: str
    arguments: dict[str, str]  # those that the robot lacks by itself


class Crashed(Record):
    """A rule that failed: a bug in urdfkit, never of the robot.

    The code is empty where what failed is a part of the check that is no rule.
    """

    code: str
    path: str
    error: str
    traceback: str = ""


def crash(code: str, path: str, error: Exception) -> Crashed:
    """What a failure that is being handled says; the code is empty where it is no rule's.

    Raises:
        NotEnoughMemory: it fails for nothing else.
    """
    if limits.lacks_memory(error):
        raise NotEnoughMemory(f"{shown(path)}: not enough memory") from error
    from traceback import format_exc  # 9 ms

    return Crashed(code, path, f"{type(error).__name__}: {error}", format_exc())


class Fixable(Record):
    """What ``urdfkit fix`` would do about the findings of a report."""

    safe: int  # how many it fixes
    unsafe: int  # how many more it may fix with ``--unsafe-fixes``
    infos: tuple[str, ...]  # the codes of infos that it fixes where they are selected
    #: Why others are left though they carry a fix, each with their number.
    left: tuple[tuple[str, int], ...]


class Superseded(Record):
    """Findings that follow from others, which are reported in their place."""

    causes: tuple[Diagnostic, ...]  # the others, without what merging adds to them
    findings: tuple[Diagnostic, ...]  # what is not reported


class Report(Record):
    """The outcome of a check.

    Attributes:
        files: that were checked, as the user named them.
        diagnostics: sorted by file, place and code.
        skipped: rules that did not run.
        crashed: rules that failed.
        rules: the codes that ran.
        targets: per file, the programs that severities depend on.
        tolerated: how many findings a baseline holds.
        suppressed: how many findings ignore comments or the configuration leave out.
        errors: those of each description, in the order of the check; what several have in common
            is one diagnostic, but an error of each.
        proposals: the edits that the fixes of each description ask for.
        launched: the robots that have their arguments from launch files, or from elsewhere.
        unknown_arguments: those given that no description mentions, each with the one that was
            meant, or nothing.
        unknown_in_config: the same of arguments in the configuration, each after the words
            that say which robot has none.
        fixable: what ``urdfkit fix`` would do; None if it was not computed.
        superseded: what is not reported because its cause is, of each description that has some.
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
        """How many diagnostics have this severity."""
        if isinstance(self.diagnostics, StoredFindings):
            return self.diagnostics.counts[severity]
        return sum(1 for diagnostic in self.diagnostics if diagnostic.severity is severity)

    @property
    def argument_typos(self) -> tuple[str, ...]:
        """The arguments that no description has, in words: a robot is not the one that is meant."""
        unknown = (("No robot here has an", *one) for one in self.unknown_arguments)
        return tuple(
            f"{which} argument '{name}'" + (f"; did you mean '{meant}'?" if meant else "")
            for which, name, meant in (*unknown, *self.unknown_in_config)
        )

    @property
    def ok(self) -> bool:
        """True if there is no error and no warning, and no rule crashed."""
        return self.exit_code() == 0

    def exit_code(self, fail_on: Severity = Severity.WARNING) -> int:
        """0 clean, 1 findings of ``fail_on`` or worse, 3 a bug in urdfkit."""
        if self.crashed:
            return 3
        return int(any(self.count(one) for one in Severity if one.rank <= fail_on.rank))


class UncheckedValues(Record):
    """Values of an argument with which a robot is not checked, though files give them."""

    name: str  # of the argument
    values: tuple[str, ...]  # of it
    total: int  # how many values it has
    why: str  # they are left out
