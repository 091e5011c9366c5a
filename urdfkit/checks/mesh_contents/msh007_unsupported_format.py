"""A mesh is in a format that programs do not load, or read as another format.

The file contains a CAD model or a scene (STEP, IGES, Blender, 3DS, VRML, Open Inventor, X3D, AMF,
3MF, USD), which Gazebo, MuJoCo and Drake do not read at all, or a mesh with the suffix of another
format: programs choose their loader by the suffix and then fail or load nothing. Export it as STL,
COLLADA or OBJ. If no target simulates the robot, such a file is a warning: planners such as
OpenRAVE and Kautham read scene files. PLY, glTF and FBX are not reported: RViz, MoveIt and
Pinocchio load them through assimp, new Gazebo loads glTF and FBX, Gazebo Classic none of the three.

MuJoCo loads only binary STL and OBJ, Drake only OBJ, glTF and, for soft bodies, VTK, which no other
program loads: if one of them is a target, a collision in another format, such as COLLADA, is an
error. Drake ignores visuals that it does not load, MuJoCo ignores all, unless the robot has
`<mujoco><compiler discardvisual="false"/>`. From an OBJ, MuJoCo loads the first object or group and
ignores the others without a message (warning).

RViz 2 does not load ASCII STL up to ROS 2 Iron, so that Humble does not show the visual; RViz loads
it since Jazzy. In a robot for ROS 2 such a visual is an info.

A binary STL that begins with `solid` is an info: ASCII files begin with this word, and the header
of a binary file can contain any text. RViz, Gazebo, MuJoCo and Python libraries load it, RViz with
a warning; simple parsers read it as a broken ASCII file. `urdfkit mesh convert` removes the word.

Sources:
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
    Gazebo Classic, MeshManager.cc: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/common/MeshManager.cc
    ros2/rviz#712, ASCII STL: https://github.com/ros2/rviz/issues/712
    ros2/rviz#1063, STL by assimp: https://github.com/ros2/rviz/pull/1063
    assimp, STLLoader.cpp: https://github.com/assimp/assimp/blob/master/code/AssetLib/STL/STLLoader.cpp
    ros2/rviz#888: https://github.com/ros2/rviz/issues/888
    MuJoCo, its decoders of meshes: https://github.com/google-deepmind/mujoco/tree/main/plugin
    Drake, URDF geometry: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_geometry.cc
"""

import os

from urdfkit.core import disk
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.io.facts import ASCII_STL, BY_SUFFIX, MAX_BYTES, OBJ, VTK
from urdfkit.mesh.io.obj import objects
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import mesh_xml

BAD = mesh_xml("visual", "forearm.stl")
GOOD = BAD.replace("forearm.stl", "hand.stl")
FILES = {"forearm.stl": b"ISO-10303-21;\nHEADER;\n", "hand.stl": PLATE}

_NOT_LOADED = frozenset(("Open Inventor", *"STEP IGES Blender 3DS VRML X3D AMF 3MF USD".split()))


@rule(
    Severity.ERROR, needs=(Need.MODEL, Need.FILES), help="export it as STL, COLLADA (.dae) or OBJ"
)
def check(context: Context) -> Findings:
    for mesh in context.files.meshes:
        facts, path = mesh.facts, mesh.located.path
        if facts is None or path is None or facts.defect:
            continue
        suffix = os.path.splitext(path)[1]
        if facts.format in _NOT_LOADED:
            message = f"{mesh.who} is of {facts.format}, which Gazebo, MuJoCo and Drake do not read"
            severity = None if context.targets.that("simulates") else Severity.WARNING
            yield Finding(mesh.at, message, severity=severity)
        elif facts.format == VTK and not _reads_vtk(context):
            yield Finding(mesh.at, f"{mesh.who} is of VTK, which only Drake reads")
        elif _is_mesh(facts.format) and facts.format not in BY_SUFFIX.get(suffix.lower(), ()):
            message = f"{mesh.who} is {facts.format} by content, and its name ends in '{suffix}'"
            yield Finding(mesh.at, message, "give the file the suffix of its format")
        else:
            yield from _not_for_target(context, mesh, facts.format)
            if facts.format == ASCII_STL and mesh.role == "visual":
                yield from _not_in_rviz(context, mesh)
    for mesh in context.files.each_file:
        if mesh.facts and mesh.facts.starts_with_solid:
            message = f"{mesh.who} is a binary STL and begins with 'solid'"
            help = "urdfkit mesh convert FILE -o NEW.stl"
            yield Finding(mesh.at, message, help, group_key="solid", severity=Severity.INFO)


def _reads_vtk(context: Context) -> bool:
    """True if a target reads VTK, or none is known."""
    targets = context.targets.facts
    return not targets or any(VTK in target.meshes for target in targets)


def _not_for_target(context: Context, mesh: MeshReference, format_name: str) -> Findings:
    """Findings about meshes that a target reads, in a format that it does not load."""
    for target in context.given_facts:
        reads_visuals = context.loads_visuals and not target.leaves_out_visuals
        if mesh.role != "collision" and not reads_visuals:
            continue
        if target.loads_first_object and format_name == OBJ and (number := _objects(mesh)) > 1:
            yield Finding(
                mesh.at,
                f"{mesh.who} contains {number} objects, of which {target.title} loads the first",
                "urdfkit mesh convert FILE -o NEW.stl",
                group_key=f"objects for {target.name}",
                severity=Severity.WARNING,
                targets=(target.name,),
            )
        if target.meshes and format_name not in target.meshes:
            yield Finding(
                mesh.at,
                f"{mesh.who} is {format_name}; {target.title} loads "
                f"{' and '.join(target.meshes)} only",
                f"urdfkit mesh convert FILE -o NEW{_suffix(target.meshes[0])}",
                group_key=f"{format_name} for {target.name}",
                targets=(target.name,),
            )


def _suffix(format_name: str) -> str:
    return next(suffix for suffix, formats in BY_SUFFIX.items() if format_name in formats)


def _not_in_rviz(context: Context, mesh: MeshReference) -> Findings:
    if context.targets.any_of(("ros2",)):
        yield Finding(
            mesh.at,
            f"{mesh.who} is an ASCII STL, which RViz 2 does not load up to ROS 2 Iron",
            "urdfkit mesh convert FILE -o NEW.stl",
            group_key="ascii in RViz",
            severity=Severity.INFO,
            targets=("ros2",),
        )


def _objects(mesh: MeshReference) -> int:
    return objects(disk.contents(mesh.located.path or "", MAX_BYTES) or b"")


def _is_mesh(format_name: str) -> bool:
    return any(format_name in formats for formats in BY_SUFFIX.values())
