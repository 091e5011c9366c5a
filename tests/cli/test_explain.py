import re

import pytest

from urdfkit.cli import main
from urdfkit.cli.explain import render
from urdfkit.lint import rule_index


@pytest.mark.parametrize("word", ["TRE003", "tre003", "cycle", "Cycle"])
def test_a_rule_is_found_by_code_and_by_name(word: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", word]) == 0
    assert capsys.readouterr().out == render(rule_index.get("TRE003"))


def test_several_rules(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["explain", "TRE003", "TRE001"]) == 0
    reported = capsys.readouterr().out
    assert reported == f"{render(rule_index.get('TRE003'))}\n\n{render(rule_index.get('TRE001'))}"


def test_a_family_is_not_a_rule(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "msh"]) == 2
    assert "a rule family (mesh files)" in capsys.readouterr().err


def test_the_page_of_a_rule() -> None:
    page = render(rule_index.get("TRE003"))
    assert page.startswith("TRE003 cycle (error, without a fix)\n\nJoints form a closed")
    assert "\n\nNeeds: a readable robot model\n\nHelp: leave a passive joint" in page
    assert '\n\nBad:\n\n    <link name="base"/>\n' in page
    assert '\n\nGood:\n\n    <link name="base"/>\n' in page
    assert "Fixed:" not in page
    sources = page.partition("</joint>\n\nSources:\n\n    ")[2].splitlines()
    assert tuple(map(str.strip, sources)) == rule_index.get("TRE003").sources


def test_short_example_files_are_shown_and_meshes_are_not() -> None:
    assert '\n\nbad.srdf in the same package:\n\n    <robot name="bad">\n' in render(
        rule_index.get("SRD004")
    )
    assert "vertex 1,0 0,0 0,0" in render(rule_index.get("MSH009"))
    assert rule_index.get("MSH009").example_files.keys() == {"meshes/comma.stl", "meshes/plate.stl"}


def test_lists_fit_into_80_columns_too() -> None:
    text = render(rule_index.get("MSH001")).partition("\n\nNeeds:")[0]
    assert max(map(len, text.splitlines())) <= 80
    assert "\n- A third slash, as in `package:///arm/arm.stl`, or a file alone, as in\n  " in text


@pytest.mark.parametrize("code", rule_index.codes())
def test_every_rule_can_be_explained(code: str) -> None:
    rule = rule_index.get(code)
    page = render(rule)
    flat = " ".join(page.split())
    assert flat.startswith(f"{code} {rule.name} ({rule.severity.value}, ")
    head = " ".join(page.partition("\n\n")[0].split())
    for target, severity in rule.severities.items():
        assert severity is rule.severity or re.search(f", {severity.value} for.*{target}", head)
    assert " ".join(rule.explanation.split()) in flat
    assert head.endswith(", with a fix)" if rule.fixable else ", without a fix)")
    assert "\n\nBad:\n\n    " in page
    assert re.search(r"\n\nGood(, after the fix)?:\n\n    ", page)
    assert [source for source in rule.sources if f"    {source}\n" not in page] == []
    code_spans = re.findall(r"`[^`]+`", " ".join(rule.explanation.split()))
    assert [span for span in code_spans if span not in page] == [], "broken between lines"


def test_paragraphs_fit_80_columns_and_lists_are_unchanged() -> None:
    rule = rule_index.get("TRE003")
    page = render(rule)
    prose = page[: page.index("\n\nBad:")]
    assert max(map(len, prose.splitlines())) <= 80


def test_severities_of_targets_are_grouped() -> None:
    page = render(rule_index.get("INE014"))
    assert "warning for " in " ".join(page.split()[:12])
    assert render(rule_index.get("GAZ012")).startswith(
        "GAZ012 wrong-generation (error, with a fix)\n"
    )


def test_a_good_robot_equal_to_the_fixed_robot_is_shown_once() -> None:
    assert "\n\nGood, after the fix:\n" in render(rule_index.get("GAZ001"))
    assert "\n\nFixed:\n" not in render(rule_index.get("GAZ001"))
    page = render(rule_index.get("GAZ010"))
    assert page.index("\n\nGood:\n") < page.index("\n\nFixed:\n")


def test_needs_of_a_rule(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "SRD009"]) == 0
    needs = "Needs: a readable robot model, an SRDF of the robot, coal (extra 'dynamics')"
    assert needs in " ".join(capsys.readouterr().out.split())
