"""Which robots are checked when a text changes, and what is reported of them."""

import os
import shutil
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest

import urdfkit
from tests.conftest import MISSION, MODELS
from tests.lsp.edited import XACRO, Edited
from urdfkit.errors import Cancelled
from urdfkit.lsp.workspace import Workspace
from urdfkit.xacro.recovery import expand_repeatedly

LEG = XACRO.format(
    '<xacro:macro name="leg" params="p"><link name="${p}"/>{}</xacro:macro>'
).replace("{}", "%s")


def robots(directory: Path) -> Path:
    """Two robots that share a file of macros."""
    (directory / "legs.xacro").write_text(LEG % "")
    for name in ("one", "two"):
        (directory / f"{name}.xacro").write_text(
            XACRO.format(f'<xacro:include filename="legs.xacro"/>\n<xacro:leg p="{name}"/>')
        )
    return directory / "legs.xacro"


def codes(checked, path: Path) -> list[str]:
    return [found.code for found in checked.diagnostics.get(os.path.realpath(path), [])]


def test_the_findings_are_those_of_the_command_line() -> None:
    file = Edited(MISSION, MISSION.read_text(encoding="utf-8"))
    checked = file.workspace.check(file.path, thorough=True)
    assert checked.failure == ""
    reported = [(f.code, f.span.start, f.message) for f in checked.diagnostics[file.path]]
    report = urdfkit.check(MISSION)
    assert reported == [(f.code, f.span.start, f.message) for f in report.diagnostics]
    assert len(reported) > 40


def test_the_text_counts_and_not_the_file() -> None:
    text = MISSION.read_text(encoding="utf-8").replace('value="3.1415926"', 'value="${pi}"')
    file = Edited(MISSION, text)
    assert "XAC007" not in codes(file.workspace.check(file.path), MISSION)
    file.workspace.close(file.path)
    assert "XAC007" in codes(file.workspace.check(file.path), MISSION)


