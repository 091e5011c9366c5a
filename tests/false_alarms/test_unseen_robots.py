"""What was wrong on small robots of laboratories and students, for which nobody had tuned."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import CLASSIC, INCLUDE, systems
from tests.checks.worlds.started import findings as of_world
from tests.gazebos import BASE, block, child, plugin, sensor
from tests.jointed import joint, limit
from tests.jointed import robot as jointed
from tests.launched import MANIFEST
from tests.launched import reported as of_launch
from tests.naming import naming
from tests.physics.collision.robots import box, link, revolute, sphere
from tests.physics.collision.robots import joint as colliding_joint
from tests.reported import messages, reported
from tests.srdfs import findings as of_srdf
from tests.workspaces import add_file, add_package
from tests.xacros import xacro
from urdfkit import check

MODEL = "<gazebo>{}</gazebo>"
LINK = '<gazebo reference="tool">{}</gazebo>'
MOTOR = "gz-sim-multicopter-motor-model-system"


@pytest.mark.parametrize(
    ("block", "library", "severity"),
    [
        (LINK, "gz-sim-imu-system", "info"),
        (LINK, "libgazebo_ros_control.so", "warning"),
        (LINK, "", "warning"),
        (MODEL, "gz-sim-imu-system", "warning"),
    ],
)
def test_gz_sim_does_not_read_self_collide_of_a_link(
    block: str, library: str, severity: str
) -> None:
    """A rover whose links all have it: gz-sim takes that of the model alone."""
    pytest.importorskip("coal")
    moments = 'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"'
    inertial = f'<inertial><mass value="1"/><inertia {moments}/></inertial>'
    robot = "\n".join(
        (
            link("base", box(0.2, 0.2, 0.2)),
            link("upper", f"{sphere(0.02)}@0 0 0.2"),
            link("tool", sphere(0.1)),
            colliding_joint("base", "upper", "revolute", "0 0 0.15", revolute(-1, 1, "0 0 1")),
            colliding_joint("upper", "tool", "revolute", "0 0 0", revolute(-1, 1, "0 0 1")),
        )
    ).replace("</link>", f"{inertial}</link>")
    flag = block.format("<self_collide>true</self_collide>")
    (found,) = reported("COL001", robot + flag + (plugin(library) if library else ""))
    assert found.severity.value == severity


@pytest.mark.parametrize("kind", ["lidar", "gpu_lidar", "imu"])
def test_a_world_system_in_a_sensor_needs_no_type_of_it(kind: str) -> None:
    """`Sensors` in a `<sensor>` renders those of the world; what is wrong is its place."""
    system = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>'
    (message,) = messages("GAZ014", BASE + sensor(kind, system))
    assert message.endswith("in the world file")


ARM = """<robot name="arm"><link name="base"/><link name="tip"/>
<joint name="elbow" type="revolute"><parent link="base"/><child link="tip"/>
  <limit lower="{}" upper="1" effort="1" velocity="1"/></joint></robot>"""
SRDF = """<robot name="arm"><group name="arm"><joint name="elbow"/></group>
<group_state name="home" group="arm"><joint name="elbow" value="-1"/></group_state></robot>"""


def test_an_srdf_between_two_robots_is_of_the_one_that_it_is_called_like(tmp_path: Path) -> None:
    """A Panda of older limits, next to the one of today that has the same name."""
    add_file(tmp_path / "package.xml", b"<package><name>p</name></package>")
    narrow = add_file(tmp_path / "urdf" / "arm.urdf", ARM.format("0").encode())
    add_file(tmp_path / "urdf" / "arm_hand.srdf", SRDF.encode())
    assert len(check(narrow, select=["SRD004"]).diagnostics) == 1
    wide = add_file(tmp_path / "urdf" / "arm_hand.urdf", ARM.format("-2").encode())
    assert check(narrow, select=["SRD004"]).diagnostics == ()
    wide.write_text(ARM.format("0"))
    assert len(check(wide, select=["SRD004"]).diagnostics) == 1
    wide.write_text(ARM.format("0").replace(' name="arm"', ""))
    assert len(check(narrow, select=["SRD004"]).diagnostics) == 1, "a part is no robot"


LAUNCH = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription


def generate_launch_description():
    path = os.path.join(get_package_share_directory("arm"), {}, "run.py")
    return LaunchDescription([print(path)])
"""


