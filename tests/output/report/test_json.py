"""The JSON report keeps to its schema: a field that comes or goes is a new version."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped, unused-ignore]
import pytest

from tests.conftest import CORPUS, MODELS, ROOT, needs_corpus
from urdfkit.output.report.document import VERSION
from urdfkit.output.report.writing import report
from urdfkit.physics.collision.matrix import PairVerdict

SCHEMA = json.loads((ROOT / "urdfkit/output/report/report.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)

ROBOTS = [
    "gazebo_pkg/urdf/waking_robot_new.xacro",
    "good/two_link_arm/urdf/two_link_arm.urdf",
    "good/mobile_base/urdf/mobile_base.urdf.xacro",
    "bad/broken_meshes.urdf",
]
ODD = [
    "",
    "<robot",
    '<robot name="r"/>',
    (
        '<robot name="r"><link name="a"/><link name="a"/><joint name="j" type="fixed">'
        '<parent link="a"/><child link="a"/></joint></robot>'
    ),
    (
        '<robot name="r"><link name="a"><visual><origin xyz="nan 0 1e300"/><geometry>'
        '<box size="1 1 inf"/></geometry></visual><inertial><mass value="1e308"/>'
        '<inertia ixx="1e308" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>'
    ),
]


def kept(path: Path, *, quick: bool = False) -> Any:
    document = json.loads(report(str(path), "json", quick=quick)[0])
    assert [error.message for error in VALIDATOR.iter_errors(document)] == []
    return document


@pytest.mark.parametrize("name", ROBOTS)
def test_reports_keep_to_the_schema(name: str) -> None:
    assert kept(MODELS / name)["version"] == VERSION


@pytest.mark.parametrize("content", ODD)
def test_reports_of_odd_files_do_too(content: str, tmp_path: Path) -> None:
    file = tmp_path / "r.urdf"
    file.write_text(content, encoding="utf-8")
    kept(file)


@needs_corpus
def test_reports_of_real_robots_do_too() -> None:
    document = kept(CORPUS / "moveit_resources" / "panda_description" / "urdf" / "panda.urdf")
    assert document["collisions"] is not None or "collisions" in document["missing"]


def objects(schema: Any) -> Iterator[dict[str, Any]]:
    """Every description of an object in a schema."""
    if isinstance(schema, dict):
        if "object" in schema.get("type", ()):
            yield schema
        for inner in schema.values():
            yield from objects(inner)
    elif isinstance(schema, list):
        for inner in schema:
            yield from objects(inner)


def test_the_schema_says_all() -> None:
    VALIDATOR.check_schema(SCHEMA)
    assert SCHEMA["properties"]["version"]["const"] == VERSION
    for one in objects(SCHEMA):
        if one["additionalProperties"] is False:
            assert sorted(one["required"]) == sorted(one["properties"])
    pair = SCHEMA["properties"]["collisions"]["properties"]["pairs"]["items"]["properties"]
    assert pair["verdict"]["enum"] == [verdict.value for verdict in PairVerdict]
