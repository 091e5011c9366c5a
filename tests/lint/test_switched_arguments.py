"""Values of arguments that no launch file passes: what is in their conditions is checked."""

from pathlib import Path

import pytest

from tests.fixing import FIXED_JOINT, fix, write
from tests.workspaces import add_file
from tests.xacros import NAMESPACE, xacro
from urdfkit import check
from urdfkit.cli.shown_files import shown_files
from urdfkit.lint.config_reader import load
from urdfkit.lint.options import Options
from urdfkit.lint.switched_arguments import MAX_SWITCHED
from urdfkit.text.diagnostic import Diagnostic, Severity

JOINT = '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>'
ARGUMENT = '<xacro:arg name="sim" default="{}"/>'
#: Inside of the condition; ``arm`` is misspelt.
BLOCK = '<xacro:{0} value="$(arg sim)"><gazebo reference="am"><mu1>1</mu1></gazebo></xacro:{0}>'
ROBOT = '<link name="base"/><link name="arm"/>' + JOINT


def _found(directory: Path, body: str, **arguments: str) -> list[Diagnostic]:
    """The findings of a package with a robot; line 2 is the beginning of its body."""
    add_file(directory / "package.xml", "<package><name>p</name></package>")
    robot = add_file(directory / "urdf" / "robot.xacro", xacro(body))
    options = Options(select=("GAZ001", "JNT001", "GEO002"), arguments=arguments)
    return list(check(robot if arguments else directory, options=options).diagnostics)


@pytest.mark.parametrize(
    ("default", "tag", "variants"),
    [
        ("false", "if", ("sim=true",)),
        ("False", "if", ("sim=true",)),
        ("true", "unless", ("sim=false",)),
        ("true", "if", ()),  # as it is started
    ],
)
def test_both_values_are_checked(
    tmp_path: Path, default: str, tag: str, variants: tuple[str, ...]
) -> None:
    found = _found(tmp_path, f"{ARGUMENT.format(default)}{ROBOT}\n{BLOCK.format(tag)}")
    (reference,) = [one for one in found if one.code == "GAZ001"]
    assert (reference.span.line, reference.variants) == (3, variants)


@pytest.mark.parametrize(
    ("condition", "tried"),
    [
        ("${sensor == 'lidar'}", ["sensor=lidar"]),
        ("${'$(arg sensor)' == 'lidar'}", ["sensor=lidar"]),
        ("${sensor in ('lidar',)}", []),
        ("${sensor != 'lidar'}", []),
        ("${sensor == 'none'}", []),  # as it is started
        ("${other == 'lidar'}", []),
    ],
)
def test_a_value_that_a_condition_compares_with_is_tried(
    tmp_path: Path, condition: str, tried: list[str]
) -> None:
    names = '<xacro:arg name="sensor" default="none"/><xacro:property name="other" value="none"/>'
    sensor = '<xacro:property name="sensor" value="$(arg sensor)"/>'
    block = f'<xacro:if value="{condition}"><gazebo reference="am"><mu1>1</mu1></gazebo></xacro:if>'
    found = _found(tmp_path, f"{names}{sensor}{ROBOT}\n{block}")
    variants = [one.variants for one in found if one.code == "GAZ001"]
    is_started = condition in ("${sensor == 'none'}", "${sensor != 'lidar'}")
    assert variants == ([()] if is_started else [(one,) for one in tried])


@pytest.mark.parametrize(
    "passed",
    [
        '<xacro:property name="real" value="$(arg hardware)"/>{}',
        '<xacro:macro name="m" params="real">{}</xacro:macro><xacro:m real="$(arg hardware)"/>',
    ],
)
def test_an_argument_under_another_name_in_the_condition(tmp_path: Path, passed: str) -> None:
    block = '<xacro:if value="${real}"><gazebo reference="am"><mu1>1</mu1></gazebo></xacro:if>'
    names = '<xacro:arg name="hardware" default="false"/>'
    found = _found(tmp_path, f"{names}{ROBOT}\n{passed.format(block)}")
    assert [one.variants for one in found if one.code == "GAZ001"] == [("hardware=true",)]


def test_an_error_is_a_warning_and_an_info_is_left_out(tmp_path: Path) -> None:
    hand = JOINT.replace("arm", "hand").replace('"j"', '"k"').replace("fixed", "revolut")
    block = f'<xacro:if value="$(arg sim)"><link name="hand"/>\n{hand}</xacro:if>'
    found = _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}\n{block}")
    shown = [(one.code, one.span.line, one.severity, one.variants) for one in found]
    assert shown == [
        ("GEO002", 1, Severity.INFO, ()),
        ("JNT001", 4, Severity.WARNING, ("sim=true",)),
    ]


