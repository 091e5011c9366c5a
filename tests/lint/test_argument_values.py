"""Values for arguments that a robot lacks, from the files around it."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.lint.argument_sets import MAX_SETS
from urdfkit.lint.fix import fix
from urdfkit.lint.report import Report

HEAD = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
#: A link whose mass is read from a file of the model.
BY_DIRECTORY = f"""{HEAD}
  <xacro:arg name="kind" default="none_such"/>
  <xacro:arg name="file" default="$(find arms)/config/$(arg kind)/data.yaml"/>
  <xacro:property name="data" value="${{xacro.load_yaml('$(arg file)')}}"/>
  <link name="base"><inertial><mass value="${{data['mass']}}"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>
"""
WANTING = f'{HEAD}<link name="$(arg side)_base"/></robot>'
LAUNCH = """\
<launch>
  <arg name="side" default="{}"/>
  <param name="robot_description" command="xacro $(find arms)/arm.xacro side:=$(arg side)"/>
</launch>
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """The package of a robot, in a workspace."""
    (tmp_path / ".git").mkdir()
    return add_package(tmp_path / "arms", "arms")


def taken(report: Report) -> list[tuple[dict[str, str], str]]:
    return [(one.arguments, Path(one.launch).name) for one in report.launched]


def codes(report: Report) -> list[str]:
    return [one.code for one in report.diagnostics]


def kinds(package: Path, **masses: float) -> Path:
    for kind, mass in masses.items():
        add_file(package / "config" / kind / "data.yaml", f"mass: {mass}\n")
    return add_file(package / "arm.xacro", BY_DIRECTORY)


def test_the_directories_that_a_path_may_lead_to(package: Path) -> None:
    robot = kinds(package, big=2, small=-1)
    add_file(package / "config" / "common" / "limits.yaml", "")  # which lacks the file
    for what in (package, robot):
        report = check(what)
        assert taken(report) == [({"kind": "big"}, "config"), ({"kind": "small"}, "config")]
        assert "INE001" in codes(report)
        assert not {"XAC001", "XAC010", "CFG003"} & set(codes(report))


def test_a_directory_with_which_the_robot_does_not_expand_is_no_value(package: Path) -> None:
    kinds(package, big=2)
    add_file(package / "config" / "odd" / "data.yaml", "weight: 1\n")
    report = check(package)
    assert taken(report) == [({"kind": "big"}, "config")]
    (found,) = (one for one in report.diagnostics if one.code.startswith(("XAC", "CFG")))
    assert (found.code, found.severity.value) == ("CFG003", "warning")
    assert found.message.startswith("robot not checked with 1 of 2 values of 'kind': odd; ")
    assert "'mass'" in found.message
    add_file(package / "config" / "big" / "data.yaml", "weight: 1\n")
    report = check(package)
    assert codes(report) == ["CFG003"]
    (found,) = report.diagnostics
    assert "(found for kind: " in found.message
    assert "has big, odd, with which it does not expand)" in found.message


def test_a_parameter_of_a_macro_that_is_called_like_the_argument(package: Path) -> None:
    add_file(
        package / "arm.xacro",
        f'{HEAD}<xacro:arg name="arm" default="NO_ARM"/>\n<xacro:macro name="load" params="arm">'
        '<xacro:include filename="$(find arms)/arms/${arm}/${arm}.xacro"/></xacro:macro>\n'
        '<xacro:load arm="$(arg arm)"/></robot>',
    )
    for arm in ("one", "two"):
        add_file(package / "arms" / arm / f"{arm}.xacro", f'{HEAD}<link name="{arm}"/></robot>')
    assert taken(check(package / "arm.xacro")) == [
        ({"arm": "one"}, "arms"),
        ({"arm": "two"}, "arms"),
    ]


def test_no_more_directories_than_a_bound(package: Path) -> None:
    kinds(package, **{f"kind{number:02}": 1 for number in range(MAX_SETS + 2)})
    report = check(package, select=["XAC"])
    assert len(report.launched) == MAX_SETS
    assert codes(report) == ["CFG003"]
    assert "with 2 of 18 values of 'kind': kind16, kind17; " in report.diagnostics[0].message


def test_no_more_launch_files_than_a_bound(package: Path) -> None:
    add_file(package / "arm.xacro", WANTING)
    for number in range(MAX_SETS + 1):
        add_file(package / "launch" / f"{number:02}.launch", LAUNCH.format(f"side{number:02}"))
    report = check(package / "arm.xacro", select=["XAC"])
    assert len(report.launched) == MAX_SETS
    assert "with 1 of 17 values of 'side': side16; " in report.diagnostics[0].message


