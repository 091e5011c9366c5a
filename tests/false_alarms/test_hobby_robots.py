"""What was wrong on robots of hobbyists and competitions, for which nobody had tuned."""

from pathlib import Path

import pytest

from tests.gazebos import BASE, BODY, block, child, plugin, sensor
from tests.jointed import joint, limit
from tests.jointed import robot as jointed
from tests.naming import naming
from tests.reported import reported
from tests.workspaces import add_file, add_package
from urdfkit import check

_SWITCH = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="c" default="true"/>
<link name="base"/><gazebo reference="wheel"><mu1>1</mu1></gazebo>
<xacro:unless value="$(arg c)"><xacro:include filename="drive.xacro"/></xacro:unless></robot>
"""


def test_a_drive_of_a_robot_without_wheels() -> None:
    """WAVE ROVER's first model: there is no joint to name."""
    drive = plugin("libgazebo_ros_diff_drive.so", "<left_joint>left</left_joint>")
    for kind, help in (("fixed", "add the joint"), ("continuous", "name a joint")):
        (found,) = reported("GAZ021", jointed(joint("arm", kind)) + drive)
        assert (found.help or "").startswith(help)


def test_the_topic_of_depth_images() -> None:
    """A robot for Robocon: the help named the topic of the coloured images."""
    lines = "<ros><remapping>depth/image_raw:=/depth</remapping></ros>"
    camera = f'<plugin name="c" filename="libgazebo_ros_camera.so">{lines}</plugin>'
    (found,) = reported("GAZ016", BASE + sensor("depth", camera))
    assert found.help == "write s/depth/image_raw:=/depth"


@pytest.mark.parametrize(
    ("kind", "velocity", "count"),
    [("continuous", "30", 0), ("continuous", "0", 1), ("revolute", "30", 1)],
)
def test_the_passive_joint_of_a_double_pendulum(kind: str, velocity: str, count: int) -> None:
    """An environment of Isaac Lab, whose second arm swings freely."""
    free = joint("free", kind, limit("-1", "1", effort="0", velocity=velocity))
    text = jointed(joint("driven", "revolute", limit("-1", "1")), free)
    found = [one.message for one in reported("JNT008", text) if "effort" in one.message]
    assert found == [naming("free", "effort", "0 N·m")] * count


@pytest.mark.parametrize(
    ("kind", "library", "maximum", "count"),
    [("ray", "libown.so", "0", 0), ("ray", "libown.so", "-1", 0), ("gpu_lidar", "", "0", 1)],
)
def test_the_beams_of_a_light_barrier(kind: str, library: str, maximum: str, count: int) -> None:
    """hrwros: fifty rays in one direction, which Gazebo Classic casts."""
    scan = (
        "<horizontal><samples>50</samples><min_angle>0</min_angle>"
        f"<max_angle>{maximum}</max_angle></horizontal>"
    )
    lidar = f"<ray><scan>{scan}</scan><range><min>0.1</min><max>1</max></range></ray>"
    use = f'<plugin name="c" filename="{library}"/>' if library else ""
    text = BASE + sensor(kind, lidar + use)
    targets = ("classic-ros1",) if library else ("gz-harmonic",)
    assert len(reported("GAZ004", text, targets=targets)) == count


def test_the_other_broadcaster_of_batteries(tmp_path: Path) -> None:
    """articubot_one: ros_battery_monitoring has a class of the same name, with `sensor_name`."""
    robot = (
        '<robot name="r"><link name="base"/><gazebo><plugin name="c" '
        'filename="libgazebo_ros2_control.so"><parameters>$(find arm)/c.yaml</parameters></plugin>'
        "</gazebo></robot>"
    )
    kind = "battery_state_broadcaster/BatteryStateBroadcaster"
    add_package(tmp_path, "arm")
    path = add_file(tmp_path / "r.xacro", robot.encode())
    for parameter, count in (("sensor_name: main", 0), ("frame_id: base", 1)):
        text = (
            f"controller_manager: {{ros__parameters: {{b: {{type: {kind}}}}}}}\n"
            f"b: {{ros__parameters: {{{parameter}}}}}\n"
        )
        add_file(tmp_path / "c.yaml", text.encode())
        found = check(path, select=["RCT034"]).diagnostics
        assert len([one for one in found if "batteries" in one.message]) == count


