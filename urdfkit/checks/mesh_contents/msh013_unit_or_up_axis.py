"""Programs read the unit or the up axis of a mesh file in different ways.

- `<unit meter="0.001"/>` in a COLLADA file states that its lengths are millimetres. RViz and Gazebo
  multiply by it; MoveIt, Pinocchio, coal and most Python tools do not. The robot looks right, but
  its planner uses a shape a thousand times as large, or the reverse. Bake the unit into the
  vertices with `urdfkit mesh convert`. A warning; an info for a mesh that is only a visual, unless
  Pinocchio is a target.
- `<up_axis>Y_UP</up_axis>` in a COLLADA file is ignored by RViz, Gazebo, MoveIt, Pinocchio and most
  Python tools. Bullet, and viewers in the browser, rotate the mesh by 90 degrees. `urdfkit mesh
  convert` writes Z_UP, with the same numbers. An info.
- glTF 2.0 defines y as up, URDF z. RViz rotates such a mesh since 15.1.4 (ROS 2 Lyrical); so do
  Drake, MeshCat and Blender. Gazebo, earlier RViz, assimp and trimesh use the coordinates
  unchanged. No file suits both: use COLLADA with Z_UP, OBJ or STL. `urdfkit mesh convert` keeps the
  coordinates, and with `--upright` rotates them as the new RViz does. An info.

A file that no given target loads, such as COLLADA for MuJoCo, is not reported.

Sources:
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
    ros-visualization/rviz#1045: https://github.com/ros-visualization/rviz/issues/1045
    moveit/geometric_shapes#52: https://github.com/moveit/geometric_shapes/issues/52
    mikedh/trimesh#1083: https://github.com/mikedh/trimesh/issues/1083
    MoveIt, mesh_operations.cpp: https://github.com/ros-planning/geometric_shapes/blob/ros2/src/mesh_operations.cpp
    PyBullet, COLLADA: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportColladaDemo/LoadMeshFromCollada.cpp
    glTF 2.0, coordinates: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
    ros2/rviz#1482: https://github.com/ros2/rviz/pull/1482
    Gazebo, AssimpLoader.cc: https://github.com/gazebosim/gz-common/blob/main/graphics/src/AssimpLoader.cc
    measured: of 517 public COLLADA files, 23 have another unit and 213 another axis
"""

from collections.abc import Collection

from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.io.facts import has_other_unit, has_other_up_axis, is_gltf
from urdfkit.mesh.samples import collada
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import mesh_xml

BAD = mesh_xml("visual", "forearm.dae")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.dae": collada('<unit name="millimeter" meter="0.001"/>'),
    "hand.dae": collada('<unit name="meter" meter="1"/>'),
}


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    help="bake the unit into the vertices: urdfkit mesh convert FILE -o NEW.dae",
)
def check(context: Context) -> Findings:
    collisions = {mesh.located.path for mesh in context.files.meshes if mesh.role == "collision"}
    loaded = [
        (mesh, mesh.facts)
        for mesh in context.files.each_file
        if mesh.facts and _is_loaded(context, mesh, collisions)
    ]
    for mesh, facts in loaded:
        if has_other_unit(facts):
            is_only_visual = mesh.located.path not in collisions and not context.targets.that(
                "ignores_units"
            )
            yield Finding(
                mesh.at,
                f"{mesh.who} has the unit {facts.unit:g} m: RViz and Gazebo multiply by it, "
                "MoveIt, Pinocchio and coal do not",
                severity=Severity.INFO if is_only_visual else None,
            )
    yield from _once(
        [(mesh, f"has {facts.up_axis}") for mesh, facts in loaded if has_other_up_axis(facts)],
        "Bullet rotates it by 90 degrees, RViz, Gazebo, MoveIt and Pinocchio do not",
        "none needed if RViz shows it right; urdfkit mesh convert writes Z_UP",
    )
    yield from _once(
        [(mesh, "is glTF, where y is up") for mesh, facts in loaded if is_gltf(facts)],
        "RViz since 15.1.4 and Drake rotate it by 90 degrees, Gazebo and earlier RViz do not",
        "use COLLADA, OBJ or STL: urdfkit mesh convert [--upright] FILE -o OUT.dae",
    )


def _is_loaded(context: Context, mesh: MeshReference, collisions: Collection[str | None]) -> bool:
    """True if a given target loads files of this format, or no target is given.

    False for a file that only visuals use, if no target loads visuals.
    """
    if not context.loads_visuals and mesh.located.path not in collisions:
        return False
    targets = context.given_facts
    mesh_format = mesh.facts.format if mesh.facts else ""
    return not targets or any(
        not target.meshes or mesh_format in target.meshes for target in targets
    )


def _once(meshes: list[tuple[MeshReference, str]], effect: str, help: str) -> Findings:
    """One info for all files of a robot, each with what it is."""
    if meshes:
        (mesh, what), *others = meshes
        message = f"{mesh.who} {what}{more_like_this(len(others))}: {effect}"
        yield Finding(mesh.at, message, help, severity=Severity.INFO)
