"""Findings about a robot: severities, edits, fixes, problems, diagnostics."""

from __future__ import annotations

from enum import Enum

from urdfkit.core.record import Record
from urdfkit.text.document import CallFrame, Step
from urdfkit.text.source import Span


class Severity(str, Enum):
    """Severity of a finding.

    ``error``: a mainstream program rejects the robot or simulates it wrongly;
    ``warning``: it loads but is probably not intended; ``info``: style or a hint.
    """

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"

    @property
    def rank(self) -> int:
        """0 for the most severe."""
        return _RANKS[self]


_RANKS = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.INFO: 2}


class Confidence(str, Enum):
    """Confidence of a finding: a fact, a conclusion from several facts, or a guess."""

    MEASURED = "measured"
    INFERRED = "inferred"
    GUESSED = "guessed"

    @property
    def rank(self) -> int:
        """0 for the most certain."""
        return _CONFIDENCE_RANKS[self]


_CONFIDENCE_RANKS = {level: rank for rank, level in enumerate(Confidence)}

#: Start of the message about a file that CMake creates: ``configure_file``, ``xacro_add_files``.
NOT_BUILT = "the build has not created the file"
#: Start of the message about a file that a script creates, as git ignores it.
NOT_CREATED = "git ignores the file, which does not exist"


class Edit(Record):
    """Replacement of the text of a span; an empty span inserts."""

    span: Span
    text: str


class Fix(Record):
    """A fix as text edits. ``safe``: it cannot change what the robot does."""

    title: str
    edits: tuple[Edit, ...]
    safe: bool = False

    @classmethod
    def of(cls, title: str, edits: tuple[Edit, ...] | None) -> Fix | None:
        """The fix that makes the edits; None if there are none."""
        return cls(title, edits) if edits else None


class Related(Record):
    """A second location that explains a finding."""

    span: Span
    message: str


class Problem(Record):
    """A defect in the text of a description."""

    code: str  # the rule that explains it
    span: Span
    message: str
    help: str = ""  # how to fix it; the rule's own help if empty
    frame: CallFrame | None = None  # the macro calls and includes that led there
    related: tuple[Related, ...] = ()
    fix: Fix | None = None
    severity: Severity | None = None  # overrides the severity of the rule
    argument: str = ""  # the xacro argument without a value, if that is the problem


class Call(Record):
    """One expansion of a macro body or an included file that caused a finding.

    Attributes:
        message: with the values of this call.
        via: the trace of calls, outermost first.
        element: path of the element after expansion.
    """

    message: str
    via: tuple[Step, ...]
    element: str


class Diagnostic(Record):
    """One finding as it is reported to the user.

    Attributes:
        code: such as ``MSH001``; never reused or renamed.
        name: such as ``missing-file``.
        severity: after configuration.
        message: element, value and bound.
        span: the source text to edit.
        calls: the expansions of this source text, worst first; one for a plain element.
        related: other locations that explain it.
        help: how to fix it.
        targets: the consumers that the severity applies to; empty for all.
        group_key: equal for findings of one rule that are shown as one if there are many; if empty,
            those that differ in names and numbers alone are.
        variants: names of the affected variants of the robot, or its assumed arguments; empty if
            all are affected.
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
    group_key: str = ""
    variants: tuple[str, ...] = ()

    @property
    def message_with_variants(self) -> str:
        """The message with the variants in parentheses, for formats that have no place for them."""
        variants = f" (variants: {', '.join(self.variants)})" if self.variants else ""
        return self.message + variants

    @property
    def text(self) -> str:
        """The message with the variants, and the help below it."""
        return "\n".join(filter(None, (self.message_with_variants, self.help)))

    @property
    def element(self) -> str:
        """Path of the first element after expansion; empty if there is none."""
        return self.calls[0].element if self.calls else ""
