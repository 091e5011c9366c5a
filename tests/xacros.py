"""Writing xacro files in tests."""

from pathlib import Path

from urdfkit.lint import engine
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Source

NAMESPACE = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
HEAD = f'<robot name="r" {NAMESPACE}>'


def xacro(body: str, name: str = ' name="r"') -> str:
    """A xacro file; its body begins in line 2."""
    return f"<robot{name} {NAMESPACE}>\n{body}\n</robot>\n"


def reported(code: str, body: str, **arguments: str) -> list[Diagnostic]:
    """What a rule says about the body of a xacro."""
    source = Source("robot.xacro", xacro(body).encode())
    report = engine.check(source, select=[code], arguments=arguments)
    assert report.crashed == ()
    return [found for found in report.diagnostics if found.code.startswith(code)]


def codes(body: str, **arguments: str) -> list[str]:
    """The codes of everything from the families XML and XAC about the body of a xacro."""
    source = Source("robot.xacro", xacro(body).encode())
    report = engine.check(source, select=["XML", "XAC"], arguments=arguments)
    assert report.crashed == ()
    return [one.code for one in report.diagnostics]


def write(directory: Path, **bodies: str) -> None:
    """xacro files ``<name>.xacro``; one called ``robot`` has a name, the others have none."""
    for name, body in bodies.items():
        text = xacro(body) if name == "robot" else xacro(body, "")
        (directory / f"{name}.xacro").write_text(text, encoding="utf-8")


def told_of(code: str, file: Path, **arguments: str) -> list[Diagnostic]:
    """What a rule says about a file."""
    report = engine.check(file, select=[code], arguments=arguments)
    assert report.crashed == ()
    return [found for found in report.diagnostics if found.code.startswith(code)]


def marked(found: list[Diagnostic]) -> list[tuple[int, str]]:
    """Line and text of each place."""
    return [(one.span.line, one.span.text) for one in found]
