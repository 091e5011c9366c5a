"""Poses as people give them: on the command line, in files, as states of an SRDF."""

import json
from math import pi
from pathlib import Path

import pytest

from tests.conftest import CORPUS, needs_corpus
from urdfkit.errors import UnreadableFile
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.physics.poses import PoseError, outside_limits, pose

ROBOT = """<robot name="r">
<link name="base"/><link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="a"/>
  <limit lower="-1" upper="2" effort="1" velocity="1"/></joint>
<joint name="slide" type="prismatic"><parent link="a"/><child link="b"/>
  <limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
<joint name="follower" type="continuous"><parent link="b"/><child link="c"/>
  <mimic joint="turn"/></joint>
<joint name="weld" type="fixed"><parent link="c"/><child link="d"/></joint>
<joint name="free" type="floating"><parent link="d"/><child link="e"/></joint>
</robot>"""

SRDF = """<robot name="r">
<group name="arm"><joint name="turn"/></group><group name="tool"><joint name="slide"/></group>
<group_state name="ready" group="arm"><joint name="turn" value="0.5"/>
  <joint name="follower" value="0.5"/><joint name="free" value="0 0 0 0 0 0 1"/></group_state>
<group_state name="ready" group="tool"><joint name="slide" value="0.05"/></group_state>
<group_state name="folded" group="arm"><joint name="turn" value="2"/></group_state>
</robot>"""


#: A list of lists that would be written with 10^12 letters.
BOMB = "turn:\n- &a0 x\n" + "".join(
    f"- &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]\n" for n in range(1, 13)
)


@pytest.fixture
def robot(tmp_path: Path) -> Context:
    (tmp_path / "r.urdf").write_text(ROBOT)
    (tmp_path / "r.srdf").write_text(SRDF)
    return read(tmp_path / "r.urdf")


@pytest.mark.parametrize(
    ("joint", "text", "position"),
    [
        ("turn", "1.5", 1.5),
        ("turn", "90deg", pi / 2),
        ("turn", "-45 deg", -pi / 4),
        ("turn", "180°", pi),
        ("turn", " 1e-3 ", 0.001),
        ("turn", 2, 2.0),
        ("slide", 0.1, 0.1),
    ],
)
def test_a_position(robot: Context, joint: str, text: str | float, position: float) -> None:
    assert pose(robot, {joint: text}) == {joint: pytest.approx(position, rel=1e-15)}


@pytest.mark.parametrize(
    ("given", "reported"),
    [
        ({"tunr": "1"}, "no joint 'tunr'; did you mean 'turn'?"),
        ({"turn": "fast"}, "joint 'turn': 'fast' is not a position; write 1.57, 90deg or 0.1"),
        ({"turn": "nan"}, "joint 'turn': 'nan' is not a position; write 1.57, 90deg or 0.1"),
        ({"turn": "deg"}, "joint 'turn': 'deg' is not a position; write 1.57, 90deg or 0.1"),
        ({"slide": "5deg"}, "joint 'slide' is prismatic; write its position in m, not in degrees"),
        ({"follower": "1"}, "joint 'follower' mimics 'turn'; set 'turn' instead"),
        ({"weld": "1"}, "joint 'weld' is fixed: it does not move"),
        (
            {"free": "1"},
            "joint 'free' is floating: it has several degrees of freedom and cannot be set",
        ),
    ],
)
def test_what_is_no_position_is_reported(
    robot: Context, given: dict[str, str], reported: str
) -> None:
    with pytest.raises(PoseError) as error:
        pose(robot, given)
    assert str(error.value) == reported


@pytest.mark.parametrize(
    "text",
    [
        "turn: 90deg\nslide: 0.1\n",
        "turn: 1.5707963267948966\nslide: 1e-1\n",
        json.dumps({"turn": "90deg", "slide": 0.1}),
        '{\n\t"turn": "90deg",\n\t"slide": 0.1\n}',
    ],
)
def test_a_file(robot: Context, tmp_path: Path, text: str) -> None:
    (tmp_path / "pose").write_text(text)
    expected = {"turn": pytest.approx(pi / 2, rel=1e-15), "slide": 0.1}
    assert pose(robot, name=str(tmp_path / "pose")) == expected


