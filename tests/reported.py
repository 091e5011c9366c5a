"""Running one rule on a robot in a test, through the engine as a user runs it."""

from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.source import Source


def reported(
    code: str, text: str | bytes, path: str = "robot.urdf", targets: tuple[str, ...] = ()
) -> list[Diagnostic]:
    """What a rule says about a robot, or about the inside of one; bytes are a whole file."""
    data = whole_robot(text).encode() if isinstance(text, str) else text
    report = engine.check(Source(path, data), select=[code], targets=targets)
    assert report.crashed == ()
    return [found for found in report.diagnostics if found.code.startswith(code)]


def messages(
    code: str, text: str, path: str = "robot.urdf", targets: tuple[str, ...] = ()
) -> list[str]:
    """The messages of a rule about a robot, in the order of the file."""
    return [diagnostic.message for diagnostic in reported(code, text, path, targets)]


def places(code: str, text: str, path: str = "robot.urdf") -> list[tuple[int, str]]:
    """Line and text of the places that a rule points at; line 1 is ``<robot>`` for a piece."""
    return [(found.span.line, found.span.text) for found in reported(code, text, path)]


def fixed(code: str, text: str, path: str = "robot.urdf", targets: tuple[str, ...] = ()) -> str:
    """The robot after every fix that a rule offers."""
    found = reported(code, text, path, targets)
    edits = [edit for diagnostic in found if diagnostic.fix for edit in diagnostic.fix.edits]
    return apply_edits(whole_robot(text).encode(), dict.fromkeys(edits)).decode()
