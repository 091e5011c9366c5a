"""Numbers that a xacro takes out of YAML files: findings are reported there (Franka's robots)."""

from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.naming import naming
from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Span

ROBOT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="inertials" value="${xacro.load_yaml('inertials.yaml')}"/>
  <xacro:property name="limits" value="${xacro.load_yaml('limits.yaml')}"/>
  <xacro:macro name="arm_link" params="name">
    <xacro:property name="inertia" value="${inertials[name]['inertia']}"/>
    <link name="${name}">
      <inertial>
        <mass value="${inertials[name].mass}"/>
        <inertia ixx="${inertia.xx}" iyy="${inertia.yy}" izz="${inertia.zz}"
                 ixy="0" ixz="0" iyz="0"/>
      </inertial>
    </link>
  </xacro:macro>
  <xacro:arm_link name="link1"/>
  <xacro:arm_link name="link2"/>
  <xacro:arm_link name="link3"/>
  <joint name="joint1" type="revolute">
    <parent link="link1"/>
    <child link="link2"/>
    <axis xyz="0 0 1"/>
    <xacro:property name="limit" value="${limits.joint1}"/>
    <limit lower="${limit.lower}" upper="${limit.upper}" effort="87" velocity="2"/>
  </joint>
</robot>
"""
INERTIALS = """\
link1:
  mass: 4.9
  inertia: {xx: 0.7, yy: 0.7, zz: 9.0}
link2:
  mass: 0.6
  inertia:
    xx: 0.1
    yy: 0.1
    zz: 5.0
link3:
  mass: -1
  inertia: {xx: 0.1, yy: 0.1, zz: 0.1}
