"""XAC024: see the rule."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.naming import naming
from urdfkit import check
from urdfkit.checks.xacro.forgotten_condition import forgotten_conditions
from urdfkit.lint.context import Context
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.document import Document
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

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


@pytest.mark.parametrize(
    ("parent", "params", "count"),
    [
        ("lidar_mount", "name", 1),
        ("${name}_mount", "name", 0),
        ("base", "name", 0),
        ("lidar_mount", "parent:=base", 0),  # the name is a property of the file
    ],
)
def test_a_name_that_a_macro_defines_with_its_parameter(
    tmp_path: Path, parent: str, params: str, count: int
) -> None:
    text = xacro_xml(
        '<xacro:property name="name" value="lidar"/><link name="base"/>',
        f'<xacro:macro name="sensor" params="{params}">',
        '<link name="${name}_mount"/><link name="${name}_link"/>',
        '<joint name="${name}_a" type="fixed">',
        '<parent link="base"/><child link="${name}_mount"/></joint>',
        '<joint name="${name}_b" type="fixed">',
        f'<parent link="{parent}"/><child link="${{name}}_link"/></joint></xacro:macro>',
        f'<xacro:sensor {"name" if params == "name" else "parent"}="lidar"/>',
    )
    path = tmp_path / "r.urdf.xacro"
    path.write_text(text)
    found = check(path, select=["XAC024"]).diagnostics
    assert [one.span.text for one in found] == [parent] * count
    assert all(one.help == "write ${name}_mount" for one in found)
    assert all(one.message == naming("lidar_mount", "${name}_mount", "<parent>") for one in found)


def renamed(
    directory: Path, name: str, default: str, given: dict[str, str], prefix: str = ""
) -> list[str]:
    """Findings of a robot with a forgotten prefix, whose prefix is an argument of any name."""
    prefix = prefix or f"$(arg {name})"
    text = xacro_xml(
        f'<xacro:arg name="{name}" default="{default}"/><xacro:arg name="mesh" default=""/>',
        f'<xacro:property name="{name}" value="$(arg {name})"/>',
        f'<link name="{prefix}base"/><link name="{prefix}tip"/>',
        f'<joint name="{prefix}end" type="fixed"><parent link="base"/>',
        f'<child link="{prefix}tip"/></joint>',
    )
    path = directory / "r.urdf.xacro"
    path.write_text(text)
    return [one.help for one in check(path, arguments=given, select=["XAC024"]).diagnostics]


@pytest.mark.parametrize("prefix", ["$(arg robot_ns)", "${robot_ns}"])
def test_a_prefix_of_another_name(tmp_path: Path, prefix: str) -> None:
    assert renamed(tmp_path, "robot_ns", "", {}, prefix) == [f"write {prefix}base"]


@pytest.mark.parametrize(("default", "value", "count"), [("", "", 1), ("a_", "", 1), ("", "a_", 0)])
def test_a_prefix_that_is_given(tmp_path: Path, default: str, value: str, count: int) -> None:
    assert len(renamed(tmp_path, "prefix", default, {"prefix": value})) == count


CAMERA = (
    '<link name="camera"/>'
    '<joint name="c" type="fixed"><parent link="base"/><child link="camera"/></joint>'
)
LIGHT = (
    '<link name="light"/>'
    '<joint name="l" type="fixed"><parent link="camera"/><child link="light"/></joint>'
)
IF = '<xacro:if value="{}">{}</xacro:if>'


def broken(directory: Path, content: str, default: str = "true") -> list[tuple[str, str]]:
    """Findings of a robot with a boolean argument: severities and messages."""
    text = xacro_xml(
        f'<xacro:arg name="with" default="{default}"/><xacro:arg name="sim" default="true"/>',
        '<xacro:property name="has" value="$(arg with)"/><link name="base"/>',
        content,
    )
    path = directory / "r.urdf.xacro"
    path.write_text(text)
    report = check(path, select=["XAC024"])
    assert report.crashed == ()
    return [(one.severity.name.lower(), one.message) for one in report.diagnostics]


@pytest.mark.parametrize(
    ("default", "content", "other"),
    [
        ("true", IF.format("${has}", CAMERA) + LIGHT, "false"),
        ("true", IF.format("$(arg with)", CAMERA) + LIGHT, "false"),
        ("false", IF.format("${not has}", CAMERA) + LIGHT, "true"),
        ("false", IF.format("${has}", CAMERA).replace("if", "unless") + LIGHT, "true"),
        ("true", IF.format("${has}", CAMERA) + IF.format("${has}", LIGHT), ""),
        ("true", IF.format("${has}", CAMERA) + IF.format("$(arg with)", LIGHT), ""),
        ("true", CAMERA + LIGHT, ""),
        # The light has a switch of its own, and may be switched off with the camera.
        ("true", IF.format("${has}", CAMERA) + IF.format("${1 == 1}", LIGHT), ""),
        (
            "true",
            IF.format("${has}", CAMERA) + IF.format("${not has}", '<link name="camera"/>') + LIGHT,
            "",
        ),
    ],
)
def test_a_parent_behind_a_condition(
    tmp_path: Path, default: str, content: str, other: str
) -> None:
    message = naming("camera", other, "<parent>")
    assert broken(tmp_path, content, default) == [("warning", message)] * bool(other)


def test_a_block_of_gazebo_outside_of_a_condition(tmp_path: Path) -> None:
    block = '<gazebo reference="camera"><sensor name="s" type="camera"/></gazebo>'
    (found,) = broken(tmp_path, IF.format("${has}", CAMERA) + IF.format("$(arg sim)", block))
    assert found[0] == "info"
    assert found[1].endswith("<gazebo> refers to it: Gazebo ignores the block")


def test_a_joint_of_ros2_control_outside_of_a_condition(tmp_path: Path) -> None:
    block = '<ros2_control name="s" type="system"><joint name="c"/></ros2_control>'
    (found,) = broken(tmp_path, IF.format("${has}", CAMERA) + block)
    assert found == (
        "warning",
        naming("c", "<joint>"),
    )


def test_a_condition_around_the_call_of_a_macro(tmp_path: Path) -> None:
    macro = f'<xacro:macro name="camera" params="">{CAMERA}</xacro:macro>'
    call = IF.format("${has}", "<xacro:camera/>")
    assert broken(tmp_path, macro + call + IF.format("${has}", LIGHT)) == []
    assert len(broken(tmp_path, macro + call + LIGHT)) == 1


def test_several_joints_of_one_block(tmp_path: Path) -> None:
    joints = '<joint name="c"/><joint name="d"/>'
    arm = CAMERA + CAMERA.replace("camera", "arm").replace('"c"', '"d"')
    block = f'<ros2_control name="s" type="system">{joints}</ros2_control>'
    (found,) = broken(tmp_path, IF.format("${has}", arm) + block)
    assert found[1] == naming("c", "<joint>", "1")


@pytest.mark.parametrize(("package", "count"), [("arm_moveit", 0), ("arm/control", 1)])
def test_the_condition_of_another_package(tmp_path: Path, package: str, count: int) -> None:
    """MIRTE's MoveIt configuration is for the robot with its arm."""
    for directory in ("arm", "arm_moveit"):
        (tmp_path / directory).mkdir()
        manifest = f"<package><name>{directory}</name></package>"
        (tmp_path / directory / "package.xml").write_text(manifest)
    arm = '<xacro:arg name="with" default="true"/><link name="base"/>'
    arm += IF.format("$(arg with)", CAMERA)
    block = '<ros2_control name="s" type="system"><joint name="c"/></ros2_control>'
    arm += block  # a mistake of its own
    (tmp_path / "arm" / "arm.xacro").write_text(xacro_xml(arm))
    robot = tmp_path / package / "r.urdf.xacro"
    robot.parent.mkdir(exist_ok=True)
    include = f'<xacro:include filename="{tmp_path}/arm/arm.xacro"/>'
    robot.write_text(xacro_xml(include, block))
    report = check(robot, select=["XAC024"])
    assert report.crashed == ()
    assert [one.span.source.path.endswith("arm.xacro") for one in report.diagnostics] == (
        [True] + [False] * count
    )