@pytest.mark.parametrize(
    ("text", "reported"),
    [
        ("", "not a YAML or JSON mapping of joints to positions"),
        ("- 1\n", "not a YAML or JSON mapping of joints to positions"),
        ("a: [", "neither YAML nor JSON"),
        ("turn: [1]\n", "joint 'turn': 'a sequence' is not a position"),
        ("turn: 0x" + 5000 * "f", f"joint 'turn': '0x{38 * 'f'}...' is not a position"),
        (BOMB, "joint 'turn': 'a sequence' is not a position"),
        ("turn: true\n", "joint 'turn': 'true' is not a position"),
        ("turn:\n", "joint 'turn': '' is not a position"),
        ("? [a, b]\n: 1\n", "not a YAML or JSON mapping of joints to positions"),
        ("[" * 20_000, "nested too deeply"),
        ("turn: 2001-02-30", "joint 'turn': '2001-02-30' is not a position"),
        ("#" * 1_100_000, "larger than 1 MiB"),
        ("elbow: 1\nshoulder: 0\nelbow: 2\n", "joint 'elbow' is defined twice"),
        ('{"elbow": 1, "elbow": 2}', "joint 'elbow' is defined twice"),
    ],
)
def test_a_file_that_is_no_pose_is_reported(
    robot: Context, tmp_path: Path, text: str, reported: str
) -> None:
    (tmp_path / "pose.yaml").write_text(text)
    with pytest.raises(PoseError) as error:
        pose(robot, name=str(tmp_path / "pose.yaml"))
    assert reported in str(error.value)


def test_a_directory_is_no_file(robot: Context, tmp_path: Path) -> None:
    with pytest.raises(UnreadableFile):
        pose(robot, name=str(tmp_path))


def test_a_state_of_the_srdf(robot: Context) -> None:
    assert pose(robot, name="ready") == {"turn": 0.5, "slide": 0.05}
    assert pose(robot, name="arm/ready") == {"turn": 0.5}
    assert pose(robot, {"slide": "0"}, "ready") == {"turn": 0.5, "slide": 0.0}


def test_an_unknown_state_is_reported_with_those_there_are(robot: Context) -> None:
    with pytest.raises(PoseError, match=r"did you mean 'folded'\?"):
        pose(robot, name="fodled")
    with pytest.raises(
        PoseError, match="; there are ready, arm/ready, tool/ready, folded, arm/folded"
    ):
        pose(robot, name="xyz")


def test_what_leaves_the_limits_is_reported(robot: Context) -> None:
    assert outside_limits(robot.tree, {"turn": 2.0, "slide": 0.0}) == []
    assert outside_limits(robot.tree, {"turn": 2.5, "slide": -0.01}) == [
        "joint 'turn' at 2.5 rad is outside its limits -1 to 2 rad",
        "joint 'slide' at -0.01 m is outside its limits 0 to 0.1 m",
    ]
    assert outside_limits(robot.tree, {"turn": 90.0}) == [
        "joint 'turn' at 90 rad is outside its limits -1 to 2 rad; write degrees as 90deg"
    ]


def test_a_state_of_a_named_srdf(robot: Context, tmp_path: Path) -> None:
    (tmp_path / "other.srdf").write_text(SRDF.replace("0.5", "0.75"))
    assert pose(robot, name=f"{tmp_path}/other.srdf:arm/ready") == {"turn": 0.75}
    (tmp_path / "no.srdf").write_text("<sdf/>")
    with pytest.raises(PoseError, match=r"no.srdf: not an SRDF file"):
        pose(robot, name=f"{tmp_path}/no.srdf:ready")


def test_without_an_srdf_there_are_no_states(tmp_path: Path) -> None:
    (tmp_path / "r.urdf").write_text(ROBOT)
    with pytest.raises(PoseError, match="no pose file 'ready', and no SRDF with this group state"):
        pose(read(tmp_path / "r.urdf"), name="ready")


@needs_corpus
def test_states_of_real_robots() -> None:
    robots = CORPUS / "moveit_resources"
    fanuc = read(robots / "fanuc_description" / "urdf" / "fanuc.urdf")
    states = robots / "fanuc_moveit_config" / "config" / "fanuc.srdf"
    zeros = {f"joint_{number}": 0.0 for number in range(1, 7)}
    assert pose(fanuc, name=f"{states}:all-zeros") == zeros
    panda = read(robots / "panda_description" / "urdf" / "panda.urdf")
    states = robots / "panda_moveit_config" / "config" / "panda.srdf"
    ready = pose(panda, name=f"{states}:ready")
    assert ready["panda_joint4"] == -2.356
    assert outside_limits(panda.tree, ready) == []
