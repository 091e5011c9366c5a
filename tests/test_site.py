"""The site of the documentation, built as CI builds it."""

import json
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest

import urdfkit
from tests.conftest import ROOT
from urdfkit.cli.group import COMMANDS
from urdfkit.lint import rule_index

pytest.importorskip("mkdocs")
pytest.importorskip("mkdocstrings")


def build(project: Path, site: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", site],
        check=False,
        cwd=project,
        capture_output=True,
        text=True,
    )


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("site")
    done = build(ROOT, directory)
    assert done.returncode == 0, done.stderr
    return directory


class Text(HTMLParser):
    """Gathers links and anchors."""

    def __init__(self) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        if given.get("id"):
            self.ids.add(given["id"] or "")
        source = given.get("src") or (given.get("href") if tag == "link" else None)
        if source:
            self.loaded.append(source)


def read(page: Path) -> Text:
    text = Text()
    text.feed(page.read_text(encoding="utf-8"))
    return text


def test_every_rule_and_every_command_has_a_page(site: Path) -> None:
    for code in rule_index.codes():
        assert (site / "rules" / code / "index.html").is_file()
    for command in COMMANDS:
        assert (site / "commands" / command / "index.html").is_file()
        assert f"commands/{command}/" in (site / "index.html").read_text(encoding="utf-8")


def test_every_public_name_is_described(site: Path) -> None:
    assert {f"urdfkit.{name}" for name in urdfkit.__all__} <= read(site / "api" / "index.html").ids


def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    for page in ("index.html", "start/index.html", "api/index.html"):
        assert not [link for link in read(site / page).loaded if "//" in link]


def test_a_broken_link_fails(tmp_path: Path) -> None:
    """With the settings of our site, and none of its pages."""
    settings = {
        "INHERIT": str(ROOT / "mkdocs.yml"),
        "hooks": [],
        "plugins": [],
        "nav": ["index.md"],
    }
    (tmp_path / "mkdocs.yml").write_text(json.dumps(settings))
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "index.md").write_text("# Here\n\n[gone](index.md#no-such-place)\n")
    done = build(tmp_path, tmp_path / "site")
    assert done.returncode == 1
    assert "no-such-place" in done.stderr


def test_llms_txt_lists_every_page_as_it_is_written(site: Path) -> None:
    text = (site / "llms.txt").read_text(encoding="utf-8")
    assert text.startswith("# urdfkit\n\n> urdfkit checks URDF and xacro robot models ")
    listed = re.findall(r"^- \[[^]]+\]\(([^)]+)\)", text, re.MULTILINE)
    pages = [*(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "commands").glob("*.md")]
    assert set(listed) == {str(page.relative_to(ROOT / "docs")) for page in pages}
    assert all((site / page).read_bytes() == (ROOT / "docs" / page).read_bytes() for page in listed)
    assert "- [urdfkit fix](commands/fix.md): Applies auto-fixes to source files" in text
