"""What urdfkit reports about a robot: severities, edits, fixes, problems, diagnostics."""

from __future__ import annotations

from enum import Enum

from urdfkit.core.record import Record
from urdfkit.text.document import CallFrame, Step
from urdfkit.text.source import Span


class Severity(str, Enum):
    """How bad a finding is.

    ``error``: a mainstream program rejects the robot or simulates it wrongly;
    ``warning``: it loads but is probably not intended; ``info``: style or a hint.
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

    @property
    def rank(self) -> int:
        """0 for the surest."""
        return _CONFIDENCE_RANKS[self]


_CONFIDENCE_RANKS = {one: rank for rank, one in enumerate(Confidence)}


class Edit(Record):
    """Replace the text of a span; an empty span inserts."""

    span: Span
    text: str


class Fix(Record):
    """A fix as text edits. ``safe``: it cannot change what the robot does."""

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


class Problem(Record):
    """Something wrong with the text of a description."""

    code: str  # the rule that explains it
    span: Span  # where
    message: str  # what
    help: str = ""  # what to do; the rule's own help if empty
    frame: CallFrame | None = None  # the macro calls and includes that led there
    related: tuple[Related, ...] = ()  # other places that explain it
    fix: Fix | None = None  # as text edits
    severity: Severity | None = None  # if it is not that of the rule
    argument: str = ""  # the xacro argument that has no value there, if that is the problem


class Call(Record):
    """One expansion of a macro body or an included file that caused a finding.

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
        calls: the expansions that arrived there, worst first; one for a plain element.
        related: other places that explain it.
        help: what to do.
        fix: as text edits, or None.
        targets: the consumers that the severity is for; empty if it is for all.
        group_key: the same for findings of one rule that are shown as one where they are many.
        variants: names of the variants of the robot that it is found in, or its assumed arguments;
            empty if it is in all.
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
    def element(self) -> str:
        """Path of the (first) element after expansion; empty where there is none."""
        return self.calls[0].element if self.calls else ""