@pytest.mark.parametrize(
    ("way", "count"),
    [
        ('"scripts"', 1),
        ('"launch", "..", "scripts"', 1),
        ('"..", "..", "src", "arm", "scripts"', 0),
    ],
)
def test_a_path_from_the_share_directory_back_to_the_sources(
    tmp_path: Path, way: str, count: int
) -> None:
    """It ends in the package by the layout of the sources alone; to install it does not help."""
    cmake = "project(arm)\ninstall(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    files = {"CMakeLists.txt": cmake, "scripts/run.py": ""}
    (tmp_path / "src").mkdir()
    found = of_launch(tmp_path / "src" / "arm", "PKG002", "a.launch.py", LAUNCH.format(way), files)
    assert len(found) == count


@pytest.mark.parametrize(("name", "count"), [("hand_controller", 0), ("haed_controller", 1)])
def test_a_controller_of_a_hand_is_no_misspelt_one_of_the_head(
    tmp_path: Path, name: str, count: int
) -> None:
    """A launch file that loads nothing: who includes it has the parameters of the hand."""
    text = f'<node name="s" pkg="controller_manager" type="spawner" args="{name}"/>'
    files = {"config/c.yaml": "head_controller: {type: effort_controllers/X}\n"}
    assert len(of_launch(tmp_path / "arm", "LAU013", "a.launch", text, files)) == count


def test_a_misspelt_option_is_not_to_be_removed(tmp_path: Path) -> None:
    node = "Node(package='ros_gz_sim', executable='create', arguments=['-topic', 't', '-r', '1'])"
    text = LAUNCH.format('"a"').replace("print(path)", node)
    text = text.replace("import os", "import os\nfrom launch_ros.actions import Node")
    (found,) = of_launch(tmp_path / "arm", "LAU016", "a.launch.py", text)
    assert found.message == naming("-r", "ignored", "-R")
    assert found.help == "write -R"


@pytest.mark.parametrize(
    ("project", "count"),
    [("driver-${KIND}", 0), ("driver-$ENV{KIND}", 0), ("driver-x", 1), ("driver", 1)],
)
def test_a_project_whose_name_ends_in_a_variable(tmp_path: Path, project: str, count: int) -> None:
    """A driver for several cameras, whose name the command line completes."""
    text = f"project({project})\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    files = {"CMakeLists.txt": text}
    assert len(of_launch(tmp_path / "arm", "PKG007", "a.launch", "", files)) == count


@pytest.mark.parametrize(("declared", "count"), [("", 1), ('<arg name="arm_id" default="a"/>', 0)])
def test_substitutions_in_a_file_take_the_arguments_of_the_launch_file(
    tmp_path: Path, declared: str, count: int
) -> None:
    """Controllers of one and of two arms in one file: `subst_value` alone stops roslaunch."""
    text = f'{declared}<rosparam file="$(find arm)/c.yaml"/>'
    (tmp_path / "arm").mkdir()
    (found,) = of_launch(
        tmp_path / "arm", "LAU019", "a.launch", text, {"c.yaml": "one: $(arg arm_id)_joint\n"}
    )
    assert found.help == 'write subst_value="true"' + ', and declare <arg name="arm_id"/>' * count


