"""What urdfkit says about a robot: severities, edits, diagnostics, the report."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.text.document import Step
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.ros.targets import Targets


class Severity(str, Enum):
    """How bad a finding is.

    ``error``: a mainstream consumer rejects the robot or simulates it wrongly;
    ``warning``: it loads but is hardly meant; ``info``: style or a hint.
    """

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"

    @property
    def rank(self) -> int:
        """0 for the worst."""
        return _RANKS[self]


_RANKS = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.INFO: 2}


class Confidence(str, Enum):
    """How sure a finding is: a fact, a conclusion from several facts, or a guess."""

    MEASURED = "measured"
    INFERRED = "inferred"
    GUESSED = "guessed"


class Edit(Record):
    """Replace the text of a span; an empty span inserts."""

    span: Span
    text: str


class Fix(Record):
    """A remedy as text edits. ``safe``: it cannot change what the robot does."""

    title: str
    edits: tuple[Edit, ...]
    safe: bool = False

    @classmethod
    def of(cls, title: str, edits: tuple[Edit, ...] | None) -> Fix | None:
        """The fix that makes some edits; None where they cannot be made."""
        return cls(title, edits) if edits else None


class Related(Record):
    """Another place that explains a finding."""

    span: Span
    message: str


class Call(Record):
    """One way in which a macro body or an included file caused a finding.

    Attributes:
        message: with the numbers of this call.
        via: the calls, outermost first.
        element: path of the element after expansion.
    """

    message: str
    via: tuple[Step, ...]
    element: str


class Diagnostic(Record):
    """One finding as a user reads it.

    Attributes:
        code: such as ``MSH001``; never reused or renamed.
        name: such as ``missing-file``.
        severity: after configuration.
        confidence: how sure it is.
        message: who, how much, what bound.
        span: the place in the file that a person edits.
        calls: the ways in which expansion arrived there, worst first; one for a plain element.
        related: other places that explain it.
        help: what to do.
        fix: a remedy as text edits, or None.
        targets: the consumers that the severity is for; empty if it is for all.
        alike: the same for findings of one rule that people are shown as one where they are many.
        variants: names of the variants of the robot that it is found in; empty if it is in all.
    """

    code: str
    name: str
    severity: Severity
    confidence: Confidence
    message: str
    span: Span
    calls: tuple[Call, ...]
    related: tuple[Related, ...]
    help: str
    fix: Fix | None
    targets: tuple[str, ...] = ()
    alike: str = ""
    variants: tuple[str, ...] = ()

    @property
    def element(self) -> str:
        """Path of the (first) element after expansion; empty where there is none."""
        return self.calls[0].element if self.calls else ""


class Skipped(Record):
    """A rule that did not run, and why."""

    code: str
    path: str
    reason: str


class Launched(Record):
    """A robot that was checked with values for arguments that it lacks by itself.

    Attributes:
        path: of the robot.
        launch: of the launch file that gives them, or of the xacro file or folder they are from.
        arguments: those that the robot lacks by itself.
    """

    path: str
    launch: str
    arguments: dict[str, str]


class Crashed(Record):
    """A rule that failed: a bug of urdfkit, never of the robot.

    The code is empty where what failed is a part of the check that is no rule.
    """

    code: str
    path: str
    error: str
    traceback: str = ""


class Fixable(Record):
    """What ``urdfkit fix`` would do about the findings of a report.

    Attributes:
        safe: how many it fixes.
        unsafe: how many more it may fix with ``--unsafe-fixes``.
        infos: the codes of infos that it fixes where they are selected.
        left: why others are left though they carry a fix, each with their number.
    """

    safe: int
    unsafe: int
    infos: tuple[str, ...]
    left: tuple[tuple[str, int], ...]


class Report(Record):
    """The outcome of a check.

    Attributes:
        files: that were checked, as the user named them.
        diagnostics: sorted by file, place and code.
        skipped: rules that did not run.
        crashed: rules that failed.
        rules: the codes that ran.
        targets: per file, the consumers that severities were weighed for.
        tolerated: how many findings a baseline holds.
        suppressed: how many findings ignore comments or the configuration leave out.
        errors: those of each description, in the order of the check; what several have in common
            is one diagnostic, but an error of each.
        proposals: the edits that the fixes of each description ask for.
        launched: the robots that have their arguments from launch files, or from elsewhere.
        unknown_arguments: those given that no description mentions, each with the one that was
            meant, or nothing.
        fixable: what ``urdfkit fix`` would do; None where nobody asked.
    """

    files: tuple[str, ...]
    diagnostics: tuple[Diagnostic, ...]
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
    fixable: Fixable | None = None

    def count(self, severity: Severity) -> int:
        """How many diagnostics have this severity."""
        return sum(1 for diagnostic in self.diagnostics if diagnostic.severity is severity)

    @property
    def ok(self) -> bool:
        """True if there is no error and no warning, and no rule crashed."""
        return self.exit_code() == 0

    def exit_code(self, fail_on: Severity = Severity.WARNING) -> int:
        """0 clean, 1 findings of ``fail_on`` or worse, 3 a bug of urdfkit."""
        if self.crashed:
            return 3
        return int(any(d.severity.rank <= fail_on.rank for d in self.diagnostics))
