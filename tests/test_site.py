"""The site of the documentation, built as CI builds it."""

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path

import pytest
import yaml

import urdfkit
from tests.conftest import ROOT
from tests.output.report.browsers import Page, browser, needs_browser, served
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
        "theme": {"custom_dir": str(ROOT / "docs" / "theme")},
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


# --- the filter of the rules


@pytest.fixture(scope="module")
def rules_page(site: Path) -> Iterator[Page]:
    with served(site) as address, browser() as page:
        page.driver.get(f"{address}/rules/")
        yield page


def listed(page: Page) -> dict[str, str]:
    """The codes and severities of the rules that are shown."""
    rows = page.driver.find_elements("css selector", "tbody tr")
    cells = [row.text.split() for row in rows if row.is_displayed()]
    return {code: severity for code, _, severity, *_ in cells}


def choose(page: Page, **values: str) -> dict[str, str]:
    """Set the filter, and return what it lists."""
    for name, value in ({"text": "", "severity": "", "target": ""} | values).items():
        page.run(
            "const field = document.querySelector(`#filter [name=${arguments[0]}]`);"
            "field.value = arguments[1];"
            "field.dispatchEvent(new Event('input', {bubbles: true}));",
            name,
            value,
        )
    return listed(page)


@needs_browser
def test_the_filter_ignores_pages_with_a_heading_of_that_name(rules_page: Page) -> None:
    """Each page has the script, and that of the targets an element with the id of its data."""
    address = rules_page.driver.current_url
    rules_page.errors.clear()
    rules_page.driver.get(address.replace("/rules/", "/targets/"))
    assert [error for error in rules_page.errors if "versions.json" not in error] == []
    rules_page.driver.get(address)


@needs_browser
def test_all_rules_are_listed_without_a_filter(rules_page: Page) -> None:
    rules = {rule.code: rule.severity.value for rule in rule_index.all_rules()}
    assert choose(rules_page) == rules
    assert rules_page.find("#filter output").text == f"{len(rules)} rules"


@needs_browser
def test_rules_by_text_and_severity(rules_page: Page) -> None:
    found = choose(rules_page, text="UNUSED comment")
    assert found == {"CFG001": "info"} | found
    assert 0 < len(found) < 5
    headings = rules_page.driver.find_elements("css selector", "article h2")
    assert [one.text[:3] for one in headings if one.is_displayed()] == ["CFG"]
    errors = [r.code for r in rule_index.all_rules() if r.severity.value == "error"]
    assert [*choose(rules_page, severity="error")] == errors
    assert choose(rules_page, text="nosuchword") == {}
    assert rules_page.find("#filter output").text == "0 rules"


@needs_browser
def test_rules_of_a_target_have_its_severities(rules_page: Page) -> None:
    found = choose(rules_page, target="gz-harmonic")
    assert found["INE004"] == "error"
    assert rule_index.get("INE004").severity.value != "error"
    assert len(found) == len(rule_index.codes())
    found = choose(rules_page, target="mujoco", severity="warning")
    assert set(found.values()) == {"warning"}
    assert not any(code.startswith(("GAZ", "SRD")) for code in found)
    assert choose(rules_page)["INE004"] == rule_index.get("INE004").severity.value


@needs_browser
def test_the_address_holds_the_filter(rules_page: Page) -> None:
    found = choose(rules_page, text="inertia", severity="warning", target="kdl")
    address = rules_page.driver.current_url
    assert address.endswith("/rules/?text=inertia&severity=warning&target=kdl")
    choose(rules_page)
    assert rules_page.driver.current_url.endswith("/rules/")
    rules_page.driver.get(address)
    assert 0 < len(found) < 50
    assert listed(rules_page) == found


# --- versions


