"""Robots of students and of competitions that the rules had not seen."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import COSTMAP, messages, reported_of
from tests.checks.worlds.started import INCLUDE
from tests.checks.worlds.started import messages as of_world
from tests.driving import reported as driven
from tests.gazebos import BASE, block, sensor, wheel
from tests.launched import reported as of_launch
from tests.massive import inertial, joint, link, part, shape
from tests.naming import naming
from tests.reported import reported
from tests.workspaces import add_file, add_package
from tests.xacros import xacro
from urdfkit import check
from urdfkit.text.diagnostic import Severity

_SIZE = "robot_base_frame: base, width: 0.5"


def test_a_costmap_whose_parameters_are_not_read_stops_at_none(tmp_path: Path) -> None:
    """A robot for Eurobot: ``local_costmap`` is not written twice, and its width is no integer."""
    unread = f"local_costmap:\n  ros__parameters: {{{_SIZE}}}\n"
    (found,) = messages("LAU024", tmp_path, unread)
    assert found == naming("local_costmap", "local_costmap/local_costmap")
    assert messages("LAU045", tmp_path, unread) == []
    (one,) = reported_of("LAU045", tmp_path, COSTMAP.format(f"{{{_SIZE}}}"))
    assert (one.message, one.help) == (naming("local_costmap", "integer", "0.5"), naming("1"))


def test_parameters_of_a_node_of_another_name_stop_none(tmp_path: Path) -> None:
    node = 'package="robot_localization", executable="ekf_node", name="ekf", '
    node += 'parameters=["../a.yaml"]'
    yaml = "{}: {{ros__parameters: {{odom0: odom, odom0_config: [true]}}}}\n"
    for name, count in (("ekf_node", 0), ("ekf", 1)):
        found = messages("LAU025", tmp_path / name, yaml.format(name), node, "")
        assert len(found) == count


def test_parameters_with_names_of_humble_and_one_of_jazzy(tmp_path: Path) -> None:
    """The same robot, whose planner has the slash of Humble."""
    planner = 'planner_server: {{ros__parameters: {{a: {{plugin: "nav2_smac_planner{}A"}}}}}}\n'
    libraries = "bt_navigator: {ros__parameters: {plugin_lib_names: [nav2_wait_action_bt_node]}}\n"
    stamped = "controller_server: {ros__parameters: {enable_stamped_cmd_vel: false}}\n"
    for sign, count in (("/", 0), ("::", 1)):
        yaml = planner.format(sign) + libraries + stamped
        found = messages("LAU024", tmp_path / str(count), yaml)
        assert ["Jazzy" in one for one in found] == [True] * count


@pytest.mark.parametrize(("height", "count"), [("4.0", 0), ("0.4", 1)])
def test_a_slab_above_the_robot_is_no_floor(tmp_path: Path, height: str, count: int) -> None:
    """A field for Robocon: what a lidar that looks up sees."""
    slab = f"""<model name="seen"><static>true</static><pose>0 0 {height} 0 0 0</pose>
<link name="l"><collision name="c"><geometry><box><size>24 18 0.05</size></box></geometry>
</collision></link></model><include><uri>model://field</uri></include>"""
    launch = INCLUDE + (
        'Node(package="ros_gz_sim", executable="create", '
        'arguments=["-topic", "robot_description", "-z", "0.05"])\n'
    )
    ball, moments = '<sphere radius="0.1"/>', (0.004, 0.004, 0.004)
    wheels = "".join(
        part(name, 1, moments, ball) + joint("base", name, "continuous", xyz)
        for name, xyz in (("left", "0 0.2 0"), ("right", "0 -0.2 0"), ("rear", "-0.3 0 0"))
    )
    found = of_world(tmp_path, "WLD003", robot=wheels, launch=launch, world=slab)
    assert ["below the ground" in one for one in found] == [True] * count


def test_a_laser_is_not_the_base() -> None:
    """The CAT vehicle: the block is for a link that the robot does not have."""
    (found,) = reported(
        "GAZ001", BASE.replace('"base"', '"base_link"') + block("<mu1>1</mu1>", "laser_link")
    )
    assert (found.severity, found.fix) == (Severity.WARNING, None)
    assert "base_link" not in found.help


def test_a_ball_does_not_have_half_the_moment_about_one_axis() -> None:
    """A tenth of izz would be possible, but not for the sphere that the link is."""
    moments = (1e-6, 1e-6, 5e-6)
    (found,) = reported("INE003", part("ball", 1e-5, moments, '<sphere radius="0.7"/>'))
    assert "ten times" not in found.help
    (found,) = reported("INE003", link("arm", inertial(1, moments)))
    assert "ten times" in found.help


