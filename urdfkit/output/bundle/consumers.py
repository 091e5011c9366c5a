"""The programs that a bundle can be made for, and what each of them reads."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.mesh.io.facts import ASCII_STL, BINARY_STL, COLLADA, GLB, GLTF, OBJ, PLY
from urdfkit.ros.targets import facts_of


class Consumer(Record):
    """A program that reads a robot from a directory."""

    name: str  # as ``--for`` takes it
    what: str  # in words
    reads: tuple[str, ...]  # the mesh formats that it has a decoder for
    visual: str  # the suffix of a visual mesh of another format; collision meshes become STL
    #: It finds meshes by ``package://``, and not by paths relative to the robot.
    is_package: bool = False
    #: The target that a bundle is checked for: the program itself, or one that reads as much.
    target: str = ""
    loads_first_object: bool = False  # it loads only the first object or group of an OBJ


_ALL = (BINARY_STL, ASCII_STL, COLLADA, OBJ, PLY, GLB, GLTF)

_MUJOCO = facts_of("mujoco")

#: Of the programs that urdfkit is compared with, the one that takes most robots: what it rejects,
#: no program takes.
_LENIENT = "yourdfpy"
#: A program that reads robots by urdfdom, as ROS does, and does not simulate them.
_URDFDOM = "pinocchio"

#: Sources: MuJoCo, its target; PyBullet, examples/Importers/ImportURDFDemo/BulletUrdfImporter.cpp;
#: web: urdf-loader's defaultMeshLoader knows STL and COLLADA; RViz and Gazebo read by assimp;
#: Isaac, https://docs.isaacsim.omniverse.nvidia.com/latest/importer_exporter/ext_isaacsim_asset_importer_urdf.html
CONSUMERS = {
    one.name: one
    for one in (
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
            target=_MUJOCO.name,
            loads_first_object=_MUJOCO.loads_first_object,
        ),
        Consumer(
            "pybullet",
            "PyBullet",
            (BINARY_STL, ASCII_STL, COLLADA, OBJ),
            ".obj",
            target="pybullet",
        ),
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
        Consumer(
            "isaac", "Isaac Sim and Isaac Lab", (BINARY_STL, COLLADA, OBJ), ".obj", target="isaac"
        ),
    )
}
