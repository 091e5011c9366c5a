"""The GitHub action and the GitLab template: their shell steps are run as the runners do it."""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.conftest import MODELS, ROOT
from tests.xacros import xacro

ACTION: dict[str, Any] = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
STEPS: list[dict[str, Any]] = ACTION["runs"]["steps"]
WORKFLOW = ROOT / ".github" / "workflows" / "robots.yml"
GITLAB: dict[str, Any] = yaml.safe_load(
    (ROOT / "templates" / "urdfkit.gitlab-ci.yml").read_text(encoding="utf-8")
)

needs_bash = pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")


def step(name: str) -> dict[str, Any]:
    (found,) = [step for step in STEPS if step["name"] == name]
    return found


class Runner:
    """Runs shell steps of the action in a directory of robots."""

    def __init__(self, workspace: Path, temporary: Path) -> None:
        self.workspace = workspace
        self.temporary = temporary
        self.output = temporary / "output"
        self.summary = temporary / "summary"
        self.values = {"github.event.pull_request.head.repo.fork": ""}

    def run(self, name: str, **inputs: str) -> subprocess.CompletedProcess[str]:
        """Run a step.

        Args:
            name: of the step.
            inputs: of the action, where they are not the defaults; ``-`` is written ``_``.
        """
        for key, value in ACTION["inputs"].items():
            self.values[f"inputs.{key}"] = inputs.get(key.replace("-", "_"), value["default"])
        environment = {
            **os.environ,
            "RUNNER_TEMP": str(self.temporary),
            "GITHUB_ACTION_PATH": str(ROOT),
            "GITHUB_OUTPUT": str(self.output),
            "GITHUB_STEP_SUMMARY": str(self.summary),
        }
        found = step(name)
        for key, value in found.get("env", {}).items():
            environment[key] = re.sub(
                r"\$\{\{ (\S+) \}\}", lambda match: self.values[match.group(1)], value
            )
        script = self.temporary / "step.sh"
        script.write_text(found["run"])
        words = ["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", str(script)]
        done = subprocess.run(
            words, check=False, cwd=self.workspace, env=environment, capture_output=True, text=True
        )
        if self.output.exists():
            for line in self.output.read_text().splitlines():
                key, _, value = line.partition("=")
                self.values[f"steps.check.outputs.{key}"] = value
        return done


