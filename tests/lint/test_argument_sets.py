"""Robots with the arguments that launch files start them with, whatever the user names."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch
from tests.workspaces import add_file, add_package
from tests.xacros import xacro
from urdfkit import Diagnostic, Report, check
from urdfkit.cli import main
from urdfkit.lint.argument_sets import MAX_SETS
from urdfkit.lint.config_reader import load
from urdfkit.lint.options import Options

#: A misspelt joint type with one of the values of an argument.
ROBOT = xacro(
    '<xacro:arg name="kind" default="good"/><link name="a"/><link name="b"/>\n'
    "<joint name=\"j\" type=\"${'revolut' if '$(arg kind)' == 'bad' else 'fixed'}\">"
    '<parent link="a"/><child link="b"/></joint>'
)
START = '<param name="robot_description" command="xacro $(dirname)/../arm.xacro {}"/>'


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A robot that one of its launch files breaks."""
    add_file(tmp_path / ".git" / "HEAD")
    add_file(tmp_path / "package.xml", MANIFEST.encode())
    add_file(tmp_path / "arm.xacro", ROBOT.encode())
    start(tmp_path, "bad", "kind:=bad")
    return tmp_path


def start(package: Path, name: str, arguments: str) -> Path:
    text = launch(START.format(arguments))
    return add_file(package / "launch" / f"{name}.launch", text.encode())


def types(report: Report) -> list[Diagnostic]:
    return [one for one in report.diagnostics if one.code in ("JNT001", "CFG003")]


def changed(*paths: Path) -> Report:
    return check(*paths, select=["JNT001", "LAU003"], options=Options(changed=True))


@pytest.mark.parametrize(
    "checked",
    [
        check,
        lambda package: check(package / "arm.xacro"),
        lambda package: changed(package / "arm.xacro"),
        lambda package: changed(package / "launch" / "bad.launch"),
    ],
    ids=["directory", "file", "changed robot", "changed launch file"],
)
def test_a_robot_is_checked_as_launch_files_start_it(
    package: Path, checked: Callable[[Path], Report]
) -> None:
    for number in range(MAX_SETS - 1):  # the eighth of them broke a robot, and four were checked
        start(package, f"{number}", f"kind:={number}")
    (found,) = types(checked(package))
    assert "unknown type 'revolut'" in found.message
    assert [step.name for step in found.calls[0].via] == ["bad.launch"]


def test_launch_files_of_another_package(package: Path) -> None:
    """The file alone, its package and the whole repository have one verdict."""
    (package / "launch" / "bad.launch").unlink()
    robot = add_file(package / "arms" / "arm.xacro", ROBOT.encode())
    add_package(package / "arms", "arms")
    add_package(package / "bringup", "bringup")
    (package / "package.xml").unlink()
    start(package / "bringup", "bad", "kind:=bad").write_text(
        launch(START.format("kind:=bad")).replace("$(dirname)/..", "$(find arms)")
    )
    for what in (robot, package / "arms", package / "bringup", package):
        assert len(types(check(what))) == 1, what


def test_arguments_of_the_command_line_are_those_that_count(package: Path) -> None:
    for what in (package, package / "arm.xacro"):
        assert types(check(what, arguments={"kind": "good"})) == []
    file = package / "urdfkit.toml"
    file.write_text(
        '[[robot]]\nfile = "arm.xacro"\nvariants.one.kind = "1"\nvariants.two.kind = "2"\n'
    )
    config = load(str(file))
    for what in (package, package / "arm.xacro"):
        assert len(types(check(what, config=config))) == 1
        assert types(check(what, config=config, options=Options(variant="one"))) == []


def test_sets_that_are_left_out_are_reported(package: Path) -> None:
    for number in range(MAX_SETS + 1):
        start(package, f"a{number:02}", f"kind:=a{number:02}")
    for what in (package, package / "arm.xacro"):
        (found,) = types(check(what))
        assert found.code == "CFG003"
        assert "with 2 of 18 values of 'kind': a16, bad; only 16 sets" in found.message


def test_new_values_come_first(package: Path) -> None:
    """Launch files that differ in their combinations alone wait for those with a new value."""
    robot = ROBOT.replace("<link", '<xacro:arg name="side" default=""/><link', 1)
    (package / "arm.xacro").write_text(robot)
    (package / "launch" / "bad.launch").unlink()
    for first in "abcd":
        for second in "abcd":
            start(package, f"{first}{second}", f"kind:={first} side:={second}")
    start(package, "z", "kind:=bad")
    (found,) = types(check(package))
    assert found.code == "JNT001"


def test_a_set_that_makes_no_other_robot_is_read_and_not_checked(package: Path) -> None:
    (package / "launch" / "bad.launch").unlink()
    for name in "ab":
        start(package, name, f"kind:={name}")
    report = check(package / "arm.xacro", select=["TRE"], targets=["ros1"])
    assert len(report.errors) == 1


def test_a_changed_launch_file_is_checked_itself(package: Path) -> None:
    file = add_file(
        package / "launch" / "lost.launch", launch('<include file="$(dirname)/no"/>').encode()
    )
    assert [one.code for one in changed(file).diagnostics] == ["JNT001", "LAU003"]
    assert [one.code for one in changed(package / "arm.xacro").diagnostics] == ["JNT001"]


def test_show_files_lists_the_sets_and_what_none_of_them_includes(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    include = '<xacro:if value="{}"><xacro:include filename="{}.xacro"/></xacro:if></robot>'
    text = ROBOT
    for value, name in (("false", "never"), ("${'$(arg kind)' == 'bad'}", "part")):
        add_file(package / f"{name}.xacro", xacro(f'<link name="{name}"/>', "").encode())
        text = text.replace("</robot>", include.format(value, name))
    (package / "arm.xacro").write_text(text)
    assert main(["check", str(package), "--show-files"]) == 0
    lines = capsys.readouterr().out.replace(f"{package}/", "").splitlines()
    assert lines == [
        "arm.xacro",
        "arm.xacro kind:=bad",
        "launch/bad.launch",
        "not checked: never.xacro: included, but not with these arguments",
    ]


def test_a_set_that_does_not_expand_next_to_one_that_does(package: Path) -> None:
    """The defaults of a robot may be for nobody, but not what a launch file starts it with."""
    robot = ROBOT.replace('default="good"', 'default="bad"').replace("'revolut'", "missing")
    (package / "arm.xacro").write_text(robot)
    start(package, "good", "kind:=good")
    (found,) = check(package, select=["XAC001"]).diagnostics
    assert "missing" in found.message
    (package / "launch" / "bad.launch").unlink()
    assert check(package, select=["XAC001"]).diagnostics == ()