@pytest.mark.parametrize(("tag", "help"), [("max_contacts", "maxContacts"), ("gap", "remove")])
def test_contacts_in_a_collision(tag: str, help: str) -> None:
    """articubot_one's wheels: the converter has a tag of its own for it."""
    inside = f'<geometry><sphere radius="1"/></geometry><{tag}>1</{tag}>'
    text = f'<link name="base"><collision>{inside}</collision></link>'
    (found,) = [one for code in ("URD001", "URD008") for one in reported(code, text)]
    assert help in (found.help or "")


@pytest.mark.parametrize("odd", ["bl", "br", "fl"])
def test_the_leg_that_is_not_like_the_other_three(odd: str) -> None:
    """A Bioloid quadruped, whose back left leg has a frame of its own."""
    robot = '<link name="base"/>'
    for name, x, y in (("fl", 1, 1), ("fr", 1, -1), ("bl", -1, 1), ("br", -1, -1)):
        hip = f'<origin xyz="{0.05 * x} {0.05 * y} 0"/><axis xyz="0 0 1"/>{limit("-1", "1")}'
        robot += joint(f"{name}_hip", "revolute", hip)
        out, back = (0.02, 0.05) if name == odd else (0.05, 0.02)
        leg = f'<origin xyz="{out * x} {back * y} -0.03"/><axis xyz="0 1 0"/>{limit("-1", "1")}'
        robot += joint(f"{name}_leg", "revolute", leg, f"{name}_hip_link")
    (found,) = reported("JNT025", robot)
    assert f"'{odd}_leg' is " in found.message


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("", 1)])
def test_the_states_of_fixed_joints(kind: str, count: int) -> None:
    """A spot micro: gz-sim leaves a joint out that it does not find, and publishes the others."""
    states = "gz-sim-joint-state-publisher-system"
    robot = BASE + (child("arm", kind) if kind else "")
    tags = plugin(states, "<joint_name>arm_joint</joint_name>")
    assert len(reported("GAZ021", robot + tags, targets=("gz-harmonic",))) == count


@pytest.mark.parametrize(("height", "count"), [("-0.4", 0), ("0.4", 1)])
def test_wheels_whose_meshes_are_missing(height: str, count: int) -> None:
    """A rover whose meshes are on another computer: the IMU is not its lowest part."""
    mesh = '<geometry><mesh filename="file:///root/ws/wheel.stl"/></geometry>'
    box = '<geometry><box size="0.2 0.2 0.02"/></geometry>'
    robot = (
        '<link name="base_footprint"/>\n'
        + child(
            "base_link", "fixed", parent="base_footprint", inside=f"<collision>{box}</collision>"
        )
        + child(
            "wheel",
            parent="base_link",
            inside=f"<collision>{mesh}</collision>",
            xyz=f"0 0 {height}",
        )
    )
    assert len(reported("TRE008", robot)) == count


@pytest.mark.parametrize(("axis", "is_roller"), [("1 0 0", True), ("0 1 0", False)])
def test_the_rollers_of_omni_wheels(axis: str, is_roller: bool) -> None:
    """An omni robot: the lowest of its rollers is no wheel that hangs below the others."""
    ball = '<collision><geometry><sphere radius="0.01"/></geometry></collision>'
    robot = '<link name="base_footprint"/>\n'
    robot += child("base_link", "fixed", parent="base_footprint", inside="")
    for wheel, x in (("front", 0.1), ("back", -0.1)):
        robot += child(wheel, parent="base_link", inside=ball, xyz=f"{x} 0 0.01")
        robot += child(f"{wheel}_top", parent=wheel, inside=ball, xyz="0 0 0.04", axis=axis)
        robot += child(f"{wheel}_low", parent=wheel, inside=ball, xyz="0 0 -0.04", axis=axis)
    (found,) = reported("TRE008", robot)
    assert ("the wheels front, back end there" not in found.message) == is_roller
    assert ("raise the robot" in (found.help or "")) == is_roller


@pytest.mark.parametrize(
    ("tags", "help"),
    [
        ('<sensor name="s" type="imu"/><visualize>1</visualize>', "move it into the <sensor>"),
        ("<visualize>1</visualize>", "remove it: it is for a <sensor>"),
        ("<slip1>0.1</slip1>", "<friction><ode><slip1>"),
        ("<visul>1</visul>", "did you mean <visual>?"),
    ],
)
def test_what_belongs_elsewhere(tags: str, help: str) -> None:
    """A balancing robot: <visualize> behind its sensor is not <visual>."""
    (found,) = reported("GAZ003", BASE + block(tags))
    assert help in (found.help or "")
    assert (found.fix is None) == ("did you mean" not in help)


