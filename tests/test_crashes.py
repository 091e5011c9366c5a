"""A bug of urdfkit costs the rules that need what is broken, and no other finding of any robot."""

import os
import re
import sys
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.conftest import MODELS
from tests.damage import damaged
from tests.xacros import xacro
from urdfkit import Source, check
from urdfkit.checks import APPLIES
from urdfkit.cli import main
from urdfkit.lint import rule_examples, rule_index, runner
from urdfkit.lint.context import Context
from urdfkit.lint.description_file import DescriptionFile
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.lint.rules import Rule
from urdfkit.output import formats
from urdfkit.robot.assets.collision_mismatches import VisualCollisionPairs
from urdfkit.robot.inertials.masses import Masses

#: Something to say for rules of many kinds: a tensor, a mesh, a plugin, an unlike collision.
ROBOT = """\
<robot name="r">
  <link name="base">
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="9" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="package://nowhere/a.stl"/></geometry></visual>
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <collision><origin xyz="0 0 5"/><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <link name="arm"/>
  <joint name="j" type="revolute"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 2"/></joint>
  <gazebo><plugin name="p" filename="libgazebo_ros_difdrive.so"/></gazebo>
  <gazebo reference="none"><sensor name="s" type="camera"/></gazebo>
</robot>
"""


def fail(*_: object) -> Any:
    raise ZeroDivisionError("planted")


def reported(report: Report) -> list[tuple[str, str, int]]:
    return [(d.span.source.path, d.code, d.span.start) for d in report.diagnostics]


@pytest.fixture
def robots(tmp_path: Path) -> list[Path]:
    paths = [tmp_path / "one.urdf", tmp_path / "two.urdf"]
    for path in paths:
        path.write_text(ROBOT)
    return paths


#: What is broken, and the beginnings of the codes of the rules that cannot do without it.
PARTS = [
    (Masses, "inertias", ("INE", "XAC014", "GEO", "DYN", "TRE")),
    (Context, "masses", ("INE", "XAC014", "DYN", "TRE", "GEO")),
    (Context, "files", ("MSH", "GEO", "PKG", "INE", "COL", "DYN", "XAC011", "XAC014")),
    (Context, "deviations", ("URD", "XAC002")),
    (Context, "plugins", ("GAZ", "RCT")),
    (Context, "ignores", ()),
    (Context, "targets", ("",)),
    (VisualCollisionPairs, "mismatches", ("GEO",)),
]


@pytest.mark.parametrize(("owner", "name", "lost"), PARTS, ids=str)
def test_a_part_that_fails_costs_its_rules(
    owner: type, name: str, lost: tuple[str, ...], robots: list[Path], monkeypatch
) -> None:
    before = reported(check(*robots))
    part = cached_property(fail)
    part.__set_name__(owner, name)
    monkeypatch.setattr(owner, name, part)
    report = check(*robots)
    assert report.exit_code() == 3
    assert {crash.path for crash in report.crashed} == set(map(str, robots))
    assert {crash.error for crash in report.crashed} == {"ZeroDivisionError: planted"}
    crashed = {crash.code for crash in report.crashed}
    assert all(code.startswith(lost or ("",)) for code in crashed if code)
    assert crashed.isdisjoint(report.rules)
    kept = [one for one in before if one[1] not in crashed]
    assert kept
    assert [one for one in kept if one not in reported(report)] == []


