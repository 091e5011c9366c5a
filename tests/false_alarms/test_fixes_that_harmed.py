"""Fixes that were offered for robots that are right, or edited more than was wrong."""

from pathlib import Path

import pytest

from tests.gazebos import block
from tests.naming import naming
from tests.reported import reported
from urdfkit.lint.engine import check
from urdfkit.lint.fix import fix
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml

#: RotorS' hummingbird: a published tensor; cylinder and box only stand for the body between arms.
DRONE = """\
<robot name="drone">
  <link name="base_link">
    <inertial>
      <mass value="0.68"/>
      <inertia ixx="0.007" ixy="0.0" ixz="0.0" iyy="0.007" iyz="0.0" izz="0.012"/>
    </inertial>
    <visual><geometry><cylinder radius="0.1" length="0.12"/></geometry></visual>
    <collision><geometry>{collision}</geometry></collision>
  </link>
</robot>
"""

#: As Kinova's wrist, with a turned box for its mesh: iyz has the wrong sign, the rest is measured.
WRIST = """\
<robot name="arm">
  <link name="wrist">
    <inertial>
      <mass value="12"/>
      <inertia ixx="0.1003" ixy="0" ixz="0" iyy="0.0618" iyz="0.02790" izz="0.1177"/>
    </inertial>
    <collision>
      <origin rpy="0.4 0 0"/><geometry><box size="0.2 0.3 0.1"/></geometry>
    </collision>
  </link>
</robot>
"""


@pytest.mark.parametrize(
    "collision", ['<box size="0.1 0.1 0.12"/>', '<cylinder radius="0.1" length="0.12"/>']
)
def test_a_published_tensor_beside_a_placeholder_shape_stays(
    tmp_path: Path, collision: str
) -> None:
    robot = tmp_path / "drone.urdf"
    robot.write_text(DRONE.format(collision=collision))
    inertia = [one for one in check(robot).diagnostics if one.code.startswith("INE")]
    assert [one.fix for one in inertia] == [None] * len(inertia)
    assert fix(robot, unsafe=True, select=["INE006", "INE008"]).files == ()


def test_of_a_measured_tensor_the_wrong_sign_alone_is_edited(tmp_path: Path) -> None:
    robot = tmp_path / "arm.urdf"
    robot.write_text(WRIST)
    fixes = fix(robot, unsafe=True)
    assert [one.code for one in fixes.applied] == ["INE006"]
    assert fixes.files[0].after.decode() == WRIST.replace('"0.02790"', '"-0.02790"')


@pytest.mark.parametrize(("mass", "is_fixed"), [("1e-8", False), ("0.1", True)])
def test_no_tensor_follows_from_a_placeholder_mass(mass: str, is_fixed: bool) -> None:
    """SAM's propellers: 1e-8 kg and 1e-8 kg·m², of which 1e-13 would be left."""
    prop = link_xml(
        "prop",
        collision_xml('<cylinder radius="0.04" length="0.02"/>'),
        inertial_xml(mass, f"{mass} {mass} {mass}"),
    )
    joint = joint_xml("continuous", parent="hull", child="prop")
    (found,) = reported("INE006", robot_xml(link_xml("hull"), prop, joint))
    assert (found.fix is not None) is is_fixed


def test_two_elements_do_not_become_the_same_one(tmp_path: Path) -> None:
    """ETH's SMB: <center_x> and <center_y> are not both <center>."""
    robot = tmp_path / "smb.urdf"
    robot.write_text(
        '<robot name="smb"><link name="a"/><gazebo reference="a"><sensor name="s" type="camera">'
        "<camera><distortion><center_x>1</center_x><center_y>2</center_y></distortion></camera>"
        "</sensor></gazebo></robot>"
    )
    found = check(robot, select=["GAZ003"]).diagnostics
    assert [one.fix for one in found] == [None, None]


def test_no_fix_of_a_warning_reveals_an_error(tmp_path: Path) -> None:
    """BlueROV2's thrusters: <limits> is ignored; a <limit> below zero Pinocchio rejects."""
    robot = tmp_path / "rov.urdf"
    robot.write_text(
        '<robot name="rov"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
        '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
        '<limits effort="-1" velocity="-1"/></joint></robot>'
    )
    fixes = fix(robot, unsafe=True, select=["URD001"])
    assert fixes.files == ()
    assert [one.reason for one in fixes.left] == [naming("skipped", "JNT008")]


