from __future__ import annotations

from pathlib import Path

from tests.xacros import codes, reported, told_of, write
from urdfkit.lint import engine
from urdfkit.lint.grouping import grouped


def test_what_was_searched_and_how_to_name_it() -> None:
    (found,) = reported("XAC011", '<xacro:include filename="$(find arm_description)/arm.xacro"/>')
    assert found.span.text == "$(find arm_description)"
    assert found.message.startswith("package 'arm_description' is not found; searched: ")
    assert "AMENT_PREFIX_PATH" in found.message
    assert "ROS_PACKAGE_PATH" in found.message
    assert found.help == "name its folder: --package arm_description=DIR"


def test_what_follows_from_it_is_not_told() -> None:
    body = '<xacro:include filename="$(find arm)/a.xacro"/><xacro:arm/><link name="${length}"/>'
    assert codes(body) == ["XAC011"]


def test_every_package_is_told() -> None:
    body = (
        '<xacro:include filename="$(find arm)/a.xacro"/>\n'
        '<xacro:include filename="$(find hand)/h.xacro"/>\n<link name="$(find base)"/>'
    )
    assert [(one.span.line, one.span.text) for one in reported("XAC011", body)] == [
        (2, "$(find arm)"),
        (3, "$(find hand)"),
        (4, "$(find base)"),
    ]


def test_found_by_name_and_beside(tmp_path: Path) -> None:
    workspace = tmp_path / "a" / "b" / "c" / "d" / "e" / "ws"
    here, arm, there = workspace / "robot", workspace / "arm", tmp_path / "far" / "away" / "hand"
    for folder, name in ((here, "robot"), (arm, "arm"), (there, "hand")):
        folder.mkdir(parents=True)
        (folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
        write(folder, part='<link name="a"/>')
    include = '<xacro:include filename="$(find {})/part.xacro"/>'
    write(here, robot=include.format("arm") + include.format("robot"))
    assert told_of("XAC011", here / "robot.xacro") == []
    write(here, robot=include.format("hand"))
    assert len(told_of("XAC011", here / "robot.xacro")) == 1
    report = engine.check(here / "robot.xacro", select=["XAC"], packages={"hand": str(there)})
    assert report.diagnostics == ()


def test_a_package_that_is_used_often_is_shown_once() -> None:
    uses = "\n".join(f'<link name="$(find arm)/{i}"/>' for i in range(7))
    (found,) = grouped(reported("XAC011", uses))
    assert found.message.endswith("(and 6 more like this)")
    assert len(found.related) == 6
