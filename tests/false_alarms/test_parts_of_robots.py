"""A part whose include is commented out is no robot of its own."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity

HEAD = b'<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="rover">\n'
SENSOR = (
    HEAD
    + b"""  <joint name="gps_joint" type="fixed">
    <parent link="base_link"/>
    <child link="gps_link"/>
  </joint>
  <link name="gps_link"><xacro:inertial_box mass="1"/></link>
</robot>
"""
)


def _whole(include: bytes) -> bytes:
    return HEAD + b'  <link name="base_link"/>\n  ' + include + b"\n</robot>\n"


@pytest.mark.parametrize(
    "include",
    [
        b'<!--xacro:include filename="gps.xacro"/-->',
        b'<!-- <xacro:include filename="gps.xacro"/> -->',
    ],
)
def test_a_part_that_only_a_comment_includes(tmp_path: Path, include: bytes) -> None:
    add_file(tmp_path / "rover.urdf.xacro", _whole(include))
    add_file(tmp_path / "gps.xacro", SENSOR)
    report = engine.check(tmp_path, select=["REF", "XAC"])
    assert report.diagnostics == ()
    assert len(report.files) == 1


def test_a_part_without_a_name_that_nothing_includes(tmp_path: Path) -> None:
    """quadruped_ros2_control: ANYmal's imu_link.xacro."""
    add_file(tmp_path / "rover.urdf.xacro", _whole(b""))
    add_file(tmp_path / "imu.xacro", SENSOR.replace(b' name="rover"', b"").replace(b"gps", b"imu"))
    report = engine.check(tmp_path, select=["REF", "XAC", "URD003"])
    assert (report.diagnostics, len(report.files)) == ((), 1)


@pytest.mark.parametrize(
    ("name", "launched", "severity"),
    [
        ("vehicle.xacro", "sensors.xacro", Severity.WARNING),
        ("vehicle.xacro", "vehicle.xacro", Severity.ERROR),
        ("vehicle.urdf.xacro", "sensors.xacro", Severity.ERROR),
        ("vehicle.urdf", "sensors.xacro", Severity.ERROR),
    ],
)
def test_a_part_without_a_name_for_another_package(
    tmp_path: Path, name: str, launched: str, severity: Severity
) -> None:
    """Autoware's vehicle.xacro, which the xacro of its launch package includes."""
    add_package(tmp_path, "vehicle_description")
    add_file(tmp_path / "launch/a.launch.py", f"urdf = '{launched}'\n".encode())
    path = add_file(tmp_path / "urdf" / name, b'<robot><link name="base_link"/></robot>')
    (found,) = engine.check(path, select=["URD003"]).diagnostics
    assert found.severity == severity


def test_a_whole_robot_is_checked_whatever_a_comment_says(tmp_path: Path) -> None:
    add_file(tmp_path / "rover.urdf.xacro", _whole(b'<!--xacro:include filename="other.xacro"/-->'))
    add_file(tmp_path / "other.xacro", _whole(b""))
    assert len(engine.check(tmp_path).files) == 2
    add_file(tmp_path / "gps.xacro", SENSOR)  # which nothing names
    assert {found.code for found in engine.check(tmp_path).diagnostics} >= {"XAC001"}


def test_a_file_that_the_build_makes_is_not_missing(tmp_path: Path) -> None:
    """Hector's quadrotor: CMake writes its plugins. The robot is not checked, and no error."""
    add_file(tmp_path / "robot.xacro", _whole(b'<xacro:include filename="plugins.xacro"/>'))
    add_file(tmp_path / "plugins.xacro.in", HEAD + b"@PLUGINS@</robot>")
    (found,) = engine.check(tmp_path / "robot.xacro").diagnostics
    assert (found.code, found.severity) == ("XAC001", Severity.WARNING)
    assert "plugins.xacro.in" in found.message
    (tmp_path / "plugins.xacro.in").unlink()
    (found,) = engine.check(tmp_path / "robot.xacro").diagnostics
    assert (found.code, found.severity) == ("XAC001", Severity.ERROR)