def test_a_robot_with_a_wheel_in_millimetres_is_not_raised_by_its_radius(tmp_path: Path) -> None:
    robot = tmp_path / "rover.urdf"
    robot.write_text(
        '<robot name="r"><link name="base_footprint"/><link name="base_link"><collision>'
        '<geometry><sphere radius="35"/></geometry></collision></link>'
        '<joint name="j" type="fixed"><parent link="base_footprint"/><child link="base_link"/>'
        "</joint></robot>"
    )
    (found,) = check(robot, select=["TRE008"]).diagnostics
    assert found.fix is None


def test_a_collision_does_not_follow_a_visual_in_millimetres(tmp_path: Path) -> None:
    body = "<{0}>{1}<geometry><box size='0.6 0.4 0.2'/></geometry></{0}>"
    origin = '<origin xyz="{} 0 0"/>'
    robot = tmp_path / "box.urdf"
    robot.write_text(
        '<robot name="r"><link name="a">'
        + body.format("visual", origin.format("300"))
        + body.format("collision", origin.format("0.3"))
        + "</link></robot>"
    )
    (found,) = check(robot, select=["GEO004"]).diagnostics
    assert found.fix is None


def boxes(directory: Path, mass: float, moments: str, visual: str, collision: str) -> Path:
    """A robot of one link with a diagonal tensor, and boxes of these sizes."""
    ixx, iyy, izz = moments.split()
    shape = "<{0}><geometry><box size='{1}'/></geometry></{0}>"
    robot = directory / "boxes.urdf"
    robot.write_text(
        f'<robot name="r"><link name="a"><inertial><mass value="{mass}"/><inertia ixx="{ixx}" '
        f'ixy="0" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"/></inertial>'
        + shape.format("visual", visual)
        + shape.format("collision", collision)
        + "</link></robot>"
    )
    return robot


def test_no_tensor_comes_from_a_shape_in_another_unit(tmp_path: Path) -> None:
    """A tensor that is right, beside a collision in millimetres and a visual in metres."""
    robot = boxes(tmp_path, 20, "0.3267 0.6667 0.86", "0.6 0.4 0.2", "600 400 200")
    assert fix(robot, unsafe=True, select=["INE006", "INE008"]).files == ()


def test_no_tensor_comes_from_a_shape_that_is_lighter_than_air(tmp_path: Path) -> None:
    """TurtleBot3's caster of 5 g, with its only shape in millimetres."""
    robot = tmp_path / "caster.urdf"
    robot.write_text(
        '<robot name="r"><link name="base"><inertial><mass value="0.8"/>'
        '<inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial>'
        '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>'
        '<joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint>'
        '<link name="a"><inertial><mass value="0.005"/>'
        '<inertia ixx="2e-07" ixy="0" ixz="0" iyy="5.4e-07" iyz="0" izz="4.1e-07"/></inertial>'
        '<collision><geometry><box size="30 9 20"/></geometry></collision></link></robot>'
    )
    fixes = fix(robot, unsafe=True, select=["INE006", "INE008"])
    assert [one.diagnostic.code for one in fixes.left] == ["INE006"]
    assert fixes.files == ()


@pytest.mark.parametrize(("name", "is_safe"), [("robot.urdf", True), ("robot.xacro", False)])
def test_an_empty_element_of_a_xacro_may_be_a_macro_without_its_prefix(
    tmp_path: Path, name: str, is_safe: bool
) -> None:
    """A copy of a robot whose base came by <create/>; the package of that macro is gone."""
    robot = tmp_path / name
    robot.write_text('<robot name="r"><create/><link name="a"/></robot>')
    (found,) = check(robot, select=["URD001"]).diagnostics
    assert found.fix is not None
    assert found.fix.safe == is_safe


def test_a_tensor_that_fits_the_visual_does_not_follow_a_turned_collision(tmp_path: Path) -> None:
    robot = boxes(tmp_path, 0.5, "0.000483 0.000133 0.000483", "0.04 0.1 0.04", "0.1 0.04 0.04")
    assert check(robot, select=["INE006"]).diagnostics == ()


def test_no_tensor_comes_from_one_of_two_shapes_of_different_size(tmp_path: Path) -> None:
    robot = boxes(tmp_path, 2, "0.0156 0.0156 0.0012", "0.06 0.06 0.3", "1.5 1.5 7.6")
    (found,) = check(robot, select=["INE006", "INE008"]).diagnostics
    assert found.fix is None


