"""Rules in preview, and findings that are less sure than was asked for."""

import pytest

from urdfkit import check
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Confidence
from urdfkit.text.source import Source

ROBOT = Source(
    "r.urdf",
    b"""<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/><axis xyz="1 0 0"/></joint>
</robot>
""",
)
WHOLE = frozenset({"JNT020"})


@pytest.fixture
def in_preview(monkeypatch: pytest.MonkeyPatch) -> None:
    get = rule_index.get
    made = get("JNT020")._replace(preview=True)
    monkeypatch.setattr(rule_index, "get", lambda code: made if code == "JNT020" else get(code))


@pytest.mark.usefixtures("in_preview")
@pytest.mark.parametrize(
    ("options", "is_run"),
    [
        ({}, False),
        ({"select": ["JNT"]}, False),
        ({"select": ["JNT020"]}, True),
        ({"select": ["axis-on-fixed"]}, True),
        ({"preview": True}, True),
        ({"preview": ["JNT020"]}, True),
        ({"preview": ["JNT021"], "select": ["JNT020"]}, False),
        ({"config": Config(preview=True)}, True),
        ({"config": Config(select=WHOLE)}, False),
        ({"config": Config(select=WHOLE, named=WHOLE)}, True),
    ],
)
def test_a_rule_in_preview_runs_where_it_is_asked_for(
    options: dict[str, object], is_run: bool
) -> None:
    report = check(ROBOT, options=Options(**options))  # type: ignore[arg-type]
    assert ("JNT020" in report.rules) is is_run
    assert any(found.code == "JNT020" for found in report.diagnostics) is is_run


@pytest.mark.parametrize("confidence", Confidence)
@pytest.mark.parametrize("least", Confidence)
def test_min_confidence(
    confidence: Confidence, least: Confidence, monkeypatch: pytest.MonkeyPatch
) -> None:
    rule = rule_index.get("JNT020")
    made = rule._replace(
        check=lambda context: (
            found._replace(confidence=confidence) for found in rule.check(context)
        )
    )
    monkeypatch.setattr(rule_index, "get", lambda code: made)
    report = check(
        ROBOT, select=["JNT020"], ignore=["CFG003"], options=Options(min_confidence=least.value)
    )
    order = ["measured", "inferred", "guessed"]
    assert bool(report.diagnostics) is (order.index(confidence.value) <= order.index(least.value))
