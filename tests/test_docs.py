"""The generated documents are those of the rules as they are."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import urdfkit
from docs import animation, generate, layers, transcripts
from tests.conftest import ROOT
from urdfkit.cli.group import COMMANDS
from urdfkit.lint import rule_index
from urdfkit.ros.importers.facts import GAZEBO, IMPORTERS

WRITTEN = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("benchmarks/*.md")])


def test_the_chinese_readme_says_the_same() -> None:
    """The same commands, programs, chapters and links; comments in commands are translated."""
    found = []
    for page in (transcripts.README, transcripts.CHINESE):
        text = page.read_text(encoding="utf-8")
        blocks = re.findall(r"^```\w+\n.*?^```$", text, re.DOTALL | re.MULTILINE)
        links = re.findall(r"\]\(([^)]+)\)", text)
        found.append(
            (
                [re.sub(r" {2,}# .*", "", block) for block in blocks],
                re.findall(r"^#+", text, re.MULTILINE),
                sorted(set(links) - {"README.md", "README.zh.md"}),
            )
        )
    assert found[0] == found[1]


@pytest.mark.skipif(os.name == "nt", reason="the animation shows Unix paths")
def test_the_animation_is_what_is_printed() -> None:
    pytest.importorskip("trimesh")
    pytest.importorskip("PIL")
    shown = animation.FILE.read_text(encoding="utf-8")
    assert animation.drawn() == shown, "run: python docs/animation.py"


def test_readme_leads_to_every_command() -> None:
    readme = transcripts.README.read_text(encoding="utf-8")
    shown = {"lsp": "(docs/editors.md)"}
    missing = [
        name
        for name in COMMANDS
        if shown.get(name, f"[{name}](docs/commands/{name}.md)") not in readme
    ]
    assert missing == []


@pytest.mark.parametrize("page", [transcripts.README, transcripts.CHINESE])
def test_the_counts_in_readme_are_true(page: Path) -> None:
    from tests.test_planted import PLANTS

    text = page.read_text(encoding="utf-8")
    counts = [int(number) for number in re.findall(r"^\| (\d+) ", text, re.MULTILINE)]
    assert counts[:2] == [len(rule_index.codes()), len(PLANTS)]
    assert counts[2] == len({*IMPORTERS, GAZEBO})
    assert f" {len(PLANTS)} " in (transcripts.ROOT / "docs" / "comparison.md").read_text("utf-8")


def test_the_road_in_readme_fixes_the_robot(tmp_path: Path) -> None:
    """The commands of the story, one after the other, in a shell."""
    pytest.importorskip("trimesh")
    pytest.importorskip("PIL")
    pytest.importorskip("jinja2")
    text = transcripts.README.read_text(encoding="utf-8")
    (story,) = re.findall(r"^```sh\n(cp -r .*?)^```$", text, re.DOTALL | re.MULTILINE)
    shutil.copytree(ROOT / "models", tmp_path / "models")
    program = f'urdfkit() {{ PYTHONPATH="{ROOT}" "{sys.executable}" -m urdfkit "$@"; }}\n'
    done = subprocess.run(
        ["sh", "-c", program + story],
        check=False,
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "error" not in done.stderr
    for file in ("robot.png", "robot.html", "meshes/hokuyo.dae"):
        assert (tmp_path / "mine" / file).stat().st_size > 10_000
    report = urdfkit.check(tmp_path / "mine" / "urdf" / "waking_robot_new.xacro")
    assert report.ok


def test_every_rule_has_a_page() -> None:
    pytest.importorskip("pinocchio", reason="the examples of some rules need it")
    assert set(generate.pages()) == {"README.md"} | {f"{code}.md" for code in rule_index.codes()}


@pytest.mark.parametrize(
    "document",
    [*WRITTEN, *ROOT.glob("docs/commands/*.md"), *ROOT.glob("examples/*/README.md")],
    ids=lambda path: f"{path.parent.name}/{path.name}",
)
def test_links_lead_to_files_that_exist(document: Path) -> None:
    text = document.read_text(encoding="utf-8")
    targets = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    assert [link for link in targets if not (document.parent / link).exists()] == []


@pytest.mark.parametrize("document", WRITTEN, ids=lambda path: path.name)
def test_the_rules_that_are_named_exist(document: Path) -> None:
    text = document.read_text(encoding="utf-8")
    named = set(re.findall(r"\b(?:XML|XAC|URD|REF|NAM|TRE|MSH|CFG)\d{3}\b", text))
    assert named <= set(rule_index.codes())


def test_the_architecture_names_every_package() -> None:
    directory = ROOT / "urdfkit"
    packages = {f"{path.parent.name}/" for path in directory.glob("*/__init__.py")}
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`([a-z_]+/)`", text.partition("\n## ")[0]))
    assert packages <= named


def test_the_drawing_of_the_layers_shows_every_package() -> None:
    """As an image: a browser needs a script from elsewhere for Mermaid, and showed its text."""
    text = layers.PICTURE.read_text(encoding="utf-8")
    drawn = re.findall(r">(\w+)</text>", text)
    assert drawn == [name for layer in layers.layers() for name in layer]
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    assert f"(pictures/{layers.PICTURE.name})" in page
