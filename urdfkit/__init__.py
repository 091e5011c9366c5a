"""Check robot models in URDF and xacro, with every finding at its true place.

::

    report = urdfkit.check("robot.urdf.xacro", arguments={"prefix": "left_"})
    for diagnostic in report.diagnostics:
        print(diagnostic.span, diagnostic.code, diagnostic.message)

Every name below is imported when it is first used: ``import urdfkit`` alone costs nothing.
"""

from __future__ import annotations

__version__ = "0.1.0"

__all__ = [
    "Call",
    "Confidence",
    "Crashed",
    "Diagnostic",
    "Edit",
    "Fix",
    "Related",
    "Report",
    "Rule",
    "Severity",
    "Skipped",
    "Source",
    "Span",
    "Step",
    "UrdfkitError",
    "all_rules",
    "check",
    "find_rule",
]

TYPE_CHECKING = False  # type checkers take it for True; importing typing costs 8 ms

if TYPE_CHECKING:
    from urdfkit.diagnostic import (
        Call,
        Confidence,
        Crashed,
        Diagnostic,
        Edit,
        Fix,
        Related,
        Report,
        Severity,
        Skipped,
    )
    from urdfkit.document import Step
    from urdfkit.engine import check
    from urdfkit.errors import UrdfkitError
    from urdfkit.rules import Rule, all_rules, find_rule
    from urdfkit.source import Source, Span

_HOMES = {
    "diagnostic": "Call Confidence Crashed Diagnostic Edit Fix Related Report Severity Skipped",
    "document": "Step",
    "engine": "check",
    "errors": "UrdfkitError",
    "rules": "Rule all_rules find_rule",
    "source": "Source Span",
}


def __getattr__(name: str) -> object:
    for module, names in _HOMES.items():
        if name in names.split():
            from importlib import import_module

            value: object = getattr(import_module(f"urdfkit.{module}"), name)
            globals()[name] = value
            return value
    raise AttributeError(f"module 'urdfkit' has no attribute '{name}'")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
