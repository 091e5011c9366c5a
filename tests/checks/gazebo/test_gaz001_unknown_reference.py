import pytest

from tests.gazebos import BASE, block, child
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.diagnostic import Severity


def test_the_lost_tags_are_named() -> None:
    text = BASE + block("<mu1>1</mu1><mu2>1</mu2><mu1>2</mu1>", "baase")
    assert messages("GAZ001", text) == [naming("unknown", "baase", "Gazebo", "<mu1>", "<mu2>")]
    assert places("GAZ001", text) == [(3, "baase")]
    assert [one.help for one in reported("GAZ001", text)] == [naming("base")]


@pytest.mark.parametrize("reference", ["base", "arm", "arm_joint", ""])
def test_links_joints_and_the_model_are_known(reference: str) -> None:
    assert reported("GAZ001", BASE + child("arm") + block("<mu1>1</mu1>", reference)) == []


def test_nothing_is_lost_of_an_empty_block() -> None:
    assert reported("GAZ001", BASE + '<gazebo reference="other"/>') == []


def test_what_nothing_is_like_has_no_hint() -> None:
    (found,) = reported("GAZ001", BASE + block("<mu1>1</mu1>", "turret"))
    assert found.fix is None
    assert "did you mean" not in found.help


@pytest.mark.parametrize(
    ("reference", "severity"),
    [("camera_frame", Severity.WARNING), ("camera_optical_frame", Severity.ERROR)],
)
def test_a_link_that_an_argument_switches_off(reference: str, severity: Severity) -> None:
    text = xacro_xml(
        '<xacro:arg name="prefix" default=""/>',
        '<xacro:arg name="vision" default="false"/>',
        '<link name="base"/>',
        '<xacro:if value="$(arg vision)"><link name="$(arg prefix)camera_frame"/></xacro:if>',
        f'<gazebo reference="{reference}"><sensor name="c" type="camera"/></gazebo>',
    )
    (found,) = reported("GAZ001", text.encode(), "robot.xacro")
    assert found.severity is severity


def test_a_link_of_a_macro_that_is_not_called() -> None:
    text = xacro_xml(
        '<xacro:macro name="tool" params=""><link name="tip"/></xacro:macro>',
        '<link name="base"/>',
        block("<mu1>1</mu1>", "tip"),
    )
    (found,) = reported("GAZ001", text.encode(), "robot.xacro")
    assert found.help == "call macro 'tool', which defines it"


def test_a_frame_is_not_the_link_that_it_is_on() -> None:
    """PAL's TIAGo has a block for a 'base_imu_link' that this variant lacks."""
    block = '<gazebo reference="base_{}"><sensor name="s" type="imu"/></gazebo>'
    (found,) = reported("GAZ001", '<link name="base_link"/>' + block.format("imu_link"))
    assert found.help == naming("robot")
    (found,) = reported("GAZ001", '<link name="base_link"/>' + block.format("lnk"))
    assert found.help == naming("base_link")


@pytest.mark.parametrize(
    ("tag", "reference", "severity"),
    [
        ("<material>Gazebo/Black</material>", "plate_2", "warning"),
        ("<mu1>1</mu1>", "baase", "error"),
        ("<material>Gazebo/Black</material>", "baase", "warning"),
        ('<sensor name="imu" type="imu"/>', "plate_2", "error"),
    ],
)
def test_properties_of_a_link_of_another_robot(tag: str, reference: str, severity: str) -> None:
    """Jupiter's `jupiter2_gazebo.xacro`, which holds the plates of the larger robot."""
    (found,) = reported("GAZ001", BASE + block(tag, reference))
    assert found.severity.value == severity


@pytest.mark.parametrize("name", ["${ns}/camera", "robot1/camera"])
def test_a_prefix_is_written_as_in_the_name_of_the_link(name: str) -> None:
    """A robot of several: its prefix is an argument."""
    text = f"""<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">
<xacro:property name="ns" value="robot1"/><link name="base"/><link name="{name}"/>
<joint name="j" type="fixed"><parent link="base"/><child link="{name}"/></joint>
<gazebo reference="camera"><sensor name="s" type="camera"/></gazebo></robot>"""
    (found,) = reported("GAZ001", text.encode(), "robot.xacro")
    assert found.help == naming("robot1/camera") if name == "robot1/camera" else name in found.help
    assert bool(found.fix) is (name == "robot1/camera")


@pytest.mark.parametrize(("value", "count"), [("none", 0), ("big", 1)])
def test_a_base_that_an_argument_chooses(value: str, count: int) -> None:
    """A kit for several bases: without one, all links of the base are missing."""
    text = f"""<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">
<xacro:arg name="base" default="{value}"/><xacro:property name="base" value="$(arg base)"/>
<xacro:if value="${{base == 'big'}}"><link name="box"/></xacro:if><link name="imu"/>
<joint name="j" type="fixed"><parent link="box"/><child link="imu"/></joint>
<gazebo reference="base_link"><sensor name="s" type="imu"/></gazebo></robot>"""
    assert len(reported("GAZ001", text.encode(), "robot.xacro")) == count