def test_launch_files_of_other_packages(package: Path) -> None:
    robot = add_file(package / "arm.xacro", WANTING)
    bringup = add_package(package.parent / "bringup", "bringup")
    add_file(bringup / "launch" / "arm.launch", LAUNCH.format("left"))
    assert taken(check(package)) == [({"side": "left"}, "arm.launch")]
    assert taken(check(robot)) == taken(check(package))
    add_file(package / "launch" / "own.launch", LAUNCH.format("right"))
    sets = [({"side": "right"}, "own.launch"), ({"side": "left"}, "arm.launch")]
    assert taken(check(robot)) == taken(check(package)) == sets


def test_launch_files_about_other_packages_say_nothing(package: Path) -> None:
    add_file(package / "arm.xacro", WANTING)
    other = add_package(package.parent / "legs", "legs")
    add_file(other / "leg.xacro", WANTING)
    launch = LAUNCH.format("left").replace("arms", "legs").replace("arm.xacro", "leg.xacro")
    add_file(other / "leg.launch", launch)
    assert codes(check(package)) == ["CFG003"]


@pytest.mark.parametrize(
    ("declaration", "values"),
    [
        ('DeclareLaunchArgument("side", choices=["left", "right"])', ["left", "right"]),
        ('DeclareLaunchArgument("side", default_value="left")', ["left"]),
        ('DeclareLaunchArgument("side", default_value="")', [""]),
        (
            'DeclareLaunchArgument("side", default_value="left", choices=["left", "right"])',
            ["left", "right"],
        ),
        ('DeclareLaunchArgument("side", default_value=here())', []),
        ('DeclareLaunchArgument("side")', []),
    ],
)
def test_arguments_that_a_launch_file_declares(
    package: Path, declaration: str, values: list[str]
) -> None:
    """What it does with them is known only by running it."""
    add_file(package / "arm.xacro", WANTING)
    text = f"def generate_launch_description():\n    return run({declaration}, setup)\n"
    add_file(package / "arm.launch.py", text)
    report = check(package)
    assert taken(report) == [({"side": value}, "arm.launch.py") for value in values]
    assert ("CFG003" in codes(report)) is not bool(values)


def test_the_default_of_an_include_that_is_not_reached(package: Path) -> None:
    add_file(package / "defaults.xacro", f'{HEAD}<xacro:arg name="side" default="left"/></robot>')
    add_file(
        package / "arm.xacro",
        f'{HEAD}<link name="$(arg side)_base"/><xacro:macro name="late">'
        '<xacro:include filename="$(find arms)/defaults.xacro"/></xacro:macro></robot>',
    )
    assert taken(check(package)) == [({"side": "left"}, "defaults.xacro")]


def test_the_default_of_an_include_below_the_use(package: Path) -> None:
    add_file(package / "defaults.xacro", f'{HEAD}<xacro:arg name="side" default="left"/></robot>')
    include = '<xacro:include filename="defaults.xacro"/>'
    add_file(package / "arm.xacro", f'{HEAD}<link name="$(arg side)_base"/>{include}</robot>')
    assert taken(check(package)) == [({"side": "left"}, "defaults.xacro")]


def test_arguments_from_different_places(package: Path) -> None:
    kinds(package, big=2, small=3)
    robot = package / "arm.xacro"
    robot.write_text(BY_DIRECTORY.replace('"base"', '"$(arg side)_base"'))
    add_file(package / "arm.launch", '<launch><arg name="side" default="left"/></launch>')
    assert taken(check(robot)) == [
        ({"side": "left"}, "arm.launch"),
        ({"kind": "big"}, "config"),
        ({"side": "left"}, "arm.launch"),
        ({"kind": "small"}, "config"),
    ]
    assert taken(check(robot, arguments={"side": "right"})) == [
        ({"kind": "big"}, "config"),
        ({"kind": "small"}, "config"),
    ]


def test_fixes_hold_for_all_values(package: Path) -> None:
    kinds(package, big=2, small=3)
    robot = package / "arm.xacro"
    robot.write_text(BY_DIRECTORY.replace("<robot", "<!-- a -->\n<robot"))
    fixes = fix(robot, unsafe=True)
    assert [one.arguments["kind"] for one in fixes.report.launched] == ["big", "small"]
    assert fixes.report.crashed == ()


@pytest.mark.parametrize(
    ("command", "sides"),
    [
        ('foreach(S IN ITEMS left right)\n  xacro(arm.xacro "side:=${S}")', ["left", "right"]),
        ("xacro(arm.xacro side:=left)", ["left"]),
        ("xacro(arm.xacro side:=${S})", []),
        ("xacro(other.xacro side:=left)", []),
    ],
)
def test_the_values_that_cmake_passes(package: Path, command: str, sides: list[str]) -> None:
    """Orca3: the build expands the robot once for each mode of the simulation."""
    add_file(package / "arm.xacro", WANTING)
    add_file(package / "CMakeLists.txt", f"{command}\n# side:=none\n")
    report = check(package)
    assert taken(report) == [({"side": side}, "CMakeLists.txt") for side in sides]
    assert ("CFG003" in codes(report)) is not bool(sides)