@pytest.mark.parametrize(("link", "help"), [("wheel", "condition of the link"), ("x", "name a")])
def test_a_link_whose_include_is_switched_off(tmp_path: Path, link: str, help: str) -> None:
    drive = f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="{link}"/></robot>'
    add_file(tmp_path / "drive.xacro", drive)
    path = add_file(tmp_path / "r.urdf.xacro", _SWITCH)
    (found,) = check(str(path), select=["GAZ001"]).diagnostics
    assert help in (found.help or "")


def test_links_of_one_chain_are_no_counterparts() -> None:
    """A wheeled biped with closed chains: ``r_l`` is a child of ``r_r``, as ``l_l`` of ``l_r``."""
    robot = '<link name="base_link"/>\n'
    for name, y in (("l", 0.1), ("r", -0.1)):
        robot += child(f"{name}_hip", parent="base_link", inside="", xyz=f"0 {y} 0")
        robot += child(f"{name}_r", parent=f"{name}_hip", inside="", xyz="0 0 0.1")
        robot += child(f"{name}_l", parent=f"{name}_r", inside="", xyz="0.1 0 0")
        robot += child(f"{name}_shank", parent=f"{name}_hip", inside="", xyz="0.2 0 0")
    assert reported("JNT025", robot) == []


@pytest.mark.parametrize(("body", "count"), [("", 0), (BODY, 1)])
def test_two_machines_in_a_world(body: str, count: int) -> None:
    """Two SCARAs next to each other, each of which reaches to its left."""
    robot = f'<link name="world">{body}</link>\n'
    for name, y in (("left", 2), ("right", -2)):
        robot += child(f"{name}_base", "fixed", parent="world", xyz=f"0 {y} 0")
        robot += child(f"{name}_1", parent=f"{name}_base", xyz="0 0 0.4", axis="0 0 1")
        robot += child(f"{name}_2", parent=f"{name}_1", xyz="0 1.5 0.1", axis="0 0 1")
    assert len(reported("JNT025", robot)) == count


@pytest.mark.parametrize(("colour", "count"), [("0.29804", 0), ("0.31", 1)])
def test_a_colour_that_is_rounded(colour: str, count: int) -> None:
    """The same biped, of two exports with more and fewer digits."""
    robot = ""
    for number, part in enumerate(("0.298039215686275", colour)):
        material = f'<material name="black"><color rgba="{part} {part} 0 1"/></material>'
        shape = f'<visual><geometry><box size="1 1 1"/></geometry>{material}</visual>'
        robot += f'<link name="a{number}">{shape}</link>\n'
    assert len(reported("NAM001", robot)) == count


@pytest.mark.parametrize(("height", "help"), [("0.2", "lower the robot"), ("0.05", "raise 'base")])
def test_a_robot_on_tracks_above_its_footprint(height: str, help: str) -> None:
    """A tracked rover: its tracks are part of the base, and lower than the wheels in them."""
    shape = '<collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>'
    ball = '<collision><geometry><sphere radius="0.05"/></geometry></collision>'
    robot = '<link name="base_footprint"/>\n'
    place = f"0 0 {height}"
    robot += child("base_link", "fixed", parent="base_footprint", inside=shape, xyz=place)
    for name, y in (("left_wheel", 0.1), ("right_wheel", -0.1)):
        robot += child(name, parent="base_link", inside=ball, xyz=f"0 {y} -0.03")
    (found,) = reported("TRE008", robot)
    assert help in (found.help or "")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ('<disable_collisions link1="base" link2="{}" reason="Never"/>', ""),
        ('<group name="g"><link name="{}"/></group>', "inside a false condition"),
    ],
)
def test_an_srdf_with_what_is_switched_off(tmp_path: Path, content: str, message: str) -> None:
    """The gripper of an arm, whose include has a condition: the SRDF is for both."""
    drive = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="wheel"/></robot>'
    add_file(tmp_path / "drive.xacro", drive)
    path = add_file(tmp_path / "r.urdf.xacro", _SWITCH)
    for link, expected in (("wheel", message), ("weel", "unknown link")):
        add_file(tmp_path / "r.srdf", f'<robot name="r">{content.format(link)}</robot>')
        found = check(str(path), select=["SRD001"]).diagnostics
        assert len(found) == bool(expected)
        assert all(expected in one.message for one in found)