@pytest.mark.parametrize("family", ["geometry", "gazebo_plugins", "inertia", "joints", "meshes"])
def test_a_family_that_cannot_say_whether_it_applies_costs_its_rules(
    family: str, robots: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    before = reported(check(*robots))
    monkeypatch.setitem(APPLIES, family, fail)
    report = check(*robots)
    lost = rule_index.of_family(family)
    assert reported(report) == [one for one in before if one[1] not in lost]
    assert {(c.code, c.path) for c in report.crashed} == {(c, str(p)) for c in lost for p in robots}


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_robot_that_fails_costs_no_other_robot(
    jobs: int, robots: list[Path], monkeypatch
) -> None:
    before = [one for one in reported(check(*robots)) if one[0] == str(robots[0])]
    read = vars(DescriptionFile)["reading"].func
    broken = str(robots[1])

    def reading(context: Context) -> object:
        return fail() if context.source.path == broken else read(context)

    part = cached_property(reading)
    part.__set_name__(Context, "reading")
    monkeypatch.setattr(Context, "reading", part)
    report = check(*robots, options=Options(jobs=jobs))
    assert reported(report) == before
    assert [(c.code, c.path) for c in report.crashed] == [("", broken)]


@pytest.mark.parametrize("jobs", [2, 3])
def test_a_process_that_dies_costs_its_robot_alone(
    jobs: int, robots: list[Path], tmp_path: Path, monkeypatch
) -> None:
    robots += [tmp_path / "three.urdf", tmp_path / "four.urdf"]
    for path in robots[2:]:
        path.write_text(ROBOT)
    deadly = [str(robots[0]), str(robots[2])]
    before = [one for one in reported(check(*robots)) if one[0] not in deadly]
    read = vars(DescriptionFile)["reading"].func

    def reading(context: Context) -> object:
        return os._exit(9) if context.source.path in deadly else read(context)

    part = cached_property(reading)
    part.__set_name__(Context, "reading")
    monkeypatch.setattr(Context, "reading", part)
    calls: list[tuple[int, int]] = []
    report = check(*robots, options=Options(jobs=jobs, progress=lambda *n: calls.append(n)))
    assert reported(report) == before
    assert [(c.code, c.path) for c in report.crashed] == [("", path) for path in deadly]
    assert report.exit_code() == 3
    assert calls == [(n, 4) for n in range(1, 5)]


def test_a_directory_that_cannot_be_searched_costs_no_other_file(
    robots: list[Path], tmp_path: Path, monkeypatch
) -> None:
    before = reported(check(*robots))
    monkeypatch.setattr("urdfkit.lint.discovery.discover", fail)
    report = check(tmp_path, *robots)
    assert reported(report) == before
    assert [(c.code, c.path) for c in report.crashed] == [("", str(tmp_path))]


@pytest.mark.parametrize("name", formats.names())
def test_every_format_tells_of_a_check_that_fails(
    name: str, robots: list[Path], monkeypatch
) -> None:
    monkeypatch.setattr(Context, "model", property(fail))
    text = formats.get(name)(check(*robots))
    if name not in ("gitlab", "rdjson", "statistics"):  # which hold findings only
        assert "ZeroDivisionError: planted" in " ".join(text.split())


def test_rules_that_fail_alike_are_one_line(robots: list[Path], monkeypatch, capsys) -> None:
    monkeypatch.setattr(Context, "model", property(fail))
    assert main(["check", str(robots[0])]) == 3
    out = " ".join(capsys.readouterr().out.split())
    assert out.count("ZeroDivisionError: planted") == 1
    assert re.search(r" and \d+ more failed", out)


def test_a_launch_file_that_fails_costs_no_robot(robots: list[Path], monkeypatch) -> None:
    launch = robots[0].with_name("r.launch")
    launch.write_text("<launch/>")
    before = reported(check(*robots))
    monkeypatch.setattr("urdfkit.ros.launch.read_launch", fail)
    report = check(launch, *robots)
    assert reported(report) == before
    assert {crash.path for crash in report.crashed} == {str(launch)}


# --- what a model may lack

GOOD = sorted((MODELS / "good").rglob("*.urdf*"))


def examples(rule: Rule) -> Iterator[tuple[str, str, str]]:
    """Damaged examples of a rule: the robot, and the name and text of a damaged file next to it."""
    for which in ("BAD", "GOOD"):
        robot = rule.example(which) or ""
        for text in damaged(rule_examples.whole_robot(robot)):
            yield text, "", ""
        files: dict[str, bytes] = getattr(sys.modules[rule.module], "FILES", {})
        for name, data in files.items():
            if name.endswith((".xml", ".srdf", ".yaml", ".launch", ".urdf", ".xacro")):
                for text in damaged(data.decode("utf-8", "surrogateescape")):
                    yield robot, name, text


def crashed(rule: Rule, robot: str, name: str, text: str) -> object:
    """The rules, of all there are, that fail on a damaged example."""
    with rule_examples.laid_out(rule, robot) as source:
        if name:
            folder = source.path.removesuffix(getattr(sys.modules[rule.module], "NAME", ""))
            folder = folder.removesuffix("example.urdf")
            data = text.encode("utf-8", "surrogateescape")
            Path(folder, name).write_bytes(data)
        context = rule_examples.context_of(rule, source)
        return runner.run_rules(context, rule_index.codes()).crashed


def sample(items: Iterator[Any], count: int, seed: str) -> list[Any]:
    found = list(items)
    return Random(seed).sample(found, min(len(found), count))


@pytest.mark.parametrize("path", GOOD, ids=lambda p: p.name)
def test_no_rule_fails_on_a_robot_with_a_defect(path: Path, pytestconfig: pytest.Config) -> None:
    count = 1000 if pytestconfig.getoption("thorough") else 40
    for text in sample(damaged(path.read_text()), count, path.name):
        assert check(Source(str(path), text.encode())).crashed == (), text


@pytest.mark.parametrize("family", sorted(rule_index.FAMILIES))
def test_no_rule_fails_on_an_example_with_a_defect(
    family: str, pytestconfig: pytest.Config
) -> None:
    """Of every rule, its own examples and the files next to them; every rule must bear them."""
    count = 20 if pytestconfig.getoption("thorough") else 2
    for code in rule_index.codes():
        if code.startswith(family):
            rule = rule_index.get(code)
            for example in sample(examples(rule), count, code):
                assert crashed(rule, *example) == (), example


@pytest.mark.parametrize("lost", ["ixx", "iyy", "izz", "ixy"])
def test_a_tensor_of_a_macro_that_lacks_a_number(lost: str) -> None:
    tensor = '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>'
    tensor = re.sub(rf' {lost}="[^"]*"', "", tensor)
    body = f"""<xacro:macro name="part" params="name mass"><link name="${{name}}"><inertial>
      <mass value="${{mass}}"/>{tensor}</inertial></link></xacro:macro>
      <xacro:part name="a" mass="1"/><xacro:part name="b" mass="5"/>
      <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>"""
    report = check(Source("robot.xacro", xacro(body).encode()))
    assert report.crashed == ()
    (found,) = [one for one in report.diagnostics if one.code == "XAC014"]
    assert "same inertia tensor (0.1, 0.1" in found.message
