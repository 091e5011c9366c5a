"""State of the check that the rules are part of."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Diagnostic


class RunState(Record):
    """State of a check, which the runner sets."""

    #: Configured options of rules, by code and name.
    rule_options: Mapping[str, Mapping[str, float]] = {}
    #: Findings of the other rules, before suppression; for the rules about the checking.
    diagnostics: tuple[Diagnostic, ...] = ()
    chosen: frozenset[str] | None = None  # codes of all rules; None until the others have run