@pytest.mark.parametrize("of_arm", [False, True])
def test_a_flag_that_the_link_has_into_which_another_one_is_merged(of_arm: bool) -> None:
    """Universal Robots' tool flange: its <selfCollide> adds nothing to that of the last wrist."""
    ball = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
    robot = BASE.replace("</link>", f"{ball}</link>") + child("hand", "fixed")
    robot += block("<selfCollide>true</selfCollide>", "hand")
    robot += child("gripper", "fixed").replace("</inertial>", f"</inertial>{ball}")
    if of_arm:
        robot += block("<selfCollide>true</selfCollide>")
    assert len(messages("GAZ067", robot)) == (not of_arm)


def test_a_world_that_one_of_several_launch_files_starts_in_the_other_gazebo(
    tmp_path: Path,
) -> None:
    """Its plugins are right; to remove them breaks it where it is started as it should be."""
    (found,) = of_world(tmp_path, "WLD005", world=systems("physics", "sensors"), launch=CLASSIC)
    assert found.message == naming("hall", "Gazebo", "Classic", "none", "2")
    assert found.span.source.path.endswith(".launch.py")
    mixed = systems("physics") + '<plugin name="p" filename="libgazebo_ros_state.so"/>'
    (found,) = of_world(tmp_path, "WLD005", world=mixed, launch=CLASSIC)
    assert found.help == "remove it"


@pytest.mark.parametrize(
    ("left", "right", "count"),
    [
        (limit("1.5708", "3.66519"), limit("2.61799", "4.71239"), 0),  # a mirror image about pi
        (limit("1.5708", "3.66519"), limit("2.61799", "4.2"), 1),
        (limit("-1.0112", "0.385068"), limit("0", "1.39626"), 0),  # of an exporter
    ],
)
def test_limits_of_counterparts_with_another_zero(left: str, right: str, count: int) -> None:
    """Exporters put zero where the parts of an assembly were drawn, and servos at half a turn."""
    arms = joint("left_arm", "revolute", left), joint("right_arm", "revolute", right)
    assert len(messages("JNT025", jointed(*arms))) == count


def test_an_axis_without_direction_is_not_the_wrong_axis_of_a_wheel() -> None:
    wheel = '<collision><geometry><cylinder radius="0.1" length="0.04"/></geometry></collision>'
    robot = jointed(joint("wheel", "continuous", '<axis xyz="0 0 0"/>'))
    robot = robot.replace('<link name="wheel_link"/>', f'<link name="wheel_link">{wheel}</link>')
    assert messages("JNT033", robot) == []
    assert len(messages("JNT006", robot)) == 1


def test_two_parents_of_a_link_whose_name_is_there_twice() -> None:
    """An exporter named two shins alike: each has its joint, and NAM001 says what is wrong."""
    shins = [joint("shin", "revolute", limit("-1", "1")) for _ in range(2)]
    robot = jointed(shins[0], shins[1].replace('joint name="shin"', 'joint name="other_shin"'))
    assert messages("TRE004", robot) == []
    assert messages("NAM001", robot) == ["duplicate link 'shin_link'"]


@pytest.mark.parametrize(("root", "is_world"), [("world", True), ("base_footprint", False)])
def test_a_world_is_no_frame_of_a_drive(root: str, is_world: bool) -> None:
    """Pepper is fixed to a link `world`, which does not drive."""
    robot = BASE.replace("base", root) + child("base_link", "fixed", parent=root)
    drive = "<robotBaseFrame>base_link</robotBaseFrame>"
    (found,) = reported("RCT029", robot + plugin("libgazebo_ros_planar_move.so", drive))
    assert found.help.startswith("remove the links") is is_world
    assert (found.fix is None) is is_world


def test_the_only_attribute_of_an_element_under_another_name() -> None:
    (found,) = reported("URD003", '<joint name="j" type="fixed"><parent value="a"/></joint>')
    assert found.help == naming("value", "link")
    assert messages("URD002", '<joint name="j" type="fixed"><parent value="a"/></joint>') == []
    assert (
        len(messages("URD002", '<link name="a"><visual><geometry shape="a"/></visual></link>')) == 1
    )