@pytest.mark.parametrize(
    ("block", "count"),
    [
        ('<xacro:if value="$(arg sim)">{}</xacro:if>', 1),
        ("{}", 0),  # akros2_description: nopath is for a program that looks elsewhere
    ],
)
def test_other_values_of_what_it_has_are_not_reported(
    tmp_path: Path, block: str, count: int
) -> None:
    value = '<xacro:if value="$(arg sim)"><xacro:property name="p" value="am"/></xacro:if>'
    tag = block.format('<gazebo reference="${p}"><mu1>1</mu1></gazebo>')
    given = '<xacro:property name="p" value="arm"/>'
    found = _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}{given}{value}\n{tag}")
    assert [one.code for one in found] == ["GEO002", *["GAZ001"] * count]


@pytest.mark.parametrize(("other", "count"), [("hand", 0), ("", 1)])
def test_what_another_boolean_adds_is_not_missing(tmp_path: Path, other: str, count: int) -> None:
    """thinclab/ur3e_irl_project: the motors of a conveyor without its rollers."""
    link = f'<link name="{other}"/>' if other else ""
    more = (
        f'<xacro:arg name="more" default="false"/><xacro:if value="$(arg more)">{link}</xacro:if>'
    )
    found = _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}{more}\n{BLOCK.format('if')}")
    assert [one.code for one in found if one.variants] == ["GAZ001"] * count


def test_a_launch_file_starts_it_with_the_other_value(tmp_path: Path) -> None:
    add_file(
        tmp_path / "launch" / "sim.launch",
        '<launch><param name="robot_description" '
        'command="xacro $(find p)/urdf/robot.xacro sim:=true"/></launch>',
    )
    (found,) = _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}\n{BLOCK.format('if')}")[1:]
    assert found.variants == ()


def test_arguments_of_the_user_are_checked_alone(tmp_path: Path) -> None:
    body = f"{ARGUMENT.format('false')}{ROBOT}\n{BLOCK.format('if')}"
    assert [one.code for one in _found(tmp_path, body, sim="false")] == ["GEO002"]


def test_arguments_of_the_configuration_are_not_switched(tmp_path: Path) -> None:
    _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}\n{BLOCK.format('if')}")
    robot = '[[robot]]\nfile = "urdf/robot.xacro"\narguments.sim = "false"\n'
    config = load(str(add_file(tmp_path / "urdfkit.toml", robot)))
    shown = shown_files([str(tmp_path)], Options(config=config)).splitlines()
    assert [line.rpartition(" ")[2] for line in shown] == ["sim:=false"]


@pytest.mark.parametrize(
    "block",
    [
        '<xacro:unless value="$(arg sim)"><link name="hand"/></xacro:unless>',  # it gets lost
        '<xacro:if value="$(arg sim)">${unknown}</xacro:if>',  # it does not expand
        "<gazebo reference=\"${'base' if '$(arg sim)' == 'false' else 'am'}\"/>",
        '<xacro:if value="$(arg sim)"/>',  # it stays the same
    ],
)
def test_other_robots_are_not_made(tmp_path: Path, block: str) -> None:
    _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}{block}")
    shown = shown_files([str(tmp_path)], Options())
    assert "sim:=" not in shown


@pytest.mark.parametrize(("more", "is_switched"), [(0, True), (1, False)])
def test_a_large_robot_is_not_checked_once_more(
    tmp_path: Path, more: int, is_switched: bool
) -> None:
    most, _ = MAX_SWITCHED[-1]
    links = "".join(f'<link name="l{number}"/>' for number in range(most - 1 + more))
    block = '<xacro:if value="$(arg sim)"><link name="hand"/></xacro:if>'
    _found(tmp_path, f"{ARGUMENT.format('false')}{links}{block}")  # the root is an element, too
    assert ("sim:=true" in shown_files([str(tmp_path)], Options())) is is_switched


@pytest.mark.parametrize(("most", "count"), MAX_SWITCHED)
def test_at_most_some_are_switched_one_at_a_time(tmp_path: Path, most: int, count: int) -> None:
    names = [f"a{number}" for number in range(count + 2)]
    links = "".join(f'<link name="l{number}"/>' for number in range(most - 20))
    arguments = "".join(f'<xacro:arg name="{name}" default="false"/>' for name in names)
    blocks = "".join(
        f'<xacro:if value="$(arg {name})"><link name="{name}"/></xacro:if>' for name in names
    )
    _found(tmp_path, f"{arguments}{ROBOT}{links}{blocks}")
    shown = shown_files([str(tmp_path)], Options()).splitlines()
    assert [line.partition(" ")[2] for line in shown] == [
        "",
        *(f"{name}:=true" for name in names[:count]),
    ]


def test_what_it_has_and_what_is_added_to_it_is_fixed(tmp_path: Path) -> None:
    added = FIXED_JOINT.replace('"a"', '"c"').replace('"b"', '"d"').replace('"j"', '"k"')
    block = f'<xacro:if value="$(arg sim)">{added}</xacro:if>'
    body = f"{ARGUMENT.format('false')}{FIXED_JOINT}{block}"
    write(tmp_path, "r.urdf.xacro", body, NAMESPACE)
    (file,) = fix(tmp_path).files
    assert (file.before.count(b"<axis"), file.after.count(b"<axis")) == (2, 0)


