"""Finding rules by what a user types."""

import subprocess
import sys
from itertools import chain

import pytest

from tests.conftest import ROOT
from urdfkit.checks import APPLIES, CODES
from urdfkit.errors import UnknownRule
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.lint.options import choose


def test_codes_are_sorted_and_each_has_one_name() -> None:
    assert rule_index.codes() == sorted(set(rule_index.codes()))
    assert sorted(chain(*rule_index.names().values())) == rule_index.codes()


def test_it_is_known_to_what_each_family_applies() -> None:
    families = {rule_index.family_of(code) for code in rule_index.codes()}
    assert set(APPLIES) == families >= set(CODES)


@pytest.mark.parametrize("word", ["XML001", "xml001", "not-well-formed", "NOT-well-formed"])
def test_find_rule(word: str) -> None:
    assert rule_index.find_rule(word).code == "XML001"


@pytest.mark.parametrize(
    ("word", "message"),
    [
        ("XML01", "no rule 'XML01'; did you mean 'XML001'?"),
        ("not-wellformed", "no rule 'not-wellformed'; did you mean 'not-well-formed'?"),
        ("", "no rule ''; 'urdfkit rules' lists them"),
    ],
)
def test_an_unknown_rule(word: str, message: str) -> None:
    for look_up in (rule_index.find_rule, rule_index.matching):
        with pytest.raises(UnknownRule) as error:
            look_up(word)
        assert str(error.value) == message
        assert error.value.word == word


def test_a_family_is_no_rule_but_matches() -> None:
    with pytest.raises(UnknownRule):
        rule_index.find_rule("XML")
    assert rule_index.matching("xml") == [
        code for code in rule_index.codes() if code.startswith("XML")
    ]
    assert rule_index.matching("XML00") == rule_index.matching("XML")
    assert rule_index.matching("cycle") == ["TRE003"]


def test_a_name_that_two_families_have(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        rule_index,
        "_modules",
        {code: f"urdfkit.checks.{code.lower()}_same_name" for code in ("ABC001", "XYZ001")},
    )
    assert rule_index.matching("same-name") == ["ABC001", "XYZ001"]
    with pytest.raises(UnknownRule, match="alone: ABC001 and XYZ001 have that name"):
        rule_index.find_rule("same-name")


def test_choose() -> None:
    assert choose([], []) == rule_index.codes()
    assert choose(["TRE003", "xml001"], ["CFG003"]) == ["TRE003", "XML001"]
    some = choose(["XML"], ["XML001"])
    assert some == ["CFG003", *(code for code in rule_index.matching("XML") if code != "XML001")]
    assert choose([], ["XML"]) == [c for c in rule_index.codes() if not c.startswith("XML")]
    assert choose(["XML001"], ["XML", "CFG"]) == []
    with pytest.raises(UnknownRule):
        choose(["XML001", "XMM"], [])
    with pytest.raises(UnknownRule):
        choose([], ["XML01"])


def test_the_rule_about_unchecked_robots_is_chosen_unless_it_is_ignored() -> None:
    assert choose(["TRE003"], []) == ["CFG003", "TRE003"]
    config = Config(select=frozenset({"TRE003"}))
    assert choose([], [], config) == ["CFG003", "TRE003"]
    assert choose([], [], config._replace(ignore=frozenset({"CFG003"}))) == ["TRE003"]


def test_former_codes_and_names_lead_to_rules_that_exist() -> None:
    redirects = rule_index.redirects()
    known = {*rule_index.codes(), *rule_index.names()}
    assert not redirects.keys() & known
    assert {code for code in redirects.values() if code} <= set(rule_index.codes())


@pytest.fixture
def renamed(monkeypatch: pytest.MonkeyPatch) -> None:
    redirects = {"TRE999": "JNT020", "old-name": "JNT020", "TRE998": ""}
    monkeypatch.setattr(rule_index, "_redirects", redirects)


@pytest.mark.usefixtures("renamed")
@pytest.mark.parametrize("word", ["TRE999", "tre999", "old-name"])
def test_a_former_code_or_name(word: str) -> None:
    assert rule_index.matching(word) == ["JNT020"]
    assert rule_index.find_rule(word).code == "JNT020"
    assert rule_index.named([word]) == {"JNT020"}
    assert rule_index.note(word) == f"{word} is now JNT020"


@pytest.mark.usefixtures("renamed")
def test_a_rule_that_was_removed() -> None:
    for look_up in (rule_index.matching, rule_index.find_rule):
        with pytest.raises(UnknownRule, match="no rule 'TRE998': it was removed"):
            look_up("TRE998")
    assert rule_index.note("TRE998") == rule_index.note("TRE003") == rule_index.note("TRE") == ""


def test_listing_the_rules_imports_none() -> None:
    program = (
        "import sys; from urdfkit.lint import rule_index; rule_index.codes(); rule_index.names();"
        "print(*[name for name in sys.modules if name.startswith('urdfkit.checks.')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, check=True, text=True
    )
    assert done.stdout.split() == []
