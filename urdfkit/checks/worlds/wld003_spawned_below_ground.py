"""The robot is spawned with its wheels below the ground of the world.

The pose of the node that spawns the robot is that of its root link. Where the wheels of a robot are
more than 0.1 m below the floor then, the physics throws it out, and it may tip over or fall through
a floor that is thin. Up to there it jumps, which is an info from a centimetre on. Spawn it higher,
or give the model a `base_footprint` on the ground.

A world without any collision has no floor at all: the robot falls for ever.

Robots with legs, those that are fixed to the world, and worlds whose floor is not one level plane
are left out.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    gazebo_ros, spawn_entity.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/spawn_entity.py
    ROS, base_footprint: https://www.ros.org/reps/rep-0120.html#base-footprint
"""

from urdfkit.checks.worlds.opened import OpenedWorld, opened_worlds
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.robot.samples import collision_xml, element_xml, joint_xml
from urdfkit.robot.stability import is_freestanding, standing
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.samples import solid_xml
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import options, spawner_of
from urdfkit.ros.launch.worlds import CLASSIC, worlds

NAME = "launch/robot.launch.py"
BAD = """\
from ament_index_python.packages import get_package_share_directory
from launch.actions import ExecuteProcess
from launch.substitutions import Command
from launch_ros.actions import Node

gazebo = ExecuteProcess(cmd=["gz", "sim", "-r", "empty.sdf"])
robot = Command(["xacro ", get_package_share_directory("cart"), "/cart.urdf"])
spawn = Node(
    package="ros_gz_sim",
    executable="create",
    arguments=["-topic", "robot_description", "-z", "0.02"],
)
"""
GOOD = BAD.replace("0.02", "0.2")
_WHEEL = collision_xml('<sphere radius="0.1"/>')
FILES = {
    "package.xml": b"<package><name>cart</name></package>",
    "cart.urdf": element_xml(
        'robot name="cart"',
        solid_xml("base"),
        *(
            part
            for name, xyz in (("left", "0 0.2 0"), ("right", "0 -0.2 0"), ("rear", "-0.3 0 0"))
            for part in (
                solid_xml(name, _WHEEL),
                joint_xml("continuous", f'<origin xyz="{xyz}"/>', name=name, child=name),
            )
        ),
    ).encode(),
}

#: Worlds of gz sim with a floor.
_WITH_FLOOR = ("default.sdf", "empty.sdf")
_DESCRIPTION = "robot_description"
#: Depths in m: up to the first nobody sees the robot jump; from the second on it is thrown.
TOLERANCE, DEEP = 0.01, 0.1


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    found = list(opened_worlds(context))
    described = [robot for _, robot in context.described_robots]
    starts = {one.span for one in worlds(context.launch)}
    if not len(found) == len(described) == len(starts) == 1:
        return  # which robot is spawned where is not known
    spawned = [
        one for one in (*context.launch.started, *context.launch.included) if spawner_of(one)
    ]
    if len(spawned) == 1:
        yield from _without_floor(found[0], described[0])
    ground = _ground(found[0])
    if ground is None:
        return
    for started in spawned:
        height = _height(started)
        if height is None:
            continue
        z, at = height
        lowest = _lowest(described[0])
        if lowest is not None and z + lowest[0] < ground - TOLERANCE:
            depth = ground - z - lowest[0]
            yield Finding(
                at,
                f"the robot is spawned at z = {z:g} m, where link '{lowest[1]}' is {depth:.3g} m "
                "below the ground",
                f"spawn it at z = {z + depth:.3g} or higher",
                related=(Related(described[0].model.links_by_name[lowest[1]].at.span, "the link"),),
                severity=None if depth > DEEP else Severity.INFO,
            )


def _without_floor(opened: OpenedWorld, robot: Context) -> Findings:
    """A world with nothing to stand on: no model in it has a collision, and none is included."""
    world = opened.world
    if world is None or b"uoyancy" in world.source.data or _lowest(robot) is None:
        return
    gravity = world.at.child("gravity")
    is_floating = gravity is not None and not any(map(number, gravity.text.split()))
    solid = ("collision", "heightmap", "include", "population")
    if not is_floating and not any(one.tag in solid for one in world.at.walk()):
        yield Finding(
            Location(world.at.span),
            f"world '{opened.name}' has nothing to stand on, so the robot falls",
            "add a model with a plane, visual and collision, or include a ground plane",
            related=opened.note,
        )


def _ground(opened: OpenedWorld) -> float | None:
    """The height of the floor in m; None if it is not known."""
    if opened.world is not None:
        return opened.world.ground
    is_plane = opened.started.name in _WITH_FLOOR or opened.started.generation == CLASSIC
    return 0.0 if is_plane and not opened.path else None


def _height(started: StartedProgram) -> tuple[float, Location] | None:
    """The z in m at which a node spawns the robot upright, and where that is written."""
    spawner = spawner_of(started)
    if spawner is None:
        return None
    given, is_known = options(started, spawner)
    parameters = {} if spawner.is_strict else started.parameters.every
    if parameters is None:
        return None
    texts = dict(parameters) | {name: word.text for name, word in given.items()}
    robot = texts.get("topic") or texts.get("param") or ""
    is_upright = all(number(texts.get(name, "0")) == 0 for name in ("R", "P"))
    z = number(texts.get("z", "0"))
    if not (is_known and is_upright and robot.endswith(_DESCRIPTION)) or z is None:
        return None
    if "reference_frame" in texts:
        return None
    span = given["z"].span if "z" in given else started.span
    return z, Location(span, started.frame)


def _lowest(robot: Context) -> tuple[float, str] | None:
    """The height in m of what a robot rolls on, below its root, and a link that touches there."""
    if robot.is_part or not robot.tree.is_sound:
        return None
    stands = standing(robot)
    if stands.stability is None or not is_freestanding(robot.tree, stands.links):
        return None
    return stands.stability.ground, stands.links[0]
