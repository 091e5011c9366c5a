"""WLD003: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import INCLUDE, findings, messages
from tests.naming import naming
from urdfkit import Severity

CODE = "WLD003"
PLANE = """<model name="floor"><static>true</static><pose>0 0 {} 0 0 0</pose><link name="l">
<collision name="c"><geometry><plane><normal>0 0 1</normal></plane></geometry></collision>
</link></model>"""
SPAWN = 'Node(package="ros_gz_sim", executable="create", arguments=[{}])\n'
TOPIC = '"-topic", "robot_description", "-name", "cart"'
EMPTY = INCLUDE.replace('["-r ", share, "/worlds/hall.sdf"]', '"-r empty.sdf"')


def wheeled(joint: str = "continuous", world: str = "") -> str:
    """Wheels with a radius of 0.1 m around the root link."""
    text = world
    for name, xyz in (("left", "0 0.8 -0.2"), ("right", "0 -0.8 -0.2"), ("rear", "-0.8 0 -0.2")):
        text += f"""<joint name="{name}" type="{joint}"><parent link="base"/><child link="{name}"/>
<origin xyz="{xyz}"/><axis xyz="0 1 0"/></joint><link name="{name}"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><sphere radius="0.1"/></geometry></collision></link>"""
    return text


@pytest.mark.parametrize(
    ("launch", "z", "depth"),
    [
        (EMPTY + SPAWN.format(TOPIC), "0", "0.3"),
        (EMPTY + SPAWN.format(TOPIC + ', "-z", "0.1"'), "0.1", "0.2"),
        (EMPTY + SPAWN.format(TOPIC + ', "-z=0.25", "-Y", "1"'), "0.25", "0.05"),
        (
            EMPTY + SPAWN.format("").replace(
                "arguments=[]", 'parameters=[{"topic": "robot_description", "z": 0.2}]'
            ),
            "0.2",
            "0.1",
        ),
    ],
)  # fmt: skip
def test_spawned_too_low(launch: str, z: str, depth: str, tmp_path: Path) -> None:
    (one,) = messages(tmp_path, CODE, robot=wheeled(), launch=launch)
    assert one == naming(f"{z} m", "left", f"{depth} m", "below")


def test_location_and_help(tmp_path: Path) -> None:
    launch = EMPTY + SPAWN.format(TOPIC + ', "-z", "0.1"')
    (one,) = findings(tmp_path, CODE, robot=wheeled(), launch=launch)
    assert one.span.text == '"0.1"'
    assert (one.help, one.severity) == (naming("0.3"), Severity.WARNING)
    (one,) = findings(tmp_path, CODE, robot=wheeled(), launch=launch.replace("0.1", "0.22"))
    assert one.severity is Severity.INFO


SLAB = """<model name="m"><static>STATIC</static><pose>POSE</pose><link name="l">
<collision name="c"><geometry><box><size>SIZE</size></box></geometry></collision></link></model>"""


@pytest.mark.parametrize(
    ("size", "pose", "static", "count"),
    [
        ("36 28 0.3", "0 0 -0.15 0 0 0", "true", 1),  # its top is the ground
        ("36 28 0.3", "0 0 -0.4 0 0 0", "true", 0),  # 0.25 m lower
        ("36 28 0.3", "0 0 -0.15 0 0 0", "false", 0),
        ("36 28 0.3", "0 0 -0.15 0 0.1 0", "true", 0),
        ("36 28 0.3", "20 0 -0.15 0 0 0", "true", 0),  # beside the origin
        ("36 28 3", "0 0 -1.5 0 0 0", "true", 0),  # a wall or a building
        ("2 2 0.3", "0 0 -0.15 0 0 0", "true", 0),  # a table
        ("36 28", "0 0 -0.15 0 0 0", "true", 0),
    ],
)
def test_a_floor_that_is_a_box(
    size: str, pose: str, static: str, count: int, tmp_path: Path
) -> None:
    launch = INCLUDE + SPAWN.format(TOPIC + ', "-z", "0.1"')
    world = SLAB.replace("SIZE", size).replace("POSE", pose).replace("STATIC", static)
    found = messages(tmp_path, CODE, robot=wheeled(), launch=launch, world=world)
    assert sum("below the ground" in one for one in found) == count


def test_two_floors_that_are_boxes(tmp_path: Path) -> None:
    launch = INCLUDE + SPAWN.format(TOPIC + ', "-z", "0.1"')
    slab = SLAB.replace("SIZE", "9 9 0.1").replace("STATIC", "true")
    low, lower = (slab.replace("POSE", f"0 0 {z} 0 0 0") for z in ("-0.05", "-3"))
    for world, count in ((low, 1), (lower, 0), (low + lower, 0)):
        found = messages(tmp_path, CODE, robot=wheeled(), launch=launch, world=world)
        assert len(found) == count


@pytest.mark.parametrize("z", ["0.3", "0.295", "1"])
def test_spawned_high_enough(z: str, tmp_path: Path) -> None:
    launch = EMPTY + SPAWN.format(f'{TOPIC}, "-z", "{z}"')
    assert messages(tmp_path, CODE, robot=wheeled(), launch=launch) == []


def test_the_floor_of_the_world(tmp_path: Path) -> None:
    launch = INCLUDE + SPAWN.format(TOPIC + ', "-z", "0.5"')
    for height, depth in (("0.2", []), ("0.3", ["0.1"])):
        found = messages(tmp_path, CODE, robot=wheeled(), launch=launch, world=PLANE.format(height))
        assert [one.split(" is ")[2].split()[0] for one in found] == depth
    include = "<include><uri>model://ground_plane</uri></include>"
    low = launch.replace("0.5", "0.1")
    assert len(messages(tmp_path, CODE, robot=wheeled(), launch=low, world=include)) == 1
    (one,) = messages(tmp_path, CODE, robot=wheeled(), launch=low, world="")
    assert one == naming("hall", "no collision geometry, so")
    spawned = low + SPAWN.format('"-file", "floor.sdf"')
    assert messages(tmp_path, CODE, robot=wheeled(), launch=spawned, world="") == []
    hilly = f"{include}<model><collision><geometry><heightmap/></geometry></collision></model>"
    assert messages(tmp_path, CODE, robot=wheeled(), launch=low, world=hilly) == []
    inclined = PLANE.format(0).replace("0 0 0</pose>", "0 0.1 0</pose>")
    assert messages(tmp_path, CODE, robot=wheeled(), launch=low, world=inclined) == []


@pytest.mark.parametrize(
    "arguments",
    [
        '"-file", "cart.sdf"',
        '"-topic", "robot_description", "-R", "3.14"',
        '"-topic", "robot_description", "-z", LaunchConfiguration("z")',
    ],
)
def test_unknown_poses(arguments: str, tmp_path: Path) -> None:
    launch = EMPTY + SPAWN.format(arguments)
    assert messages(tmp_path, CODE, robot=wheeled(), launch=launch) == []


def test_robots_without_wheels(tmp_path: Path) -> None:
    launch = EMPTY + SPAWN.format(TOPIC)
    assert messages(tmp_path, CODE, robot=wheeled("fixed"), launch=launch) == []
    fixed = '<link name="world"/><joint name="w" type="fixed"><parent link="world"/>'
    fixed += '<child link="base"/></joint>'
    assert messages(tmp_path, CODE, robot=wheeled(world=fixed), launch=launch) == []


def test_classic(tmp_path: Path) -> None:
    launch = """