def test_a_colour_of_three_numbers_in_an_element() -> None:
    color = "<material name='m'><color>1.0 0.5 0</color></material>"
    assert [one.help for one in reported("URD003", color)] == [
        naming('<color rgba="1.0 0.5 0 1"/>', "attribute")
    ]


@pytest.mark.parametrize("level", ["info", "Debug", "verbose"])
def test_a_log_level_in_small_letters(level: str) -> None:
    """gazebo_ros_utils compares it regardless of case, and ignores another."""
    drive = f"<rosDebugLevel>{level}</rosDebugLevel>"
    assert messages("GAZ004", BASE + plugin("libgazebo_ros_diff_drive.so", drive)) == []


@pytest.mark.parametrize(("option", "count"), [("--shutdown-time 1", 0), ("--stopped 1", 1)])
def test_the_first_letters_of_an_option_of_the_spawner(
    tmp_path: Path, option: str, count: int
) -> None:
    """argparse accepts `--shutdown-time`: the number is its value, not a controller."""
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="{} arm_controller"/>'
    text = '<rosparam file="$(find arm)/c.yaml"/>' + spawner.format(option)
    files = {"c.yaml": "arm_controller:\n  type: position_controllers/JointPositionController\n"}
    assert len(of_launch(tmp_path / "arm", "LAU013", "a.launch", text, files)) == count


def test_a_launch_file_is_not_suggested_to_include_itself(tmp_path: Path) -> None:
    text = '<include file="$(find arm)/launch/run_robot_spawner.launch"/>'
    (found,) = of_launch(tmp_path / "arm", "LAU003", "run_robot.launch", text)
    assert "did you mean" not in found.help
    (found,) = of_launch(tmp_path / "arm", "LAU003", "other.launch", text)
    assert found.help == naming("run_robot.launch")


def test_an_argument_that_an_including_file_passes(tmp_path: Path) -> None:
    """roslaunch resolves the default after it has set what the including file passes."""
    passed_on = '<arg name="machine" default="$(arg machine)"/>'
    assert of_launch(tmp_path / "arm", "LAU006", "a.launch", passed_on) == []
    other = '<arg name="machine" default="$(arg host)"/><arg name="host" default="a"/>'
    assert len(of_launch(tmp_path / "arm", "LAU006", "b.launch", other)) == 1


@pytest.mark.parametrize(("name", "count"), [("top_apriltag", 0), ("top_camera", 1)])
def test_the_optical_frame_of_a_tag(name: str, count: int) -> None:
    """What a camera sees, not what looks."""
    turned = 'xyz="0 0 0" rpy="0 0 1.57079633"'
    frame = child(f"{name}_optical", "fixed", parent=f"{name}_link")
    frame = frame.replace('xyz="0 0 0"', turned, 1)
    assert len(messages("JNT030", BASE + child(f"{name}_link", "fixed") + frame)) == count


def test_a_frame_of_a_sensor_in_gz() -> None:
    (found,) = reported("GAZ003", BASE + sensor("imu", "<frame>base</frame>"))
    assert found.help == naming("<gz_frame_id>", "<sensor>")


@pytest.mark.parametrize(("build", "count"), [("catkin", 0), ("ament_cmake", 1)])
def test_the_name_of_pilz_in_moveit_1(tmp_path: Path, build: str, count: int) -> None:
    """Its plugin description has a double colon there, and a slash in MoveIt 2."""
    depend = f"<buildtool_depend>{build}</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(MANIFEST.replace("</package>", depend))
    plugin = "planning_plugin: pilz_industrial_motion_planner::CommandPlanner\n"
    (tmp_path / "pilz_industrial_motion_planner_planning.yaml").write_text(plugin)
    group = '<group name="arm"><link name="arm"/></group>'
    assert len(of_srdf(tmp_path, group, "SRD026")) == count


