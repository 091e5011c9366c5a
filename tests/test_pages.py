"""The pages that people read: what they show happens, and what they promise is all there is."""

import os
import re
import shutil
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

import urdfkit
from docs import transcripts
from tests.conftest import MODELS, ROOT
from urdfkit.cli import main
from urdfkit.lint import config_reader
from urdfkit.output import formats
from urdfkit.ros.targets import TARGETS

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

DOCS = ROOT / "docs"


def blocks(page: str, language: str) -> list[str]:
    text = (DOCS / page).read_text(encoding="utf-8")
    return re.findall(rf"(?<=^```{language}\n).*?(?=^```$)", text, re.DOTALL | re.MULTILINE)


@pytest.mark.skipif(os.name == "nt", reason="the pages show a Unix shell")
@pytest.mark.parametrize("page", transcripts.PAGES, ids=lambda path: path.stem)
def test_what_a_page_shows_is_what_is_printed(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert transcripts.with_output(text) == text, "run: python docs/transcripts.py"


# --- the configuration


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The directories and files that the example of a configuration names."""
    directory = tmp_path / "project"
    (directory / "urdf").mkdir(parents=True)
    (tmp_path / "gripper" / "gripper_description").mkdir(parents=True)
    (directory / "urdf" / "arm.urdf.xacro").write_text("<robot/>")
    monkeypatch.chdir(directory)
    return directory


def test_the_example_of_a_configuration_is_one(project: Path) -> None:
    (example,) = blocks("configuration.md", "toml")
    (project / "urdfkit.toml").write_text(example)
    loaded = config_reader.load("urdfkit.toml")
    assert [robot.name for robot in loaded.robots] == ["left", "right"]
    assert loaded.robots[0].arguments == {"prefix": "lab_", "side": "left"}
    nested = "\n".join(re.sub(r"^(\[+)", r"\1tool.urdfkit.", line) for line in example.splitlines())
    (project / "pyproject.toml").write_text(f"[tool.urdfkit]\n{nested}")
    again = config_reader.load("pyproject.toml")
    assert again._replace(path="") == loaded._replace(path="")


def test_every_setting_is_documented(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that the reader takes, at the top and in tables."""
    taken: set[str] = set()
    take = config_reader._SettingsReader.take

    def recorded(self: Any, key: str, kind: type, default: Any) -> Any:
        taken.add(key)
        return take(self, key, kind, default)

    monkeypatch.setattr(config_reader._SettingsReader, "take", recorded)
    (example,) = blocks("configuration.md", "toml")
    (project / "urdfkit.toml").write_text(example)
    config_reader.load("urdfkit.toml")
    assert len(taken) > 15
    page = (DOCS / "configuration.md").read_text(encoding="utf-8")
    shown = {*_keys(tomllib.loads(example)), *re.findall(r"`([a-z-]+) = ", page)}
    assert taken - shown == set()


def _keys(table: dict[str, Any]) -> set[str]:
    found = set(table)
    for value in table.values():
        for inner in value if isinstance(value, list) else [value]:
            if isinstance(inner, dict):
                found |= _keys(inner)
    return found


# --- pre-commit and CI


def test_what_ci_runs_can_be_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(MODELS / "good", tmp_path / "robots")
    monkeypatch.chdir(tmp_path / "robots")
    commands = [
        line.partition("urdfkit check ")[2]
        for block in blocks("pre-commit.md", "yaml")
        for line in block.splitlines()
        if "urdfkit check " in line
    ]
    assert len(commands) >= 2
    for command in commands:
        assert main(["check", *command.split()]) == 0
    written = {path.name for path in Path().iterdir()} - {p.name for p in MODELS.glob("good/*")}
    page = (DOCS / "pre-commit.md").read_text(encoding="utf-8")
    for name in written:
        assert page.count(name) >= 2, f"{name} is written, and nobody takes it"
    assert len(written) == 3


def test_the_settings_of_ci_are_yaml() -> None:
    hook, *jobs = map(yaml.safe_load, blocks("pre-commit.md", "yaml"))
    hooks = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    assert [h["id"] for repo in hook["repos"] for h in repo["hooks"]] == [h["id"] for h in hooks]
    assert all(jobs)


def test_every_format_and_target_is_documented() -> None:
    page = (DOCS / "commands" / "check.md").read_text(encoding="utf-8")
    assert [name for name in formats.names() if f"`{name}`" not in page] == []
    assert [name for name in TARGETS if f"`{name}`" not in page] == []


# --- pytest


def test_every_fixture_assertion_and_setting_is_documented() -> None:
    page = (DOCS / "pytest.md").read_text(encoding="utf-8")
    from urdfkit import pytest_plugin, testing

    fixtures = re.findall(r"@pytest.fixture\ndef (\w+)", Path(pytest_plugin.__file__).read_text())
    settings = re.findall(r'addini\(\s*"(\w+)"', Path(pytest_plugin.__file__).read_text())
    assert len(fixtures) == 8
    assert len(settings) == 2
    assert [name for name in (*fixtures, *settings, *testing.__all__) if name not in page] == [
        "marked_urdf"  # what the others are made from
    ]


# --- the library


@pytest.mark.parametrize("page", ["../README.md"])
def test_the_python_of_a_page_runs(page: str, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    monkeypatch.chdir(ROOT)
    for block in blocks(page, "python"):
        exec(compile(block, page, "exec"), {})
    out = capsys.readouterr().out
    assert "mount_to_palm fixed written at models/good/gripper.urdf:" in out
    assert '<robot name="mobile_base">' in out


def test_the_page_of_the_library_lists_all_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    page = (DOCS / "api.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"^::: urdfkit\.(\w+)$", page, re.MULTILINE)) == urdfkit.__all__
    pytest.importorskip("pinocchio")
    monkeypatch.chdir(ROOT)
    *_, properties = blocks("api.md", "python")
    exec(compile(properties, "api.md", "exec"), {})
