"""GAZ071: a planar lidar on a robot with wheels does not scan level."""

import pytest

from tests.naming import naming
from tests.reported import messages, reported
from urdfkit import Severity

ROBOT = """<link name="base"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="left_wheel"/><link name="laser"/>
<joint name="w" type="{wheel}"><parent link="base"/><child link="left_wheel"/>
<axis xyz="0 1 0"/></joint>
<joint name="l" type="{mount}"><parent link="base"/><child link="laser"/>
<origin xyz="0.1 0 0.3" rpy="{rpy}"/><axis xyz="0 1 0"/></joint>
<gazebo reference="laser"><sensor name="s" type="{type}">{pose}<update_rate>10</update_rate>
<{block}><scan><horizontal><samples>360</samples><min_angle>{first}</min_angle>
<max_angle>3.14</max_angle></horizontal>{vertical}</scan>
<range><min>0.1</min><max>10</max></range></{block}></sensor></gazebo>"""
LEVEL = {
    "wheel": "continuous", "mount": "fixed", "rpy": "0 0 0", "type": "gpu_lidar", "pose": "",
    "block": "lidar", "first": "-3.14", "vertical": "",
}  # fmt: skip


def robot(**changed: str) -> str:
    return ROBOT.format(**(LEVEL | changed))


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"rpy": "0 0.2618 0"}, naming("s", "15 deg", "1 m", "above", "after", "3.86 m")),
        (
            {"rpy": "0.5 0 0", "type": "ray", "block": "ray"},
            naming("s", "28.6 deg", "1 m", "above", "after", "2.09 m"),
        ),
        (
            {"pose": "<pose>0 0 0 0 -0.3 1</pose>"},
            naming("s", "17.2 deg", "1 m", "above", "after", "3.38 m"),
        ),
        ({"rpy": "3.1416 0.2 0"}, naming("s", "11.5 deg", "1 m", "above", "after", "5.03 m")),
        ({"rpy": "1.5708 0 0"}, naming("s", "upright")),
        ({"rpy": "-1.5708 0 -1.5708"}, naming("s", "upright")),
    ],
)
def test_it_is_not_level(changed: dict[str, str], message: str) -> None:
    (one,) = reported("GAZ071", robot(**changed))
    assert one.message == message
    assert one.severity is Severity.WARNING


@pytest.mark.parametrize("rpy", ["3.14159 0 0", "0 3.14159 0", "3.1 0 1.2"])
def test_upside_down_is_an_info(rpy: str) -> None:
    (one,) = reported("GAZ071", robot(rpy=rpy))
    assert one.message == naming("s", "upside", "down", "above")
    assert one.severity is Severity.INFO


DRIVE = """<gazebo><plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
<left_joint>w</left_joint></plugin></gazebo>"""


def test_wheels_of_a_drive_may_have_any_name() -> None:
    tilted = robot(rpy="0 0.3 0").replace("left_wheel", "drive_l")
    assert messages("GAZ071", tilted) == []
    assert len(messages("GAZ071", tilted + DRIVE)) == 1


@pytest.mark.parametrize(("feet", "count"), [(4, 1), (2, 0)])
def test_a_quadruped_carries_it_level(feet: int, count: int) -> None:
    """Mangdang's Mini Pupper; a humanoid may look at the floor."""
    tilted = robot(rpy="0 1.5708 0").replace("left_wheel", "foot0")
    for number in range(1, feet):
        tilted += f'<link name="foot{number}"/><joint name="f{number}" type="fixed">'
        tilted += f'<parent link="base"/><child link="foot{number}"/></joint>'
    assert messages("GAZ071", tilted) == [naming("s", "upright")] * count


@pytest.mark.parametrize(
    "changed",
    [
        {},
        {"rpy": "0 0 2"},
        {"rpy": "0 0.05 0"},
        {"rpy": "0 0.3 0", "pose": "<pose>0 0 0 0 -0.3 0</pose>"},
        {"rpy": "0 0.3 0", "mount": "revolute"},
        {"rpy": "0 0.3 0", "wheel": "fixed"},
        {"rpy": "0 0.3 0", "first": "2.5"},
        {"rpy": "0 0.3 0", "vertical": "<vertical><samples>16</samples></vertical>"},
        {"rpy": "0 0.3 0", "pose": '<pose relative_to="base">0 0 0 0 0 0</pose>'},
    ],
)
def test_it_is_level_or_not_known(changed: dict[str, str]) -> None:
    assert messages("GAZ071", robot(**changed)) == []