def test_four_times_the_size_is_no_unit() -> None:
    """An arm whose macros get 4 * the lengths: 16 times the moments, not those in lb·ft²."""
    moments = tuple(16 * moment for moment in (0.00433, 0.00433, 0.00833))
    (found,) = reported("INE006", part("base", 5, moments, '<box size="0.1 0.1 0.02"/>'))
    assert "lb" not in found.help


@pytest.mark.parametrize(("xyz", "is_collision"), [("0 0 0.3", True), ("0 0 0.2", False)])
def test_a_collision_that_repeats_the_origin_of_its_joint(xyz: str, is_collision: bool) -> None:
    """A lidar whose macro gives ``xyz`` to the joint, the collision and the inertia."""
    can = '<cylinder radius="0.05" length="0.04"/>'
    collision, mass = shape("collision", can, "0 0 0.3"), inertial(1, (1e-3,) * 3, "0 0 0.3")
    lidar = link("lidar", shape("visual", can), collision, mass)
    (found,) = reported("GEO004", link("base") + joint("base", "lidar", xyz=xyz) + lidar)
    assert found.help == naming("the collision the <origin> of the visual") or not is_collision
    assert (found.span.text.startswith("<collision")) is is_collision


def test_the_rollers_on_both_sides_of_each_wheel() -> None:
    """Omni wheels: the counterpart of ``left_right_roller`` is ``left_left_roller``."""
    rows = [("right", -1, 0.5), ("left", 1, 0.6)]
    robot = link("base")
    for hub, y in (("left", 0.1), ("right", -0.1)):
        robot += link(hub) + joint("base", hub, "continuous", f"0 {y} 0")
        for side, sign, x in rows:
            name = f"{hub}_{side}_roller"
            robot += link(name) + joint(hub, name, "continuous", f"{x} {0.009 * sign} 0")
    assert reported("JNT025", robot) == []


_SPAWNER = '<node name="s" pkg="controller_manager" type="spawner" args="{}"/>'
_LOAD = '<rosparam file="$(find arm)/c.yaml"/>'


def test_a_key_of_a_controller_with_a_namespace(tmp_path: Path) -> None:
    """An underwater robot of ROS 1: ``camera/controller`` is one key of the file."""
    yaml = "camera/tilt:\n  type: effort_controllers/JointPositionController\n"
    for name, count in (("camera/tilt", 0), ("camera/tlit", 1)):
        text = _LOAD + _SPAWNER.format(name)
        found = of_launch(tmp_path / "arm", "LAU013", "a.launch", text, {"c.yaml": yaml})
        assert len(found) == count


def test_controllers_in_the_form_of_ros_2_that_ros_1_loads(tmp_path: Path) -> None:
    """An omnidirectional robot: its class is no mistake, but ROS 1 does not find it."""
    controller = "wheel: {type: velocity_controllers/JointVelocityController, joint: left_joint}"
    files = {
        "r.urdf": f'<robot name="r">{BASE}{wheel("left", 0.1)}</robot>',
        "c.yaml": f"controller_manager:\n  ros__parameters:\n    {controller}\n",
    }
    robot = '<param name="robot_description" textfile="$(find arm)/r.urdf"/>'
    of_launch(tmp_path / "arm", "LAU013", "a.launch", robot + _LOAD, files)
    found = check(tmp_path / "arm", select=["RCT026", "RCT034"]).diagnostics
    assert [(one.code, one.span.text) for one in found] == [("RCT026", "ros__parameters")]


def test_a_copy_of_a_driver_may_be_reliable(tmp_path: Path) -> None:
    """A driver in the workspace that publishes on another topic, for RViz that shows /scan."""
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/LaserScan\n"
        "    Topic: {Reliability Policy: Reliable, Value: /scan}\n"
    )
    driver = "ydlidar_ros2_driver"
    text = (
        "from launch_ros.actions import Node\n"
        f"nodes = [Node(package='{driver}', executable='{driver}_node'), Node(package='rviz2', "
        "executable='rviz2', arguments=['-d', get_package_share_directory('arm') + '/a.rviz'])]\n"
    )
    add_package(tmp_path / "src" / "arm", "arm")
    for count in (1, 0):
        files = {"a.rviz": rviz}
        found = of_launch(tmp_path / "src" / "arm", "LAU027", "a.launch.py", text, files)
        assert ["best effort" in one.message for one in found] == [True] * count
        add_package(tmp_path / "src" / driver, driver)