@pytest.mark.parametrize(
    ("command", "severity"),
    [
        ("xacro_add_files(\n  urdf/arm.urdf.xacro\n  INSTALL DESTINATION urdf)", Severity.WARNING),
        ("xacro_add_xacro_file(urdf/arm.urdf.xacro)", Severity.WARNING),
        ("# xacro_add_files(urdf/arm.urdf.xacro)", Severity.ERROR),
        ("xacro_add_files(urdf/charm.urdf.xacro)", Severity.ERROR),
        ("install(FILES urdf/arm.urdf.xacro DESTINATION share/arm)", Severity.ERROR),
        (
            "set(A ${CMAKE_BINARY_DIR}/arm.urdf)\ninstall(FILES ${A} DESTINATION share/arm/urdf)",
            Severity.WARNING,
        ),
        (
            "install(FILES ${CMAKE_CURRENT_BINARY_DIR}/arm.urdf DESTINATION share/${PROJECT_NAME})",
            Severity.ERROR,
        ),
    ],
)
def test_a_file_that_the_build_expands(tmp_path: Path, command: str, severity: Severity) -> None:
    """SO-ARM100: CMake makes the URDF that MoveIt's xacro includes; DFKI's H1: downloads it."""
    add_file(tmp_path / "CMakeLists.txt", command.encode())
    add_file(tmp_path / "urdf" / "arm.urdf.xacro", _whole(b""))
    include = b'<xacro:include filename="../urdf/arm.urdf"/>'
    robot = add_file(tmp_path / "config" / "arm.urdf.xacro", _whole(include))
    (found,) = engine.check(robot, select=["XAC001"]).diagnostics
    assert found.severity == severity


@pytest.mark.parametrize(
    ("pattern", "other", "severity"),
    [
        ("robot/urdf", "", Severity.WARNING),
        ("robot/urdf", "robot/urdf/leg.xacro", Severity.ERROR),  # the script has run
        ("robot/meshes", "", Severity.ERROR),
    ],
)
def test_a_file_that_a_script_creates(
    tmp_path: Path, pattern: str, other: str, severity: Severity
) -> None:
    """Aero: setup.sh copies the xacros of a type to a directory that git ignores."""
    if shutil.which("git") is None:
        pytest.skip("git is not installed")
    subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    (tmp_path / ".gitignore").write_text(f"{pattern}\n")
    if other:
        add_file(tmp_path / other, HEAD + b"</robot>")
    include = b'<xacro:include filename="../urdf/arm.xacro"/>'
    robot = add_file(tmp_path / "robot" / "types" / "a.urdf.xacro", _whole(include))
    (found,) = engine.check(robot, select=["XAC001"]).diagnostics
    assert found.severity == severity


def test_an_srdf_of_macros_only_is_none(tmp_path: Path) -> None:
    """Franka's hand: macros for the SRDF files of arms, next to the hand's xacro."""
    robot = add_file(tmp_path / "hand.urdf", b'<robot name="hand"><link name="hand"/></robot>')
    head = b'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
    macro = head + b'<xacro:macro name="hand_srdf"><group name="g"/></xacro:macro>%s</robot>'
    for call, count in ((b"", 0), (b"<xacro:hand_srdf/>", 1)):
        add_file(tmp_path / "hand.srdf.xacro", macro % call)
        assert bool(check(robot, select=["SRD017"]).diagnostics) == bool(count)


@pytest.mark.parametrize(("prefix", "codes"), [("", []), ("xacro:", [])])
def test_an_example_that_an_environment_variable_includes(
    tmp_path: Path, prefix: str, codes: list[str]
) -> None:
    """Jackal's `custom_example.urdf`: joints and calls of macros, without a name and links."""
    space = ' xmlns:xacro="http://www.ros.org/wiki/xacro"' if prefix else ""
    joint = '<joint name="j" type="fixed"><parent link="mount"/><child link="camera"/></joint>'
    text = f'<robot{space}><{prefix}camera_mount name="front"/>{joint}</robot>'
    example = add_file(tmp_path / "custom_example.urdf", text.encode())
    found = check(example).diagnostics
    assert [one.code for one in found if one.severity is not Severity.INFO] == codes
    robot = text.replace("<robot", '<robot name="r"', 1)
    example.write_text(robot)
    assert any(one.severity is Severity.ERROR for one in check(example).diagnostics)


@pytest.mark.parametrize(("name", "severity"), [("", Severity.INFO), ("base", Severity.ERROR)])
def test_a_part_whose_including_file_a_program_writes(
    tmp_path: Path, name: str, severity: Severity
) -> None:
    """Mobile_Robot_URDF_Maker: robots without a name; a wizard writes what includes one."""
    head = HEAD.replace(b' name="rover"', f' name="{name}"'.encode() if name else b"")
    box = b'<box size="${length} ${width} ${height}"/>'
    link = b'<link name="base"><visual><geometry>%s</geometry></visual>${mass}</link>' % box
    part = add_file(tmp_path / "four_wheels.xacro", head + link + b"</robot>")
    found = check(part, select=["XAC001"]).diagnostics
    assert {one.severity for one in found} == {severity}


