"""A mesh refers to an image or a material file that does not exist.

The mesh file or its .mtl contains the path of a texture, relative to itself; the `mtllib` line of
an OBJ refers to the file with its colours. The file was not copied, was renamed, or the path is
that of another machine. RViz and Gazebo draw the part white, grey or black and fill the log with
warnings. Add the file next to the mesh, export the mesh with a plain colour, or delete the `mtllib`
line and give the visual a `<material>` of URDF: an OBJ in a visual with `<material>` is not
reported, and neither are collisions.

Sources:
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
    Wavefront OBJ, mtllib: https://paulbourke.net/dataformats/obj/
"""

from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.samples import collada
from urdfkit.robot.assets.mesh_defects import MeshDefect, missing_textures
from urdfkit.robot.samples import mesh_xml

BAD = mesh_xml("visual", "forearm.dae")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.dae": collada(effect='<diffuse><texture texture="image" texcoord="UV"/></diffuse>'),
    "hand.dae": collada(effect="<diffuse><color>1 0 0 1</color></diffuse>"),
}


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="add the image next to the mesh, or give the mesh a plain colour",
)
def check(context: Context) -> Findings:
    defects = context.measured.defects
    for use in defects.get(MeshDefect.MISSING_TEXTURES, ()):
        names = missing_textures(use)
        more = more_like_this(len(names) - 1)
        yield Finding(use.at, f"{use.who} uses the image '{names[0]}', which does not exist{more}")
    for use in defects.get(MeshDefect.MISSING_MATERIALS, ()):
        yield Finding(
            use.at,
            f"{use.who} has its colours in '{use.measures.no_materials[0]}', which does not exist",
            "add the file next to the mesh, or give the visual a <material>",
            group_key="materials",
        )
