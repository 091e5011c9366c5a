"""CFG001: see the rule; ``tests/test_suppress.py`` has what comments do."""

import pytest

from tests.naming import naming
from urdfkit import check
from urdfkit.text.source import Source

ROBOT = """<robot name="r">
  <!-- urdfkit: ignore[{codes}] reason -->
  <link name="a"/>
</robot>
"""


def findings(codes: str, select: tuple[str, ...] = ()) -> list[tuple[str, str]]:
    report = check(Source("r.urdf", ROBOT.format(codes=codes).encode()), select=select)
    reported = [(found.code, found.message) for found in report.diagnostics]
    return [(code, message) for code, message in reported if code.startswith("CFG")]


def test_the_codes_that_hit_nothing_are_named():
    assert findings("TRE003, JNT") == [("CFG001", naming("unused", "TRE003"))]


@pytest.mark.parametrize(
    "comment", ["ignore[]", "ignore TRE003", "ignore", "ignore(TRE003)", "ignore[TRE003 reason"]
)
def test_a_comment_without_a_rule_in_brackets_hits_nothing(comment: str) -> None:
    text = f'<robot name="r"><!-- urdfkit: {comment} --><link name="a"/></robot>'
    report = check(Source("r.urdf", text.encode()), select=["CFG"])
    (found,) = report.diagnostics
    assert (found.code, found.message) == ("CFG001", naming("without"))
    assert found.fix is None


def test_a_sentence_is_no_ignore_comment() -> None:
    text = b'<robot name="r"><!-- urdfkit: ignores this --><link name="a"/></robot>'
    assert check(Source("r.urdf", text), select=["CFG"]).diagnostics == ()


def test_rules_that_were_not_run_are_not_missed():
    assert (
        findings(
            "TRE003",
            select=(
                "CFG",
                "JNT",
            ),
        )
        == []
    )


def test_an_unknown_code_is_not_reported_twice():
    assert [code for code, _ in findings("TRE999")] == ["CFG002"]