def test_a_text_is_no_block_of_a_sensor() -> None:
    """``<lidarName>``, which is that of a topic."""
    named = "<lidarName>front</lidarName><alwaysOn>1</alwaysOn>"
    first, second = reported("GAZ003", BASE + sensor("gpu_lidar", named))
    assert ("did you mean" in first.message, "always_on" in second.message) == (False, True)


def test_the_wheels_are_lower_than_the_chassis(tmp_path: Path) -> None:
    """A scooter whose deck is 25 mm above the ground."""
    launch = INCLUDE + (
        'Node(package="ros_gz_sim", executable="create", '
        'arguments=["-topic", "robot_description"])\n'
    )
    ball, moments = '<sphere radius="0.2"/>', (0.016, 0.016, 0.016)
    deck = link("deck", shape("collision", '<box size="1.2 0.3 0.39"/>'))
    robot = deck + joint("base", "deck")
    robot += "".join(
        part(name, 1, moments, ball) + joint("base", name, "continuous", xyz)
        for name, xyz in (("left", "0.5 0.3 0"), ("right", "0.5 -0.3 0"), ("rear", "-0.7 0 0"))
    )
    plane = """<model name="floor"><static>true</static><link name="l"><collision name="c">
<geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>"""
    (found,) = of_world(tmp_path, "WLD003", robot=robot, launch=launch, world=plane)
    assert found == naming("0 m", "left", "0.2 m", "below")


def test_hyphens_in_a_comment_of_a_world(tmp_path: Path) -> None:
    """A plan of the rooms, +----+, as libsdformat 12 reads it."""
    world = "<!-- +----+--+ -->\n<gravity>0 0 9.8</gravity>"
    (found,) = of_world(tmp_path, "WLD002", launch=INCLUDE, world=world)
    assert "gravity" in found


@pytest.mark.parametrize(
    ("rgba", "suggested"), [("0.278 0.255 12.95 1", ""), ("71 65 26 1", "0.278 0.255 0.102 1")]
)
def test_a_colour_of_which_one_formula_is_wrong(rgba: str, suggested: str) -> None:
    """``${71/255} ${65/255} ${26/2} 1`` is not 0.001 0.001 0.05."""
    robot = f'<material name="brass"><color rgba="{rgba}"/></material>' + link("base")
    (found,) = reported("GEO007", robot)
    assert (suggested in found.help, bool(found.fix)) == (True, bool(suggested))


def test_the_noise_of_each_axis_of_an_imu() -> None:
    noise = "<linear_acceleration><noise><mean>0</mean></noise></linear_acceleration>"
    (found,) = reported("GAZ003", BASE + sensor("imu", f"<imu>{noise}</imu>"))
    assert found.help == naming("<x>", "<y>", "<z>")


def test_a_file_as_of_ros_1_that_a_plugin_of_ros_2_names(tmp_path: Path) -> None:
    """The types are not those of ROS 1, whose parameters have other names."""
    yaml = "robot:\n  drive:\n    type: diff_drive_controller/DiffDriveController\n"
    assert driven(tmp_path, "RCT034", yaml) == []
    (found,) = driven(tmp_path, "RCT026", yaml)
    assert (found.span.text, found.message) == ("robot", naming("ROS 2", "ros__parameters"))


def test_controllers_of_joints_whose_macro_is_not_called(tmp_path: Path) -> None:
    """A robot with two arms: XAC002 says that ``<m_joint>`` lacks the prefix."""
    macro = '<xacro:macro name="m_joint" params="name"/>'
    names = [f"arm_joint{number}" for number in range(1, 6)]
    yaml = "".join(
        f"c_{name}:\n  type: effort_controllers/JointPositionController\n  joint: {name}\n"
        for name in names
    )
    text = '<param name="robot_description" command="xacro $(find arm)/r.xacro"/>' + _LOAD
    for tag, count in (("m_joint", 0), ("other", 1)):
        calls = "".join(f'<{tag} name="{name}"/>' for name in names)
        files = {"r.xacro": xacro(macro + BASE + wheel("left", 0.1) + calls), "c.yaml": yaml}
        of_launch(tmp_path / "arm", "LAU013", "a.launch", text, files)
        found = check(tmp_path / "arm", select=["RCT001"]).diagnostics
        assert ["none of the" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("plugin", "tag", "text", "severity", "help"),
    [
        ("ros1", "odometrySource", "WORLD", Severity.WARNING, "one of these words"),
        ("ros1", "odometrySource", "ENCODER", Severity.ERROR, "one of these words"),
        ("ros2", "odometry_source", "world", Severity.ERROR, "write 1"),
        ("ros2", "odometry_source", "gps", Severity.ERROR, "write a number"),
    ],
)
def test_the_source_of_odometry(
    plugin: str, tag: str, text: str, severity: Severity, help: str
) -> None:
    """A word that is unknown to ROS 1 stays at world; ROS 2 reads a number."""
    names = ("leftJoint", "rightJoint") if plugin == "ros1" else ("left_joint", "right_joint")
    tags = "".join(
        f"<{name}>{side}_joint</{name}>"
        for name, side in zip(names, ("left", "right"), strict=True)
    )
    robot = BASE + wheel("left", 0.1) + wheel("right", -0.1)
    tags += f"<{tag}>{text}</{tag}>"
    robot += block(f'<plugin name="d" filename="libgazebo_ros_diff_drive.so">{tags}</plugin>', "")
    (found,) = reported("GAZ004", robot)
    assert (found.severity, help in found.help) == (severity, True)


