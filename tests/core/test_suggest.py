import pytest

from tests.growth import assert_linear
from urdfkit.core.suggest import Suggester, did_you_mean, is_typo, nearest, nearest_file_name

CODES = ["XML001", "XML002", "TRE003", "not-well-formed", "base_link"]


@pytest.mark.parametrize(
    ("word", "suggested"),
    [
        ("XML01", "XML001"),
        ("xml002", "XML002"),
        ("TER003", "TRE003"),
        ("not-wellformed", "not-well-formed"),
        ("Base_Link", "base_link"),
        ("completely else", None),
        ("", None),
    ],
)
def test_nearest(word: str, suggested: str | None) -> None:
    assert nearest(word, CODES) == suggested


@pytest.mark.parametrize(
    ("name", "other", "is_near"),
    [
        ("caster_link", "base_link", False),
        ("laser_link", "base_link", False),
        ("finger_joint1", "laser_joint", False),  # project_articubot
        ("cam_link", "camera_link", True),
        ("arm_joint_1", "arm_joint1", True),
    ],
)
def test_a_common_suffix_makes_no_names_similar(name: str, other: str, is_near: bool) -> None:
    assert nearest(name, [other]) == (other if is_near else None)


@pytest.mark.parametrize(
    ("name", "known", "suggested"),
    [
        # auv-software: the common suffix made the names similar
        ("start_cameras.launch.xml", ["start_xsens_driver.launch.xml"], None),
        ("start_camera.launch.xml", ["start_cameras.launch.xml"], "start_cameras.launch.xml"),
        # khi_robot, stretch_ros: similar letters, but another word
        ("chomp_planning.yaml", ["ompl_planning.yaml"], None),
        ("stretch_dex_wrist.xacro", ["stretch_description.xacro"], None),
        ("rviz_iiwa.rviz", ["rviz.rviz"], None),  # Marco19987's Dual_arm_control
        ("rviz_arm.rviz", ["rviz_arms.rviz"], "rviz_arms.rviz"),
        ("link_2.xacro", ["link_1.xacro", "links_2.xacro"], "links_2.xacro"),
        # kinova-ros: a word more
        ("move_group.launch", ["move_group_m1n6s300.launch"], "move_group_m1n6s300.launch"),
        ("armdescription.rviz", ["arm_description.rviz"], "arm_description.rviz"),
        ("robt.xacro", ["robot.gazebo.xacro", "robot.xacro", "robot.yaml"], "robot.xacro"),
        ("arm.xacro", ["arm.urdf.xacro"], "arm.urdf.xacro"),
        ("arm.yaml", ["arm.xacro"], None),
        # mini_pupper_ros: the description that is expanded to a file of this name
        ("arm.urdf", ["arm.urdf.xacro", "arms.urdf"], "arm.urdf.xacro"),
        ("arm.urdf", ["arm.xacro"], None),
        ("parol6.urdf", ["PAROL6.csv", "PAROL6.urdf"], "PAROL6.urdf"),
        ("PAROL6.urdf", ["parol6.urdf"], "parol6.urdf"),
        # trossen_arm_ros: parts of a robot of different kinds
        ("wxai.ros2_control.xacro", ["wxai.srdf.xacro", "wxai.urdf.xacro"], None),
        ("arm.ros2_contol.xacro", ["arm.ros2_control.xacro"], "arm.ros2_control.xacro"),
        (".rviz", ["arm.rviz"], None),
        # delto_m_ros2: hands of four and of five fingers
        ("dg4f.xacro", ["dg5f.xacro"], None),
        ("dg4f.xacro", ["dgf.xacro"], "dgf.xacro"),
        ("arm_gazebo.xacro", ["arm.gazebo.xacro", "arm.xacro"], "arm.gazebo.xacro"),
        ("base-plate.stl", ["baseplate.stl", "base.stl"], "baseplate.stl"),
    ],
)
def test_nearest_file_name(name: str, known: list[str], suggested: str | None) -> None:
    assert nearest_file_name(name, known) == suggested


def test_a_name_without_what_kind_of_thing_it_is() -> None:
    """Meshes of an Elfin arm, of which a sibling has more letters in common."""
    meshes = ["elfin_end_link", "elfin_base", "elfin_link1"]
    assert nearest("elfin_base_link", meshes) == "elfin_base"


@pytest.mark.parametrize(
    ("word", "other", "expected"),
    [
        ("drive", "drive", True),
        ("drive", "driver", True),
        ("dive", "drive", True),
        ("drove", "drive", True),
        ("drvie", "drive", True),
        ("drives", "driver", True),
        ("aa", "a", True),
        ("", "a", True),
        ("drvei", "drive", False),
        ("drivers", "drive", False),
        ("gps", "imu", False),
        ("drive2", "drive", False),
        ("drive1", "drive2", False),
    ],
)
def test_a_typo_is_one_letter_or_two_exchanged(word: str, other: str, expected: bool) -> None:
    assert is_typo(word, other) is expected
    assert is_typo(other, word) is expected


def test_did_you_mean() -> None:
    assert did_you_mean("bse_link", CODES) == "; did you mean 'base_link'?"
    assert did_you_mean("wheel", CODES) == ""
    assert did_you_mean("wheel", []) == ""


