"""The part of a robot that needs no package that is not found."""

from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.lint import engine
from urdfkit.robot.samples import joint_xml, link_xml, xacro_xml
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import expand

INCLUDE = '<xacro:include filename="$(find camera_description)/camera.xacro"/>'
CAMERA = f'{INCLUDE}<xacro:camera parent="base" name="front"/>'
BASE = '<link name="base"><inertial><mass value="-1"/></inertial></link>'
#: A frame of the camera, to which the robot adds another.
OPTICAL = """<link name="view"/>
<joint name="view_joint" type="fixed"><parent link="front_link"/><child link="view"/></joint>
<gazebo reference="front_link"><mu1>1</mu1></gazebo>"""


def part(*parts: str) -> list[str] | None:
    """The tags below the root of the part; None if there is none."""
    xacro = expand(Source("r.xacro", xacro_xml(*parts).encode()), Resolver(environment={}))
    assert xacro.document is None
    document = xacro.without_packages
    return None if document is None else [element.tag for element in document.root.children]


def codes(*parts: str) -> list[str]:
    source = Source("r.xacro", xacro_xml(*parts).encode())
    report = engine.check(source, select=["XAC", "INE001", "REF001", "TRE002", "GAZ001"])
    assert report.crashed == ()
    return [one.code for one in report.diagnostics]


def test_the_rest_of_the_robot_is_checked() -> None:
    assert codes(BASE, CAMERA) == ["INE001", "XAC011"]


def test_what_the_package_may_define_is_not_missing() -> None:
    assert codes(BASE.replace("-1", "1"), CAMERA, OPTICAL) == ["XAC011"]


@pytest.mark.parametrize(
    ("more", "what"),
    [("", "only a part of the robot checked: "), ("${1/0}", "robot not checked: ")],
)
def test_a_part_is_reported_whatever_is_selected(more: str, what: str) -> None:
    source = Source("r.xacro", xacro_xml(BASE, CAMERA, more).encode())
    (found,) = engine.check(source, select=["CFG", "TRE"]).diagnostics
    assert found.code == "CFG003"
    assert found.message.startswith(what)


MESH = '<mesh filename="$(find gone)/a.stl"/>'
PLUGIN = (
    '<gazebo><plugin name="p" filename="p.so"><parameters>$(find gone)/c.yaml</parameters>'
    "</plugin></gazebo>"
)


@pytest.mark.parametrize(
    ("text", "tags"),
    [
        (BASE + INCLUDE, ["link"]),
        (f'<link name="a"><visual><geometry>{MESH}</geometry></visual></link>', ["link"]),
        (BASE + PLUGIN, ["link"]),
        (INCLUDE, None),
        (BASE + INCLUDE + "<xacro:own/>" + '<link name="${1/0}"/>', None),
        (BASE + '<xacro:property name="z" value="$(find gone)"/><link name="${z}"/>', None),
    ],
)
def test_parts(text: str, tags: list[str] | None) -> None:
    assert part(text) == tags


def test_the_visual_of_a_mesh_in_the_package_is_left_out() -> None:
    text = xacro_xml(f'<link name="a"><visual><geometry>{MESH}</geometry></visual></link>')
    xacro = expand(Source("r.xacro", text.encode()), Resolver(environment={}))
    assert xacro.without_packages is not None
    assert [element.tag for element in xacro.without_packages.root.walk()] == ["robot", "link"]


def test_a_part_of_a_robot_without_a_name_has_none() -> None:
    text = xacro_xml(BASE, INCLUDE).replace(' name="r"', "", 1)
    xacro = expand(Source("r.xacro", text.encode()), Resolver(environment={}))
    assert xacro.without_packages is None


def test_a_launch_file_requires_the_whole_robot(tmp_path: Path) -> None:
    """Its controllers may be for joints of the package."""
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "r.urdf.xacro").write_text(xacro_xml(BASE.replace("-1", "1"), CAMERA))
    (tmp_path / "c.yaml").write_text(
        "c:\n  ros__parameters:\n    joints: [camera_pan]\n"
        "controller_manager:\n  ros__parameters:\n    c:\n"
        "      type: joint_trajectory_controller/JointTrajectoryController\n"
    )
    (tmp_path / "r.launch").write_text(
        '<launch><param name="robot_description" command="xacro $(find arm)/r.urdf.xacro"/>'
        '<rosparam file="$(find arm)/c.yaml"/></launch>'
    )
    found = check(tmp_path, select=["RCT001", "REF001", "TRE001", "LAU013", "XAC011"]).diagnostics
    assert [one.code for one in found] == ["XAC011"]


@pytest.mark.parametrize(("name", "found"), [("basse", ["REF001"]), ("camera", []), ("base2", [])])
def test_a_typo_is_not_in_the_package(name: str, found: list[str]) -> None:
    arm = link_xml("arm") + joint_xml("fixed", name="j", parent=name, child="arm")
    sound = BASE.replace("-1", "1")
    assert [code for code in codes(sound, CAMERA, arm) if code != "XAC011"] == found


DRIVER = (
    '<ros2_control name="c" type="system"><hardware><param name="p">$(find gone)/c.yaml</param>'
    "</hardware></ros2_control>"
)


@pytest.mark.parametrize(
    ("lost", "found"),
    [
        (PLUGIN, ["GAZ001"]),
        (f'<link name="a"><visual><geometry>{MESH}</geometry></visual></link>', ["GAZ001"]),
        (DRIVER, []),
        (INCLUDE, []),
        ('<xacro:property name="z" value="$(find gone)"/><xacro:include filename="${z}/a"/>', []),
    ],
)
def test_shapes_and_plugins_define_no_link(lost: str, found: list[str]) -> None:
    link = BASE.replace("-1", "1") + '<gazebo reference="camera"><mu1>1</mu1></gazebo>'
    assert [code for code in codes(link, lost) if code == "GAZ001"] == found
