"""XAC024: see the rule."""

from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.robot.samples import xacro_xml

P = "$(arg prefix)"


def reported(directory: Path, default: str, parent: str, extra: str = "") -> list[int]:
    text = xacro_xml(
        f'<xacro:arg name="prefix" default="{default}"/>',
        f'<xacro:macro name="end" params="parent"><joint name="{P}end" type="fixed">',
        f'<parent link="${{parent}}"/><child link="{P}tip"/></joint></xacro:macro>',
        f'<link name="{P}base"/><link name="{P}tip"/><link name="world"/>',
        f'<xacro:end parent="{parent}"/>',
        extra,
    )
    path = directory / "r.urdf.xacro"
    path.write_text(text)
    report = check(path, select=["XAC024"])
    assert report.crashed == ()
    return [one.span.line for one in report.diagnostics]


@pytest.mark.parametrize(
    ("default", "parent", "count"),
    [("", "base", 1), ("", f"{P}base", 0), ("", "world", 0), ("arm_", "base", 0)],
)
def test_a_name_that_a_macro_is_given(
    tmp_path: Path, default: str, parent: str, count: int
) -> None:
    assert len(reported(tmp_path, default, parent)) == count


@pytest.mark.parametrize(
    ("tag", "name", "count"),
    [("gz_frame_id", "tip", 1), ("gz_frame_id", f"{P}tip", 0), ("topic", "tip", 0)],
)
def test_texts_that_name_a_link(tmp_path: Path, tag: str, name: str, count: int) -> None:
    sensor = f'<sensor name="s" type="imu"><{tag}>{name}</{tag}></sensor>'
    extra = f'<gazebo reference="{P}tip">{sensor}</gazebo>'
    assert len(reported(tmp_path, "", f"{P}base", extra)) == count


def test_a_reference_of_gazebo(tmp_path: Path) -> None:
    assert (
        len(reported(tmp_path, "", f"{P}base", '<gazebo reference="tip"><mu1>1</mu1></gazebo>'))
        == 1
    )


def test_a_macro_that_adds_the_prefix_itself(tmp_path: Path) -> None:
    extra = (
        f'<xacro:macro name="wheel" params="side"><link name="{P}${{side}}"/>'
        f'<joint name="{P}${{side}}_joint" type="fixed"><parent link="{P}base"/>'
        f'<child link="{P}${{side}}"/></joint></xacro:macro><xacro:wheel side="rim"/>'
    )
    assert reported(tmp_path, "", f"{P}base", extra) == []


def renamed(directory: Path, name: str, default: str, given: dict[str, str]) -> list[str]:
    """Findings of a robot with a forgotten prefix, whose prefix is an argument of any name."""
    prefix = f"$(arg {name})"
    text = xacro_xml(
        f'<xacro:arg name="{name}" default="{default}"/><xacro:arg name="mesh" default=""/>',
        f'<link name="{prefix}base"/><link name="{prefix}tip"/>',
        f'<joint name="{prefix}end" type="fixed"><parent link="base"/>',
        f'<child link="{prefix}tip"/></joint>',
    )
    path = directory / "r.urdf.xacro"
    path.write_text(text)
    return [one.help for one in check(path, arguments=given, select=["XAC024"]).diagnostics]


def test_a_prefix_of_another_name(tmp_path: Path) -> None:
    assert renamed(tmp_path, "robot_ns", "", {}) == ["write ${robot_ns}base"]


@pytest.mark.parametrize(("default", "value", "count"), [("", "", 1), ("a_", "", 1), ("", "a_", 0)])
def test_a_prefix_that_is_given(tmp_path: Path, default: str, value: str, count: int) -> None:
    assert len(renamed(tmp_path, "prefix", default, {"prefix": value})) == count
