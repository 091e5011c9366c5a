"""Gravity asks nothing of a joint that moves links without gravity, as the PR2's arms."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.massive import link
from tests.reported import messages
from tests.robot.test_joint_loads import pendulum
from urdfkit import check

pytest.importorskip("pinocchio")

OFF = '<gazebo reference="{}"><{}>{}</{}></gazebo>'


@pytest.mark.parametrize(
    ("tag", "value", "count"),
    [
        ("turnGravityOff", "true", 0),
        ("turnGravityOff", "false", 1),
        ("gravity", "false", 0),
        ("gravity", "0", 0),
        ("gravity", "true", 1),
    ],
)
def test_a_link_without_gravity(tag: str, value: str, count: int) -> None:
    text = pendulum("13.7") + OFF.format("bob", tag, value, tag)
    assert len(messages("DYN003", text)) == count


def test_what_still_has_weight_counts() -> None:
    """The flag of the base takes no weight from the bob."""
    text = pendulum("13.7") + OFF.format("base", "turnGravityOff", "true", "turnGravityOff")
    assert len(messages("DYN003", text)) == 1


def test_the_flag_of_a_merged_link_holds_for_the_body() -> None:
    label = link("label") + (
        '<joint name="glue" type="fixed"><parent link="bob"/><child link="label"/></joint>'
    )
    text = pendulum("13.7") + label + OFF.format("label", "gravity", "false", "gravity")
    assert messages("DYN003", text) == []


@pytest.mark.parametrize(
    ("name", "count"), [("rotor{}", 0), ("motor_rotor_{}_joint", 0), ("w{}", 1)]
)
def test_no_root_of_a_robot_that_flies_is_held(name: str, count: int) -> None:
    """jsk_aerial_robot's Dragon: its rotors carry the links, not its joints."""
    rotors = "".join(
        link(f"blade{n}") + f'<joint name="{name.format(n)}" type="continuous">'
        f'<parent link="bob"/><child link="blade{n}"/></joint>'
        for n in (1, 2)
    )
    assert len(messages("DYN003", pendulum("13.7") + rotors)) == count


START = """\
<node pkg="robot_state_publisher" exec="robot_state_publisher">
  <param name="robot_description" value="$(command 'cat $(find-pkg-share arm)/arm.urdf')"/></node>
"""
GAZEBO = """<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py">
  <arg name="gz_args" value="-r $(find-pkg-share arm)/WORLD"/></include>
"""
WORLD = """<sdf version="1.9"><world name="w"><gravity>VECTOR</gravity></world></sdf>"""


@pytest.mark.parametrize(
    ("worlds", "count"),
    [(["orbit.sdf"], 0), (["earth.sdf"], 1), (["orbit.sdf", "earth.sdf"], 1), ([], 1)],
)
def test_a_robot_that_is_started_in_weightlessness(
    tmp_path: Path, worlds: list[str], count: int
) -> None:
    """Space ROS: the arm of the space station, in a world without gravity."""
    files = {
        "arm.urdf": f'<robot name="r">{pendulum("13.7")}</robot>',
        "orbit.sdf": WORLD.replace("VECTOR", "0 0 0"),
        "earth.sdf": WORLD.replace("VECTOR", "0 0 -9.8"),
    }
    launch = START + "".join(GAZEBO.replace("WORLD", world) for world in worlds)
    reported(tmp_path / "arm", "LAU001", "a.launch.xml", launch, files)
    found = check(tmp_path / "arm" / "arm.urdf", select=["DYN003"]).diagnostics
    assert len(found) == count
