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
    "Context",
    "Diagnostic",
    "Dynamics",
    "Edit",
    "Fix",
    "Fixes",
    "Formatted",
    "Options",
    "Related",
    "Report",
    "RobotModel",
    "Rule",
    "Severity",
    "Source",
    "Span",
    "Tolerances",
    "UnreadableRobot",
    "UrdfkitError",
    "Xacro",
    "all_rules",
    "bundle",
    "check",
    "collisions",
    "compare",
    "convert",
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
    "simulate",
    "stand",
    "statics",
    "summarise",
    "to_yourdfpy",
    "transform",
]

TYPE_CHECKING = False  # type checkers take it for True; importing typing costs 8 ms

if TYPE_CHECKING:
    from urdfkit.errors import UnreadableRobot, UrdfkitError
    from urdfkit.lint.context import Context
    from urdfkit.lint.engine import check
    from urdfkit.lint.fix import fix
    from urdfkit.lint.fix_session import Fixes
    from urdfkit.lint.formatting import Formatted, format_files
    from urdfkit.lint.loading import expand, load, read
    from urdfkit.lint.options import Options
    from urdfkit.lint.report import Report
    from urdfkit.lint.rule_index import all_rules, find_rule
    from urdfkit.lint.rules import Rule
    from urdfkit.output.bundle.writing import bundle
    from urdfkit.output.comparison import Comparison, compare
    from urdfkit.output.comparison.differences import Tolerances
    from urdfkit.output.conversion import convert
    from urdfkit.output.exchange import to_yourdfpy
    from urdfkit.output.mass_table import mass_properties
    from urdfkit.output.overview import summarise
    from urdfkit.output.report.writing import report
    from urdfkit.output.simulation import simulate
    from urdfkit.physics.collision.sampling import collisions
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.physics.dynamics.statics import statics
    from urdfkit.physics.poses import pose
    from urdfkit.robot.kinematics import frames, transform
    from urdfkit.robot.model import RobotModel
    from urdfkit.robot.stability import stand
    from urdfkit.text.diagnostic import Call, Confidence, Diagnostic, Edit, Fix, Related, Severity
    from urdfkit.text.source import Source, Span
    from urdfkit.xacro import Xacro

_HOMES = {
    "physics.collision.sampling": "collisions",
    "output.bundle.writing": "bundle",
    "output.comparison": "Comparison compare",
    "output.conversion": "convert",
    "output.simulation": "simulate",
    "text.diagnostic": "Call Confidence Diagnostic Edit Fix Related Severity",
    "output.comparison.differences": "Tolerances",
    "physics.dynamics.robot": "Dynamics",
    "physics.dynamics.statics": "statics",
    "lint.engine": "check",
    "errors": "UnreadableRobot UrdfkitError",
    "output.exchange": "to_yourdfpy",
    "xacro": "Xacro",
    "lint.fix": "fix",
    "lint.fix_session": "Fixes",
    "lint.formatting": "Formatted format_files",
    "lint.loading": "expand load read",
    "output.mass_table": "mass_properties",
    "robot.kinematics": "frames transform",
    "robot.stability": "stand",
    "robot.model": "RobotModel",
    "output.overview": "summarise",
    "output.report.writing": "report",
    "physics.poses": "pose",
    "lint.options": "Options",
    "lint.report": "Report",
    "lint.rule_index": "all_rules find_rule",
    "lint.rules": "Rule",
    "text.source": "Source Span",
    "lint.context": "Context",
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
