"""``check --simulate``: rules that simulate the robot, within limits, only with the option."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mujoco")

from tests.conftest import ROOT
from urdfkit.checks.simulation.sim001_unstable import BAD, GOOD
from urdfkit.cli import main
from urdfkit.lint.rule_examples import whole_robot

CHECK = ["check", "--isolated", "--no-cache"]


@pytest.fixture
def bad(tmp_path: Path) -> str:
    file = tmp_path / "bad.urdf"
    file.write_text(whole_robot(BAD))
    return str(file)


def found(capsys: pytest.CaptureFixture[str]) -> list[tuple[str, str, int]]:
    """Code, severity and line of the findings about simulations in JSON."""
    return [
        (one["code"], one["severity"], one["line"])
        for one in json.loads(capsys.readouterr().out)["diagnostics"]
        if one["code"].startswith("SIM")
    ]


def test_only_with_the_option(bad: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*CHECK, bad, "--simulate", "--fail-on", "error", "--format", "json"]) == 1
    assert found(capsys) == [("SIM001", "error", 8)]
    assert main([*CHECK, bad, "--fail-on", "error", "--format", "json"]) == 0
    assert found(capsys) == []


def test_comments_selection_and_formats(bad: str, capsys: pytest.CaptureFixture[str]) -> None:
    file = Path(bad)
    text = file.read_text()
    ignored = "<!-- urdfkit: ignore[SIM001] thrown on purpose -->\n<collision>"
    file.write_text(text.replace("<collision>", ignored))
    assert main([*CHECK, bad, "--simulate", "--format", "json"]) in (0, 1)
    assert found(capsys) == []
    file.write_text(text)
    assert main([*CHECK, bad, "--simulate", "--select", "SIM", "--format", "sarif"]) == 1
    (run,) = json.loads(capsys.readouterr().out)["runs"]
    assert [one["ruleId"] for one in run["results"]] == ["SIM001"]
    assert main([*CHECK, bad, "--simulate", "--ignore", "SIM", "--format", "json"]) in (0, 1)
    assert found(capsys) == []


def test_several_robots_in_processes(
    bad: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "good.urdf").write_text(whole_robot(GOOD))
    words = [str(tmp_path), "--simulate", "--select", "SIM", "--jobs", "2", "--format", "json"]
    assert main([*CHECK, *words]) == 1
    assert found(capsys) == [("SIM001", "error", 8)]


def test_a_robot_that_cannot_be_simulated_is_a_finding(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "gone.urdf"
    mesh = '<collision><geometry><mesh filename="gone.stl"/></geometry></collision>'
    file.write_text(whole_robot(GOOD).replace("</link>", f"{mesh}</link>", 1))
    assert main([*CHECK, str(file), "--simulate", "--select", "SIM", "--format", "json"]) == 1
    report = json.loads(capsys.readouterr().out)
    (unchecked,) = report["diagnostics"]
    message = "robot not simulated: mesh files of collisions are missing"
    assert (unchecked["code"], unchecked["message"]) == ("CFG003", message)
    skipped = report["skipped"]
    assert [one["code"] for one in skipped] == ["SIM001", "SIM002", "SIM003", "SIM004"]
    reason = "not simulated: mesh files of collisions are missing"
    assert {one["reason"] for one in skipped} == {reason}


def test_each_variant_is_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = '<origin xyz="0.1 0 0"/>'
    assert place in BAD
    robot = BAD.replace(place, place.replace("0.1", "$(arg x)"))
    (tmp_path / "robot.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:arg name="x" default="0.6"/>\n{robot}</robot>'
    )
    (tmp_path / "urdfkit.toml").write_text(
        '[[robot]]\nfile = "robot.urdf.xacro"\nvariants = {near = {x = "0.1"}, far = {x = "0.6"}}\n'
    )
    words = ["check", str(tmp_path), "--no-cache", "--simulate", "--select", "SIM"]
    assert main([*words, "--format", "json"]) == 1
    (one,) = json.loads(capsys.readouterr().out)["diagnostics"]
    assert (one["code"], one["variants"]) == ("SIM001", ["near"])


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["--select", "SIM001"], "--select SIM001 needs --simulate"),
        (["--timeout", "3"], "--timeout needs --simulate"),
        (["--simulate", "--timeout", "soon"], "--timeout soon: write a number from 0.01"),
        (["--simulate", "--fix"], "--simulate cannot be combined with --fix or --diff"),
    ],
)
def test_options_that_do_not_go_together(
    words: list[str], error: str, bad: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*CHECK, bad, *words]) == 2
    assert error in capsys.readouterr().err


def test_without_mujoco(
    bad: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in list(sys.modules):
        if name.startswith("urdfkit.output.simulation."):
            monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "mujoco", None)
    assert main([*CHECK, bad, "--simulate"]) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: --simulate needs mujoco: ")
    assert "[simulate]" in error


_IMPORTS = "import sys; from urdfkit.cli import main, result_cache"


def run(program: str, *words: str, cache: Path) -> subprocess.CompletedProcess[str]:
    """A program in another process, which imports urdfkit."""
    return subprocess.run(
        [sys.executable, "-c", f"{_IMPORTS}\n{program}", *words],
        check=False,
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "URDFKIT_CACHE_DIR": str(cache)},
    )


@pytest.mark.skipif(os.name == "nt", reason="Windows cannot fork")
def test_a_simulation_that_takes_too_long(bad: str, tmp_path: Path) -> None:
    done = run("main()", *CHECK, bad, "--simulate", "--timeout", "0.01", cache=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("error: not finished after 0.01 s")
    assert "--timeout raises the limit" in done.stderr


def test_the_result_is_cached_with_the_option(
    bad: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    cache, words = tmp_path_factory.mktemp("cache"), ["check", "--isolated", bad]
    first = run("main()", *words, "--simulate", cache=cache)
    assert "SIM001" in first.stdout
    replay = "print(result_cache.replay(sys.argv[1:]))"
    again = run(replay, *words, "--simulate", cache=cache)
    assert again.stdout == f"{first.stdout}1\n"
    assert run(replay, *words, cache=cache).stdout == "None\n"