"""
LIMITS = "joint1: {lower: 1.0, upper: -1.0}\n"


def findings(tmp_path: Path, code: str, robot: str = ROBOT) -> Sequence[Diagnostic]:
    files = {"arm.urdf.xacro": robot, "inertials.yaml": INERTIALS, "limits.yaml": LIMITS}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    return check(tmp_path / "arm.urdf.xacro", select=[code]).diagnostics


def place(span: Span) -> tuple[str, int, int]:
    return Path(span.source.path).name, span.line, span.column


def test_an_element_is_reported_at_its_first_number(tmp_path: Path) -> None:
    (found,) = findings(tmp_path, "JNT003")
    assert place(found.span) == ("limits.yaml", 1, 17)
    (call,) = found.calls
    assert [(step.kind, Path(step.name).name, place(step.span)) for step in call.via] == [
        ("include", "limits.yaml", ("arm.urdf.xacro", 22, 5))
    ]
    assert found.related == ()


def test_every_call_of_a_macro_has_its_own_place(tmp_path: Path) -> None:
    first, second = findings(tmp_path, "INE003")
    assert [place(found.span) for found in (first, second)] == [
        ("inertials.yaml", 3, 17),
        ("inertials.yaml", 7, 9),
    ]
    assert [step.kind for step in first.calls[0].via] == ["macro", "include"]
    assert first.related == ()
    assert [(place(one.span), one.message) for one in second.related] == [
        (("inertials.yaml", 8, 9), naming("here")),
        (("inertials.yaml", 9, 9), naming("here")),
    ]


def test_one_attribute(tmp_path: Path) -> None:
    (found,) = findings(tmp_path, "INE001")
    assert (place(found.span), found.related) == (("inertials.yaml", 11, 9), ())


@pytest.mark.parametrize("written", ["${-limit.lower}", "${limit.lower * 2}"])
def test_a_calculated_number_is_reported_in_the_xacro(tmp_path: Path, written: str) -> None:
    """The calculation may be what is wrong; a note says where its value is from."""
    robot = ROBOT.replace('lower="${limit.lower}"', f'lower="{written}"')
    robot = robot.replace('upper="${limit.upper}"', 'upper="-9"')
    (found,) = findings(tmp_path, "JNT003", robot)
    assert place(found.span) == ("arm.urdf.xacro", 22, 5)
    assert [(place(one.span), one.message) for one in found.related] == [
        (("limits.yaml", 1, 17), naming("lower", "here"))
    ]


def test_a_missing_number_is_reported_in_the_xacro(tmp_path: Path) -> None:
    robot = ROBOT.replace(' effort="87" velocity="2"', "")
    (found,) = findings(tmp_path, "JNT002", robot)
    assert place(found.span) == ("arm.urdf.xacro", 22, 5)


def test_a_name_from_a_data_file_is_reported_where_it_is_used(tmp_path: Path) -> None:
    (tmp_path / "names.yaml").write_text("a: base\n")
    robot = (
        '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        '<xacro:property name="n" value="${xacro.load_yaml(\'names.yaml\')}"/>\n'
        '<link name="${n.a}"/><link name="${n.a}"/></robot>'
    )
    (found,) = findings(tmp_path, "NAM001", robot)
    assert place(found.span) == ("arm.urdf.xacro", 3, 34)


def test_a_comment_at_the_use_ignores_a_number_of_a_data_file(tmp_path: Path) -> None:
    ignored = ROBOT.replace("<limit ", "<!-- urdfkit: ignore[JNT003] -->\n    <limit ")
    assert findings(tmp_path, "JNT003", ignored) == ()


def test_a_number_in_the_xacro_itself_has_no_note(tmp_path: Path) -> None:
    robot = ROBOT.replace("${limit.lower}", "1").replace("${limit.upper}", "-1")
    (found,) = findings(tmp_path, "JNT003", robot)
    assert (place(found.span)[0], found.related) == ("arm.urdf.xacro", ())


def test_data_of_a_package_that_is_not_there(tmp_path: Path) -> None:
    """Robots around a UR, whose `ur_description` is installed elsewhere."""
    robot = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="file" default="$(find ur_description)/config/initial.yaml"/>'
        '<xacro:property name="file" default="$(arg file)"/>'
        '<xacro:macro name="arm" params="p"><link name="l${p[\'a\']}"/></xacro:macro>'
        '<xacro:arm p="${xacro.load_yaml(file)}"/></robot>'
    )
    (tmp_path / "r.urdf.xacro").write_text(robot)
    report = check(tmp_path / "r.urdf.xacro", select=["XAC001", "XAC011"])
    assert [one.code for one in report.diagnostics] == ["XAC011"]


@pytest.mark.parametrize(
    ("package", "severity"),
    [("far/other", "warning"), ("clearpath_platfrom", "error"), ("", "warning")],
)
def test_a_robot_outside_of_packages(tmp_path: Path, package: str, severity: str) -> None:
    """A Husky's `robot.urdf.xacro`, which Clearpath's generator writes from a YAML file."""
    (tmp_path / ".git").mkdir()
    add_package(tmp_path / package, package.rpartition("/")[2] or "husky")
    find = '<xacro:include filename="$(find clearpath_platform)/a.xacro"/>'
    robot = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{find}</robot>'
    path = add_file(tmp_path / "robot.urdf.xacro", robot.encode())
    (found,) = check(path, select=["XAC011"]).diagnostics
    assert found.severity.value == severity


@pytest.mark.parametrize(("package", "code"), [("absent", "XAC011"), ("p", "XAC001")])
def test_a_block_of_a_package_that_is_missing(tmp_path: Path, package: str, code: str) -> None:
    """hector_models: the calibration of a lidar is in the package of the vehicle."""
    robot = f"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:include filename="$(find {package})/pose.xacro"/>
<xacro:macro name="lidar" params="*origin"><link name="a"/></xacro:macro>
<xacro:lidar><xacro:insert_block name="pose"/></xacro:lidar></robot>"""
    add_file(add_package(tmp_path, "p") / "pose.xacro", "<robot/>")
    path = add_file(tmp_path / "r.urdf.xacro", robot)
    report = check(path, select=["XAC001", "XAC011"])
    assert {one.code for one in report.diagnostics} == {code}
