"""The robot is spawned with its wheels below the ground of the world.

The pose of the node that spawns the robot is that of its root link. If the wheels are more than
0.1 m below the floor, the physics ejects the robot, which may tip over or fall through a thin
floor. With 0.01 to 0.1 m it jumps (info). Spawn it higher, or add a `base_footprint` on the ground.

A world without any collision geometry below the robot has no floor: the robot falls for ever.

Robots with legs, robots that are fixed to the world, and worlds whose floor is not a single level
plane are not checked.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    gazebo_ros, spawn_entity.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/spawn_entity.py
    ROS, base_footprint: https://www.ros.org/reps/rep-0120.html#base-footprint
"""

from math import hypot, inf

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.samples import collision_xml, element_xml, joint_xml
from urdfkit.robot.stability import is_freestanding, standing_verdict
from urdfkit.robot.values import number, numbers
from urdfkit.ros.gazebo.samples import solid_xml
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import model_spawner, options
from urdfkit.ros.launch.worlds import CLASSIC, worlds
from urdfkit.text.document import Element

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
#: What may have a floor in it, besides models.
_FLOORS = ("heightmap", "include", "population", "actor", "road")
#: How far a robot reaches beyond its origin, in m.
_MARGIN = 1.0
#: Depths in m: below the first the robot does not visibly jump; above the second it is ejected.
TOLERANCE, EJECTION_DEPTH = 0.01, 0.1


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    opened, robots = list(opened_worlds(context)), [robot for _, robot in context.described_robots]
    starts = {world.span for world in worlds(context.launch)}
    if not len(opened) == len(robots) == len(starts) == 1:
        return  # it is unknown which robot is spawned in which world
    (robot,) = robots
    spawners = list(filter(model_spawner, context.launch.programs))
    if len(spawners) == 1:
        yield from _without_floor(opened[0], robot, spawners[0])
    ground = _ground(opened[0])
    if ground is None:
        return
    for spawner in spawners:
        height = _height(spawner)
        if height is None:
            continue
        z, at = height
        lowest = _lowest(robot)
        if lowest is not None and z + lowest[0] < ground - TOLERANCE:
            depth = ground - z - lowest[0]
            yield Finding(
                at,
                f"the robot is spawned at z = {z:g} m, where link '{lowest[1]}' is {depth:.3g} m "
                "below the ground",
                f"spawn it at z = {round(z + depth, 4) + 0:.3g} or higher",
                related=(Related(robot.model.links_by_name[lowest[1]].at.span, "the link"),),
                severity=None if depth > EJECTION_DEPTH else Severity.INFO,
            )


def _without_floor(opened: OpenedWorld, robot: Context, spawner: StartedProgram) -> Findings:
    """A world without a floor: no collision geometry carries the robot, and it includes nothing."""
    world, place = opened.world, _position(spawner)
    if world is None or b"uoyancy" in world.source.data or _lowest(robot) is None:
        return
    has_others = any(element.tag in _FLOORS for element in world.at.walk())
    if world.is_weightless or has_others:
        return
    models = [model for model in world.at.all("model") if _has_collision(model)]
    if not models or (place and not any(_may_carry(model, place) for model in models)):
        what = "no collision geometry below the robot" if models else "no collision geometry"
        yield Finding(
            world.at.span,
            f"world '{opened.name}' has {what}, so the robot falls",
            "add a model with a plane, visual and collision, or include a ground plane",
            related=opened.note,
        )


def _has_collision(model: Element) -> bool:
    return any(element.tag == "collision" for element in model.walk())


def _may_carry(model: Element, place: tuple[float, float]) -> bool:
    """False for a model that falls itself, and for solids beside the robot."""
    static = model.child("static")
    if static is None or static.text.strip().lower() not in ("true", "1"):
        return any(element.tag == "joint" for element in model.walk())
    poses = [element for element in model.walk() if element.tag == "pose"]
    origins = [numbers(pose.text) or () for pose in poses if pose.text.strip()]
    sizes = [_extent(element) for element in model.walk() if element.tag == "geometry"]
    if any(pose.get("relative_to") for pose in poses) or not all(map(len, origins)):
        return True
    own = model.child("pose")
    x, y = (numbers(own.text) or (0.0, 0.0))[:2] if own is not None else (0.0, 0.0)
    # The poses of its parts are in the frame of the model.
    reach = sum(hypot(*origin[:3]) for origin in origins) - hypot(x, y)
    return hypot(x - place[0], y - place[1]) <= reach + max(sizes, default=inf) + _MARGIN


def _extent(geometry: Element) -> float:
    """The radius of a sphere around a solid, in m; infinite for others, such as a mesh."""
    (solid,) = geometry.children or (geometry,)
    values = [numbers(part.text) for part in solid.children]
    if solid.tag not in ("box", "cylinder", "sphere") or not all(values):
        return inf
    reach = sum(hypot(*value) for value in values if value)
    return reach / 2 if solid.tag == "box" else reach


def _position(program: StartedProgram) -> tuple[float, float] | None:
    """The x and y in m at which a node spawns the robot; None if unknown."""
    spawner = model_spawner(program)
    arguments, is_known = options(program, spawner) if spawner else ({}, False)
    parameters = program.parameters.every
    if not is_known or parameters is None:
        return None
    texts = dict(parameters) | {name: word.text for name, word in arguments.items()}
    x, y = (number(texts.get(name, "0") or "") for name in ("x", "y"))
    return None if x is None or y is None else (x, y)


def _ground(opened: OpenedWorld) -> float | None:
    """Height of the floor in m; None if it is unknown."""
    if opened.world is not None:
        return opened.world.ground
    is_plane = opened.started.name in _WITH_FLOOR or opened.started.generation == CLASSIC
    return 0.0 if is_plane and not opened.path else None


def _height(program: StartedProgram) -> tuple[float, Location] | None:
    """The z in m at which a node spawns the robot upright, and its location; None if unknown."""
    spawner = model_spawner(program)
    if spawner is None:
        return None
    arguments, is_known = options(program, spawner)
    parameters = {} if spawner.is_strict else program.parameters.every
    if parameters is None:
        return None
    texts = dict(parameters) | {name: word.text for name, word in arguments.items()}
    robot = texts.get("topic") or texts.get("param") or ""
    is_upright = all(number(texts.get(name, "0")) == 0 for name in ("R", "P"))
    z = number(texts.get("z", "0"))
    if not (is_known and is_upright and robot.endswith(_DESCRIPTION)) or z is None:
        return None
    if "reference_frame" in texts:
        return None
    span = arguments["z"].span if "z" in arguments else program.span
    return z, Location(span, program.frame)


def _lowest(robot: Context) -> tuple[float, str] | None:
    """Height of the ground relative to the root in m, and a link that touches the ground."""
    if robot.is_part or not robot.tree.is_sound:
        return None
    stance = standing_verdict(robot)
    if stance.stability is None or not is_freestanding(robot.tree, stance.links):
        return None
    fixed = rigid_bodies(robot.tree)[0].names
    wheels = [name for name in stance.links if name not in fixed]  # of the lowest links
    return stance.stability.ground, (wheels or stance.links)[0]