def test_a_control_plugin_without_transmissions() -> None:
    (found,) = reported("RCT010", BASE + plugin("libgazebo_ros_control.so"))
    assert found.help == naming("<transmission>", "driven")


def test_an_expression_with_parts_outside_its_braces() -> None:
    """`${m/12} * (${l}*${l})` is a text of three words, and not three numbers."""
    moments = '<inertia ixx="0.5 * (0.1*0.1)" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    robot = f'<link name="a"><inertial><mass value="1"/>{moments}</inertial></link>'
    (found,) = reported("URD005", robot)
    assert "'0.5 * (0.1*0.1)'" in found.message
    assert "${...}" in found.help


@pytest.mark.parametrize(
    ("collision", "count"), [("<collision>seat</collision>", 0), ("<collision/>", 1)]
)
def test_the_collision_that_a_contact_sensor_names(
    tmp_path: Path, collision: str, count: int
) -> None:
    """The seats of a race track: a text alone is the name of another element."""
    sensor = f'<sensor name="s" type="contact"><contact>{collision}</contact></sensor>'
    world = f'<model name="m"><link name="l">{sensor}</link></model>'
    assert len(of_world(tmp_path, "WLD002", world=world)) == count


@pytest.mark.parametrize(("axis", "is_steered"), [("0 0 1", True), ("1 0 0", False)])
def test_a_wheel_that_a_joint_steers(axis: str, is_steered: bool) -> None:
    """A buggy whose universal joints became continuous ones about z: the wheels only steer."""
    tyre = '<origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.1" length="0.05"/></geometry>'
    wheel = f'<link name="wheel"><collision>{tyre}</collision></link>'
    turn = f'<parent link="base"/><child link="wheel"/><axis xyz="{axis}"/>'
    robot = f'<link name="base"/>{wheel}<joint name="turn" type="continuous">{turn}</joint>'
    (found,) = reported("JNT033", robot)
    assert ("steers" in found.help) == is_steered


def test_the_surface_of_a_collision() -> None:
    """A mecanum base: the friction of SDF, directly in the <gazebo> of the link."""
    (found,) = reported("GAZ003", BASE + block("<surface><friction/></surface>", "base"))
    assert found.help == naming("<surface>", "<collision>", "inside", "<gazebo>")


def test_the_files_that_an_argument_may_name(tmp_path: Path) -> None:
    """A base with one of several cameras: the directory of a missing file has the others."""
    for name in ("d435.urdf.xacro", "lidar.urdf", "notes.txt"):
        add_file(tmp_path / "sensors" / name, b"<robot/>")
    add_file(tmp_path / "r.xacro", xacro('<xacro:include filename="sensors/astra.urdf"/>').encode())
    (found,) = check(tmp_path / "r.xacro", select=["XAC001"]).diagnostics
    assert found.help == naming("d435.urdf.xacro", "lidar.urdf")


@pytest.mark.parametrize("world", ["default", "hall"])
def test_a_model_that_gz_sim_starts(tmp_path: Path, world: str) -> None:
    """A heightmap on which a quadruped walks: gz sim loads a model into the world `default`."""
    add_file(tmp_path / "worlds" / "hall.sdf", b'<sdf version="1.9"><model name="hill"/></sdf>')
    topic = f"/world/{world}/pose/info@geometry_msgs/msg/PoseArray@gz.msgs.Pose_V"
    bridge = f'Node(package="ros_gz_bridge", executable="parameter_bridge", arguments=["{topic}"])'
    launch = f"{INCLUDE}{bridge}\n"
    assert of_world(tmp_path, "WLD002", launch=launch) == []
    assert len(of_world(tmp_path, "WLD007", launch=launch)) == (world != "default")
    assert len(of_world(tmp_path, "WLD002", launch=CLASSIC)) == 1