@pytest.fixture
def runner(tmp_path: Path) -> Runner:
    """A runner where the first steps have been: 'urdfkit' is that of this checkout."""
    (tmp_path / "temp" / "urdfkit" / "bin").mkdir(parents=True)
    # As the installed program does, this imports nothing from the current directory.
    begin = f"import sys; sys.path.insert(0, '{ROOT}'); from urdfkit.cli import main; main()"
    for name, words in (("urdfkit", f'-I -c "{begin}" '), ("python", "")):
        program = tmp_path / "temp" / "urdfkit" / "bin" / name
        program.write_text(f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" {words}"$@"\n')
        program.chmod(0o755)
    shutil.copytree(MODELS, tmp_path / "robots")
    return Runner(tmp_path / "robots", tmp_path / "temp")


@needs_bash
@pytest.mark.skipif(importlib.util.find_spec("ensurepip") is None, reason="there is no ensurepip")
def test_it_installs_this_urdfkit(tmp_path: Path) -> None:
    """From a package registry, with the oldest rules of pip: nothing of the job is touched."""
    runner = Runner(tmp_path, tmp_path)
    runner.values["steps.python.outputs.python-path"] = sys.executable
    done = runner.run("Install", reports="false")
    assert done.returncode == 0, done.stderr
    program = tmp_path / "urdfkit" / "bin" / "urdfkit"
    heavy = subprocess.run(
        [program.with_name("python"), "-c", "import numpy"], check=False, capture_output=True
    )
    assert heavy.returncode != 0, "no extra was asked for"
    reported = subprocess.run([program, "--version"], check=True, capture_output=True, text=True)
    assert reported.stdout.startswith("urdfkit ")


@needs_bash
def test_clean_robots_are_green(runner: Runner) -> None:
    done = runner.run("Check", files="good")
    assert done.returncode == 0, done.stderr
    assert all(line.startswith("wrote ") for line in done.stdout.splitlines())
    assert runner.values["steps.check.outputs.exit-code"] == "0"
    assert runner.summary.read_text() == "### urdfkit: no findings in 3 files\n"
    assert runner.run("Result").returncode == 0


@needs_bash
def test_findings_are_reported_everywhere(runner: Runner) -> None:
    done = runner.run("Check", files="gazebo_pkg\n", options="--select\nMSH001")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(
        "::error file=gazebo_pkg/urdf/waking_robot_new.xacro,line=266,endLine=266,col=25"
    )
    assert runner.values["steps.check.outputs.exit-code"] == "1"
    reports = Path(runner.values["steps.check.outputs.reports"])
    names = {path.name for path in reports.iterdir()}
    assert names == {"summary.md", "urdfkit.json", "urdfkit.sarif"}
    (result,) = json.loads((reports / "urdfkit.sarif").read_text())["runs"][0]["results"]
    assert result["ruleId"] == "MSH001"
    assert "error **MSH001**" in runner.summary.read_text()
    assert runner.run("Result").returncode == 1


@needs_bash
def test_each_robot_gets_a_report_and_an_image(runner: Runner) -> None:
    pytest.importorskip("jinja2")
    pytest.importorskip("PIL")
    runner.run(
        "Check", files="good/gripper.urdf\ngazebo_pkg/launch/view_waking_robot.launch\nunused:=1"
    )
    done = runner.run("Reports", files="unused:=1")
    assert done.returncode == 0, done.stderr
    reports = Path(runner.values["steps.check.outputs.reports"])
    assert sorted(path.name for path in reports.glob("[0-9]*")) == [
        "1-gripper.urdf.html",
        "1-gripper.urdf.png",
        "2-waking_robot_new.xacro.html",
        "2-waking_robot_new.xacro.png",
    ]
    assert (reports / "1-gripper.urdf.png").read_bytes().startswith(b"\x89PNG")
    assert b"gripper" in (reports / "1-gripper.urdf.html").read_bytes()
    summary = runner.summary.read_text()
    (tree,) = re.findall(r"```mermaid\n(.*?)```", summary, re.DOTALL)
    assert tree.startswith("flowchart TD\n")
    assert '"left_finger"' in tree


@needs_bash
def test_each_variant_gets_a_report_and_an_image(runner: Runner) -> None:
    pytest.importorskip("jinja2")
    pytest.importorskip("PIL")
    (runner.workspace / "arm.urdf.xacro").write_text(
        xacro(
            '<link name="$(arg side)"><visual><geometry><sphere radius="1"/></geometry></visual>'
            "</link>"
        )
    )
    (runner.workspace / "urdfkit.toml").write_text(
        '[[robot]]\nfile = "arm.urdf.xacro"\n'
        'variants = {left = {side = "l"}, "the right" = {side = "r"}}\n'
    )
    runner.run("Check", files="arm.urdf.xacro")
    done = runner.run("Reports", files="arm.urdf.xacro")
    assert done.returncode == 0, done.stderr
    assert all(line.startswith("wrote ") for line in done.stdout.splitlines())
    reports = Path(runner.values["steps.check.outputs.reports"])
    assert sorted(path.name for path in reports.glob("[0-9]*")) == [
        "1-arm.urdf.xacro-left.html",
        "1-arm.urdf.xacro-left.png",
        "2-arm.urdf.xacro-the_right.html",
        "2-arm.urdf.xacro-the_right.png",
    ]


@needs_bash
def test_an_image_that_is_missing_is_reported(runner: Runner) -> None:
    pytest.importorskip("jinja2")
    (runner.workspace / "x.urdf").write_text("<robot")
    runner.run("Check", files="x.urdf")
    done = runner.run("Reports", files="x.urdf")
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        f"::warning title=urdfkit::no {what} of 1-x.urdf; the log of this step says why"
        for what in ("image", "tree")
    ]
    assert "x.urdf" in done.stderr
    assert "No image of `1-x.urdf`." in runner.summary.read_text()


@needs_bash
def test_it_runs_where_programs_are_in_scripts(runner: Runner) -> None:
    """As on Windows."""
    (runner.temporary / "urdfkit" / "bin").rename(runner.temporary / "urdfkit" / "Scripts")
    assert runner.run("Check", files="good").returncode == 0
    assert runner.values["steps.check.outputs.exit-code"] == "0"
    assert all("|| true" not in step.get("run", "") for step in STEPS)


@needs_bash
def test_no_name_breaks_out_of_the_tree(runner: Runner) -> None:
    pytest.importorskip("jinja2")
    name = "a```&#10;```&#10;# x &lt;b>"
    (runner.workspace / "x.urdf").write_text(f'<robot name="r"><link name="{name}"/></robot>')
    runner.run("Check", files="x.urdf")
    before = runner.summary.read_text()
    assert runner.run("Reports", files="x.urdf").returncode == 0
    added = runner.summary.read_text()[len(before) :]
    assert added.count("```") == 2
    assert "<b" not in added


