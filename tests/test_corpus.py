"""Real robots: what independent tools measured, what the rules find, and that nothing crashes."""

import math
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from tests import update_corpus_findings as corpus_findings
from tests.conftest import CORPUS, CorpusRobot, manifest, model_id, needs_corpus
from urdfkit.errors import UrdfkitError
from urdfkit.lint import engine
from urdfkit.lint.context import Context
from urdfkit.lint.report import Crashed
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

pytestmark = [needs_corpus, pytest.mark.usefixtures("only_the_corpus")]

ENTRIES = list(manifest())
#: Two tests of the urdf package that no XML reader takes.
NOT_XML = {"fail_pr2_desc_no_joint2.urdf", "fail_three_links_one_joint.urdf"}
READABLE = [
    entry for entry in ENTRIES if "expect" in entry.facts and entry.path.name not in NOT_XML
]
#: Models that stock xacro does not expand, and the rule that says why.
REFUSED = [entry for entry in ENTRIES if entry.facts.get("expands") is False]
REASONS = {
    "external-package-missing": "XAC011",
    "required-argument": "XAC010",
    "unknown-macro": "XAC001",
    "include-missing": "XAC001",
}
#: Degrees of freedom as the corpus counts them; a planar joint is one axis to most readers.
FREEDOM = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 1, "floating": 6}


@pytest.mark.parametrize("entry", READABLE, ids=model_id)
def test_the_model_is_as_independent_tools_measured_it(entry: CorpusRobot) -> None:
    context = entry.alone
    robot, expected = context.model, entry.facts["expect"]
    masses = [
        link.inertial.mass.value for link in robot.links if link.inertial and link.inertial.mass
    ]
    assert len(robot.links) == expected["links"]
    assert len(robot.joints) == expected["joints"]
    assert sum(FREEDOM.get(joint.kind, 0) for joint in robot.joints) == expected["dof"]
    assert math.fsum(masses) == pytest.approx(expected["total_mass_kg"], rel=1e-9, abs=1e-12)
    children = {joint.child.value for joint in robot.joints if joint.child}
    roots = [link.name for link in robot.links if link.name not in children]
    assert roots == expected["root_links"]
    ends = [context.tree.ends(joint) for joint in robot.joints]
    if all(pair and pair[0] != pair[1] for pair in ends):
        assert [root.name for root in context.tree.roots] == roots


@pytest.mark.parametrize("entry", REFUSED, ids=model_id)
def test_the_reason_why_xacro_refuses_a_model_is_reported(entry: CorpusRobot) -> None:
    # A check takes values for arguments from around the file.
    context = Context(Source.read(entry.path), Resolver(), entry.arguments)
    found = {problem.code for problem in context.reading.problems}
    assert REASONS[entry.facts["expand_error_class"]] in found


@pytest.mark.parametrize("name", sorted(NOT_XML))
def test_what_is_no_xml(name: str) -> None:
    (file,) = CORPUS.rglob(name)
    report = engine.check(file)
    assert "XML001" in {one.code for one in report.diagnostics}


@pytest.mark.parametrize("entry", ENTRIES, ids=model_id)
def test_the_findings_are_those_that_were_read(entry: CorpusRobot) -> None:
    report = corpus_findings.report_on(entry)
    assert report.crashed == ()
    now = corpus_findings.counts(report)
    before = corpus_findings.read().get(str(entry), {})
    for skipped in report.skipped:  # what it needs is not installed
        before.pop(skipped.code, None)
    if any(skipped.code == "MSH015" for skipped in report.skipped):
        # These rules look at meshes where they can be measured, and else at primitives alone.
        now, before = (
            {c: n for c, n in counts.items() if not c.startswith("INE") and c != "GEO004"}
            for counts in (now, before)
        )
    changes = [
        f"{code}: {before.get(code, 0)} -> {now.get(code, 0)}"
        for code in sorted({*before, *now})
        if before.get(code) != now.get(code)
    ]
    reported = "\n".join(
        f"{one.span}: {one.code} {one.message}"
        for one in report.diagnostics
        if now.get(one.code, 0) > before.get(one.code, 0)
    )
    assert not changes, f"{', '.join(changes)}; python -m tests.update_corpus_findings\n{reported}"


def test_every_model_has_its_findings() -> None:
    assert set(corpus_findings.read()) == {str(entry) for entry in ENTRIES}


FILES = sorted(path for path in CORPUS.rglob("*") if path.suffix in (".urdf", ".xacro"))
MODELS = {entry.path for entry in ENTRIES}


@cache
def alone(file: Path) -> tuple[tuple[Crashed, ...], tuple[str, ...]]:
    """The rules that crash on a file alone, and the codes of its errors."""
    report = engine.check(file)
    errors = (one.code for one in report.diagnostics if one.severity is Severity.ERROR)
    return report.crashed, tuple(errors)


@pytest.mark.parametrize(
    "file", [path for path in FILES if path not in MODELS], ids=lambda p: str(p.relative_to(CORPUS))
)
def test_no_rule_crashes_on_a_file_alone(file: Path) -> None:
    try:
        crashed, _ = alone(file)
    except UrdfkitError as error:
        pytest.fail(f"cannot be checked: {error}")
    assert crashed == ()


#: Errors of maintained parts and libraries when they are checked alone: none for what their users
#: define. What remains are four includes without their prefix, a test of xacro's that is not XML,
#: and one of a bug of xacro.
ERRORS_ALONE = {"XAC001": 1, "XAC002": 4, "XML001": 1}


def test_parts_and_libraries_checked_alone_are_calm() -> None:
    found = Counter(code for file in FILES if file not in MODELS for code in alone(file)[1])
    assert found == ERRORS_ALONE
