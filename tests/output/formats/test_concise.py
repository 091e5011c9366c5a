from tests.output.formats.made import diagnostic, report, span
from urdfkit.lint.report import Crashed
from urdfkit.output import formats
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

render = formats.get("concise")

AT = span(Source("robot.urdf", b"<robot/>"), "robot")


def test_a_finding_is_one_line_however_long() -> None:
    found = diagnostic(AT, message="word " * 60 + "end", help="do", severity=Severity.INFO)
    assert render(report(found, diagnostic(AT)), width=40) == (
        f"robot.urdf:1:2: info ABC123 {'word ' * 60}end\n"
        "robot.urdf:1:2: warning ABC123 link 'arm': 2 m is over 1 m\n"
        "1 warning, 1 info in 1 file\n"
    )


def test_a_crash_is_one_line() -> None:
    crashed = (Crashed("ABC001", "a.urdf", "ValueError: boom"),)
    assert render(report(crashed=crashed)).splitlines()[0].startswith("a.urdf: ABC001 failed")


def test_colours_only_when_asked_for() -> None:
    assert "\x1b[1;33mwarning\x1b[0m" in render(report(diagnostic(AT)), color=True)
