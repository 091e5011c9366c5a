from tests.output.formats.made import diagnostic, report, span
from urdfkit.lint.report import Skipped
from urdfkit.output.formats.statistics import render
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

AT = span(Source("robot.urdf", b"<robot/>"), "robot")


def test_the_most_frequent_comes_first() -> None:
    often = diagnostic(AT, code="XYZ001", name="often")
    seldom = [
        diagnostic(AT, code=code, name="seldom", severity=Severity.ERROR)
        for code in ("ABC002", "ABC001")
    ]
    skipped = (Skipped("XYZ009", "robot.urdf", "not a xacro"),)
    assert (
        render(report(often, *seldom, often, skipped=skipped))
        == """\
     2  XYZ001  warning  often
     1  ABC001  error    seldom
     1  ABC002  error    seldom
2 errors, 2 warnings in 1 file (1 rule skipped: not a xacro)
"""
    )


def test_nothing_found() -> None:
    assert render(report()) == "no findings in 1 file\n"
