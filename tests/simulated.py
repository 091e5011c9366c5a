"""Rules about simulations in tests, through the engine as ``check --simulate`` runs them."""

import urdfkit
from urdfkit.lint import engine
from urdfkit.lint.options import Options
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Source


def simulated(text: str, *select: str) -> list[Diagnostic]:
    """The findings of some rules, by default of those about simulations, on a robot."""
    source = Source("robot.urdf", whole_robot(text).encode())
    options = Options(simulate=urdfkit.simulate)
    report = engine.check(source, select=select or ["SIM"], options=options)
    assert report.crashed == ()
    assert report.skipped == ()
    return list(report.diagnostics)


def codes(text: str, *select: str) -> list[str]:
    """Their codes, in the order of the file."""
    return [found.code for found in simulated(text, *select)]
