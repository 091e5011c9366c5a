"""What every rule promises, tried on the examples that it carries."""

import re
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

import pytest

import urdfkit
from tests import update_wording
from urdfkit.core.libraries import missing_for_meshes
from urdfkit.lint import engine, rule_examples, rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.lint.rules import Need, Rule
from urdfkit.text.diagnostic import Diagnostic, Severity

HERE = Path(__file__).parent

#: The parts of a Context that a rule may use for what it declares to need. The source, the
#: problems of reading and the targets are free.
PARTS = {
    Need.XACRO: ("xacro",),
    Need.MODEL: ("document", "deviations", "model", "tree"),
    Need.FILES: ("files",),
    Need.MESHES: ("files", "measured", "meshes"),
    Need.GAZEBO: {"gazebo", "plugins"},
    Need.LAUNCH: {"launch", "other_robot", "described_robots"},
    Need.SRDF: {"srdf"},
    Need.DYNAMICS: {"dynamics"},
    Need.COLLISIONS: {"collisions", "measured", "meshes", "files"},
    Need.SIMULATION: {"simulation"},
}

#: What rules of a family, or a rule, look at where it is to be had, and do without otherwise.
OPTIONAL = {family: {"files", "measured"} for family in ("INE", "GEO", "MSH")}
OPTIONAL |= {"XAC011": {"document", "files", "model"}, "XAC014": {"files", "measured", "xacro"}}
OPTIONAL |= {"XAC024": {"other_robot", "srdf"}}
#: Of a name that is misspelt, everything else that may have it.
OPTIONAL |= {code: {"plugins", "srdf"} for code in ("REF001", "GAZ001", "SRD001", "RCT001")}
#: The pairs that the SRDF, if there is one, disables.
OPTIONAL |= {"COL001": {"srdf"}, "SIM": {"files", "meshes", "srdf"}}
#: Of the robots that a launch file starts.
OPTIONAL |= {
    "LAU023": {"document", "model", "tree"},
    "WLD": {"document", "model", "plugins", "tree"},
}

#: Rules about the checking itself, and those that are nothing but our judgement of what is untidy.
OUR_OWN = {"CFG001", "CFG002", "CFG003", "MSH024"}

pytestmark = pytest.mark.parametrize("code", rule_index.codes())


@pytest.fixture(autouse=True)
def _what_it_needs(code: str) -> None:
    needs = rule_index.get(code).needs
    if Need.DYNAMICS in needs:
        pytest.importorskip("pinocchio")
    missing = missing_for_meshes()
    if missing and Need.MESHES in needs:
        pytest.skip(f"{missing} is not installed")
    if Need.COLLISIONS in needs:
        pytest.importorskip("coal")
    if Need.SIMULATION in needs:
        pytest.importorskip("mujoco")


def simulation(rule: Rule) -> Any:
    """What simulates the robot for a rule that needs it."""
    return urdfkit.simulate if Need.SIMULATION in rule.needs else None


def checked(rule: Rule, which: str) -> Report:
    """One of its examples, checked with all rules."""
    with rule_examples.laid_out(rule, example(rule, which)) as source:
        settings = Options(simulate=simulation(rule))
        return engine.check(source, targets=rule_examples.targets_of(rule), options=settings)


def alone(rule: Rule, which: str) -> list[Diagnostic]:
    """One of its examples, checked with this rule alone."""
    text = example(rule, which)
    return rule_examples.diagnose_example(rule, text, simulate=simulation(rule))


def example(rule: Rule, which: str) -> str:
    text = rule.example(which)
    assert text, f"{rule.module} has no {which}"
    return text


@cache
def of_bad(code: str) -> tuple[Diagnostic, ...]:
    """What a rule says about its BAD; several tests look at it."""
    return tuple(alone(rule_index.get(code), "BAD"))


def test_the_file_is_named_after_the_rule_and_has_tests(code: str) -> None:
    rule = rule_index.get(code)
    assert rule.code == code
    assert code in rule_index.names()[rule.name]
    family, name = rule_index.family_of(code), f"{code.lower()}_{rule.name.replace('-', '_')}"
    assert rule.module == f"urdfkit.checks.{family}.{name}"
    assert (HERE / family / f"test_{name}.py").is_file()


def test_the_explanation_begins_with_one_sentence_and_names_its_sources(code: str) -> None:
    first, blank, *rest = rule_index.get(code).explanation.split("\n")
    assert re.fullmatch(r"[A-Z`$].*[^.]\.", first)
    assert ". " not in first.replace("e.g. ", ""), "one sentence"
    assert blank == ""
    assert " ".join(rest).strip(), "what happens, in which program, and what to do"
    sources = rule_index.get(code).sources
    assert bool(sources) is (code not in OUR_OWN)
    for source in sources:
        assert re.fullmatch(r"(?!.*measured).+: https?://[^ ]+\w[^ ]*|measured: .*\d.*", source)
    assert len(set(sources)) == len(sources)


def test_bad_is_found(code: str) -> None:
    """By the rule alone, and among all others."""
    rule, found = rule_index.get(code), of_bad(code)
    assert found
    assert {(one.code, one.name) for one in found} == {(code, rule.name)}
    assert all(one.message and one.help for one in found), "a message and what to do"
    report = checked(rule, "BAD")
    among_others = [one for one in report.diagnostics if one.code == code]
    assert places(among_others) == sorted(places(found))
    assert report.crashed == ()


def test_what_is_said_about_bad(code: str) -> None:
    said = update_wording.wording(of_bad(code))
    assert said == update_wording.read().get(code), "if it is meant: python -m tests.update_wording"


def test_good_is_good(code: str) -> None:
    rule = rule_index.get(code)
    assert alone(rule, "GOOD") == []
    report = checked(rule, "GOOD")
    assert [found for found in report.diagnostics if found.severity is Severity.ERROR] == []
    assert report.crashed == ()


def test_the_fix_gives_fixed(code: str) -> None:
    rule = rule_index.get(code)
    if not rule.fixable:
        assert not any(one.fix for one in of_bad(code))
        assert rule.example("FIXED") is None
        return
    fixed = rule.example("FIXED")
    after = rule_examples.apply_fixes(rule, example(rule, "BAD"))
    assert after.pop("", None) == (rule_examples.whole_robot(fixed) if fixed else None)
    files = getattr(sys.modules[rule.module], "FIXED_FILES", {})
    assert after == {name: data.decode() for name, data in files.items()}
    assert after or fixed
    if fixed:
        assert rule_examples.diagnose_example(rule, fixed) == []


def test_the_rule_needs_no_more_than_it_declares(
    code: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    rule = rule_index.get(code)
    honest = places(of_bad(code))
    allowed = {part for need in rule.needs for part in PARTS[need]}
    allowed |= OPTIONAL.get(code, OPTIONAL.get(code[:3], set()))
    for part in {part for parts in PARTS.values() for part in parts} - allowed:
        monkeypatch.setattr(Context, part, property(refuse(code, part)))
    assert places(alone(rule, "BAD")) == honest


def places(diagnostics: Iterable[Diagnostic]) -> list[tuple[int, int]]:
    return [(found.span.start, found.span.end) for found in diagnostics]


def refuse(code: str, part: str) -> Any:
    def raise_(_: Context) -> NoReturn:
        pytest.fail(f"{code} uses {part} and does not declare it")

    return raise_
