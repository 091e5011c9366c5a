"""SRD011: an SRDF for another variant is one info, not an error for each name."""

import re
from pathlib import Path

import pytest

from tests.naming import naming
from urdfkit import Diagnostic, check
from urdfkit.lint.grouping import grouped

ARMS = ("left", "right")


def about_srdf(robot: Path, **arguments: str) -> tuple[Diagnostic, ...]:
    """The findings for the SRDF, as they are printed."""
    return grouped(check(robot, select=["SRD"], arguments=arguments).diagnostics)


def arm(side: str, prefix: str = "") -> str:
    """Links and joints of an arm on base_link, as talos has two."""
    names = [f"{prefix}arm_{side}_{number}" for number in range(1, 6)]
    parents = [f"{prefix}base_link", *(f"{name}_link" for name in names)]
    return "".join(
        f'<link name="{name}_link"/><joint name="{name}_joint" type="continuous">'
        f'<parent link="{parent}"/><child link="{name}_link"/></joint>'
        for name, parent in zip(names, parents, strict=False)
    )


def write(directory: Path, *, with_complete: bool = True) -> Path:
    """The left arm alone, with the SRDF of both arms."""
    (directory / "robots").mkdir()
    (directory / "srdf").mkdir()
    (directory / "package.xml").write_text("<package><name>talos_data</name></package>")
    base = '<robot name="talos"><link name="base_link"/>'
    complete = base + "".join(map(arm, ARMS)) + "</robot>"
    if with_complete:
        (directory / "robots" / "talos_full.urdf").write_text(complete)
    groups = "".join(
        f'<group name="{side}_arm">'
        + "".join(f'<joint name="arm_{side}_{number}_joint"/>' for number in range(1, 6))
        + "</group>"
        for side in ARMS
    )
    matrix = "".join(
        f'<disable_collisions link1="arm_left_{one}_link" link2="arm_right_{other}_link" '
        'reason="Never"/>\n'
        for one in range(1, 6)
        for other in range(1, 6)
    )
    (directory / "srdf" / "talos.srdf").write_text(f'<robot name="talos">{groups}{matrix}</robot>')
    left = directory / "robots" / "talos_left_arm.urdf"
    left.write_text(base + arm("left") + "</robot>")
    return left


def test_another_robot_of_the_package_has_the_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (found,) = about_srdf(write(tmp_path))
    assert (found.code, found.severity.value) == ("SRD011", "info")
    assert found.message == naming("10", "20", "robots/talos_full.urdf")


def test_an_outdated_srdf_is_reported_in_groups(tmp_path: Path) -> None:
    found = about_srdf(write(tmp_path, with_complete=False))
    assert [one.code for one in found].count("SRD001") == 2


@pytest.mark.parametrize("prefix", ["left_", ""])
def test_a_prefix_is_one_finding(tmp_path: Path, prefix: str) -> None:
    robot = tmp_path / "r.urdf.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="prefix" default=""/><xacro:property name="p" value="$(arg prefix)"/>'
        f'<link name="${{p}}base_link"/>{arm("left", "${p}")}</robot>'
    )
    matrix = "".join(
        f'<disable_collisions link1="arm_left_{n}_link" link2="base_link" reason="Never"/>'
        for n in range(1, 6)
    )
    group = '<group name="arm"><chain base_link="base_link" tip_link="arm_left_5_link"/></group>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">\n{group}{matrix}</robot>')
    found = about_srdf(robot, prefix=prefix)
    if not prefix:
        assert found == ()
        return
    (finding,) = found
    assert (finding.code, finding.message) == (
        "SRD011",
        naming("6", "6", "left_"),
    )


def test_the_floating_base_is_in_no_robot(tmp_path: Path) -> None:
    """Solo: the SRDF of all legs has a state with Pinocchio's root joint."""
    left = write(tmp_path)
    srdf = tmp_path / "srdf" / "talos.srdf"
    root = '<joint name="root_joint" value="0 0 0.3 0 0 0 1"/>'
    states = f'<group_state name="a" group="left_arm">{root}</group_state></robot>'
    text = srdf.read_text().replace("</robot>", states)
    lines = [line for line in text.splitlines(True) if not re.search("_[45]_link", line)]
    srdf.write_text("".join(lines))
    assert [one.code for one in about_srdf(left)] == ["SRD011"]
