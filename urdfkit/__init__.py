"""Check robot models in URDF and xacro, with every finding at its true place.

>>> import urdfkit
>>> report = urdfkit.check("models/gazebo_pkg/urdf/waking_robot_new.xacro", select=["MSH"])
>>> for diagnostic in report.diagnostics:
...     print(diagnostic.span, diagnostic.severity.value, diagnostic.code)
models/gazebo_pkg/urdf/waking_robot_new.xacro:266:25 error MSH001
>>> urdfkit.load("models/good/gripper.urdf").degrees_of_freedom
1

Every name below is imported when it is first used: ``import urdfkit`` alone costs nothing.
"""

from __future__ import annotations

__version__ = "0.1.0"

__all__ = [
    "Call",
    "Comparison",
    "Confidence",
    "Diagnostic",
    "Dynamics",
    "Edit",
    "Fix",
    "Fixes",
    "Formatted",
    "Related",
    "Report",
    "RobotModel",
    "Rule",
    "Severity",
    "Source",
    "Span",
    "Subject",
    "Tolerances",
    "UnreadableRobot",
    "UrdfkitError",
    "Xacro",
    "all_rules",
    "check",
    "collisions",
    "compare",
    "expand",
    "find_rule",
    "fix",
    "format_files",
    "frames",
    "load",
    "mass_properties",
    "pose",
    "read",
    "report",
    "stand",
    "statics",
    "summarise",
    "to_yourdfpy",
    "transform",
]

TYPE_CHECKING = False  # type checkers take it for True; importing typing costs 8 ms

if TYPE_CHECKING:
    from urdfkit.collision.sampling import collisions
    from urdfkit.comparison import Comparison, compare
    from urdfkit.diagnostic import (
        Call,
        Confidence,
        Diagnostic,
        Edit,
        Fix,
        Related,
        Report,
        Severity,
    )
    from urdfkit.differences import Tolerances
    from urdfkit.dynamics.robot import Dynamics
    from urdfkit.dynamics.statics import statics
    from urdfkit.engine import check
    from urdfkit.errors import UnreadableRobot, UrdfkitError
    from urdfkit.exchange import to_yourdfpy
    from urdfkit.expansion import Xacro
    from urdfkit.fixing import Fixes, fix
    from urdfkit.formatting import Formatted, format_files
    from urdfkit.loading import expand, load, read
    from urdfkit.mass_table import mass_properties
    from urdfkit.mechanics.kinematics import frames, transform
    from urdfkit.mechanics.stability import stand
    from urdfkit.model import RobotModel
    from urdfkit.overview import summarise
    from urdfkit.page.writing import report
    from urdfkit.poses import pose
    from urdfkit.rules import Rule, all_rules, find_rule
    from urdfkit.source import Source, Span
    from urdfkit.subject import Subject

_HOMES = {
    "collision.sampling": "collisions",
    "comparison": "Comparison compare",
    "diagnostic": "Call Confidence Diagnostic Edit Fix Related Report Severity",
    "differences": "Tolerances",
    "dynamics.robot": "Dynamics",
    "dynamics.statics": "statics",
    "engine": "check",
    "errors": "UnreadableRobot UrdfkitError",
    "exchange": "to_yourdfpy",
    "expansion": "Xacro",
    "fixing": "Fixes fix",
    "formatting": "Formatted format_files",
    "loading": "expand load read",
    "mass_table": "mass_properties",
    "mechanics.kinematics": "frames transform",
    "mechanics.stability": "stand",
    "model": "RobotModel",
    "overview": "summarise",
    "page.writing": "report",
    "poses": "pose",
    "rules": "Rule all_rules find_rule",
    "source": "Source Span",
    "subject": "Subject",
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
