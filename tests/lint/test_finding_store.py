"""Findings on disk are those in memory, in the same order."""

from pathlib import Path

import pytest

from tests.xacros import xacro
from urdfkit import check
from urdfkit.cli import main
from urdfkit.core import memo
from urdfkit.lint import finding_store
from urdfkit.lint.config_reader import load
from urdfkit.lint.engine import check_with
from urdfkit.lint.finding_store import StoredFindings
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.output import formats
from urdfkit.text.diagnostic import Severity

LOOP = '<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>'


@pytest.fixture
def robots(tmp_path: Path) -> Path:
    """Robots that include one file with a defect, and each have one of their own."""
    (tmp_path / "shared.xacro").write_text(f'<robot name="r"><link name="a"/>{LOOP}</robot>')
    for number in range(12):
        (tmp_path / f"r{number}.urdf.xacro").write_text(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
            '<xacro:include filename="shared.xacro"/>\n'
            f'<link name="b{number}"/><link name="b{number}"/></robot>'
        )
    return tmp_path


def spilled(directory: Path, monkeypatch: pytest.MonkeyPatch) -> Report:
    monkeypatch.setattr(finding_store, "IN_MEMORY", 2)
    monkeypatch.setattr(finding_store, "MAX_REPORTED", 2)
    return check_with(Options(), [str(directory)], spills=True)


def test_they_are_the_same_in_the_same_order(robots: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    expected = check_with(Options(), [str(robots)])
    report = spilled(robots, monkeypatch)
    assert isinstance(report.diagnostics, StoredFindings)
    places = [(str(one.span), one.code, one.message) for one in expected.diagnostics]
    assert [(str(one.span), one.code, one.message) for one in report.diagnostics] == places
    assert len(report.diagnostics) == len(places)
    assert report.diagnostics[1].message == places[1][2]
    assert [one.message for one in report.diagnostics[:2]] == [place[2] for place in places[:2]]
    for severity in Severity:
        assert report.count(severity) == expected.count(severity)
    assert report.exit_code() == expected.exit_code()


def test_what_is_forgotten_is_found_again(robots: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    expected = check_with(Options(), [str(robots)])
    monkeypatch.setattr(memo, "LIMIT", 1)
    render = formats.get("json")
    assert render(check_with(Options(), [str(robots)])) == render(expected)


@pytest.mark.parametrize("name", formats.names())
def test_every_format_writes_the_same(
    name: str, robots: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = formats.get(name)(check_with(Options(), [str(robots)]))
    report = spilled(robots, monkeypatch)
    assert "".join(formats.stream(name, report)) == expected
    assert formats.get(name)(report) == expected


def test_the_command_writes_them(
    robots: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["check", str(robots), "--no-cache", "--format", "github", "--jobs", "1"]
    assert main(words) == 1
    expected = capsys.readouterr().out
    monkeypatch.setattr(finding_store, "IN_MEMORY", 2)
    file = robots.parent / "out.txt"
    assert main([*words, "--format", f"json:{file}"]) == 1
    assert capsys.readouterr().out == expected
    assert file.read_text().count('"code": "NAM001"') == 12


def test_one_element_with_other_names_has_one_finding(tmp_path: Path) -> None:
    """Variants of a robot, and two robots with a macro in common, each with names of their own."""
    wheel = '<link name="${name}"/><joint name="${name}_j" type="revolut">{}</joint>'
    ends = '<parent link="base"/><child link="${name}"/>'
    (tmp_path / "wheel.xacro").write_text(
        xacro(f'<xacro:macro name="wheel" params="name">{wheel.replace("{}", ends)}</xacro:macro>')
    )
    head = '<xacro:include filename="wheel.xacro"/><xacro:arg name="side" default="left"/>'
    for number in range(2):
        call = f'<xacro:wheel name="$(arg side)_{number}"/>'
        (tmp_path / f"r{number}.xacro").write_text(xacro(f'{head}<link name="base"/>{call}'))
    sides = "".join(f'variants.{side} = {{ side = "{side}" }}\n' for side in ("left", "right"))
    (tmp_path / "urdfkit.toml").write_text(f'[[robot]]\nfile = "r0.xacro"\n{sides}')
    robots = (tmp_path / "r0.xacro", tmp_path / "r1.xacro")
    config = load(str(tmp_path / "urdfkit.toml"))
    (found,) = check(*robots, select=["JNT001"], config=config).diagnostics
    names = [call.message.split("'")[1] for call in found.calls]
    assert names == ["left_0_j", "right_0_j", "left_1_j"]
    assert found.variants == ()


def test_findings_at_one_place_that_differ_by_more_than_names(tmp_path: Path) -> None:
    """The meshes of the variants of an arm."""
    mesh = '<visual><geometry><mesh filename="$(arg kind).stl"/></geometry></visual>'
    source = f'<xacro:arg name="kind" default="a"/><link name="base">{mesh}</link>'
    (tmp_path / "r.xacro").write_text(xacro(source))
    kinds = "".join(f'variants.{kind} = {{ kind = "{kind}" }}\n' for kind in "ab")
    (tmp_path / "urdfkit.toml").write_text(f'[[robot]]\nfile = "r.xacro"\n{kinds}')
    config = load(str(tmp_path / "urdfkit.toml"))
    found = check(tmp_path / "r.xacro", select=["MSH001"], config=config).diagnostics
    assert [one.variants for one in found] == [("a",), ("b",)]
