"""Green means checked: a robot that is found and cannot be checked is a finding of its own."""

import json
import os
import re
import shutil
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml

from tests.conftest import CORPUS, ROOT, needs_corpus
from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import check
from urdfkit.cli import main
from urdfkit.lint.config_reader import load
from urdfkit.output import formats

WANTING = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="$(arg side)_base"/>
  <link name="tip"/>
  <joint name="j" type="fixd"><parent link="$(arg side)_base"/><child link="tip"/></joint>
</robot>
"""
BROKEN = '<robot name="broken"><link name="a"></robot>'


def codes(directory: Path, **options: object) -> list[str]:
    return [found.code for found in check(directory, **options).diagnostics]  # type: ignore[arg-type]


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    file = tmp_path / "arm.xacro"
    file.write_text(WANTING)
    return file


def test_the_argument_is_named_and_how_to_give_it(robot: Path) -> None:
    (found,) = check(robot.parent).diagnostics
    assert found.message == naming("checked", "side")
    assert found.help == naming("side:=VALUE", "urdfkit.toml", "arm.xacro", "arguments.side")
    assert [note.span.line for note in found.related] == [2]
    (robot.parent / "urdfkit.toml").write_text(
        '[[robot]]\nfile = "arm.xacro"\narguments.side = "left"\n'
    )
    config = load(str(robot.parent / "urdfkit.toml"))
    assert "CFG003" not in codes(robot.parent, config=config)
    assert "CFG003" not in codes(robot.parent, arguments={"side": "left"})


def test_the_file_is_named_from_the_repository(tmp_path: Path) -> None:
    """One of several repositories in the src of a workspace: each has its own configuration."""
    repository = tmp_path / "src" / "arm_description"
    for name in ("arm_description", "hand_description"):
        add_file(tmp_path / "src" / name / "package.xml", f"<package><name>{name}</name></package>")
    add_file(repository / ".git" / "HEAD", "ref: refs/heads/main")
    path = add_file(repository / "urdf" / "arm.xacro", WANTING)
    (found,) = check(path, select=["CFG003"]).diagnostics
    assert found.help == naming("side:=VALUE", "urdfkit.toml", "urdf/arm.xacro", "arguments.side")


def test_selected_rules_that_found_nothing_did_not_look(robot: Path) -> None:
    directory = robot.parent
    assert codes(directory, select=["JNT"]) == ["CFG003"]
    assert codes(directory, select=["CFG003"]) == ["CFG003"]
    assert codes(directory, select=["XAC001", "CFG003"]) == ["CFG003"]  # XAC010 would explain it
    assert codes(directory, select=["LAU", "CFG003"]) == []  # nothing selected reads the robot
    assert codes(directory, select=["LAU"]) == [], "rules that look at no robot"
    assert codes(directory, select=["JNT"], ignore=["CFG003"]) == []
    assert codes(directory, ignore=["CFG"]) == []
    robot.write_text(BROKEN)
    assert codes(robot, select=["JNT"]) == ["CFG003"]
    assert codes(robot, select=["XML001"]) == ["XML001"], "whose error says enough"


def test_what_accepts_it(robot: Path) -> None:
    directory = robot.parent
    config = directory / "urdfkit.toml"
    config.write_text('[[per-file-ignores]]\nfiles = ["arm.xacro"]\ncodes = ["CFG003"]\n')
    report = check(directory, config=load(str(config)))
    assert (report.diagnostics, report.suppressed) == ((), 1)
    config.write_text('[severity]\nCFG003 = "error"\n')
    report = check(directory, config=load(str(config)))
    assert [one.severity.value for one in report.diagnostics] == ["error"]
    assert [one.code for one in report.skipped] == [""]
    robot.write_text(f"<!-- urdfkit: ignore[CFG003] started with a side -->\n{WANTING}")
    assert codes(directory) == []


def test_an_error_says_enough(robot: Path) -> None:
    robot.write_text(WANTING.replace("$(arg side)", "$(find no_such_package)"))
    assert set(codes(robot.parent)) == {"XAC011"}
    assert set(codes(robot.parent, ignore=["XAC"])) == {"CFG003"}


def test_a_file_that_cannot_be_opened(tmp_path: Path) -> None:
    (tmp_path / "good.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    (tmp_path / "gone.urdf").symlink_to(tmp_path / "nowhere.urdf")
    assert codes(tmp_path, select=["XML"]) == ["CFG003"]
    assert codes(tmp_path, select=["XML"], ignore=["CFG003"]) == []


def test_a_robot_that_is_checked_otherwise(robot: Path) -> None:
    """What a launch file that cannot be followed gives it is no defect."""
    (robot.parent / "package.xml").write_text("<package><name>arms</name></package>")
    (robot.parent / "arm.launch.py").write_text(
        "def generate_launch_description():\n"
        '    command = Command(["xacro ", PathJoinSubstitution([FindPackageShare("arms"),\n'
        '                       "arm.xacro"]), " side:=", side_of_today()])\n'
        '    return LaunchDescription([Node(package="p", parameters=[command])])\n'
    )
    config = robot.parent / "urdfkit.toml"
    config.write_text('[[robot]]\nfile = "arm.xacro"\narguments.side = "left"\n')
    assert "CFG003" in codes(robot.parent)
    assert "CFG003" not in codes(robot.parent, config=load(str(config)))


@pytest.mark.parametrize("name", formats.names())
def test_every_format_tells_it(robot: Path, name: str) -> None:
    reported = formats.get(name)(check(robot.parent))
    assert "CFG003" in reported
    assert "needs the argument" in " ".join(reported.split()) or name == "statistics"


def test_it_is_a_notification_and_a_skipped_test_case(robot: Path) -> None:
    report = check(robot.parent)
    (run,) = json.loads(formats.get("sarif")(report))["runs"]
    assert [result["ruleId"] for result in run["results"]] == ["CFG003"]
    (note,) = run["invocations"][0]["toolExecutionNotifications"]
    assert (note["level"], "argument 'side'" in note["message"]["text"]) == (
        "warning",
        True,
    )
    suites = ElementTree.fromstring(formats.get("junit")(report))
    assert (suites.get("skipped"), suites.get("failures")) == ("1", "0")
    assert "no findings" not in formats.get("text")(report)
    assert formats.get("text")(report).endswith("1 warning in 1 file (1 robot not checked)\n")


def hook(*changed: str) -> int:
    """The exit code of what pre-commit runs."""
    hooks = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    return main([*hooks[0]["entry"].split()[1:], *changed])


@pytest.mark.parametrize("words", [["check", "."], ["check", ".", "--format", "github"]])
def test_the_gate_fails(
    robot: Path,
    words: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(robot.parent)
    assert main(words) == 1
    assert "CFG003" in capsys.readouterr().out
    assert hook("arm.xacro") == 1
    assert main([*words, "--fail-on", "error"]) == 0


@needs_corpus
def test_the_gate_fails_for_an_arm_whose_launch_files_are_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Universal Robots' package without launch files, and with every moving joint misspelt."""
    for variable in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"):
        monkeypatch.delenv(variable, raising=False)
    directory = tmp_path / "ur_description"
    shutil.copytree(
        CORPUS / "Universal_Robots_ROS2_Description",
        directory,
        ignore=shutil.ignore_patterns("launch"),
    )
    for path in (directory, *directory.rglob("*")):
        os.chmod(path, 0o755)
    macro = directory / "urdf" / "ur_macro.xacro"
    text, count = re.subn(
        r'type="(revolute|\$\{wrist_3_joint_type\})"', 'type="revolut"', macro.read_text()
    )
    assert count == 6
    macro.write_text(text)
    monkeypatch.chdir(directory)
    assert main(["check", ".", "--select", "CFG,URD,JNT,XAC"]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "urdf/ur.urdf.xacro with ur_type ur10, ur10e, ur16e, " in said
    assert "of config" in said
    assert said.count("'revolut'") == 6
    assert main(["check", ".", "--format", "github", "--select", "URD,JNT"]) == 1
    assert capsys.readouterr().out.count("::error file=urdf/ur_macro.xacro") >= 6
    assert hook("urdf/ur_macro.xacro", "--select", "URD,JNT") == 1
    capsys.readouterr()
    for arm in (directory / "config").glob("ur*"):  # nothing tells a value any more
        shutil.rmtree(arm)
    assert main(["check", "."]) == 1
    assert "CFG003 robot not checked" in " ".join(capsys.readouterr().out.split())


def test_a_misspelt_argument_that_no_file_gives(tmp_path: Path) -> None:
    """Andino's robot for Gazebo, whose argument only a launch file gives."""
    declared = '<xacro:arg name="left_side" default="l"/>'
    text = WANTING.replace("<link", f"{declared}<link", 1)
    (tmp_path / "arm.xacro").write_text(text.replace("(arg side)", "(arg leftside)"))
    (found,) = check(tmp_path).diagnostics
    assert found.message == naming("checked", "leftside", "leftside", "left_side")