<include file="$(find gazebo_ros)/launch/empty_world.launch"/>
<param name="robot_description" command="xacro $(dirname)/../robot.urdf"/>
<node name="s" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model c"/>
"""
    (one,) = messages(tmp_path, CODE, robot=wheeled(), launch=launch, name="robot.launch")
    assert "0.3 m below" in one
    high = launch.replace("-model c", "-model c -z 0.4")
    assert messages(tmp_path, CODE, robot=wheeled(), launch=high, name="robot.launch") == []


SOLID = (
    "<model>{}<pose>{} 0 0.5 0 0 0</pose><link><collision><geometry>{}</geometry></collision>"
    "</link></model>"
)
BOX, MESH = "<box><size>1 1 1</size></box>", "<mesh><uri>hall.dae</uri></mesh>"


@pytest.mark.parametrize(
    ("static", "x", "geometry", "count"),
    [
        ("<static>true</static>", "0", BOX, 0),
        ("<static>true</static>", "4", BOX, 1),
        ("<static>true</static>", "4", "<box><size>9 9 1</size></box>", 0),
        ("<static>true</static>", "4", MESH, 0),
        ("", "0", BOX, 1),  # it falls, too
    ],
)
def test_solids_beside_the_robot(
    static: str, x: str, geometry: str, count: int, tmp_path: Path
) -> None:
    launch = INCLUDE + SPAWN.format(TOPIC + ', "-z", "0.5"')
    world = SOLID.format(static, x, geometry)
    found = messages(tmp_path, CODE, robot=wheeled(), launch=launch, world=world)
    assert found == [naming("hall", "collision", "below")] * count