def test_a_value_that_removes_nothing_is_tried_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """A robot is checked with several sets of arguments."""
    robot = xacro_xml(
        *(f'<xacro:arg name="{name}" default="true"/>' for name in ("with", "sim")),
        f'<xacro:arg name="mass" default="1"/><link name="base"/>{LIGHT}',
        IF.format("${1 == 1}", CAMERA),
    )
    source, resolver = Source("r.urdf.xacro", robot.encode()), Resolver()
    expanded: list[Mapping[str, str]] = []
    expanded_with = Context.expanded_with

    def counted(context: Context, arguments: Mapping[str, str]) -> Document | None:
        expanded.append(arguments)
        return expanded_with(context, arguments)

    monkeypatch.setattr(Context, "expanded_with", counted)
    for mass in ("1", "2"):
        assert list(forgotten_conditions(Context(source, resolver, {"mass": mass}))) == []
    assert expanded == [{"mass": "1", "with": "false"}, {"mass": "1", "sim": "false"}]


@pytest.mark.parametrize(
    ("parent", "child", "expected"),
    [
        (f"{P}base", f"{P}tip", None),
        ("base", f"{P}tip", ("base", f"{P}base", "<parent>")),
        (f"{P}base", "tip", ("tip", f"{P}tip", "<child>")),
        (f"{P}base", "hook", None),  # it may be in the package that is not found
    ],
)
def test_a_robot_without_a_package(
    tmp_path: Path, parent: str, child: str, expected: tuple[str, str, str] | None
) -> None:
    """Robotnik's RBCAR: its sensors are in another repository, so that REF001 is skipped."""
    robot = tmp_path / "r.urdf.xacro"
    robot.write_text(
        xacro_xml(
            '<xacro:arg name="prefix" default="robot_"/>',
            '<xacro:arg name="end" default="robot_tip"/>',
            '<gazebo reference=""/>',  # the end of FANUC's robots is an argument of this kind
            '<xacro:include filename="$(find sensors)/laser.xacro"/>',
            f'<link name="{P}base"/><link name="{P}tip"/>',
            f'<joint name="j" type="fixed"><parent link="{parent}"/>',
            f'<child link="{child}"/></joint>',
        )
    )
    report = check(robot, select=["XAC024"])
    assert report.crashed == ()
    own = (one for one in report.diagnostics if one.code == "XAC024")
    found = [(one.message, one.help, one.span.text) for one in own]
    if expected is None:
        assert found == []
    else:
        name, written, role = expected
        assert found == [
            (naming(name, f"robot_{name}", "prefix", "robot_", role), f"write {written}", name)
        ]
