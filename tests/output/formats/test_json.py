import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped, unused-ignore]
import pytest

import urdfkit
from tests.conftest import MODELS, ROOT
from tests.output.formats.made import diagnostic, macro, report, span
from urdfkit.lint.report import Crashed, Launched, Skipped
from urdfkit.output import formats
from urdfkit.output.formats.json import VERSION
from urdfkit.ros.targets import Targets
from urdfkit.text.diagnostic import Call, Confidence, Edit, Fix, Related, Severity
from urdfkit.text.source import Source, shown

render = formats.get("json")

SCHEMA = json.loads(
    (ROOT / "urdfkit/output/formats/report.schema.json").read_text(encoding="utf-8")
)
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
        targets=("ros1",),
        variants=("left",),
        fix=Fix("write 'leg'", (Edit(span(SOURCE, "轮子"), "leg"),), safe=True),
    ),
    skipped=(Skipped("ABC001", "robot.xacro", "b"), Skipped("", "part.xacro", "a")),
    crashed=(Crashed("ABC003", "robot.xacro", "ValueError: boom", "Traceback ..."),),
    suppressed=2,
    tolerated=3,
    launched=(Launched("robot.xacro", "a.launch.py", {"side": "left"}),),
    targets=(("robot.urdf", Targets(("ros1",), ("ros1: package.xml",))),),
)


_STRUCTURE = frozenset(
    "$schema title description properties required items $defs oneOf propertyNames".split()
) | {"additionalProperties"}


def fields(schema: Any, path: str) -> Iterator[str]:
    """Every field with what it may hold, whatever the descriptions say."""
    if "$ref" in schema:
        schema = SCHEMA["$defs"][schema["$ref"].rpartition("/")[2]]
    for choice in schema.get("oneOf", ()):
        yield from fields(choice, path)
    bounds = {key: value for key, value in schema.items() if key not in _STRUCTURE}
    if bounds:
        yield f"{path}: {json.dumps(bounds, sort_keys=True)}"
    for name, inner in schema.get("properties", {}).items():
        yield from fields(inner, f"{path}.{name}")
    if "items" in schema:
        yield from fields(schema["items"], f"{path}[]")
    for name in ("additionalProperties", "propertyNames"):
        if isinstance(schema.get(name), dict):
            yield from fields(schema[name], f"{path}.{name}")


FIELDS = list(fields(SCHEMA, "report"))


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


def test_this_version_is_frozen() -> None:
    """A reader of today must read the reports of tomorrow.

    To add, rename or remove a field makes another version: count VERSION up, and write its
    fields to a new file beside report-v2.txt.
    """
    written = (Path(__file__).parent / f"report-v{VERSION}.txt").read_text(encoding="utf-8")
    assert "\n".join(FIELDS) + "\n" == written
    assert SCHEMA["properties"]["version"] == {
        "description": "Of this document format.",
        "const": VERSION,
    }


def test_the_page_names_every_field() -> None:
    page = (ROOT / "docs" / "report-format.md").read_text(encoding="utf-8")
    paths = [line.partition(":")[0].removesuffix("[]") for line in FIELDS]
    names = {path.rpartition(".")[2] for path in paths if "." in path}
    assert {name for name in names if f"`{name}`" not in page} == {
        "additionalProperties",  # in the schema's words: of the counts by code
        "propertyNames",
    }


def test_every_field() -> None:
    place = {"path": "robot.xacro", "line": 2, "column": 19, "end_line": 2, "end_column": 21}
    assert load(render(FULL)) == {
        "version": VERSION,
        "urdfkit": urdfkit.__version__,
        "diagnostics": [
            {
                "code": "ABC123",
                "name": "some-defect",
                "severity": "error",
                "confidence": "guessed",
                "targets": ["ros1"],
                "variants": ["left"],
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
        "launched": [
            {"path": "robot.xacro", "launch": "a.launch.py", "arguments": {"side": "left"}}
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
            "code name severity confidence targets variants message path line column "
            "end_line end_column element calls related help fix"
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
        (["version"], 1),
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
    assert document["summary"]["files"] == [shown(str(model))]
    assert sum(document["summary"]["codes"].values()) == len(checked.diagnostics)


@pytest.mark.parametrize("data", [b"", b"\x00\xff\xfe", b"<robot", "<robot/>".encode("utf-16")])
def test_reports_of_rubbish_fit_the_schema(data: bytes) -> None:
    load(render(urdfkit.check(Source("rubbish.urdf", data))))
