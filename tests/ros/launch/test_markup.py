"""Launch files in YAML are read as those in XML."""

from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.ros.launch import read_launch
from urdfkit.ros.launch.contents import Launch
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

ROBOT = """\
launch:
- arg:
    name: side
    default: left
- node:
    pkg: robot_state_publisher
    exec: robot_state_publisher
    param:
    - name: robot_description
      value: "$(command 'xacro $(find-pkg-share arm)/urdf/arm.xacro side:=$(var side)')"
    - name: use_sim_time
      value: true
"""


def read(package: Path, text: str) -> Launch:
    path = package / "launch" / "a.launch.yaml"
    path.write_text(text)
    return read_launch(Source.read(path), Resolver(environment={}))


def test_robot_and_started_programs(package):
    launch = read(package, ROBOT)
    (description,) = launch.descriptions
    assert Path(description.path) == package / "urdf" / "arm.xacro"
    assert description.arguments == {"side": "left"}
    (started,) = launch.started
    assert set(started.parameters.values) == {"robot_description", "use_sim_time"}
    assert launch.problems == ()


@pytest.mark.parametrize(
    "group",
    [
        "- group:\n{}",
        "- group:\n    scoped: true\n    children:\n{}",
    ],
)
def test_actions_in_a_group(package, group):
    inner = ROBOT.partition("\n")[2].replace("\n", "\n    ").rstrip()
    text = "launch:\n" + group.format("    " + inner) + "\n"
    assert len(read(package, text).descriptions) == 1


@pytest.mark.parametrize(
    ("old", "new", "code", "line", "place"),
    [
        ("exec:", "type:", "LAU010", 7, "robot_state_publisher"),
        ("    exec: robot_state_publisher\n", "", "LAU010", 5, "node"),
        ("$(var side)", "$(var siide)", "LAU006", 10, ""),
        ("- node:", "- nodes:", "LAU010", 5, "nodes"),
        ("    name: side", "\tname: side", "LAU001", 3, ""),
        ("launch:", "lunch:", "LAU001", 1, ""),
        ("arm.xacro side", "leg.xacro side", "LAU003", 10, ""),
        ("side:=$", "sied:=$", "LAU005", 8, ""),
    ],
)
def test_yaml_follows_the_rules_of_xml(package, old, new, code, line, place):
    path = package / "launch" / "a.launch.yaml"
    path.write_text(ROBOT.replace(old, new))
    (package / "urdf" / "arm.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="side" default="l"/><link name="$(arg side)"/></robot>'
    )
    report = check(path, select=[code])
    assert report.crashed == ()
    (found,) = report.diagnostics
    assert (found.code, found.span.line) == (code, line)
    assert not place or found.span.text == place


@pytest.mark.parametrize(
    "text", ["", "launch:", "launch: [1, [2], {3: 4}]", "- a", "launch: {a: b}"]
)
def test_files_without_a_launch_key_are_ignored(package, text):
    assert read(package, text).descriptions == ()


@pytest.mark.parametrize(
    ("child", "count"),
    [
        ("<arg name='a' value='b'/>", 1),
        ("<node pkg='a' exec='b'/>", 1),
        ("<env name='a' value='b'/>", 0),
    ],
)
def test_tags_in_a_node(package, child, count):
    path = package / "launch" / "a.launch.xml"
    path.write_text(f"<launch><node pkg='rviz2' exec='rviz2'>{child}</node></launch>")
    found = check(path, select=["LAU010"]).diagnostics
    assert ["ROS 2 stops at it" in one.message for one in found] == [True] * count