def test_the_mesh_of_another_link_is_not_that_of_a_forearm(tmp_path: Path) -> None:
    robot = "".join(
        link(name, shape("visual", f'<mesh filename="{name}.stl"/>'))
        for name in ("l_arm_pitch", "l_forearm_pitch")
    )
    add_file(tmp_path / "l_arm_pitch.stl")
    (found,) = reported("MSH001", robot, str(tmp_path / "robot.urdf"))
    assert "l_arm_pitch" not in found.help
    add_file(tmp_path / "l_forearm.stl")
    (found,) = reported("MSH001", robot, str(tmp_path / "robot.urdf"))
    assert found.help == naming("l_forearm.stl")


@pytest.mark.parametrize(("axis", "count"), [("0 1 0", 0), ("0 0 1", 1)])
def test_a_gripper_does_not_stand_on_its_fingers(axis: str, count: int) -> None:
    """But a robot on jacks does."""
    box, moments = '<box size="0.08 0.04 0.06"/>', (1e-3, 1e-3, 1e-3)
    robot = link("base", inertial(3, moments), shape("collision", '<box size="0.08 0.04 0.04"/>'))
    for name, y in (("left", 0.03), ("right", -0.03)):
        slide = joint("base", name, "prismatic", f"0.1 {y} 0")
        robot += part(name, 0.1, moments, box)
        robot += slide.replace("<limit", f'<axis xyz="{axis}"/><limit')
    assert len(reported("DYN004", robot)) == count


@pytest.mark.parametrize(("last", "count"), [("0.3 -0.35 0", 0), ("0.4 -0.35 0", 1)])
def test_bumpers_that_are_numbered_round_the_robot(last: str, count: int) -> None:
    """The first of the left is in front, and that of the right behind: all have mirror images."""
    places = {
        "left_bumper1": "0.3 0.35 0",
        "left_bumper2": "-0.3 0.35 0",
        "right_bumper1": "-0.3 -0.35 0",
        "right_bumper2": last,
    }
    robot = link("base") + "".join(
        link(name) + joint("base", name, xyz=xyz) for name, xyz in places.items()
    )
    assert len(reported("JNT025", robot)) == count


@pytest.mark.parametrize(("interface", "reader"), [("", "Drake"), ("Effort", "ignored")])
def test_a_transmission_in_the_form_of_drake(interface: str, reader: str) -> None:
    """The arms of a humanoid, in the directory `drake` of a package of ROS 1."""
    inside = f"<hardwareInterface>{interface}</hardwareInterface>" * bool(interface)
    robot = (
        BASE
        + wheel("left", 0.1)
        + f"""<transmission type="SimpleTransmission">
<joint name="left_joint">{inside}</joint><actuator name="left_motor"/></transmission>"""
    )
    (found,) = reported("RCT024", robot, targets=("ros1",))
    severity = Severity.ERROR if interface else Severity.WARNING
    assert (found.severity, reader in found.message) == (severity, True)


@pytest.mark.parametrize(("second", "count"), [("second", 0), ("", 1)])
def test_two_arms_that_face_each_other(second: str, count: int) -> None:
    """Of two equal chains on one base, one may begin 1 m away; a single chain does not."""
    robot = link("base", shape("visual", '<box size="0.1 0.1 0.1"/>'))
    for arm, place in ((second, "0 0 0.1"), ("arm", "1 0 0.1")):
        parent = "base"
        for number in range(4 if arm else 0):
            name = f"{arm}_{'abcd'[number]}"
            robot += link(name, shape("visual", '<box size="0.05 0.05 0.1"/>'))
            robot += joint(parent, name, "revolute", "0 0 0.1" if number else place)
            parent = name
    assert len(reported("JNT037", robot)) == count


