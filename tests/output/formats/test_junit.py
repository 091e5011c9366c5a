"""JUnit XML, as an independent reader understands it."""

from typing import Any

import pytest

import urdfkit
from tests.conftest import MODELS
from tests.output.formats.made import diagnostic, report, span
from urdfkit.lint.report import Crashed, Skipped
from urdfkit.output.formats.junit import render
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

junitparser = pytest.importorskip("junitparser")

ONE = Source("one.urdf", b'<robot name="r">\n  <link name="arm"/>\n</robot>\n')
TWO = Source("two.urdf", b"<robot/>")


def read(text: str) -> Any:
    """What the reader makes of it; the counts that are written are those of the cases."""
    suites = junitparser.JUnitXml.fromstring(text.encode())
    for holder in [suites, *suites]:
        written = (holder.tests, holder.failures, holder.errors, holder.skipped)
        cases = [case for suite in (suites if holder is suites else [holder]) for case in suite]
        kinds = [type(case.result[0]) if case.result else None for case in cases]
        assert written == (
            len(cases),
            kinds.count(junitparser.Failure),
            kinds.count(junitparser.Error),
            kinds.count(junitparser.Skipped),
        )
    return suites


def cases(text: str) -> list[tuple[str, str, str, str]]:
    """Suite, case, outcome and message of all test cases."""
    reported = []
    for suite in read(text):
        for case in suite:
            assert case.classname == suite.name
            (result,) = case.result or [None]
            kind = type(result).__name__ if result else "passed"
            reported.append((suite.name, case.name, kind, result.message if result else ""))
    return reported


def test_variants_are_a_property() -> None:
    found = diagnostic(span(ONE, "arm"), variants=("left", "right"))
    case = next(iter(next(iter(read(render(report(found, files=())))))))
    named = [dict(one.attrib) for one in case._elem.iter("property")]
    assert named == [{"name": "variants", "value": "left, right"}]
    assert case.result[0].text.endswith("over 1 m (variants: left, right)")


def test_a_case_for_each_rule_of_each_file() -> None:
    text = render(
        report(
            diagnostic(span(ONE, "arm"), severity=Severity.ERROR, message="first"),
            diagnostic(span(ONE, "robot"), severity=Severity.ERROR, message="second"),
            diagnostic(span(ONE, "link"), code="ABC124", severity=Severity.INFO, message="hint"),
            files=("one.urdf", "two.urdf", "three.urdf"),
            skipped=(Skipped("ABC001", "two.urdf", "why not"), Skipped("", "lib.xacro", "a part")),
            crashed=(Crashed("ABC003", "two.urdf", "ValueError: boom", "Traceback ..."),),
        )
    )
    assert cases(text) == [
        ("one.urdf", "ABC123 some-defect", "Failure", "first"),
        ("one.urdf", "ABC124 some-defect", "passed", ""),
        ("two.urdf", "ABC001", "Skipped", "why not"),
        ("two.urdf", "ABC003", "Error", "ValueError: boom"),
        ("three.urdf", "check", "passed", ""),
        ("lib.xacro", "check", "Skipped", "a part"),
    ]


def test_all_findings_of_a_rule_are_in_the_text() -> None:
    suites = read(
        render(
            report(
                diagnostic(span(ONE, "arm"), severity=Severity.WARNING, message="first"),
                diagnostic(span(ONE, "link"), severity=Severity.WARNING, message="second"),
                diagnostic(span(ONE, "robot"), severity=Severity.INFO, message="hint"),
                files=("one.urdf",),
            )
        )
    )
    ((case,),) = suites
    (failure,) = case.result
    assert failure.type == "warning"
    assert failure.text == (
        "one.urdf:2:15: warning ABC123 first\none.urdf:2:4: warning ABC123 second"
    )
    assert case.system_out == "one.urdf:1:2: info ABC123 hint"
    assert case._elem.get("file") == "one.urdf"
    assert case._elem.get("line") == "2"


def test_a_clean_report_is_green() -> None:
    assert cases(render(report())) == [("robot.urdf", "check", "passed", "")]


def test_what_xml_cannot_hold_is_replaced() -> None:
    message = "a\x00b\x1b[31mc\ufffed\udcffe <&> \u202e 轮 🦾"
    source = Source("bad\udcff\x07.urdf", b"<robot/>")
    text = render(report(diagnostic(span(source, "robot"), message=message), files=()))
    ((suite, _, kind, reported),) = cases(text)
    assert (suite, kind) == ("bad??.urdf", "Failure")
    assert reported == "a?b?[31mcd?e <&> \u202e 轮 🦾"


@pytest.mark.parametrize("model", sorted(MODELS.rglob("*.urdf")), ids=lambda path: path.name)
def test_reports_of_the_models_can_be_read(model) -> None:
    checked = urdfkit.check(model)
    outcomes = [kind for _, _, kind, _ in cases(render(checked))]
    assert outcomes.count("Failure") == len(
        {d.code for d in checked.diagnostics if d.severity is not Severity.INFO}
    )


def test_a_robot_that_is_not_checked_is_skipped_with_every_reason() -> None:
    found = [diagnostic(span(ONE, "arm"), code="CFG003", message=one) for one in ("no", "nor")]
    skipped = (Skipped("MSH001", "one.urdf", "too much"), Skipped("", "one.urdf", "never"))
    for some in ((), skipped[:1], skipped):
        of_file = cases(render(report(*found, files=(), skipped=some)))
        assert [kind for *_, kind, _ in of_file] == ["Skipped"] * (1 + bool(some))
        assert "CFG003 no\n" in of_file[-1][3]
        assert "CFG003 nor\n" in of_file[-1][3]