#: A rod on a joint, its visual turned and its collision not.
ROD = """\
<robot name="r">
  <link name="base"/>
  <joint name="j" type="{kind}">
    <parent link="base"/><child link="rod"/><axis xyz="{axis}"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <link name="rod">
    <inertial><mass value="1"/>
      <inertia ixx="0.0210" ixy="0" ixz="0" iyy="0.0210" iyz="0" izz="0.0002"/></inertial>
    <visual><origin rpy="1.5708 0 0"/><geometry>{shape}</geometry></visual>
    <collision><geometry>{shape}</geometry></collision>
  </link>
</robot>
"""
CYLINDER = '<cylinder radius="0.02" length="0.5"/>'


@pytest.mark.parametrize(
    ("kind", "axis", "shape", "title"),
    [
        ("revolute", "1 0 0", CYLINDER, None),
        ("fixed", "0 0 1", CYLINDER, None),
        ("revolute", "0 0 1", '<box size="0.036 0.036 0.5"/>', None),
        ("continuous", "0 1 0", CYLINDER, naming("give", "<origin>")),
        ("continuous", "0 0 1", CYLINDER, naming("remove", "<origin>")),
    ],
)
def test_of_a_turned_visual_and_a_collision_that_its_tensor_fits_either_may_be_wrong(
    tmp_path: Path, kind: str, axis: str, shape: str, title: str | None
) -> None:
    """A cylinder turns about its own axis; of another shape nothing shows which was turned."""
    robot = tmp_path / "rod.urdf"
    robot.write_text(ROD.format(kind=kind, axis=axis, shape=shape))
    (found,) = check(robot, select=["GEO004"]).diagnostics
    assert (found.fix and found.fix.title) == title
    if title is None:
        assert fix(robot, unsafe=True, select=["GEO004", "INE006", "INE008"]).files == ()


def test_a_robot_is_not_raised_by_the_one_wheel_that_is_too_large(tmp_path: Path) -> None:
    link = (
        '<link name="{0}"><collision><geometry><sphere radius="{1}"/></geometry></collision></link>'
        '<joint name="{0}_joint" type="continuous"><origin xyz="0 {2} 0"/>'
        '<parent link="base_link"/><child link="{0}"/><axis xyz="0 1 0"/></joint>'
    )
    robot = tmp_path / "rover.urdf"
    for radius, is_fixable in (("0.05", True), ("0.08", False), ("0.5", False)):
        robot.write_text(
            '<robot name="r"><link name="base_footprint"/><link name="base_link"/>'
            '<joint name="j" type="fixed"><parent link="base_footprint"/>'
            '<child link="base_link"/></joint>'
            + link.format("left", "0.05", "0.1")
            + link.format("right", radius, "-0.1")
            + "</robot>"
        )
        (found,) = check(robot, select=["TRE008"]).diagnostics
        assert (found.fix is not None) == is_fixable


def test_no_reference_is_changed_where_the_name_of_its_link_is_misspelt(tmp_path: Path) -> None:
    """``naame`` hides camera_link, and its references are not those of camera_lens."""
    text = (
        '<robot name="r"><link name="base"/><link name="camera_lens"/><link {}="camera_lnk"/>'
        '<joint name="a" type="fixed"><parent link="base"/><child link="camera_lnk"/></joint>'
        '<joint name="b" type="fixed"><parent link="camera_lnk"/><child link="camera_lens"/>'
        "</joint></robot>"
    )
    robot = tmp_path / "camera.urdf"
    robot.write_text(text.format("naame"))
    fixes = fix(robot, unsafe=True)
    assert [one.code for one in fixes.applied] == ["URD003"]
    assert fixes.files[0].after.decode() == text.format("name")


def test_a_moment_becomes_that_of_the_shape_that_the_others_are_of(tmp_path: Path) -> None:
    """A tenth of 0.05 is possible, and ten times too much."""
    moments = "0.00602 0.00602 {}"
    robot = boxes(tmp_path, 1.2, moments.format("0.05"), "0.05 0.05 0.24", "0.05 0.05 0.24")
    fixes = fix(robot, unsafe=True, select=["INE003"])
    assert [one.fix.title for one in fixes.applied if one.fix] == ['write izz="0.0005"']