def test_an_endless_word_costs_little() -> None:
    known = [f"link_{n}" for n in range(100)]
    assert_linear(lambda size: lambda: nearest("x" * size, known), 4_000_000)


@pytest.mark.parametrize(
    ("word", "suggested"),
    [
        ("base_lnk", "base_link"),
        ("Base_Link", "base_link"),
        ("left_weel", "left_wheel"),
        ("wheel_3", ""),  # wheel_1 and wheel_2 are its siblings
        ("right_wheel", ""),
        ("rl_leg", ""),
        ("gripper", ""),
        ("roller_1", ""),  # nor roller_b
        ("base_imu_link", ""),
        ("fl_arm", ""),
        ("imu_link", ""),
        ("bs_link", "base_link"),
        ("roler_b", "roller_b"),
    ],
)
def test_a_sibling_is_not_a_typo(word: str, suggested: str) -> None:
    known = ["base_link", "left_wheel", "wheel_1", "wheel_2", "fl_leg", "roller_b"]
    assert Suggester(known).suggested(word) == suggested


def test_a_speller_bounds_its_work() -> None:
    suggester = Suggester(["base_link"])
    mistakes = [f"bas{'e' * length}_link" for length in range(2, Suggester.MAX_WORDS + 12)]
    assert suggester.suggested(mistakes[0]) == "base_link"
    for mistake in mistakes:
        suggester.suggested(mistake)
    assert suggester.suggested("base_lnk") == "", "more words are not looked at"
    assert suggester.suggested(mistakes[0]) == "base_link", "a word is looked at once"
    assert Suggester([f"l{n}" for n in range(Suggester.MAX_KNOWN + 1)]).suggested("l1x") == ""


def test_the_hint_of_a_speller() -> None:
    suggester = Suggester(["left_arm", "right_arm"])
    assert suggester.hint("left_amr") == "; did you mean 'left_arm'?"
    assert suggester.hint("rght_arm") == "; did you mean 'right_arm'?"
    assert suggester.hint("head") == ""


@pytest.mark.parametrize(
    ("word", "known", "suggested"),
    [
        ("baseline", "hackBaseline", ""),
        ("wheel_diameter", "left_wheel_diameter", ""),
        ("updateRate", "updateRateHZ", "updateRateHZ"),
        ("robotBaseFrme", "robotBaseFrame", "robotBaseFrame"),
        ("imageTopic", "imageTopicName", "imageTopicName"),
        ("max_linear_acceleration", "min_acceleration", ""),
        ("max_aceleration", "max_acceleration", "max_acceleration"),
        ("frontal_laser_rotation_link", "front_laser_link", ""),
        ("frontl_laser_link", "front_laser_link", "front_laser_link"),
    ],
)
def test_a_word_in_front_changes_the_meaning(word: str, known: str, suggested: str) -> None:
    assert Suggester([known]).suggested(word) == suggested


@pytest.mark.parametrize(
    ("word", "suggested"),
    [
        ("robot_1/mouse_jont", "robot_1/mouse_joint"),
        ("robot_1/imu_joint", ""),  # what is like is the namespace
        ("robot_1/plate_joint", "plate_joint"),
        ("robot_1/", ""),
    ],
)
def test_a_namespace_makes_no_names_alike(word: str, suggested: str) -> None:
    """Interbotix' locobots: `imu_joint` has no namespace, and is not the joint of the mouse."""
    known = ["robot_1/mouse_joint", "plate_joint"]
    assert Suggester(known).suggested(word) == suggested


@pytest.mark.parametrize(
    ("word", "suggested"),
    [
        ("base_link", "husky/base_link"),
        ("huksy/base_link", "husky/base_link"),
        ("imu_link", ""),  # of the left or the right arm
        ("arm_1/tool", ""),  # the tool of arm_2 is its sibling
    ],
)
def test_a_name_with_another_namespace(word: str, suggested: str) -> None:
    known = ["husky/base_link", "husky/base_imu", "left/imu_link", "right/imu_link", "arm_2/tool"]
    assert Suggester(known).suggested(word) == suggested


@pytest.mark.parametrize(
    ("word", "suggested"),
    [
        ("wheel_left_joint", "left_wheel_joint"),
        ("joint_1", "joint1"),
        ("RightArm", "right_arm"),
        ("right_left_finger", ""),  # of the other hand
        ("finger_2_1", ""),
        ("wheel_joint", ""),
    ],
)
def test_a_name_with_equal_words(word: str, suggested: str) -> None:
    known = ["left_wheel_joint", "joint1", "joint2", "right_arm"]
    known += ["left_right_finger", "finger_1_2"]
    assert Suggester(known).suggested(word) == suggested


def test_a_name_with_a_space_is_not_suggested() -> None:
    assert Suggester(["tool0 ", "tool 0"]).suggested("tool0") == ""


def test_a_known_name_with_the_kind_of_thing() -> None:
    """The macro of a lidar adds the suffix to the name of its link: msd700_robot_description."""
    known = ["base_link", "livox_joint", "livox_link"]
    assert Suggester(known).suggested("livox") == "livox_link"
    assert Suggester(known).suggested("scan") == ""
