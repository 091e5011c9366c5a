"""The programs that a bundle can be made for, and the formats that they read."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.mesh.io.facts import ASCII_STL, BINARY_STL, COLLADA, GLB, GLTF, OBJ, PLY
from urdfkit.ros.targets import facts_of


class Consumer(Record):
    """A program that reads a robot from a directory."""

    name: str  # value of ``--for``
    title: str  # in messages
    reads: tuple[str, ...]  # supported mesh formats
    visual: str  # suffix to which other visual meshes are converted; collision meshes become STL
    #: True if it finds meshes by ``package://``, not by paths relative to the robot.
    is_package: bool = False
    #: The target that a bundle is checked for if it is not the program, but one that reads the same
    #: robots.
    target: str = ""
    loads_first_object: bool = False  # True if only the first object or group of an OBJ is loaded


_ALL = (BINARY_STL, ASCII_STL, COLLADA, OBJ, PLY, GLB, GLTF)

_MUJOCO = facts_of("mujoco")

#: The most lenient of the programs that urdfkit is compared with: a robot that it rejects is
#: rejected by all.
_LENIENT = "yourdfpy"
#: A program that reads robots with urdfdom, as ROS does, and does not simulate them.
_URDFDOM = "pinocchio"

#: Sources: MuJoCo, its target; PyBullet, examples/Importers/ImportURDFDemo/BulletUrdfImporter.cpp;
#: web: urdf-loader's defaultMeshLoader reads STL and COLLADA; RViz and Gazebo read by assimp;
#: Isaac, https://docs.isaacsim.omniverse.nvidia.com/latest/importer_exporter/ext_isaacsim_asset_importer_urdf.html
CONSUMERS = {
    consumer.name: consumer
    for consumer in (
        Consumer(
            "any",
            "any program that finds files relative to the robot",
            _ALL,
            ".obj",
            target=_LENIENT,
        ),
        Consumer(
            _MUJOCO.name,
            _MUJOCO.title,
            _MUJOCO.meshes,
            ".obj",
            loads_first_object=_MUJOCO.loads_first_object,
        ),
        Consumer("pybullet", "PyBullet", (BINARY_STL, ASCII_STL, COLLADA, OBJ), ".obj"),
        Consumer("genesis", "Genesis", _ALL, ".obj", target="genesis"),
        Consumer(
            "web",
            "urdf-loader for three.js",
            (BINARY_STL, ASCII_STL, COLLADA),
            ".dae",
            target=_LENIENT,
        ),
        Consumer(
            "ros",
            "a ROS 2 package",
            (*_ALL[:4], GLB, GLTF),
            ".dae",
            is_package=True,
            target=_URDFDOM,
        ),
        Consumer("isaac", "Isaac Sim and Isaac Lab", (BINARY_STL, COLLADA, OBJ), ".obj"),
    )
}
