"""SARIF: the schema of OASIS agrees, and regions are what SARIF means by them."""

import json
import os
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import jsonschema  # type: ignore[import-untyped, unused-ignore]
import pytest

import urdfkit
from tests.conftest import MODELS
from tests.output.formats.made import diagnostic, macro, report, span
from urdfkit.lint import rule_index
from urdfkit.lint.report import Crashed, Skipped
from urdfkit.output.formats.sarif import render
from urdfkit.text.diagnostic import Call, Confidence, Edit, Fix, Related, Severity
from urdfkit.text.document import Step
from urdfkit.text.source import Source, Span

#: sarif-2.1.0.json of npm's @microsoft/sarif-multitool-linux; .ci/run fetches it.
SCHEMA = os.environ.get("SARIF_SCHEMA")

WIDE = Source("robot.xacro", '<robot>\n  <m n="🦾"/><link name="轮子"/>\n</robot>\n'.encode())
TOP = Source("top.xacro", b'<robot>\n<xacro:include filename="robot.xacro"/></robot>')


def run_of(*diagnostics: Any, **changes: Any) -> Any:
    """The single run of a report, as a reader gets it."""
    (run,) = json.loads(render(report(*diagnostics, **{"rules": (), **changes})))["runs"]
    return run


def result_of(at: Span, **changes: Any) -> Any:
    """The single result of a finding."""
    (result,) = run_of(diagnostic(at, code="TRE003", name="cycle", **changes))["results"]
    return result


def cut_out(source: Source, region: dict[str, int]) -> str:
    """The text of a region, by UTF-16 code units as an editor or a service cuts it."""
    lines = source.data.decode().split("\n")
    start, end = region["startLine"] - 1, region["endLine"] - 1
    cut = [line.encode("utf-16-le") for line in lines[start : end + 1]]
    cut[-1] = cut[-1][: 2 * (region["endColumn"] - 1)]
    cut[0] = cut[0][2 * (region["startColumn"] - 1) :]
    return "\n".join(line.decode("utf-16-le") for line in cut)


def location(span_: Span) -> Any:
    return result_of(span_)["locations"][0]["physicalLocation"]


@pytest.mark.parametrize("text", ["轮子", "🦾", "<robot>", '<link name="轮子"/>\n</robot>', "/>"])
def test_regions_count_utf16_code_units(text: str) -> None:
    region = location(span(WIDE, text))["region"]
    assert cut_out(WIDE, region) == text


def test_an_emoji_before_counts_two() -> None:
    assert run_of()["columnKind"] == "utf16CodeUnits"
    assert location(span(WIDE, "轮子"))["region"] == {
        "startLine": 2,
        "startColumn": 26,  # of 24 characters before it one counts two
        "endLine": 2,
        "endColumn": 28,
    }


def test_a_place_between_characters_has_an_empty_region() -> None:
    at = span(WIDE, "<link").start
    region = location(Span(WIDE, at, at))["region"]
    assert (region["startColumn"], region["endColumn"]) == (14, 14)


@pytest.mark.parametrize(
    ("path", "uri"),
    [
        ("urdf/a.urdf", {"uri": "urdf/a.urdf", "uriBaseId": "SRCROOT"}),
        ("./urdf/../a b#1.urdf", {"uri": "a%20b%231.urdf", "uriBaseId": "SRCROOT"}),
        ("轮.urdf", {"uri": "%E8%BD%AE.urdf", "uriBaseId": "SRCROOT"}),
        ("bad\udcff.urdf", {"uri": "bad%FF.urdf", "uriBaseId": "SRCROOT"}),
        ("<stdin>", {"uri": "%3Cstdin%3E", "uriBaseId": "SRCROOT"}),
        ("/opt/a b.urdf", {"uri": "file:///opt/a%20b.urdf"}),
    ],
)
def test_files_of_the_repository_are_relative(path: str, uri: dict[str, str]) -> None:
    source = Source(path, b"<robot/>")
    assert location(span(source, "robot"))["artifactLocation"] == uri


