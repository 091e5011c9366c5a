from pathlib import Path

import pytest

from tests.controls import ROBOT, plugin
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.controllers import Controller, controllers, parameter_files, read
from urdfkit.text.located_yaml import MAX_BYTES
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

DRIVE = "diff_drive_controller/DiffDriveController"
PLAIN = f"""\
controller_manager:
  ros__parameters:
    update_rate: 50
    drive:
      type: {DRIVE}
drive:
  ros__parameters:
    left_wheel_names: ["größe", 'left']
    wheel_radius: 0.1
    linear:
      x: {{max: 1.0}}
"""


def of(text: str | bytes) -> tuple[Controller, ...]:
    return read(Source("c.yaml", text.encode() if isinstance(text, str) else text))


def plain(controller: Controller) -> dict[str, list[str]]:
    section = controller.section
    return {name: [value.text for value in section.values(name)] for name in section.given}


def test_a_controller_and_its_parameters() -> None:
    (drive,) = of(PLAIN)
    assert (drive.name, drive.type) == ("drive", DRIVE)
    assert plain(drive) == {
        "left_wheel_names": ["größe", "left"],
        "wheel_radius": ["0.1"],
        "linear.x.max": ["1.0"],
    }
    found = drive.values(["wheel_radius", "nothing", "left_wheel_names"])
    assert [value.text for value in found] == ["0.1", "größe", "left"]


def test_a_controller_that_only_the_launch_file_names() -> None:
    """<rosparam ns="drive"> of ROS 1; messages called it controller ''."""
    (drive,) = of(f"type: {DRIVE}\nwheel_radius: 0.1\n")
    assert (drive.name, drive.title) == ("", "the controller")


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_the_place_of_a_value(end: str) -> None:
    (drive,) = of(PLAIN.replace("\n", end))
    radius, first, second = drive.values(["wheel_radius", "left_wheel_names"])
    assert (radius.span.line, radius.span.column, radius.span.text) == (9, 19, "0.1")
    assert (first.span.line, first.span.column, first.span.text) == (8, 24, '"größe"')
    assert second.span.text == "'left'"


@pytest.mark.parametrize(
    "text",
    [
        f"drive:\n  ros__parameters: {{type: {DRIVE}, wheel_radius: 0.1}}",
        "/**/controller_manager:\n  ros__parameters:\n    drive.type: " + DRIVE + "\n"
        "/**/drive:\n  ros__parameters:\n    wheel_radius: 0.1",
        "/**:\n  controller_manager:\n    ros__parameters:\n      drive: {type: " + DRIVE + "}\n"
        "  drive:\n    ros__parameters: {wheel_radius: 0.1}",
        "robot:\n  controller_manager:\n    ros__parameters:\n      drive: {type: " + DRIVE + "}\n"
        "/robot/drive:\n  ros__parameters: {wheel_radius: 0.1}",
    ],
)
def test_the_ways_to_write_it(text: str) -> None:
    (drive,) = of(text)
    assert (drive.name, drive.type) == ("drive", DRIVE)
    assert plain(drive)["wheel_radius"] == ["0.1"]


def test_namespaces_are_kept_apart() -> None:
    text = "a:\n  controller_manager:\n    ros__parameters:\n      drive: {type: T}\n"
    (drive,) = of(text + "b:\n  drive:\n    ros__parameters: {wheel_radius: 0.1}\n")
    assert drive.section.given == {}


@pytest.mark.parametrize(
    "text",
    [
        "",
        "text",
        "- list",
        "a: [",
        "\t",
        "\0",
        b"\xff\xfe\xff",
        "ros__parameters: {type: T}",
        "/**: {ros__parameters: {type: T}}",
        "a: {ros__parameters: [type, T]}",
        "a: {ros__parameters: {type: []}}",
        "a: {ros__parameters: {type: {b: T}}}",
        "? {a: b}\n: c",
        "&a a: *a",
        "a: &a [*a]",
    ],
)
def test_what_holds_no_controller(text: str | bytes) -> None:
    assert of(text) == ()


def test_an_alias_is_no_value() -> None:
    (drive,) = of("a: {ros__parameters: {type: T, x: &x [1, 2], y: *x, z: [*x, 3]}}")
    assert plain(drive) == {"type": ["T"], "x": ["1", "2"], "z": ["3"]}


@pytest.mark.parametrize(
    "text",
    [
        "[" * 300_000,
        "{a: " * 200_000,
        "- " * 300_000,
        "a: {ros__parameters: {type: T, x: [" + "1," * 20_000 + "1]}}",
        "a: &a [x,x]\n" + "".join(f"b{n}: &b{n} [*a,*a]\n" for n in range(3_000)),
        "a" * (MAX_BYTES + 1),
    ],
)
def test_hostile_files_end(text: str) -> None:
    assert len(of(text)) <= 1


def context(directory: Path, *paths: str) -> Context:
    parameters = "".join(f"<parameters> {path} </parameters>" for path in paths)
    text = whole_robot(ROBOT + plugin("libgazebo_ros2_control.so", parameters))
    return Context(Source(str(directory / "r.urdf"), text.encode()), Resolver(environment={}))


def test_the_files_that_a_plugin_names(tmp_path: Path) -> None:
    here = tmp_path / "c.yaml"
    here.write_text(PLAIN, encoding="utf-8")
    model = context(tmp_path, str(here), "/nowhere/c.yaml", str(here))
    assert [(file.path, file.found) for file in parameter_files(model)] == [
        (str(here), str(here)),
        ("/nowhere/c.yaml", None),
    ]
    ((file, drive),) = controllers(model)
    assert file.element is not None
    assert file.element.text == f" {here} "
    assert drive.name == "drive"
    assert drive.values(["wheel_radius"])[0].span.source.path == str(here)


def test_paths_that_say_nothing_here(tmp_path: Path) -> None:
    model = context(tmp_path, "c.yaml", "$(find p)/c.yaml", "/${x}.yaml", "")
    assert parameter_files(model) == []


def test_a_file_that_a_build_would_install(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "bringup" / "config").mkdir(parents=True)
    source = tmp_path / "bringup" / "config" / "c.yaml"
    source.write_text(PLAIN, encoding="utf-8")
    (file,) = parameter_files(context(tmp_path, str(tmp_path / "config" / "c.yaml")))
    assert file.found == str(source)


def test_a_file_outside_of_the_workspace_is_not_read(tmp_path: Path) -> None:
    workspace, outside = tmp_path / "ws" / "p", tmp_path / "c.yaml"
    workspace.mkdir(parents=True)
    (workspace / "package.xml").write_text("<package><name>p</name></package>")
    outside.write_text(PLAIN, encoding="utf-8")
    model = context(workspace, str(outside))
    assert [file.found for file in parameter_files(model)] == [str(outside)]
    assert list(controllers(model)) == []