@pytest.mark.parametrize(
    ("include", "severity", "help"),
    [
        ("xacro/utils/box.xacro", Severity.WARNING, "write utils/box.xacro"),
        ("xacro/utils/bar.xacro", Severity.ERROR, "directory 'xacro' not"),
    ],
)
def test_an_include_from_the_directory_where_xacrodoc_runs(
    tmp_path: Path, include: str, severity: Severity, help: str
) -> None:
    """upkie_description: its Makefile expands xacro/upkie.xacro with xacrodoc, in its root."""
    add_file(tmp_path / "xacro/utils/box.xacro", b"<robot/>")
    text = _whole(f'<xacro:include filename="{include}"/>'.encode())
    path = add_file(tmp_path / "xacro/robot.xacro", text)
    (found,) = engine.check(path, select=["XAC001"]).diagnostics
    assert (found.severity, str(found.help)[: len(help)]) == (severity, help)


@pytest.mark.parametrize(
    ("content", "severity"),
    [
        (b'<ros2_control name="c" type="system"/>', Severity.INFO),
        (b"<gazebo/>", Severity.INFO),
        (b'<material name="m"/>', Severity.ERROR),
        (b"", Severity.ERROR),
    ],
)
def test_the_hardware_of_a_robot_in_a_file_of_its_own(
    tmp_path: Path, content: bytes, severity: Severity
) -> None:
    """A biped has five of them; a sixth, of its first version, is left."""
    path = add_file(tmp_path / "v1.urdf", b'<robot name="biped">' + content + b"</robot>")
    (found,) = check(path, select=["TRE001"]).diagnostics
    assert found.severity is severity


@pytest.mark.parametrize(
    ("body", "severity"),
    [
        ("", Severity.INFO),
        ('<link name="wheel"/>', Severity.ERROR),
        ("<xacro:wheel/>", Severity.ERROR),
        ('<xacro:include filename="no.xacro"/>', Severity.ERROR),
    ],
)
def test_plugins_that_an_argument_includes(tmp_path: Path, body: str, severity: Severity) -> None:
    """acl-robotgroup/mobile_manipulator: a launch file passes extra_xacro:=.../gazebo.xacro."""
    plugin = b"<gazebo><plugin><wheel_separation>${track}</wheel_separation></plugin></gazebo>"
    joint = b'<ros2_control><joint name="$(arg namespace)wheel"/></ros2_control>'
    add_file(
        tmp_path / "rover.urdf.xacro",
        _whole(
            b'<xacro:arg name="extra" default="none.xacro"/><xacro:property name="track" '
            b'value="1"/><xacro:include filename="$(arg extra)"/>'
        ),
    )
    add_file(tmp_path / "none.xacro", HEAD + b"</robot>\n")
    text = HEAD + plugin + joint + body.encode() + b"\n</robot>\n"
    file = add_file(tmp_path / "sim.xacro", text)
    of_file = engine.check(file, select=["XAC", "CFG003"]).diagnostics
    assert max(found.severity for found in of_file) is severity
    of_all = engine.check(tmp_path, select=["XAC001", "XAC010", "CFG003"]).diagnostics
    shown = [found for found in of_all if found.severity is not Severity.INFO]
    assert bool(shown) == (severity is Severity.ERROR)


@pytest.mark.parametrize(("argument", "count"), [("tool_dir", 0), ("other", 1)])
def test_a_part_that_an_argument_names(tmp_path: Path, argument: str, count: int) -> None:
    """Stretch 4: a xacro two directories above includes the tool that an argument names."""
    (tmp_path / ".git").mkdir()
    whole = b"""<xacro:arg name="tool" default="none"/><xacro:arg name="tool_dir" default=""/>
  <xacro:include filename="$(arg tool_dir)/$(arg tool).urdf"/>"""
    add_file(tmp_path / "rover.xacro", _whole(whole))
    mesh = f'<mesh filename="$(arg {argument})/a.stl"/>'
    part = f'<robot name="a"><link name="a"><visual><geometry>{mesh}</geometry></visual></link>'
    path = add_file(tmp_path / "tools" / "a" / "a.urdf", f"{part}</robot>".encode())
    assert len(check(path, select=["XAC003"]).diagnostics) == count