@pytest.mark.parametrize(("width", "count"), [("0.05", 0), ("0.03", 1)])
def test_boards_that_have_no_place_side_by_side(width: str, count: int) -> None:
    """Two motor drivers on the diagonal: mirror images would overlap."""
    robot = link("base") + "".join(
        link(name, shape("visual", f'<box size="0.05 {width} 0.02"/>'))
        + joint("base", name, xyz=xyz)
        for name, xyz in (("bts_left", "0.03 0.02 0"), ("bts_right", "-0.03 -0.02 0"))
    )
    assert len(reported("JNT025", robot)) == count


@pytest.mark.parametrize(("height", "verb"), [(0.145, "lower"), (0.05, "raise")])
def test_a_robot_above_or_below_its_footprint(height: float, verb: str) -> None:
    robot = link("base_footprint") + part("body", 1, (0.01, 0.01, 0.01), '<sphere radius="0.1"/>')
    (found,) = reported("TRE008", robot + joint("base_footprint", "body", xyz=f"0 0 {height}"))
    assert found.help.startswith(f"{verb} the robot")
    assert found.fix is not None
    assert found.fix.title.startswith(f"{verb} the robot by 0.0")


def test_the_mesh_of_another_series(tmp_path: Path) -> None:
    """The wheels of the rover `mega` are not those of `max`."""
    add_file(tmp_path / "mega_wheels.dae")
    robot = link("base", shape("visual", '<mesh filename="max_wheels.dae"/>'))
    (found,) = reported("MSH001", robot, str(tmp_path / "robot.urdf"))
    assert "mega" not in found.help


def test_a_missing_mesh_of_a_package_that_xacro_finds(tmp_path: Path) -> None:
    """All computers find the package, so that package:// is no remedy."""
    package = add_package(tmp_path / "rover", "rover")
    mesh = '<mesh filename="file://$(find rover)/meshes/max_wheels.dae"/>'
    file = add_file(package / "urdf" / "max.xacro", xacro(link("base", shape("visual", mesh))))
    (found,) = check(file, select=["MSH001"]).diagnostics
    assert "package://" not in found.help


def test_a_class_of_fortress_keeps_its_namespace(tmp_path: Path) -> None:
    plugin = '<plugin filename="ignition-gazebo-imu-system" name="ignition::gazebo::systems::IMU"/>'
    (found,) = of_world(tmp_path, "WLD005", launch=INCLUDE, world=plugin)
    assert found.endswith("only ignition::gazebo::systems::Imu")


def test_uses_of_a_property_that_xacro_does_not_allow() -> None:
    """An old file of UR: the name of the property is the one error."""
    text = xacro('<xacro:property name="__k" value="${dict(a=1)}"/>' + link("b", "${__k['a']}"))
    assert reported("XAC009", text, "robot.xacro") == []
    (found,) = reported("XAC001", text, "robot.xacro")
    assert "rename the property" in found.help
    (unsafe,) = reported("XAC009", text.replace("__k['a']", "__import__('os')"), "robot.xacro")
    assert "__import__" in unsafe.message


@pytest.mark.parametrize(("height", "count"), [("0.2", 0), ("0.19", 1)])
def test_a_lidar_in_the_plane_of_the_deck(height: str, count: int) -> None:
    """Its beams run along the upper face of the chassis, and end there or not."""
    deck = shape("collision", '<box size="1 0.6 0.4"/>')
    robot = link("deck", deck) + link("base") + joint("deck", "base", xyz=f"0.4 0 {height}")
    lidar = "<ray><scan><horizontal><samples>360</samples><min_angle>-3.14</min_angle>"
    lidar += "<max_angle>3.14</max_angle></horizontal></scan>"
    lidar += "<range><min>0.1</min><max>12</max></range></ray>"
    assert len(reported("GAZ072", robot + sensor("ray", lidar))) == count


def test_an_included_file_that_is_next_to_its_includer(tmp_path: Path) -> None:
    """The directory `urdf` of the package is called otherwise now."""
    package = add_package(tmp_path / "quad", "quad")
    add_file(package / "robots" / "macros.xacro", xacro(""))
    text = xacro('<xacro:include filename="$(find quad)/urdf/macros.xacro"/>' + link("base"))
    file = add_file(package / "robots" / "quad.xacro", text)
    (found,) = check(file, select=["XAC001"]).diagnostics
    assert found.help == "write macros.xacro, which is next to this file"