@pytest.mark.parametrize(
    ("tags", "count"),
    [("<actuator_number>0</actuator_number>", 0), ("<motorNumber>0</motorNumber>", 0), ("", 1)],
)
def test_the_number_of_a_motor_under_its_first_name(tags: str, count: int) -> None:
    """A drone of Humble: Fortress reads <motorNumber> alone, and later versions either of them."""
    tags += "<jointName>tool_joint</jointName><linkName>tool</linkName>"
    tags += "<turningDirection>ccw</turningDirection>"
    found = messages("GAZ017", BASE + child("tool") + plugin(MOTOR, tags))
    wanted = naming("p", MOTOR, "<actuator_number>", "<motorNumber>")
    assert found == [wanted] * count


def test_a_remapped_topic_that_resembles_none_of_the_node(tmp_path: Path) -> None:
    """Points of a camera, whose input is called otherwise: no output is meant."""
    remappings = "[('image_rect', '/d'), ('camera_info', '/i'), ('image', '/x')]"
    text = (
        "from launch_ros.actions import Node\n"
        "Node(package='depth_image_proc', executable='point_cloud_xyz_node', "
        f"remappings={remappings})\n"
    )
    (found,) = of_launch(tmp_path / "arm", "LAU028", "a.launch.py", text)
    assert found.help == "remap one of these topics, or remove it"


def test_a_controller_manager_of_gazebo_classic_without_its_parameters() -> None:
    """It only says that the configuration might be wrong, while those of gz-sim do not start."""
    (found,) = reported("GAZ017", BASE + plugin("libgazebo_ros2_control.so"))
    assert found.severity == "warning"
    gz = plugin("gz_ros2_control-system", name="gz_ros2_control::GazeboSimROS2ControlPlugin")
    (found,) = reported("GAZ017", BASE + gz)
    assert found.severity == "error"


def test_an_offset_that_only_the_latest_odometry_reads() -> None:
    odometry = "gz-sim-odometry-publisher-system"
    offset = "<xyz_global_offset>0 0 1</xyz_global_offset>"
    assert reported("GAZ016", BASE + plugin(odometry, offset)) == []


def test_particles_of_fortress() -> None:
    """There the plugin of a model makes the emitter; later, a system of the world serves all."""
    emitter = plugin("ignition-gazebo-particle-emitter-system", "<rate>1</rate>")
    assert reported("GAZ014", BASE + emitter) == reported("GAZ016", BASE + emitter) == []


@pytest.mark.parametrize("part", ["laser", "mast"])
def test_a_sensor_for_the_other_robot_that_includes_its_file(tmp_path: Path, part: str) -> None:
    """Two rovers: only the smaller has the lidar that their common file describes."""
    add_package(tmp_path, "rover")
    scan = '<gazebo reference="laser_link"><sensor name="s" type="ray"/></gazebo>'
    (tmp_path / "common.gazebo").write_text(xacro(scan))
    include = '<xacro:include filename="common.gazebo"/><link name="lazer_link"/>'
    (tmp_path / "rover.xacro").write_text(xacro(include))
    (tmp_path / "mini.xacro").write_text(xacro(include + joint(part, "fixed", parent="lazer_link")))
    (found,) = check(tmp_path / "rover.xacro", select=["GAZ001"]).diagnostics
    assert found.severity == "error"
    assert (found.fix is None, "mini.xacro" in found.help) == ((part == "laser"),) * 2


def test_a_directory_around_the_package_that_only_has_the_name(tmp_path: Path) -> None:
    """``$(find ranger_mini)`` in ranger_mini/ranger_mini_v2 finds no package, not a file less."""
    text = (
        '<node name="s" pkg="gazebo_ros" type="spawn_model" '
        'args="-file $(find rover)/urdf/rover.urdf -urdf -model rover"/>'
    )
    (tmp_path / "rover").mkdir()
    found = of_launch(tmp_path / "rover" / "v2", "LAU016 XAC011", "gazebo.launch", text)
    assert [one.code for one in found] == ["XAC011"]