@needs_bash
def test_the_summary_leads_to_what_was_uploaded(runner: Runner) -> None:
    runner.run("Check", files="good")
    runner.values["steps.artifact.outputs.artifact-url"] = "https://example.org/a?b=1"
    runner.values["steps.picture.outputs.artifact-url"] = ""
    assert runner.run("Links").returncode == 0
    assert runner.summary.read_text().endswith("\n[All reports](https://example.org/a?b=1)\n")
    assert "Picture" not in runner.summary.read_text()


@needs_bash
def test_what_cannot_be_done_fails_without_reports(runner: Runner) -> None:
    done = runner.run("Check", files="missing.urdf")
    assert done.returncode == 0
    assert "missing.urdf: file not found" in done.stderr
    assert not runner.summary.exists()
    assert "steps.check.outputs.reports" not in runner.values
    assert runner.run("Result").returncode == 2


@needs_bash
def test_words_of_the_inputs_are_words_and_no_code(runner: Runner) -> None:
    """Spaces, quotes, expansions and commands reach urdfkit as they stand."""
    strange = """a b'c"d $(touch hit) `touch hit` ; touch hit.urdf"""
    (runner.workspace / strange).write_text("<robot/>")
    done = runner.run("Check", files=strange, options="--select\nTRE001")
    assert runner.values["steps.check.outputs.exit-code"] == "1", done.stderr
    assert "TRE001" in done.stdout
    assert not (runner.workspace / "hit").exists()


@needs_bash
def test_a_robot_of_a_stranger_gives_the_runner_no_commands(runner: Runner) -> None:
    """Neither by what it is called, nor by what its names are, nor by its expressions."""
    (runner.workspace / "evil").mkdir()
    name = "a\n::set-output name=x::y".replace("\n", "&#10;")
    (runner.workspace / "evil" / "x.urdf").write_text(
        f'<robot name="r"><link name="{name}"/><link name="{name}"/></robot>'
    )
    (runner.workspace / "evil" / "y.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        "<link name=\"${__import__('os').system('touch hit')}\"/></robot>"
    )
    config = runner.workspace / "evil" / "urdfkit.toml"
    config.write_text('trust = true\nrule-packages = ["evil"]\n')
    done = runner.run("Check", files="evil/x.urdf\nevil/y.xacro", options="--isolated")
    lines = done.stdout.splitlines()
    assert lines
    assert all(re.match("::(error|warning|notice) file=", line) for line in lines)
    assert not (runner.workspace / "hit").exists()
    refused = runner.run("Check", files="evil/x.urdf")
    assert refused.stdout == ""
    assert runner.values["steps.check.outputs.exit-code"] == "2"