def deploying() -> str:
    """What the workflow of a release runs to deploy the site."""
    text = (ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8")
    (step,) = (
        step
        for step in yaml.safe_load(text)["jobs"]["site"]["steps"]
        if step.get("name") == "Deploy"
    )
    return str(step["run"])


@pytest.fixture(scope="module")
def deployed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The branch that GitHub would serve, after two releases, each from a fresh clone."""
    pytest.importorskip("mike")
    directory = tmp_path_factory.mktemp("deployed")
    origin, pages = directory / "origin.git", directory / "pages"
    subprocess.run(["git", "init", "-q", "--bare", origin], check=True)
    without = shutil.ignore_patterns("__pycache__", "rules")  # docs/rules is written by the build
    (directory / "npm").write_text("#!/bin/sh\nexit 1\n")  # the playground has tests of its own
    (directory / "npm").chmod(0o755)
    programs = os.pathsep.join(
        (str(directory), str(Path(sys.executable).parent), os.environ["PATH"])
    )
    for tag in ("v0.1.0", "v0.2.0"):
        clone = directory / tag
        subprocess.run(["git", "clone", "-q", origin, clone], check=True)
        for name in ("docs", "models", "urdfkit"):
            shutil.copytree(ROOT / name, clone / name, ignore=without, dirs_exist_ok=True)
        for name in ("mkdocs.yml", "CHANGELOG.md", "README.md"):
            shutil.copy(ROOT / name, clone)
        who = ("-c", "user.name=a", "-c", "user.email=a@b.c")
        for words in (
            ["add", "-A"],
            ["commit", "-qm", tag, "--allow-empty"],
            ["push", "-q", "origin", "HEAD"],
        ):
            subprocess.run(["git", *who, *words], cwd=clone, check=True)
        more = {"PATH": programs, "PYTHONPATH": str(clone), "TAG": tag}
        more |= {"REPOSITORY_URL": "https://github.com/a/urdfkit"}
        done = subprocess.run(
            ["bash", "-e", "-c", deploying()],
            check=False,
            cwd=clone,
            capture_output=True,
            text=True,
            env={**os.environ, **more},
        )
        assert done.returncode == 0, done.stderr
    subprocess.run(["git", "clone", "-q", "-b", "gh-pages", origin, pages], check=True)
    return pages


def test_a_release_adds_its_version_and_moves_latest(deployed: Path) -> None:
    versions = json.loads((deployed / "versions.json").read_text(encoding="utf-8"))
    assert versions == [
        {"version": "0.2", "title": "0.2.0", "aliases": ["latest"]},
        {"version": "0.1", "title": "0.1.0", "aliases": []},
    ]
    for version in ("0.1", "0.2", "latest"):
        assert (deployed / version / "rules" / "XML001" / "index.html").is_file()
    assert (deployed / "latest").resolve().name == "0.2"
    assert "latest/" in (deployed / "index.html").read_text(encoding="utf-8")


@needs_browser
def test_the_page_offers_the_versions_and_the_repository(deployed: Path) -> None:
    with served(deployed) as address, browser() as page:
        page.driver.get(f"{address}/0.1/faq/")
        page.driver.implicitly_wait(20)
        page.find("[data-md-component=outdated]:not([hidden])")
        assert "older version" in page.find(".md-banner--warning").text
        offered = page.driver.find_elements("css selector", ".md-version__link")
        names = {one.get_attribute("textContent"): one.get_attribute("href") for one in offered}
        assert names == {"0.2.0latest": f"{address}/0.2/", "0.1.0": f"{address}/0.1/"}
        link = page.find(".md-header .md-source")
        assert link.get_attribute("href") == "https://github.com/a/urdfkit"
        assert "GitHub" in link.text
        loaded = page.run("return performance.getEntriesByType('resource').map((one) => one.name)")
        assert [one for one in loaded if not one.startswith(address)] == []
        page.driver.get(f"{address}/latest/faq/")
        page.find(".md-version__link")
        assert not page.find(".md-banner--warning").is_displayed()
        assert page.errors == []
