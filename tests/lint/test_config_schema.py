"""The JSON Schema of urdfkit.toml takes what the configuration takes, and no other setting."""

import json
import re
import sys
from pathlib import Path
from typing import Any

import pytest

jsonschema = pytest.importorskip("jsonschema")

from tests.conftest import ROOT
from urdfkit.lint.config import ConfigError
from urdfkit.lint.config_reader import load
from urdfkit.ros.targets import TARGETS
from urdfkit.text.diagnostic import Confidence, Severity

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

SCHEMA = json.loads((ROOT / "docs" / "urdfkit.schema.json").read_text())
SETTINGS: dict[str, Any] = SCHEMA["properties"]
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


def is_valid(text: str) -> bool:
    return bool(VALIDATOR.is_valid(tomllib.loads(text)))


def is_taken(text: str, directory: Path) -> bool:
    (directory / "r.urdf").write_text('<robot name="r"/>')
    file = directory / "urdfkit.toml"
    file.write_text(text)
    try:
        load(str(file))
    except ConfigError:
        return False
    return True


def test_it_is_a_schema_as_schemastore_has_them() -> None:
    jsonschema.Draft7Validator.check_schema(SCHEMA)
    assert SCHEMA["$schema"] == "http://json-schema.org/draft-07/schema#"
    assert SCHEMA["$id"] == "https://json.schemastore.org/urdfkit.json"
    assert all(setting["description"] for setting in SETTINGS.values())


def test_the_settings_of_the_page_are_valid() -> None:
    page = (ROOT / "docs" / "configuration.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    assert is_valid(text)
    named = set(tomllib.loads(text)) | {"trust", "rule-packages"}
    assert named == set(SETTINGS)


def test_words_are_those_of_the_program() -> None:
    assert SETTINGS["targets"]["items"]["enum"] == list(TARGETS)
    assert SETTINGS["fail-on"]["enum"] == [one.value for one in Severity]
    assert SETTINGS["min-confidence"]["enum"] == [one.value for one in Confidence]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", True),
        ("select = ['MSH', 'own-pi']\nwidth = 40", True),
        ("[[robot]]\nfile = 'r.urdf'\n[robot.variants]\na = {x = 1}", True),
        ("[severity]\nMSH = 'info'\n[rules.MSH019]\ntriangles = 1", True),
        ("targtes = ['ros2']", False),
        ("targets = ['ros3']", False),
        ("targets = 'ros2'", False),
        ("width = 39", False),
        ("fail-on = 'fatal'", False),
        ("preview = 1", False),
        ("xacro-seconds = 0", False),
        ("[severity]\nMSH = 'fatal'", False),
        ("[rules.MSH019]\ntriangles = -1", False),
        ("[[robot]]\nfiles = 'r.urdf'", False),
        ("[[per-file-ignores]]\nfiles = ['a']", False),
        ("[arguments]\na = []", False),
    ],
)
def test_it_takes_what_the_configuration_takes(text: str, expected: bool, tmp_path: Path) -> None:
    assert is_valid(text) is expected
    assert is_taken(text, tmp_path) is expected