#: gz_ros2_control's tricycle: a steering link of 5 g bears the front wheel.
STEERED = """\
<robot name="tricycle">
  <link name="chassis"><inertial><mass value="40"/>
    <inertia ixx="3" ixy="0" ixz="0" iyy="4" iyz="0" izz="6"/></inertial></link>
  <link name="steering">
    <visual><geometry><box size="0.01 0.01 0.01"/></geometry></visual>
    <inertial>
      <mass value="0.005"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <link name="wheel"><inertial><mass value="{mass}"/>
    <inertia ixx="0.3" ixy="0" ixz="0" iyy="0.3" iyz="0" izz="0.6"/></inertial></link>
  <joint name="steer" type="continuous"><parent link="chassis"/><child link="steering"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="roll" type="continuous"><parent link="steering"/><child link="wheel"/>
    <axis xyz="0 1 0"/></joint>
</robot>
"""


@pytest.mark.parametrize(("mass", "is_offered"), [("15", False), ("0.05", True)])
def test_the_moments_of_a_light_link_that_carries_a_heavy_one_stay(
    tmp_path: Path, mass: str, is_offered: bool
) -> None:
    robot = tmp_path / "tricycle.urdf"
    robot.write_text(STEERED.format(mass=mass))
    found = [one for one in check(robot, select=["INE006"]).diagnostics if "steer" in one.message]
    assert [one.fix is not None for one in found] == [is_offered]
    assert is_offered or found[0].help == naming("carry", "15 kg")


HINGE = naming("hinge")


@pytest.mark.parametrize(
    ("own", "help"),
    [
        ("<material>Gazebo/Red</material><mu1>1</mu1>", naming("link", "joint")),
        ("<mu1>1</mu1>", HINGE),
        ('<sensor name="a" type="imu"/>', HINGE),
    ],
)
def test_a_link_that_has_the_properties_is_not_suggested(own: str, help: str) -> None:
    """cooperative_transportation_4ws: v1_front_right_joint_1, beside v1_front_right_hinge_1."""
    other = block('<material>Gazebo/Blue</material><sensor name="b" type="imu"/>', "hinges")
    (found,) = reported("GAZ001", '<link name="hinge"/>' + block(own, "hinge") + other)
    assert found.help == help
    assert (found.fix is None) is (help is not HINGE)


HAND = """\
<robot name="hand" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="inertial" params="mass"><inertial>
    <mass value="${{mass}}"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial></xacro:macro>
  <link name="base"/>
  <link name="tip">
    <visual><geometry><box size="0.01 0.01 0.01"/></geometry></visual>
    {}
  </link>
  <joint name="roll" type="revolute">
    <parent link="base"/><child link="tip"/><axis xyz="1 0 0"/>
    <limit lower="-1" upper="1" effort="{}" velocity="3.14"/>
  </joint>
</robot>
"""
TIP = """<inertial><mass value="0.001"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial>"""


@pytest.mark.parametrize(("effort", "is_fixed"), [("54", False), ("0.1", True)])
def test_a_joint_with_far_too_much_effort_for_the_tensor_of_the_shape(
    tmp_path: Path, effort: str, is_fixed: bool
) -> None:
    """mogi_arm's virtual links of 1 g: with the tensor of a grain, 54 N·m throw them."""
    robot = tmp_path / "hand.urdf.xacro"
    robot.write_text(HAND.format(TIP, effort))
    (found,) = check(robot, select=["INE006"]).diagnostics
    assert (found.fix is not None) is is_fixed
    assert ("'roll' has too" in found.help) is not is_fixed


@pytest.mark.parametrize(("effort", "is_fixed"), [("54", False), ("0.1", True)])
def test_a_macro_that_gives_such_a_link_its_tensor(
    tmp_path: Path, effort: str, is_fixed: bool
) -> None:
    body = '<link name="body"><visual><geometry><sphere radius="0.1"/></geometry></visual>'
    other = f'{body}<xacro:inertial mass="1"/></link><joint name="f" type="fixed">'
    tip = HAND.format('<xacro:inertial mass="0.001"/>', effort)
    robot = tmp_path / "hand.urdf.xacro"
    robot.write_text(
        tip.replace("<joint", other + '<parent link="base"/><child link="body"/></joint><joint')
    )
    (found,) = check(robot, select=["XAC014"]).diagnostics
    assert (found.fix is not None) is is_fixed
