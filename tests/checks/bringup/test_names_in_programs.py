"""LAU032: typos in the names that programs of the workspace use."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, SPAWNER
from tests.checks.bringup.topics import SCAN
from tests.growth import assert_linear
from tests.launched import reported
from tests.naming import naming
from urdfkit import Diagnostic
from urdfkit.checks.bringup.names_in_programs import lists_of_words, pairs_of_words
from urdfkit.text.source import Source

NAMES = ("shoulder_joint", "elbow_joint", "wrist_joint", "joint_l", "joint_r")
JOINT = '<joint name="{0}" type="continuous"><parent link="base"/><child link="{0}_link"/></joint>'
ROBOT = '<robot name="r"><link name="base"/>{}</robot>'.format(
    "".join(f'<link name="{name}_link"/>{JOINT.format(name)}' for name in NAMES)
)
CONTROLLERS = """
controller_manager:
  ros__parameters:
    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    hand_l_controller: {type: position_controllers/GripperActionController}
arm_controller: {ros__parameters: {joints: [elbow_joint]}}
hand_l_controller: {ros__parameters: {joint: wrist_joint}}
"""
TEXT = (
    'Node(package="robot_state_publisher", executable="robot_state_publisher",\n'
    '     parameters=[{"robot_description": open("../r.urdf").read()}])\n'
    + NODE.format("controller_manager", "ros2_control_node", "parameters=['../c.yaml']")
    + SPAWNER.format(["arm_controller", "hand_l_controller"])
    + NODE.format("mine", "move", "")
)


RIGHT = "write arm_controller/follow_joint_trajectory"


def of_program(directory: Path, program: str, name: str = "mine/move.py") -> list[Diagnostic]:
    files = {"r.urdf": ROBOT, "c.yaml": CONTROLLERS, f"src/{name}": program}
    files["src/mine/package.xml"] = "<package><name>mine</name></package>"
    files["src/other/package.xml"] = "<package><name>other</name></package>"
    return reported(directory, "LAU032", "a.launch.py", TEXT, files)


@pytest.mark.parametrize(
    ("name", "help"),
    [
        ("arm_controller/follow_joint_trajectory", ""),
        ("/arm_controller/follow_joint_trajectory", ""),
        (
            "arm_controller/follow_joint_trajectories",
            "write arm_controller/follow_joint_trajectory",
        ),
        ("arm_controler/follow_joint_trajectory", "write arm_controller/follow_joint_trajectory"),
        ("/arm_controler/follow_joint_trajectory", "write arm_controller/follow_joint_trajectory"),
        ("arm_controller/joint_trajectory", ""),  # its topic
        ("arm_controller/command", "write arm_controller/joint_trajectory"),
        ("/arm_controller/commands", "write arm_controller/joint_trajectory"),
        ("leg_controller/command", ""),
        ("arm_controller/state", ""),
        ("arm_trajectory_controller/follow_joint_trajectory", RIGHT),
        ("/arm_control/joint_trajectory", "write arm_controller/joint_trajectory"),
        ("hand_l_control/joint_trajectory", ""),  # not a topic of this controller
        ("arm_position_trajectory_controller/follow_joint_trajectory", RIGHT),
        ("left_arm_controller/follow_joint_trajectory", ""),
        ("joint_trajectory_controller/follow_joint_trajectory", ""),
        ("leg_controller/follow_joint_trajectory", ""),  # of another robot
        ("hand_r_controller/gripper_cmd", ""),
        ("arm_controler/gripper_cmd", ""),  # not what this controller serves
        ("arm_controler/state", ""),
    ],
)
def test_the_action_of_a_controller(tmp_path: Path, name: str, help: str) -> None:
    found = of_program(tmp_path, f'client = ActionClient(self, Action, "{name}")\n')
    assert [one.help for one in found] == [help] * bool(help)
    assert [one.span.text for one in found] == [name] * bool(help)


@pytest.mark.parametrize(
    ("names", "unknown"),
    [
        ("shoulder_joint elbow_joint wrist_joint", ""),
        ("shoulder_joint elbow_joint wrst_joint", "wrst_joint"),
        ("shoulder_joint elbwo_joint wrist_joint", "elbwo_joint"),
        ("shoulder_joint elbow_joint wheel_joint", ""),  # of another robot
        ("shoulder_joint elbo_joint wrst_joint", ""),
        ("shoulder_joint wrst_joint", ""),  # too few to be a list of joints
        ("shoulder_joint wrist_joint elbow_joint wrst_joint", ""),  # the joint itself is named
        ("shoulder_joint elbow_joint joint_m", ""),  # a short word tells joints apart
        ("shoulder_joint elbow_joint wrist_joint_link", ""),
    ],
)
def test_a_list_of_joints(tmp_path: Path, names: str, unknown: str) -> None:
    found = of_program(tmp_path, f"JOINTS = {names.split()}\n")
    assert [one.span.text for one in found] == [unknown] * bool(unknown)


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("mine/src/move.cpp", 1),
        ("mine/launch/move.launch.py", 0),  # a launch file
        ("other/move.py", 0),  # nothing starts it
    ],
)
def test_programs(tmp_path: Path, name: str, count: int) -> None:
    lines = '{"shoulder_joint",\n "elbow_joint",\n "wrst_joint"}\n'
    found = of_program(tmp_path, lines, name)
    assert [one.message for one in found] == [naming("wrst_joint", "wrist_joint")] * count
    assert [one.span.line for one in found] == [3] * count


@pytest.mark.parametrize(
    "piece", [b"[ ", b'["a", ', b'["a","b","c"  ', b'"a/', b'["a","b","c","d",', b'"a']
)
def test_many_pieces_of_lists(piece: bytes) -> None:
    def reading(many: int) -> Callable[[], object]:
        source = Source("move.py", piece * many)
        return lambda: (list(pairs_of_words(source)), list(lists_of_words(source)))

    assert_linear(reading, 40_000)


@pytest.mark.parametrize("head", [b"[", b'["a","b","c"', b'"'])
@pytest.mark.parametrize("piece", [b" ", b"a", b"a/"])
def test_long_words_and_spaces(head: bytes, piece: bytes) -> None:
    def reading(many: int) -> Callable[[], object]:
        source = Source("move.py", head + piece * many)
        return lambda: (list(pairs_of_words(source)), list(lists_of_words(source)))

    assert_linear(reading, 40_000)


WATCH = "def start(node, on):\n    node.create_subscription({}, '{}', on, 5)\n"


@pytest.mark.parametrize(
    ("program", "node", "more", "help"),
    [
        (WATCH.format("LaserScan", "scan"), "", {}, ""),
        (WATCH.format("LaserScan", "lidar"), "", {}, "write /scan"),
        (WATCH.format("LaserScan", "lidar"), "remappings=[('lidar', 'scan')]", {}, ""),
        (
            WATCH.format("LaserScan", "scan"),
            "remappings=[('scan', '/lidar')]",
            {},
            "remap scan to /scan",
        ),
        (WATCH.format("LaserScan", "scan"), "namespace='a'", {}, "remap scan to /scan"),
        (WATCH.format("Image", "image"), "", {}, ""),  # this launch file starts no camera
        (WATCH.format("Odd", "lidar"), "", {}, ""),
        # what another program names it may publish, even if no launch file starts it
        (
            WATCH.format("LaserScan", "lidar"),
            "",
            {"src/other/lidar.py": "topic = '/lidar'\n"},
            "",
        ),
        (
            WATCH.format("LaserScan", "lidar"),
            "condition=IfCondition(LaunchConfiguration('a'))",
            {},
            "",
        ),
    ],
)
def test_what_a_program_reads(
    tmp_path: Path, program: str, node: str, more: dict[str, str], help: str
) -> None:
    files = {
        "src/mine/package.xml": "<package><name>mine</name></package>",
        "src/mine/setup.py": "from setuptools import setup\n"
        "setup(entry_points={'console_scripts': ['watch = mine.watch:main']})\n",
        "src/mine/mine/watch.py": program,
        "src/other/package.xml": "<package><name>other</name></package>",
        **more,
    }
    text = SCAN.format("/scan") + NODE.format("mine", "watch", node)
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [one.help for one in found] == [help] * bool(help)
