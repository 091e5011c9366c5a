from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped, unused-ignore]
import pytest

import urdfkit
from tests.conftest import MODELS, ROOT
from tests.formats.made import diagnostic, macro, report, span
from urdfkit.diagnostic import Call, Confidence, Crashed, Edit, Fix, Related, Severity, Skipped
from urdfkit.formats.json import VERSION, render
from urdfkit.source import Source
from urdfkit.targets import Targets

SCHEMA = json.loads((ROOT / "urdfkit/formats/report.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)

SOURCE = Source("robot.xacro", '<robot>\n  <m/><link name="轮子"/>\n</robot>\n'.encode())
FULL = report(
    diagnostic(
        span(SOURCE, "轮子"),
        severity=Severity.ERROR,
        confidence=Confidence.GUESSED,
        message="link '轮子': 2 m is over 1 m",
        calls=(
            Call("link '轮子': 2 m is over 1 m", (macro("m", span(SOURCE, "<m/>")),), "link/轮子"),
        ),
        related=(Related(span(SOURCE, "</robot>"), "the robot ends here"),),
        help="make it shorter",
        fix=Fix("write 'leg'", (Edit(span(SOURCE, "轮子"), "leg"),), safe=True),
    ),
    skipped=(Skipped("ABC001", "robot.xacro", "b"), Skipped("", "part.xacro", "a")),
    crashed=(Crashed("ABC003", "robot.xacro", "ValueError: boom", "Traceback ..."),),
    suppressed=2,
    tolerated=3,
    targets=(("robot.urdf", Targets(("ros1",), ("ros1: package.xml",))),),
)


def load(text: str) -> Any:
    """The document, after the schema has agreed with it."""
    document = json.loads(text)
    VALIDATOR.validate(document)
    return document


def test_the_schema_is_a_schema_and_strict() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    objects = [SCHEMA, *(part for part in SCHEMA["$defs"].values() if part.get("type") == "object")]
    assert all(part["additionalProperties"] is False for part in objects)
    assert all(sorted(part["required"]) == sorted(part["properties"]) for part in objects)


def test_every_field() -> None:
    place = {"path": "robot.xacro", "line": 2, "column": 19, "end_line": 2, "end_column": 21}
    assert load(render(FULL)) == {
        "version": VERSION,
        "diagnostics": [
            {
                "code": "ABC123",
                "name": "some-defect",
                "severity": "error",
                "confidence": "guessed",
                "message": "link '轮子': 2 m is over 1 m",
                **place,
                "element": "link/轮子",
                "calls": [
                    {
                        "message": "link '轮子': 2 m is over 1 m",
                        "element": "link/轮子",
                        "via": [
                            {
                                "kind": "macro",
                                "name": "m",
                                "path": "robot.xacro",
                                "line": 2,
                                "column": 3,
                                "end_line": 2,
                                "end_column": 7,
                            }
                        ],
                    }
                ],
                "related": [
                    {
                        "message": "the robot ends here",
                        "path": "robot.xacro",
                        "line": 3,
                        "column": 1,
                        "end_line": 3,
                        "end_column": 9,
                    }
                ],
                "help": "make it shorter",
                "fix": {"title": "write 'leg'", "safe": True, "edits": [{**place, "text": "leg"}]},
            }
        ],
        "skipped": [
            {"code": "", "path": "part.xacro", "reason": "a"},
            {"code": "ABC001", "path": "robot.xacro", "reason": "b"},
        ],
        "crashed": [{"code": "ABC003", "path": "robot.xacro", "error": "ValueError: boom"}],
        "summary": {
            "files": ["robot.urdf"],
            "rules": ["ABC123"],
            "targets": [
                {"path": "robot.urdf", "names": ["ros1"], "evidence": ["ros1: package.xml"]}
            ],
            "error": 1,
            "warning": 0,
            "info": 0,
            "suppressed": 2,
            "tolerated": 3,
            "codes": {"ABC123": 1},
        },
    }


def test_the_fields_of_a_diagnostic_are_those_promised_in_that_order() -> None:
    assert (
        list(load(render(FULL))["diagnostics"][0])
        == (
            "code name severity confidence message path line column end_line end_column element "
            "calls related help fix"
        ).split()
    )


def test_the_same_report_gives_the_same_bytes_and_they_are_text() -> None:
    text = render(FULL)
    assert text == render(FULL, color=True, width=20)
    assert text.endswith("}\n")
    assert "轮子" in text


@pytest.mark.parametrize(
    ("path", "wrong"),
    [
        (["version"], 2),
        (["diagnostics", 0, "severity"], "fatal"),
        (["diagnostics", 0, "line"], 0),
        (["diagnostics", 0, "calls"], []),
        (["diagnostics", 0, "extra"], 1),
        (["diagnostics", 0, "fix", "edits", 0, "line"], "1"),
        (["summary", "codes", "ABC123"], 0),
        (["summary", "codes", "abc"], 1),
        (["crashed", 0, "traceback"], ""),
    ],
)
def test_the_schema_refuses(path: list[str | int], wrong: object) -> None:
    document: Any = json.loads(render(FULL))
    holder = document
    for key in path[:-1]:
        holder = holder[key]
    holder[path[-1]] = wrong
    with pytest.raises(jsonschema.ValidationError):
        VALIDATOR.validate(document)


@pytest.mark.parametrize(
    "model", sorted(MODELS.rglob("*.urdf")) + sorted(MODELS.rglob("*.xacro")), ids=lambda p: p.name
)
def test_reports_of_the_models_fit_the_schema(model: Path) -> None:
    checked = urdfkit.check(model)
    document = load(render(checked))
    assert len(document["diagnostics"]) == len(checked.diagnostics)
    assert document["summary"]["files"] == [str(model)]
    assert sum(document["summary"]["codes"].values()) == len(checked.diagnostics)


@pytest.mark.parametrize("data", [b"", b"\x00\xff\xfe", b"<robot", "<robot/>".encode("utf-16")])
def test_reports_of_rubbish_fit_the_schema(data: bytes) -> None:
    load(render(urdfkit.check(Source("rubbish.urdf", data))))
