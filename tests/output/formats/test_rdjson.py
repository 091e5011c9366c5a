"""reviewdog's JSON, whole and by lines."""

import json
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped, unused-ignore]
import pytest

import urdfkit
from tests.conftest import MODELS
from tests.output.formats.made import diagnostic, report, span
from urdfkit.output.formats import rdjson
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.source import Source, Span

WIDE = Source("r.urdf", '<robot name="轮🦾"><link\n name="é"/><a/></robot>\n'.encode())
OTHER = Source("o.urdf", b"<robot/>")


def _closed(required: list[str], **properties: Any) -> dict[str, Any]:
    """An object with these fields and no others."""
    return {
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": False,
    }


_COUNT = {"type": "integer", "minimum": 1}
_TEXT = {"type": "string"}
_POSITION = _closed(["line", "column"], line=_COUNT, column=_COUNT)
_RANGE = _closed(["start", "end"], start=_POSITION, end=_POSITION)
_SOURCE = _closed(["name"], name=_TEXT, url=_TEXT)
#: What ``reviewdog.proto`` allows, and no field that it does not know.
DIAGNOSTIC = _closed(
    ["message", "location"],
    message={"type": "string", "minLength": 1},
    location=_closed(["path"], path=_TEXT, range=_RANGE),
    severity={"enum": ["ERROR", "WARNING", "INFO"]},
    source=_SOURCE,
    code=_closed(["value"], value=_TEXT, url=_TEXT),
    suggestions={"type": "array", "items": _closed(["range", "text"], range=_RANGE, text=_TEXT)},
)
RESULT = _closed(
    ["diagnostics"],
    source=_SOURCE,
    severity=_TEXT,
    diagnostics={"type": "array", "items": DIAGNOSTIC},
)


def whole(*found: Any) -> Any:
    document = json.loads(rdjson.render(report(*found)))
    jsonschema.validate(document, RESULT)
    return document


def cut_out(source: Source, place: dict[str, dict[str, int]]) -> bytes:
    """What a range means: bytes of lines, the end exclusive."""
    lines = source.data.splitlines(keepends=True)
    start, end = (
        sum(map(len, lines[: at["line"] - 1])) + at["column"] - 1
        for at in (place["start"], place["end"])
    )
    return source.data[start:end]


def test_every_field() -> None:
    found = diagnostic(span(WIDE, "é"), severity=Severity.ERROR, help="mend it")
    assert whole(found) == {
        "source": {"name": "urdfkit"},
        "diagnostics": [
            {
                "message": "link 'arm': 2 m is over 1 m\nmend it",
                "location": {
                    "path": "r.urdf",
                    "range": {"start": {"line": 2, "column": 8}, "end": {"line": 2, "column": 10}},
                },
                "severity": "ERROR",
                "code": {"value": "ABC123"},
            }
        ],
    }


@pytest.mark.parametrize("text", ["轮", "🦾", '<link\n name="é"', "<a/>", "</robot>"])
def test_columns_count_bytes(text: str) -> None:
    ((found,),) = [whole(diagnostic(span(WIDE, text)))["diagnostics"]]
    assert cut_out(WIDE, found["location"]["range"]) == text.encode()


def test_a_fix_is_a_suggestion() -> None:
    edits = (Edit(span(WIDE, "é"), "e"), Edit(Span(WIDE, 0, 0), "<!-- -->"))
    (found,) = whole(diagnostic(span(WIDE, "é"), fix=Fix("write e", edits)))["diagnostics"]
    replaced, inserted = found["suggestions"]
    assert (cut_out(WIDE, replaced["range"]), replaced["text"]) == ("é".encode(), "e")
    assert (cut_out(WIDE, inserted["range"]), inserted["text"]) == (b"", "<!-- -->")


def test_a_fix_in_another_file_is_none() -> None:
    """A suggestion has no path of its own; half of a fix would do harm."""
    edits = (Edit(span(WIDE, "é"), "e"), Edit(span(OTHER, "robot"), "r"))
    (found,) = whole(diagnostic(span(WIDE, "é"), fix=Fix("both", edits)))["diagnostics"]
    assert "suggestions" not in found


def test_nothing_found() -> None:
    assert whole()["diagnostics"] == []


@pytest.mark.parametrize(
    "model", sorted(MODELS.rglob("*.urdf")) + sorted(MODELS.rglob("*.xacro")), ids=lambda p: p.name
)
def test_reports_of_the_models(model: Path) -> None:
    checked = urdfkit.check(model)
    document = json.loads(rdjson.render(checked))
    jsonschema.validate(document, RESULT)
    for found, reported in zip(checked.diagnostics, document["diagnostics"], strict=True):
        source = found.span.source
        assert cut_out(source, reported["location"]["range"]) == source.data[slice(*found.span[1:])]
        if found.fix and "suggestions" in reported:
            for edit, suggestion in zip(found.fix.edits, reported["suggestions"], strict=True):
                assert cut_out(source, suggestion["range"]) == source.data[slice(*edit.span[1:])]
            assert apply_edits(source.data, found.fix.edits)