CHOICE = """<launch><arg name="place" default="depot">{}</arg>
<node pkg="robot_localization" exec="ekf_node" name="local"/>
<group if="$(eval '{}')"><node pkg="robot_localization" exec="{}" name="global"/></group></launch>
"""
COMPARED = "\\'$(var place)\\' == \\'yard\\'"


@pytest.mark.parametrize(
    ("choice", "condition", "executable", "variants"),
    [
        ('<choice value="yard"/>', COMPARED, "ekf_node", [("place=yard",)]),
        ("", COMPARED, "ekf_node", [("place=yard",)]),
        ("", COMPARED, "navsat_transform_node", []),
        ("", COMPARED.replace("yard", "depot"), "ekf_node", [()]),
    ],
)
def test_choices_of_a_launch_file(
    tmp_path: Path,
    choice: str,
    condition: str,
    executable: str,
    variants: list[tuple[str, ...]],
) -> None:
    """What is started together with another choice than the default is checked, too."""
    add_file(tmp_path / "package.xml", "<package><name>p</name></package>")
    text = CHOICE.format(choice, condition, executable)
    file = add_file(tmp_path / "launch" / "a.launch.xml", text)
    found = check(file, select=["LAU021"]).diagnostics
    assert [one.variants for one in found] == variants


LAUNCH = """<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
<param name="robot_description" value="$(command 'xacro $(find-pkg-share p)/urdf/robot.xacro {}')"/>
</node></launch>"""


@pytest.mark.parametrize(
    ("passed", "variants"),
    [
        ("sim:=true", [("camera=true",)]),
        ("sim:=true camera:=true", [()]),  # as it is started
        ("", []),  # neither argument adds it alone
    ],
)
def test_a_part_that_needs_a_value_of_a_launch_file_and_another_one(
    tmp_path: Path, passed: str, variants: list[tuple[str, ...]]
) -> None:
    """RT's CRANE+: the camera of the simulation, which a launch file starts without it."""
    add_file(tmp_path / "launch" / "a.launch.xml", LAUNCH.format(passed))
    camera = '<xacro:arg name="camera" default="false"/>'
    block = f'<xacro:if value="$(arg camera)">{BLOCK.format("if")}</xacro:if>'
    block += BLOCK.format("if").replace('"am"', '"arm"')
    found = _found(tmp_path, f"{ARGUMENT.format('false')}{camera}{ROBOT}\n{block}")
    assert [one.variants for one in found if one.code == "GAZ001"] == variants


#: A macro with another parameter than its call has, in a file of its own.
CALL = '<xacro:if value="$(arg sim)">{}<xacro:sensor parent="arm"/></xacro:if>'


@pytest.mark.parametrize(
    ("params", "body", "count"),
    [
        ("parent_link", "", 1),
        ("parent size", "", 1),
        ("parent", '<link name="${size}"/>', 0),  # another argument may define it
        ("parent", "", 0),
    ],
)
def test_a_call_with_other_parameters_is_reported(
    tmp_path: Path, params: str, body: str, count: int
) -> None:
    macro = f'<xacro:macro name="sensor" params="{params}">{body}</xacro:macro>'
    add_file(tmp_path / "package.xml", "<package><name>p</name></package>")
    robot = xacro(f"{ARGUMENT.format('false')}{ROBOT}\n{CALL.format(macro)}")
    add_file(tmp_path / "urdf" / "robot.xacro", robot)
    found = check(tmp_path, options=Options(select=("XAC001",))).diagnostics
    assert [(one.code, one.severity, one.variants) for one in found] == [
        ("XAC001", Severity.WARNING, ("sim=true",))
    ] * count


LACKING = "<gazebo><plugin><parameters>$(find absent)/c.yaml</parameters></plugin></gazebo>"


@pytest.mark.parametrize(
    "block", [BLOCK.replace("</xacro:{0}>", LACKING + "</xacro:{0}>"), BLOCK + LACKING]
)
def test_a_package_that_is_not_found_hides_no_other_value(tmp_path: Path, block: str) -> None:
    """What a simulation adds is checked, though its parameter file is in another package."""
    found = _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}\n{block.format('if')}")
    assert [(one.code, one.variants) for one in found if one.variants] == [
        ("GAZ001", ("sim=true",))
    ]


def test_what_another_value_leaves_out_may_be_in_a_package(tmp_path: Path) -> None:
    """The robot has its hand as it is started, from a package that is not found."""
    include = '<xacro:include filename="$(find absent)/hand.xacro"/>'
    include = f'<xacro:unless value="$(arg sim)">{include}</xacro:unless>'
    hand = '<xacro:if value="$(arg sim)"><gazebo reference="hand"><mu1>1</mu1></gazebo></xacro:if>'
    found = _found(tmp_path, f"{ARGUMENT.format('false')}{ROBOT}\n{include}{hand}")
    assert [one for one in found if one.variants] == []