def test_a_text_is_expanded_once(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A text that takes as long as it may must not delay an editor several times."""
    file = Edited(tmp_path / "r.xacro", XACRO.format('<link name="${1}"/>'))
    expanded: list[object] = []

    def counted(request: Any) -> Any:
        expanded.append(request)
        return expand_repeatedly(request)

    monkeypatch.setattr("urdfkit.xacro.expand_repeatedly", counted)
    file.workspace.check(file.path)
    file.workspace.check(file.path, thorough=True)
    file.workspace.robot(file.path).markup(file.path)
    assert len(expanded) == 1
    file.workspace.set_text(file.path, XACRO.format('<link name="${2}"/>').encode())
    file.workspace.check(file.path)
    assert len(expanded) == 2


def test_a_cancelled_check_ends_before_the_next_rule_and_changes_nothing() -> None:
    file = Edited(MISSION, MISSION.read_text(encoding="utf-8"))
    before = file.workspace.check(file.path)
    file.workspace.set_text(file.path, b"<robot/>")
    asked: list[bool] = []

    def is_cancelled() -> bool:
        asked.append(len(asked) > 1)
        return asked[-1]

    with pytest.raises(Cancelled):
        file.workspace.check(file.path, is_cancelled=is_cancelled)
    assert asked == [False, False, True]
    assert list(file.workspace._findings(file.path)) == before.diagnostics[file.path]
    assert codes(file.workspace.check(file.path), MISSION) != codes(before, MISSION)


def test_a_file_of_macros_is_checked_in_every_robot_that_includes_it(tmp_path: Path) -> None:
    legs = robots(tmp_path)
    bad = '<joint name="j_${p}" type="fixed"><parent link="${p}"/><child link="no"/></joint>'
    file = Edited(legs, LEG % bad)
    checked = file.workspace.check(file.path)
    (found,) = [d for d in checked.diagnostics[file.path] if d.code == "REF001"]
    assert "'no'" in found.message
    assert codes(checked, tmp_path / "one.xacro") == codes(checked, tmp_path / "two.xacro")
    file.type(LEG % "")
    assert codes(file.workspace.check(file.path), legs) == []


def test_what_one_robot_finds_stays_when_the_other_is_checked(tmp_path: Path) -> None:
    legs = robots(tmp_path)
    two = tmp_path / "two.xacro"
    workspace = Workspace()
    bad = "<xacro:if value=\"${p == 'two'}\"><foo/></xacro:if>"
    file = Edited(legs, LEG % bad, workspace)
    assert codes(workspace.check(file.path), legs) == ["URD001"]
    one = Edited(tmp_path / "one.xacro", (tmp_path / "one.xacro").read_text(), workspace)
    assert codes(workspace.check(one.path), legs) == ["URD001"]
    two.write_text(two.read_text().replace('p="two"', 'p="three"'))
    workspace.reload()
    assert codes(workspace.check(file.path), legs) == []


def test_a_file_that_is_not_on_disk(tmp_path: Path) -> None:
    file = Edited(tmp_path / "new.urdf", '<robot name="r"></robot>')
    assert codes(file.workspace.check(file.path), tmp_path / "new.urdf") == ["TRE001"]
    workspace = Workspace()
    workspace.set_text("untitled:Untitled-1", b"<robot")
    checked = workspace.check("untitled:Untitled-1")
    assert [d.code for found in checked.diagnostics.values() for d in found] == ["XML001"]


def test_the_configuration_counts_and_its_mistakes_are_reported(tmp_path: Path) -> None:
    (tmp_path / "urdfkit.toml").write_text('ignore = ["TRE001"]\n')
    file = Edited(tmp_path / "r.urdf", '<robot name="r"></robot>')
    assert codes(file.workspace.check(file.path), tmp_path / "r.urdf") == []
    (tmp_path / "urdfkit.toml").write_text('ignroe = ["TRE001"]\n')
    file.workspace.reload()
    checked = file.workspace.check(file.path)
    assert "did you mean 'ignore'" in checked.failure
    assert codes(checked, tmp_path / "r.urdf") == ["TRE001"]


def test_a_configuration_from_anywhere_runs_no_code(tmp_path: Path) -> None:
    (tmp_path / "urdfkit.toml").write_text("rule-packages = ['evil_rules']\n")
    (tmp_path / "evil_rules.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')\n")
    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    checked = Workspace().check(str(tmp_path / "r.urdf"))
    assert "evil_rules" in checked.failure
    assert not (tmp_path / "ran").exists()


def test_a_configuration_from_anywhere_gets_no_trust(tmp_path: Path) -> None:
    (tmp_path / "urdfkit.toml").write_text("trust = true\n")
    text = XACRO.format("<link name=\"${__import__('os').system('touch hit')}\"/>")
    file = Edited(tmp_path / "r.xacro", text)
    checked = file.workspace.check(file.path)
    assert "XAC009" in codes(checked, tmp_path / "r.xacro")
    assert "trust" in checked.failure
    assert not Path("hit").exists()


def test_the_arguments_of_the_configuration_are_given(tmp_path: Path) -> None:
    text = XACRO.format('<link name="$(arg p)"/>')
    (tmp_path / "r.xacro").write_text(text)
    file = Edited(tmp_path / "r.xacro", text)
    assert "XAC010" in codes(file.workspace.check(file.path), tmp_path / "r.xacro")
    (tmp_path / "urdfkit.toml").write_text('[[robot]]\nfile = "r.xacro"\narguments = { p = "a" }\n')
    file.workspace.reload()
    assert "XAC010" not in codes(file.workspace.check(file.path), tmp_path / "r.xacro")
    assert file.robot.model is not None
    assert [link.name for link in file.robot.model.links] == ["a"]


def test_a_directory_that_goes_away_is_no_end(tmp_path: Path) -> None:
    shutil.copytree(MODELS / "good" / "mobile_base", tmp_path / "mobile_base")
    path = tmp_path / "mobile_base" / "urdf" / "mobile_base.urdf.xacro"
    file = Edited(path, path.read_text())
    assert codes(file.workspace.check(file.path), path) == []
    shutil.rmtree(tmp_path / "mobile_base")
    file.workspace.reload()
    file.type(path.name)
    assert "XML001" in codes(file.workspace.check(file.path), path)


@pytest.mark.parametrize("thorough", [False, True])
def test_every_prefix_of_a_text_is_checked_without_an_error(thorough: bool) -> None:
    """Typing the mission's model, some characters at a time."""
    text = MISSION.read_text(encoding="utf-8")
    file = Edited(MISSION, "")
    for end in range(0, len(text), 1997 if thorough else 397):
        file.type(text[:end])
        checked = file.workspace.check(file.path, thorough=thorough)
        assert checked.failure == ""
        assert checked.diagnostics[file.path]
        assert file.robot.markup(file.path).source.data == text[:end].encode()


def test_directories_are_listed_once_until_files_on_disk_change(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A package that is nowhere is looked for in the whole workspace."""
    nowhere = f"p{uuid4().hex}"  # directories of other tests are neighbours of this one
    (tmp_path / "package.xml").write_text("<package><name>own</name></package>")
    mesh = '<mesh filename="package://{}/x.stl"/>'
    text = '<robot name="r"><link name="a"><visual><geometry>{}</geometry></visual></link></robot>'
    file = Edited(tmp_path / "r.urdf", text.format(mesh.format(nowhere)))
    assert "XAC011" in codes(file.workspace.check(file.path), tmp_path / "r.urdf")
    listed: list[object] = []
    scandir = os.scandir

    def noted(path: str) -> Any:
        listed.append(path)
        return scandir(path)

    monkeypatch.setattr(os, "scandir", noted)
    file.type(text.format(mesh.format(nowhere)) + "\n")
    assert "XAC011" in codes(file.workspace.check(file.path), tmp_path / "r.urdf")
    assert listed == []
    (tmp_path / "package.xml").write_text(f"<package><name>{nowhere}</name></package>")
    file.workspace.reload()
    assert "XAC011" not in codes(file.workspace.check(file.path), tmp_path / "r.urdf")
    assert listed


def test_a_robot_that_lacks_arguments_has_those_of_a_launch_file(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arms</name></package>")
    (tmp_path / "arm.launch").write_text(
        '<launch><param name="robot_description" '
        'command="$(find xacro)/xacro $(find arms)/arm.xacro side:=left"/></launch>'
    )
    text = XACRO.format('<link name="$(arg side)_arm"/><link name="$(arg side)_arm"/>')
    path = tmp_path / "arm.xacro"
    path.write_text(text)
    here = Edited(path, text)
    assert here.robot.defined("link") == ["left_arm"]
    codes = {found.code for found in here.workspace.check(str(path)).diagnostics[str(path)]}
    assert "NAM001" in codes
    assert "XAC010" not in codes


def test_each_set_of_arguments_is_checked_when_a_file_is_saved(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arms</name></package>")
    for side in ("left", "right"):
        (tmp_path / f"{side}.launch").write_text(
            '<launch><param name="robot_description" '
            f'command="$(find xacro)/xacro $(find arms)/arm.xacro side:={side}"/></launch>'
        )
    text = XACRO.format('<link name="$(arg side)"/><link name="right"/>')
    path = tmp_path / "arm.xacro"
    path.write_text(text)
    here = Edited(path, text)
    assert "NAM001" not in codes(here.workspace.check(str(path)), path)
    assert "NAM001" in codes(here.workspace.check(str(path), thorough=True), path)