def test_an_absolute_path_in_the_current_directory_is_relative(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    source = Source(str(tmp_path / "a.urdf"), b"<robot/>")
    assert location(span(source, "robot"))["artifactLocation"]["uri"] == "a.urdf"


def test_severity_confidence_and_help() -> None:
    for severity, level in (("error", "error"), ("warning", "warning"), ("info", "note")):
        assert result_of(span(WIDE, "robot"), severity=Severity(severity))["level"] == level
    result = result_of(span(WIDE, "robot"), help="mend it", confidence=Confidence.GUESSED)
    assert result["message"]["text"] == "link 'arm': 2 m is over 1 m\nmend it"
    assert result["properties"] == {"confidence": "guessed"}


def test_the_element_is_the_logical_location() -> None:
    (place,) = result_of(span(WIDE, "轮子"))["locations"]
    assert place["logicalLocations"] == [{"fullyQualifiedName": "link/arm", "kind": "element"}]
    plain = result_of(span(WIDE, "轮子"), calls=(Call("m", (), ""),))
    assert "logicalLocations" not in plain["locations"][0]


def test_the_calls_are_related_locations_innermost_first() -> None:
    via = (
        Step("include", "robot.xacro", span(TOP, '<xacro:include filename="robot.xacro"/>'), None),
        macro("m", span(WIDE, '<m n="🦾"/>')),
    )
    result = result_of(
        span(WIDE, "轮子"),
        calls=(Call("link 'arm': 2 m is over 1 m", via, "link/arm"),),
        related=(Related(span(WIDE, "</robot>"), "it ends here"),),
    )
    reported = [
        (
            place["id"],
            place["message"]["text"],
            place["physicalLocation"]["artifactLocation"]["uri"],
            place["physicalLocation"]["region"]["startLine"],
        )
        for place in result["relatedLocations"]
    ]
    assert reported == [
        (1, "it ends here", "robot.xacro", 3),
        (2, "expanded from macro 'm'", "robot.xacro", 2),
        (3, "included", "top.xacro", 2),
    ]


def test_each_of_several_calls_has_its_own_numbers() -> None:
    calls = tuple(
        Call(f"link {n}", (macro("m", span(WIDE, text)),), "")
        for n, text in enumerate(('<m n="🦾"/>', "<robot>"))
    )
    result = result_of(span(WIDE, "轮子"), calls=calls)
    assert [place["message"]["text"] for place in result["relatedLocations"]] == [
        "link 0",
        "link 1",
    ]


def test_a_fix_is_replacements_by_file() -> None:
    edits = (Edit(span(WIDE, "轮子"), "leg"), Edit(span(TOP, "robot"), ""))
    (fix,) = result_of(span(WIDE, "轮子"), fix=Fix("write 'leg'", edits))["fixes"]
    assert fix["description"] == {"text": "write 'leg'"}
    first, second = fix["artifactChanges"]
    assert first["artifactLocation"]["uri"] == "robot.xacro"
    (replacement,) = first["replacements"]
    assert cut_out(WIDE, replacement["deletedRegion"]) == "轮子"
    assert replacement["insertedContent"] == {"text": "leg"}
    assert second["artifactLocation"]["uri"] == "top.xacro"
    assert second["replacements"][0]["insertedContent"] == {"text": ""}


def test_the_table_has_the_rules_that_ran_with_their_help() -> None:
    run = run_of(
        diagnostic(span(WIDE, "轮子"), code="TRE003", name="cycle"),
        rules=("TRE001", "MSH001"),
    )
    table = run["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in table] == ["MSH001", "TRE001", "TRE003"]
    (result,) = run["results"]
    assert table[result["ruleIndex"]]["id"] == result["ruleId"] == "TRE003"
    entry, rule = table[2], rule_index.get("TRE003")
    assert entry["name"] == "Cycle"
    assert entry["shortDescription"]["text"] == rule.explanation.split("\n")[0]
    assert entry["fullDescription"]["text"].startswith("URDF describes trees")
    assert rule.help in entry["help"]["text"]
    assert entry["defaultConfiguration"] == {"level": "error"}
    assert run["tool"]["driver"]["version"] == urdfkit.__version__


def test_what_did_not_run_is_reported() -> None:
    run = run_of(
        skipped=(Skipped("ABC001", "a.urdf", "why not"),),
        crashed=(Crashed("ABC003", "a.urdf", "ValueError: boom", "Traceback ..."),),
    )
    (invocation,) = run["invocations"]
    assert invocation["executionSuccessful"] is False
    assert [
        (note["level"], note["message"]["text"])
        for note in invocation["toolExecutionNotifications"]
    ] == [
        ("note", "a.urdf: ABC001 skipped: why not"),
        ("error", "a.urdf: ABC003: ValueError: boom"),
    ]
    assert run_of()["invocations"][0]["executionSuccessful"] is True


JOINT = '<joint name="{}" type="fixed"><parent link="a"/><child link="a"/></joint>\n'


def marks(tmp_path: Path, text: str) -> dict[str, str]:
    """The fingerprint of each finding of TRE003, by its element."""
    file = tmp_path / "r.urdf"
    file.write_text(f'<robot name="r">\n<link name="a"/>\n{text}</robot>\n')
    found = json.loads(render(urdfkit.check(file, select=["TRE003"])))["runs"][0]["results"]
    return {
        result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]: result[
            "partialFingerprints"
        ]["urdfkit/v1"]
        for result in found
    }


def test_fingerprints_are_stable_under_edits_elsewhere(tmp_path: Path) -> None:
    one, two = JOINT.format("one"), JOINT.format("two")
    before = marks(tmp_path, one + two)
    assert len(set(before.values())) == 2
    assert marks(tmp_path, "<!-- new -->\n\n" + one + "  " + two) == before
    assert marks(tmp_path, two + one) == before
    changed = marks(tmp_path, one + two.replace("fixed", "revolute"))
    assert changed.items() ^ before.items() == {
        (path, mark)
        for marks_ in (before, changed)
        for path, mark in marks_.items()
        if "two" in path
    }


# --- against the schema

needs_schema = pytest.mark.skipif(
    SCHEMA is None, reason="SARIF_SCHEMA names no schema of SARIF; .ci/run fetches it"
)


@pytest.fixture(scope="module")
def validator() -> Any:
    assert SCHEMA is not None
    schema = json.loads(Path(SCHEMA).read_text(encoding="utf-8"))
    assert schema["title"].startswith("Static Analysis Results Format (SARIF) Version 2.1.0")
    kind = jsonschema.validators.validator_for(schema)
    return kind(schema, format_checker=kind.FORMAT_CHECKER)


@needs_schema
def test_a_report_with_everything_fits_the_schema(validator: Any) -> None:
    via = (macro("m", span(WIDE, '<m n="🦾"/>')),)
    full = report(
        diagnostic(
            span(WIDE, "轮子"),
            code="TRE003",
            name="cycle",
            calls=(Call("a", via, "link/轮子"), Call("b", via, "")),
            related=(Related(span(TOP, "</robot>"), "it ends here"),),
            fix=Fix("write 'leg'", (Edit(span(WIDE, "轮子"), "leg"),)),
            help="mend it",
        ),
        rules=("TRE001",),
        skipped=(Skipped("", "a.urdf", "why not"),),
        crashed=(Crashed("ABC003", "a.urdf", "ValueError: boom"),),
    )
    validator.validate(json.loads(render(full)))


@needs_schema
@pytest.mark.parametrize(
    "model", sorted(MODELS.rglob("*.urdf")) + sorted(MODELS.rglob("*.xacro")), ids=lambda p: p.name
)
def test_reports_of_the_models_fit_the_schema(validator: Any, model: Path) -> None:
    checked = urdfkit.check(model)
    document = json.loads(render(checked))
    validator.validate(document)
    for found, result in zip(checked.diagnostics, document["runs"][0]["results"], strict=True):
        place = result["locations"][0]["physicalLocation"]
        source = found.span.source
        assert cut_out(source, place["region"]) == found.span.text.replace("\r", "")
        assert Path(unquote(place["artifactLocation"]["uri"])) == Path(os.path.relpath(source.path))


@needs_schema
def test_all_rules_fit_the_schema(validator: Any) -> None:
    validator.validate(json.loads(render(report(rules=tuple(rule_index.codes())))))


@needs_schema
def test_the_schema_refuses_what_is_wrong(validator: Any) -> None:
    document = json.loads(render(report(rules=())))
    document["runs"][0]["columnKind"] = "bytes"
    with pytest.raises(jsonschema.ValidationError):
        validator.validate(document)


def test_variants_are_a_property() -> None:
    result = result_of(span(WIDE, "robot"), variants=("left",))
    assert result["properties"]["variants"] == ["left"]