@needs_bash
@pytest.mark.parametrize(("fork", "count"), [("true", 1), ("false", 0), ("", 0)])
def test_a_fork_that_may_run_code_is_a_warning(runner: Runner, fork: str, count: int) -> None:
    runner.values["github.event.pull_request.head.repo.fork"] = fork
    (runner.workspace / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    done = runner.run("Check", files="r.urdf", options="--trust")
    assert done.stdout.count("--trust lets a pull request from a fork run code") == count


# --- what the files promise


def test_inputs_reach_the_shell_as_variables_only() -> None:
    scripts = [step["run"] for step in STEPS if "run" in step]
    assert len(scripts) == 5
    assert not any("${{" in script for script in scripts)
    assert all(step["shell"] == "bash" for step in STEPS if "run" in step)


def test_every_action_is_pinned_to_a_commit() -> None:
    text = (ROOT / "action.yml").read_text(encoding="utf-8") + WORKFLOW.read_text(encoding="utf-8")
    used = re.findall(r"^ *(?:- )?uses: (\S+)(?: # (v[\d.]+))?", text, re.MULTILINE)
    assert len(used) == 6
    for name, version in used:
        assert name == "./" or re.fullmatch(r"[\w./-]+@[0-9a-f]{40}", name)
        assert name == "./" or version


def test_no_secret_is_read_and_forks_cannot_write() -> None:
    text = (ROOT / "action.yml").read_text(encoding="utf-8")
    assert "secrets." not in text
    assert "github.token" not in text
    workflow = WORKFLOW.read_text(encoding="utf-8")
    assert "pull_request_target" not in workflow
    assert "persist-credentials: false" in workflow
    assert "head.repo.full_name == github.repository" in step("Code scanning")["if"]


def test_every_input_is_documented() -> None:
    page = (ROOT / "docs" / "pre-commit.md").read_text(encoding="utf-8")
    assert [name for name in ACTION["inputs"] if f"| `{name}` |" not in page] == []


def test_the_workflow_gives_inputs_that_there_are() -> None:
    job = yaml.safe_load(WORKFLOW.read_text(encoding="utf-8"))["jobs"]["urdfkit"]
    (used,) = [step for step in job["steps"] if step["uses"] == "./"]
    assert set(used["with"]) <= set(ACTION["inputs"])


@needs_bash
def test_the_script_of_gitlab(runner: Runner) -> None:
    """All lines but that of pip; the reports that are announced are written."""
    job = GITLAB["urdfkit"]
    files = "good/gripper.urdf bad/broken_meshes.urdf"
    assert job["script"][0].startswith("pip install ")
    done = run_of_gitlab(runner, job["script"][1:], files)
    assert done.returncode == 1, done.stderr
    assert "bad/broken_meshes.urdf" in done.stdout
    for report in job["artifacts"]["reports"].values():
        assert (runner.workspace / report).stat().st_size > 0
    done = run_of_gitlab(runner, job["after_script"], files)
    assert done.returncode == 0, done.stderr
    reports = runner.workspace / "urdfkit-reports"
    assert len([*reports.glob("*-gripper.urdf.html"), *reports.glob("*-gripper.urdf.png")]) == 2
    assert (reports / "summary.md").read_text().startswith("### ")


@needs_bash
def test_gitlab_takes_any_name(runner: Runner) -> None:
    """Names of variants come from the merge request."""
    pytest.importorskip("jinja2")
    (runner.workspace / "arm.urdf.xacro").write_text(xacro('<link name="$(arg side)"/>'))
    (runner.workspace / "urdfkit.toml").write_text(
        '[[robot]]\nfile = "arm.urdf.xacro"\n'
        r'variants = {"a\nb\t`touch ran`" = {side = "l"}, "$(touch ran)\"" = {side = "r"}}'
    )
    job = GITLAB["urdfkit"]
    for part in (job["script"][1:], job["after_script"]):
        done = run_of_gitlab(runner, part, "arm.urdf.xacro")
    assert done.returncode == 0, done.stderr
    assert r"no render of 'arm.urdf.xacro' 'a\nb\t`touch ran`'" in done.stdout
    assert sorted(path.name for path in (runner.workspace / "urdfkit-reports").glob("*.html")) == [
        "1-arm.urdf.xacro-a_b__touch_ran_.html",
        "2-arm.urdf.xacro-__touch_ran__.html",
    ]
    assert not (runner.workspace / "ran").exists()


@needs_bash
def test_python_imports_nothing_of_a_pull_request(runner: Runner) -> None:
    """Neither in the action nor in GitLab's job."""
    for name in ("json", "os", "pip", "subprocess", "sys", "urdfkit", "venv"):
        (runner.workspace / f"{name}.py").write_text("open('ran', 'w')\n")
    runner.run("Check", files="good/gripper.urdf")
    assert runner.run("Reports", files="good/gripper.urdf").returncode == 0
    job = GITLAB["urdfkit"]
    for part in (job["script"][1:], job["after_script"]):
        assert run_of_gitlab(runner, part, "good/gripper.urdf").returncode == 0
    assert not (runner.workspace / "ran").exists()


def test_python_is_always_started_apart_from_the_pull_request() -> None:
    scripts = [step["run"] for step in STEPS if "run" in step] + GITLAB["urdfkit"]["after_script"]
    started = [one for text in scripts for one in re.findall(r'(?i)python"? (-\S+)', text)]
    assert started == ["-I"] * 4


def run_of_gitlab(runner: Runner, lines: list[str], files: str) -> subprocess.CompletedProcess[str]:
    binaries = runner.temporary / "urdfkit" / "bin"
    environment = {
        **os.environ,
        **GITLAB["variables"],
        "URDFKIT_FILES": files,
        "PATH": f"{binaries}{os.pathsep}{os.environ['PATH']}",
    }
    return subprocess.run(
        ["bash", "-e", "-o", "pipefail", "-c", "\n".join(lines)],
        check=False,
        cwd=runner.workspace,
        env=environment,
        capture_output=True,
        text=True,
    )
